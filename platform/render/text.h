/* text.h -- the stall's words: UTF-8, glyphs and their measures. Knows no OpenGL.
 *
 * Words come from assets/text by key and language; adding one there is all it takes. */
#ifndef KINGYO_PLATFORM_RENDER_TEXT_H
#define KINGYO_PLATFORM_RENDER_TEXT_H

#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"
#include "fonts.h"
#include "text_keys.h"

#define TEXT_MALFORMED 0xfffdu /* What text_next() says for bytes that are not UTF-8. */
#define TEXT_LINE_MAX 256u     /* Bytes of a line with its number put in, and the zero. */

/* The words of `key`; an unknown language speaks Japanese. Never null. */
const char *text_words(uint8_t language, enum text_key key);

/* Copies `words` with its first {} replaced by `number`; cut at a whole character
 * when `out` is full. */
void text_number(char *out, size_t out_size, const char *words, uint32_t number);

/* The code point at `*at`, which moves past it; 0 at the end. Malformed bytes are skipped
 * one by one. */
uint32_t text_next(const char **at);

/* Null when the font was baked without that character. */
const struct font_glyph *text_glyph(enum font_id font, uint32_t code);

/* What is drawn for a character: its glyph, else `?`, else null (nothing, and no room taken). */
const struct font_glyph *text_glyph_or_mark(enum font_id font, uint32_t code);

/* From the first pen position to the last, in ems; `spacing_em` is added between characters. */
float text_width_em(enum font_id font, const char *words, float spacing_em);

#endif
