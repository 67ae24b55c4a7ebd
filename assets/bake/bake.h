/* bake.h -- the bake: a tool that computes assets once, on the building machine. The assets are
 * linked as constants.
 *
 * `build/bake ASSET ...` writes one asset and prints one line about it. The output depends only on
 * the sources, the fonts and the constants in this header, so that the same sources give the same
 * bytes. The tool never runs on the kiosk. For that reason the tool may allocate memory, use libm
 * and exit at the first error. */
#ifndef KINGYO_ASSETS_BAKE_BAKE_H
#define KINGYO_ASSETS_BAKE_BAKE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Sizes of the baked textures in texels. bake_header() writes these sizes to a header for the
 * renderer. */
#define CAUSTICS_SIZE 256u /* Side of one tile of caustics, a power of two for mipmaps. */
/* Number of layers of one loop of caustics. choose_waves() in caustics.c states how the number
 * relates to the waves. */
#define CAUSTICS_FRAMES 32u
#define PATTERN_WIDTH 128u /* Width of a pattern, from snout to tail root. */
/* Height of a pattern, which covers the body's girth once, beginning at the back. */
#define PATTERN_HEIGHT 64u
#define PATTERN_LAYERS 12u
#define ENVIRONMENT_SIZE 128u
#define WOOD_SIZE 256u
#define PAPER_SIZE 128u
/* Width of the font atlas, a texture width that OpenGL ES 3.0 guarantees. */
#define FONT_ATLAS_WIDTH 2048u
/* Maximum height of a page, a texture height that OpenGL ES 3.0 guarantees. */
#define FONT_PAGE_ROWS_MAX 2048u
/* Maximum number of pages. Two pages have 8 MiB, which is enough for all texts. */
#define FONT_PAGES_MAX 2u
/* Distance value on a letter's outline. Most of the range 0 to 255 lies outside the letter. */
#define FONT_EDGE 160u
/* Change of the distance value per atlas pixel. The values reach 10 px outward and 6 px inward. */
#define FONT_STEP 16u
#define FONT_MAX 8u
/* Number of languages. Must equal LANGUAGE_COUNT of core/scene.h, with the languages in the same
 * order. */
#define TEXT_LANGUAGES 2u
#define TEXT_KEYS_MAX 1024u

/* Ends the bake with exit code 65 (invalid input data) and one line on standard error. */
_Noreturn void bake_fail(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Reads a whole file and adds a terminating zero. The caller frees the returned memory. Ends the
 * bake if the file cannot be read. */
uint8_t *bake_read(const char *path, size_t *size);
/* Writes a whole file. Ends the bake if the file cannot be written. */
void bake_write(const char *path, const void *bytes, size_t size);
/* Opens a file for writing. Ends the bake if the file cannot be opened. */
FILE *bake_open(const char *path);
/* Closes a file. Ends the bake if any byte could not be written. */
void bake_close(FILE *file, const char *path);
void *bake_alloc(size_t size); /* Returns zeroed memory. Ends the bake if no memory is left. */

/* Declarations of functions that each fill the texels of one texture, beginning with row 0. The
 * channels are interleaved. */
void bake_caustics(uint8_t *r8);
void bake_patterns(uint8_t *rg8);
void bake_environment(uint8_t *rgb8);
void bake_wood(uint8_t *r8);
void bake_paper(uint8_t *r8);

/* A line of the user interface's text in assets/text/ja.txt or en.txt. */
struct text_line {
    char *key, *words;
    uint32_t line; /* Line number in the text file, beginning with 1. */
};

/* All lines of one language's text file. */
struct text_file {
    const char *path;
    struct text_line lines[TEXT_KEYS_MAX];
    uint32_t count;
};

/* Reads `directory`/ja.txt and en.txt. Ends the bake if the files do not have the same keys. */
void text_read(struct text_file files[TEXT_LANGUAGES], const char *directory);
/* Writes the enum of the text keys as a C header. */
void text_write_keys(const struct text_file files[TEXT_LANGUAGES], const char *path);
/* Writes the texts of all languages as a C table. */
void text_write_table(const struct text_file files[TEXT_LANGUAGES], const char *path);

/* Output files of font_bake(): the atlas, its glyph tables, and the ids of its fonts. */
struct font_output {
    const char *atlas_path, *table_path, *header_path;
};
/* Bakes the fonts that `directory`/fonts.txt lists, with all characters of `files`. */
void font_bake(const struct text_file files[TEXT_LANGUAGES], const char *directory,
               const struct font_output *output);

/* Writes the sizes of the baked assets as a C header. */
void bake_header(const char *path);

#endif
