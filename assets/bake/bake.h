/* bake.h -- the bake: a tool that computes assets once, on the building machine. The assets are
 * linked as constants.
 *
 * `build/bake ASSET ...` writes one asset and prints one line about it. The output depends only on
 * the sources, the fonts and the constants in this header, so that the same sources give the same
 * bytes. The tool never runs on the kiosk. For that reason the tool may allocate memory, use libm
 * and exit at the first error. */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Sizes of the baked textures in texels. header_bake() writes these sizes to a header for the
 * renderer. */
/* Side of the square caustics texture in texels: a power of two, as mipmaps need. */
#define CAUSTICS_SIZE 256u
/* Number of pictures (texture layers) in one loop of the caustics animation. choose_waves() in
 * caustics.c states how the number relates to the waves. */
#define CAUSTICS_FRAMES 32u
/* Width of a pattern of fish skin in texels. The width covers the body from the snout to the tail
 * root. */
#define PATTERN_WIDTH 256u
/* Height of a pattern of fish skin in texels. The height covers the body's girth once, beginning at
 * the back. */
#define PATTERN_HEIGHT 128u
#define PATTERN_LAYERS 7u
#define ENVIRONMENT_SIZE 128u
/* Size in texels of each of the two pictures of the street behind the stall: night, and day. */
#define BACKDROP_WIDTH 1024u
#define BACKDROP_HEIGHT 256u
#define WOOD_SIZE 256u
#define PAPER_SIZE 128u
/* Width of the font atlas, a texture width that OpenGL ES 3.0 guarantees. */
#define FONT_ATLAS_WIDTH 2048u
/* Maximum height of a page of the font atlas, a texture height that OpenGL ES 3.0 guarantees. */
#define FONT_PAGE_ROWS_MAX 2048u
/* Maximum number of pages of the font atlas. Two pages have 8 MiB, which is enough for all
 * texts. */
#define FONT_PAGES_MAX 2u
/* Value of an atlas texel that lies exactly on a letter's outline. The texels store the distance
 * from the outline. Smaller values lie outside the letter, and larger values lie inside. */
#define FONT_EDGE 160u
/* Change of a texel's value for a distance of one atlas pixel. The values 0 to 255 therefore
 * represent distances up to 10 px outside and 6 px inside the outline. */
#define FONT_STEP 16u
#define FONT_MAX 8u
#define BAKE_PATH_SIZE 1024u
/* Number of languages. Must equal LANGUAGE_COUNT of core/scene.h, with the languages in the same
 * order. */
#define TEXT_LANGUAGES 2u
#define TEXT_KEYS_MAX 1024u

/* Prints one line to standard error, and ends the bake with exit code 65 (invalid input data). */
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

/* Reads a text file and calls `read_line` with `self` for each line, without the white space at
 * both ends. Skips empty lines and lines that begin with '#'. Lines are counted from 1. The texts
 * of the lines stay valid until the program ends. */
void bake_read_lines(const char *path,
                     void (*read_line)(void *self, const char *path, char *line, uint32_t number),
                     void *self);
/* Removes the white space at both ends of `text`, in place. Returns the start of the trimmed
 * text. */
char *bake_trim(char *text);
/* Writes `words` in capital letters. */
void bake_put_capitals(FILE *file, const char *words);

/* Each of these functions fills the texels of one texture, beginning with row 0. The channels of a
 * texel are interleaved. */
void bake_caustics(uint8_t *r8);
void bake_patterns(uint8_t *rg8);
void bake_environment(uint8_t *rgb8);
void bake_backdrop(uint8_t *rgb8);
void bake_wood(uint8_t *r8);
void bake_paper(uint8_t *r8);

/* A line of a text file of the user interface (assets/text/ja.txt or en.txt). */
struct text_line {
    char *key, *words;
    uint32_t line; /* Line number in the text file, beginning with 1. */
};

/* All lines of one language's text file. */
struct text_file {
    char path[BAKE_PATH_SIZE];
    struct text_line lines[TEXT_KEYS_MAX];
    uint32_t count;
};

/* Reads `directory`/ja.txt and en.txt. Ends the bake if the files do not have the same keys. */
void text_read(struct text_file files[TEXT_LANGUAGES], const char *directory);

/* text_bake(), font_bake() and words_bake() each bake one asset. `paths` contains the paths from
 * the command line of the bake. */

/* Converts the texts of the folder paths[0] to an enum of the text keys, the C header paths[1], and
 * to a table of the texts of all languages, the C source paths[2]. */
void text_bake(char **paths);

/* Bakes the fonts that paths[0]/fonts.txt lists, with all characters of the texts in the folder
 * paths[0]. Writes the atlas to paths[1], its glyph tables to the C source paths[2], and the ids of
 * its fonts to the C header paths[3]. */
void font_bake(char **paths);

/* Converts the list paths[0] of rejected player names to the C table paths[1]. */
void words_bake(char **paths);

/* ---- Noise and small numeric functions for the baking of textures (noise.c) ------------------ */

#define TAU 6.28318530718f

/* Returns a hash of `x`, `y` and `seed` in [0, 1). */
float noise_hash01(int32_t x, int32_t y, uint32_t seed);
/* Returns the next value of a pseudo-random sequence, in [0, 1). `*state` is the state of the
 * sequence and may have any initial value. */
float noise_random01(uint32_t *state);
/* Returns smooth value noise in [0, 1]. The noise repeats after `period_x` and `period_y` cells. */
float noise_2d(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed);
/* Returns the sum of `octaves` octaves of noise_2d(), scaled to [0, 1]. Each octave is twice as
 * fine and half as strong as the octave before. The sum repeats with the periods of noise_2d(). */
float noise_2d_sum(float x, float y, int32_t period_x, int32_t period_y, uint32_t seed,
                   uint32_t octaves);

/* Adds `amount` of light to a square picture at the position (x, y), in texels. The four nearest
 * texels share the amount. `size` is the side of the picture in texels and must be a power of two.
 * Positions outside the picture wrap around. */
void noise_add_light(float *sum, uint32_t size, float x, float y, float amount);

float noise_mix(float a, float b, float t);
/* Returns 0 at and before `from`, 1 at and after `to`, and a smooth transition between them. If
 * `from` is greater than `to`, the direction is reversed. */
float noise_ramp(float from, float to, float x);
uint8_t noise_to_u8(float x01);
