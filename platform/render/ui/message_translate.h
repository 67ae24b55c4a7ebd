/* message_translate.h -- translates the status lines of devices into the operator's language.
 *
 * A driver reports each line only in English, for the log and for the screen. assets/text has a
 * pattern for each of these lines, from TEXT_SAYS_NO_PICTURE to TEXT_SAYS_NO_ROOM. The pattern in
 * en.txt is the driver's line with {} in place of each name or number. The pattern in ja.txt is the
 * Japanese translation. A line without a pattern is shown in English. */
#ifndef KINGYO_PLATFORM_RENDER_UI_MESSAGE_TRANSLATE_H
#define KINGYO_PLATFORM_RENDER_UI_MESSAGE_TRANSLATE_H

#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"

/* Maximum size of a translated line in bytes. A Japanese character needs up to three bytes. */
#define MESSAGE_TRANSLATE_SIZE (3u * SCENE_LINE_SIZE)

/* Writes the translation of `line` into `language` (enum language) to `out`. If `out` is too small,
 * the translation is cut after a whole character. Parts of `line` that "; " separates are
 * translated separately. */
void message_translate(char *out, size_t out_size, uint8_t language, const char *line);

#endif
