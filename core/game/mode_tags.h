/* mode_tags.h -- the tags of the mode selection and their positions on the canvas
 * (pointer_mapping.h). The pointer code and the renderer share the positions. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/pointer_mapping.h"

#define MODE_TAG_COUNT 6u
/* Number of tags that select a level. These tags are the first in the order, begin with the easiest
 * level, and all start the festival mode. */
#define MODE_TAG_LEVELS 3u
#define MODE_TAG_LEVEL_MASK ((1u << MODE_TAG_LEVELS) - 1u)

struct mode_tag {
    uint8_t mode;  /* Mode that the tag starts (enum game_mode), or CHOICE_LAB. */
    uint8_t level; /* Level that the tag selects (enum level). The other tags have LEVEL_MASTER and
                      select no level. */
};

extern const struct mode_tag mode_tags[MODE_TAG_COUNT];

/* Returns the bit mask (1 << tag) of the tags for the modes in the bit mask `modes` (1 << enum
 * game_mode, or 1 << CHOICE_LAB). Without `has_levels` the festival mode has one tag instead of one
 * for each level. */
uint32_t mode_tags_offered(uint8_t modes, bool has_levels);

/* Returns the box of the offered tag `tag` on the portrait canvas (`upright`) or on the wide
 * canvas. `offered` is the bit mask of all offered tags. Tags that select a level are large, and
 * the other tags are small. */
struct layout_box mode_tag_box(bool upright, uint32_t offered, uint32_t tag);
