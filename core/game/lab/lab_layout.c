/* lab_layout.c -- the position of each part of the growth lab on both canvases. */
#include "core/game/lab/lab_layout.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"

#define KEY_GAP 8.0f
#define KEY_WIDTH_MAX 262.0f
/* Margin around a field (the plot, the chart or the age axis) within which a press still selects
 * the field. */
#define PRESS_ROOM 12.0f

static const struct layout_box wide[LAB_PART_COUNT] = {
    [LAB_BACK] = { 24.0f, 14.0f, 56.0f, 52.0f },
    [LAB_NAME] = { 84.0f, 14.0f, 560.0f, 52.0f },
    [LAB_NEXT] = { 648.0f, 14.0f, 56.0f, 52.0f },
    [LAB_LEAVE] = { 1132.0f, 14.0f, 124.0f, 52.0f },
    [LAB_STAGE] = { 24.0f, 78.0f, 740.0f, 356.0f },
    [LAB_KEY] = { 24.0f, 444.0f, 740.0f, 128.0f },
    [LAB_AGE] = { 24.0f, 578.0f, 740.0f, 56.0f },
    [LAB_PLAY] = { 24.0f, 646.0f, 200.0f, 58.0f },
    [LAB_COMPARE] = { 236.0f, 646.0f, 258.0f, 58.0f },
    [LAB_PATH] = { 506.0f, 646.0f, 258.0f, 58.0f },
    [LAB_CARD] = { 784.0f, 78.0f, 472.0f, 356.0f },
    [LAB_PLOT] = { 848.0f, 128.0f, 340.0f, 222.0f },
    [LAB_SIZE] = { 800.0f, 384.0f, 136.0f, 42.0f },
    [LAB_ADD] = { 948.0f, 384.0f, 142.0f, 42.0f },
    [LAB_REMOVE] = { 1100.0f, 384.0f, 142.0f, 42.0f },
    [LAB_OWN] = { 784.0f, 444.0f, 88.0f, 46.0f },
    [LAB_ORDINARY] = { 880.0f, 444.0f, 88.0f, 46.0f },
    [LAB_PAIRWISE] = { 976.0f, 444.0f, 88.0f, 46.0f },
    [LAB_SIMULTANEOUS] = { 1072.0f, 444.0f, 88.0f, 46.0f },
    [LAB_SMOOTH] = { 1168.0f, 444.0f, 88.0f, 46.0f },
    [LAB_CHART_CARD] = { 784.0f, 500.0f, 472.0f, 134.0f },
    [LAB_CHART] = { 866.0f, 518.0f, 370.0f, 86.0f },
    [LAB_SAVE] = { 784.0f, 646.0f, 230.0f, 58.0f },
    [LAB_RESET] = { 1026.0f, 646.0f, 230.0f, 58.0f },
};

static const struct layout_box upright_boxes[LAB_PART_COUNT] = {
    [LAB_BACK] = { 24.0f, 20.0f, 64.0f, 60.0f },
    [LAB_NAME] = { 92.0f, 20.0f, 516.0f, 60.0f },
    [LAB_NEXT] = { 612.0f, 20.0f, 64.0f, 60.0f },
    [LAB_LEAVE] = { 702.0f, 20.0f, 128.0f, 60.0f },
    [LAB_STAGE] = { 24.0f, 96.0f, 806.0f, 430.0f },
    [LAB_KEY] = { 24.0f, 538.0f, 806.0f, 138.0f },
    [LAB_AGE] = { 24.0f, 682.0f, 806.0f, 60.0f },
    [LAB_PLAY] = { 24.0f, 754.0f, 206.0f, 64.0f },
    [LAB_COMPARE] = { 242.0f, 754.0f, 288.0f, 64.0f },
    [LAB_PATH] = { 542.0f, 754.0f, 288.0f, 64.0f },
    [LAB_CARD] = { 24.0f, 832.0f, 806.0f, 306.0f },
    [LAB_PLOT] = { 100.0f, 878.0f, 660.0f, 176.0f },
    [LAB_SIZE] = { 48.0f, 1086.0f, 236.0f, 44.0f },
    [LAB_ADD] = { 308.0f, 1086.0f, 236.0f, 44.0f },
    [LAB_REMOVE] = { 568.0f, 1086.0f, 236.0f, 44.0f },
    [LAB_OWN] = { 24.0f, 1150.0f, 154.0f, 50.0f },
    [LAB_ORDINARY] = { 187.0f, 1150.0f, 154.0f, 50.0f },
    [LAB_PAIRWISE] = { 350.0f, 1150.0f, 154.0f, 50.0f },
    [LAB_SIMULTANEOUS] = { 513.0f, 1150.0f, 154.0f, 50.0f },
    [LAB_SMOOTH] = { 676.0f, 1150.0f, 154.0f, 50.0f },
    [LAB_CHART_CARD] = { 24.0f, 1212.0f, 806.0f, 104.0f },
    [LAB_CHART] = { 112.0f, 1228.0f, 692.0f, 58.0f },
    [LAB_SAVE] = { 24.0f, 1328.0f, 397.0f, 60.0f },
    [LAB_RESET] = { 433.0f, 1328.0f, 397.0f, 60.0f },
};

/* Returns the box of a part. The pictures of the key shapes lie in one row. Each picture is as wide
 * as the row permits, but not wider than a fish needs. */
struct layout_box lab_box(bool upright, uint32_t key_count, enum lab_part part)
{
    const struct layout_box *boxes = upright ? upright_boxes : wide, row = boxes[LAB_KEY];
    CORE_ASSERT(part < LAB_PART_COUNT);
    CORE_ASSERT(key_count >= 2 && key_count <= MORPH_KEY_MAX);
    if (part < LAB_KEY || part > LAB_KEY_LAST) {
        return boxes[part];
    }
    const uint32_t key = (uint32_t)part - LAB_KEY;
    if (key >= key_count) {
        return (struct layout_box){ 0.0f, 0.0f, 0.0f, 0.0f };
    }
    const float share = (row.width + KEY_GAP) / (float)key_count;
    const float width = f_min(share - KEY_GAP, KEY_WIDTH_MAX);
    const float span = row.width - width;
    const float x = row.x + span * (float)key / (float)(key_count - 1u);
    return (struct layout_box){ x, row.y, width, row.height };
}

enum lab_part lab_part_at(bool upright, uint32_t key_count, struct layout_point at)
{
    for (uint32_t part = LAB_NOTHING + 1u; part < LAB_PRESSED_COUNT; part++) {
        const bool is_field = part == LAB_PLOT || part == LAB_CHART;
        const struct layout_box box = lab_box(upright, key_count, (enum lab_part)part);
        if (pointer_is_inside(box, is_field ? PRESS_ROOM : 0.0f, at)) {
            return (enum lab_part)part;
        }
    }
    return LAB_NOTHING;
}

struct span {
    float from, to;
};

static struct span age_span(bool upright, uint32_t key_count)
{
    const struct layout_box first = lab_box(upright, key_count, LAB_KEY);
    const struct layout_box last =
        lab_box(upright, key_count, (enum lab_part)(LAB_KEY + key_count - 1u));
    return (struct span){ first.x + 0.5f * first.width, last.x + 0.5f * last.width };
}

float lab_age_x(bool upright, uint32_t key_count, float progress)
{
    const struct span span = age_span(upright, key_count);
    return f_lerp(span.from, span.to, progress);
}

float lab_age_progress(bool upright, uint32_t key_count, float x)
{
    const struct span span = age_span(upright, key_count);
    return f_clamp((x - span.from) / (span.to - span.from), 0.0f, 1.0f);
}
