/* message_translate.h -- translates the status lines of devices into the operator's language.
 *
 * A driver reports one line in English, for the log and for the screen, and supports no other
 * language. assets/text has a pattern for each such line, from TEXT_SAYS_NO_PICTURE to
 * TEXT_SAYS_NO_ROOM. The pattern in en.txt is the driver's line with {} in place of each name or
 * figure; ja.txt has the Japanese line. A line without a pattern is shown unchanged. */
#ifndef KINGYO_PLATFORM_RENDER_UI_MESSAGE_TRANSLATE_H
#define KINGYO_PLATFORM_RENDER_UI_MESSAGE_TRANSLATE_H

#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"

/* Size of a translated line: three bytes a letter, the maximum for Japanese. */
#define MESSAGE_TRANSLATE_SIZE (3u * SCENE_LINE_SIZE)

/* Writes `line` in that language (enum language), cut at a whole character when `out` is full.
 * Parts separated by "; " are translated one by one. */
void message_translate(char *out, size_t out_size, uint8_t language, const char *line);

#endif
