/* bake.h -- the bake: assets that are computed once, on the building machine, and linked as
 * constants.
 *
 * `build/bake ASSET ...` writes one asset and prints one line about it. The output depends only on
 * the sources, the fonts and the numbers here, so the same sources give the same bytes. This tool
 * never runs on the kiosk, so it may allocate memory, use libm and exit at the first error. */
#ifndef KINGYO_ASSETS_BAKE_BAKE_H
#define KINGYO_ASSETS_BAKE_BAKE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Sizes in texels; bake_header() repeats them for the renderer. */
#define CAUSTICS_SIZE 256u  /* Side of one tile, a power of two for mipmaps. */
#define CAUSTICS_FRAMES 32u /* Layers of one loop; choose_waves() explains the number. */
#define PATTERN_WIDTH 128u  /* From snout to tail root. */
#define PATTERN_HEIGHT 64u  /* Round the girth, from the back. */
#define PATTERN_LAYERS 12u
#define ENVIRONMENT_SIZE 128u
#define WOOD_SIZE 256u
#define PAPER_SIZE 128u
#define FONT_ATLAS_WIDTH 2048u   /* Texture width that OpenGL ES 3.0 guarantees. */
#define FONT_PAGE_ROWS_MAX 2048u /* Texture height that OpenGL ES 3.0 guarantees. */
#define FONT_PAGES_MAX 2u        /* 8 MiB of texture are enough for the text. */
#define FONT_EDGE 160u           /* Distance value on the outline: most of the range is outside. */
#define FONT_STEP 16u            /* Value per atlas pixel: reaches 10 px out and 6 px in. */
#define FONT_MAX 8u
#define TEXT_LANGUAGES 2u /* Same as LANGUAGE_COUNT of core/scene.h, in its order. */
#define TEXT_KEYS_MAX 1024u

/* Ends the bake with one line on standard error and exit code 65 (bad input data). */
_Noreturn void bake_fail(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Reads the whole file, zero-terminated. The caller frees it. Fails when the file cannot be
 * read. */
uint8_t *bake_read(const char *path, size_t *size);
void bake_write(const char *path, const void *bytes, size_t size);
/* Opens a file for writing and fails when it cannot be opened. bake_close() also fails when not
 * every byte was written. */
FILE *bake_open(const char *path);
void bake_close(FILE *file, const char *path);
void *bake_alloc(size_t size); /* Allocates zeroed memory. */

/* Each function fills its texels, row 0 first, channels interleaved. */
void bake_caustics(uint8_t *r8);
void bake_patterns(uint8_t *rg8);
void bake_environment(uint8_t *rgb8);
void bake_wood(uint8_t *r8);
void bake_paper(uint8_t *r8);

/* The user interface's text: assets/text/ja.txt and en.txt, read and compared. */
struct text_line {
    char *key, *words;
    uint32_t line; /* Line number in its file, from 1. */
};

struct text_file {
    const char *path;
    struct text_line lines[TEXT_KEYS_MAX];
    uint32_t count;
};

/* Reads `directory`/ja.txt and en.txt. Fails with one line unless both have the same keys. */
void text_read(struct text_file files[TEXT_LANGUAGES], const char *directory);
void text_write_keys(const struct text_file files[TEXT_LANGUAGES], const char *path);
void text_write_table(const struct text_file files[TEXT_LANGUAGES], const char *path);

/* Returns the next code point of zero-terminated UTF-8 and advances `*at`. Returns 0 at the end and
 * -1 for malformed bytes. */
int32_t text_utf8_next(const char **at);

/* Output files of font_bake(), which reads `directory`/fonts.txt and writes the atlas, its glyph
 * tables and the ids of its fonts. */
struct font_output {
    const char *atlas_path, *table_path, *header_path;
};
void font_bake(const struct text_file files[TEXT_LANGUAGES], const char *directory,
               const struct font_output *output);

void bake_header(const char *path);

#endif
