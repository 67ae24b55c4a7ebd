/* text.h -- the user interface's text: UTF-8 decoding, translations, glyphs and their widths. Uses
 * no OpenGL.
 *
 * Text comes from assets/text by key and language. Adding a text there needs no other change. */
#ifndef KINGYO_PLATFORM_RENDER_UI_TEXT_H
#define KINGYO_PLATFORM_RENDER_UI_TEXT_H

#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"
#include "fonts.h"
#include "text_keys.h"

#define TEXT_MALFORMED 0xfffdu /* Result of text_next() for bytes that are not UTF-8. */
/* Bytes of a line with its number inserted and the terminating zero. */
#define TEXT_LINE_MAX 256u

/* Returns the text of `key`, never null. An unknown language selects Japanese. */
const char *text_words(uint8_t language, enum text_key key);

/* Copies `words` with the first {} replaced by `number`, cut at a whole character when `out` is
 * full. */
void text_number(char *out, size_t out_size, const char *words, uint32_t number);

/* Returns the code point at `*at` and advances `*at` past it; returns 0 at the end. Malformed bytes
 * are consumed one by one. */
uint32_t text_next(const char **at);

/* Returns null when the font was baked without that character. */
const struct font_glyph *text_glyph(enum font_id font, uint32_t code);

/* Returns the glyph drawn for a character: its own glyph, otherwise `?`, otherwise null (nothing is
 * drawn, without width). */
const struct font_glyph *text_glyph_or_mark(enum font_id font, uint32_t code);

/* Returns the width from the first pen position to the last, in ems; `spacing_em` is added between
 * characters. */
float text_width_em(enum font_id font, const char *words, float spacing_em);

#endif
