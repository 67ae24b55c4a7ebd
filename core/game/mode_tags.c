/* mode_tags.c -- the table of the tags of the mode selection, and the layout of the tags. */
#include "core/game/mode_tags.h"

#include "core/base/panic.h"
#include "core/scene.h"

const struct mode_tag mode_tags[MODE_TAG_COUNT] = {
    { MODE_FESTIVAL, LEVEL_EASY },   { MODE_FESTIVAL, LEVEL_NORMAL },
    { MODE_FESTIVAL, LEVEL_MASTER }, { MODE_CHAMPIONSHIP, LEVEL_MASTER },
    { MODE_PRACTICE, LEVEL_MASTER }, { CHOICE_LAB, LEVEL_MASTER },
};

uint32_t mode_tags_offered(uint8_t modes, bool has_levels)
{
    uint32_t offered = 0;
    for (uint32_t tag = 0; tag < MODE_TAG_COUNT; tag++) {
        const bool is_offered = (modes >> mode_tags[tag].mode & 1u) &&
                                (has_levels || mode_tags[tag].level == LEVEL_MASTER);
        offered |= (uint32_t)is_offered << tag;
    }
    return offered;
}

/* A group of equal tags, in a row or in a column. */
struct tag_group {
    float x, y;           /* Middle of the group on the canvas. */
    float width, height;  /* Size of each tag. */
    float step_x, step_y; /* Distance from the middle of a tag to the middle of the next tag. */
};

struct layout_box mode_tag_box(bool upright, uint32_t offered, uint32_t tag)
{
    /* On the wide canvas the small tags are in a column to the right of the large tags. On the
     * portrait canvas the small tags are in a row below the large tags. */
    static const struct tag_group groups[2][2] = {
        { { 1094.0f, 340.0f, 292.0f, 124.0f, 0.0f, 136.0f },
          { 476.0f, 340.0f, 276.0f, 396.0f, 298.0f, 0.0f } },
        { { 427.0f, 956.0f, 256.0f, 150.0f, 272.0f, 0.0f },
          { 427.0f, 600.0f, 256.0f, 480.0f, 272.0f, 0.0f } },
    };
    const bool is_large = tag < MODE_TAG_LEVELS;
    const struct tag_group *group = &groups[upright][is_large];
    CORE_ASSERT(offered >> tag & 1u);
    uint32_t before = 0, count = 0;
    for (uint32_t i = 0; i < MODE_TAG_COUNT; i++) {
        const bool is_same = (offered >> i & 1u) && (i < MODE_TAG_LEVELS) == is_large;
        count += is_same;
        before += is_same && i < tag;
    }
    const float x =
        offered & MODE_TAG_LEVEL_MASK ? group->x : 0.5f * pointer_layout_size(upright).x;
    const float steps = (float)before - 0.5f * (float)(count - 1u);
    return (struct layout_box){ x + group->step_x * steps - 0.5f * group->width,
                                group->y + group->step_y * steps - 0.5f * group->height,
                                group->width, group->height };
}
