/* says.h -- what devices say of themselves, in the operator's language.
 *
 * A driver says one line in English, for the log as well as for the screen, and knows no other
 * language. assets/text has a pattern for each such line, from TEXT_SAYS_NO_PICTURE to
 * TEXT_SAYS_NO_ROOM: in en.txt as the driver says it, with {} where a name or a figure stands; in
 * ja.txt what that is in Japanese. A line that is none of them is shown as it is. */
#ifndef KINGYO_PLATFORM_RENDER_SAYS_H
#define KINGYO_PLATFORM_RENDER_SAYS_H

#include <stddef.h>
#include <stdint.h>

#include "core/scene.h"

/* A line of three bytes a letter, which is as long as Japanese gets. */
#define SAYS_SIZE (3u * SCENE_LINE_SIZE)

/* Writes `line` in that language (enum language); cut at a whole character when `out` is full. Of
 * several lines with "; " between them each is written on its own. */
void says(char *out, size_t out_size, uint8_t language, const char *line);

#endif
