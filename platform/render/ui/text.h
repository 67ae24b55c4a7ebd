/* text.h -- the user interface's text: translations, glyphs (pictures of characters) and their
 * widths. Also translates the status lines of devices into the operator's language. Uses no OpenGL.
 * The texts are in assets/text and are selected by key and language. A new text in assets/text
 * needs no change in this module. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "core/base/printable.h"
#include "core/scene.h"
#include "fonts.h"
#include "text_keys.h"

/* Maximum size of a text line in bytes, including the inserted number and the terminating zero. */
#define TEXT_LINE_MAX 256u

/* Returns the text of `key` in `language`, never null. If `language` is unknown, returns the
 * Japanese text. */
const char *text_words(uint8_t language, enum text_key key);

/* Copies `words` to `out`, and replaces the first {} by `number`. If `out` is too small, the text
 * is cut after a whole character. */
void text_number(char *out, size_t out_size, const char *words, uint32_t number);

/* Returns the glyph of a character, or null if the font that the build generates lacks the
 * character. */
const struct font_glyph *text_glyph(enum font_id font, uint32_t code);

/* Returns the glyph that is drawn for a character: its own glyph, otherwise the glyph of `?`.
 * Returns null if the font has neither glyph. The caller then draws nothing and uses a width of
 * 0. */
const struct font_glyph *text_glyph_or_mark(enum font_id font, uint32_t code);

/* Returns the width of a text in ems, from the pen position before the first character to the pen
 * position after the last. `spacing_em` is added between characters. */
float text_width_em(enum font_id font, const char *words, float spacing_em);

/* Maximum size of a translated line in bytes. A Japanese character needs up to three bytes. */
#define TEXT_TRANSLATE_SIZE (3u * SCENE_LINE_SIZE)

/* Translates a status line of a device. A driver reports each line only in English, for the log and
 * for the screen. assets/text has a pattern for each of these lines, from TEXT_MESSAGE_NO_PICTURE
 * to TEXT_MESSAGE_NO_ROOM. The pattern in en.txt is the driver's line with {} in place of each name
 * or number. The pattern in ja.txt is the Japanese translation. A line without a pattern is shown
 * in English.
 *
 * Writes the translation of `line` into `language` (enum language) to `out`. If `out` is too small,
 * the translation is cut after a whole character. Parts of `line` that "; " separates are
 * translated separately. */
void text_translate(char *out, size_t out_size, uint8_t language, const char *line);
