/* placing.h -- how the picture lies on the screen: turned, inset, moved a little, dimmed.
 *
 * Like the camera (view.h) it is a contract of two sides that must agree: the display draws through
 * it, and whoever points at the picture looks back through it. The core itself knows of no screen.
 * Screen and picture are measured in pixels from their top left corners, x to the right, y down. */
#ifndef KINGYO_CORE_PLACING_H
#define KINGYO_CORE_PLACING_H

#include <stdint.h>

#include "core/base/fmath.h"

#define PLACING_INSET_MAX 0.25f /* Of a side; more would leave no picture. */

/* What is asked of the display. Zero is a picture as large as the screen, and dark. */
struct showing {
    uint32_t rotation;        /* Quarter turns clockwise, 0 .. 3. */
    float inset_x, inset_y;   /* [0, PLACING_INSET_MAX]: left black at each side of the screen, as a
                                 share of its width, of its height. */
    float shift_x, shift_y;   /* [-0.01, 0.01] of the screen's height: against burning in. */
    float light;              /* [0, 1]; at 0 nothing need be drawn. */
};

/* The same for one size of screen. */
struct placing {
    float screen_width, screen_height; /* > 0 */
    float width, height;               /* Of the picture, as it is drawn and read; > 0. */
    float x, y;                        /* Its top left corner on the screen. */
    float xx, xy, yx, yy;              /* Its axes there: (xx, yx) is its x, (xy, yy) its y. */
    float light;                       /* As struct showing's. */
};

/* A picture that fills the screen, at full light. */
static inline struct placing placing_whole(float width, float height)
{
    return (struct placing){ .screen_width = width, .screen_height = height,
                             .width = width, .height = height,
                             .xx = 1.0f, .yy = 1.0f, .light = 1.0f };
}

static inline float placing_whole_pixels(float pixels)
{
    return f_floor(pixels + 0.5f);
}

/* Whole pixels: the picture is as sharp as one that fills the screen. */
static inline struct placing placing_of(const struct showing *showing, float width, float height)
{
    static const float turn_x[4] = { 1.0f, 0.0f, -1.0f, 0.0f }; /* Where its x points, and ... */
    static const float turn_y[4] = { 0.0f, 1.0f, 0.0f, -1.0f }; /* ... its y is a quarter on. */
    const uint32_t turn = showing->rotation & 3u;
    const float left = placing_whole_pixels(
        f_clamp(showing->inset_x, 0.0f, PLACING_INSET_MAX) * width);
    const float top = placing_whole_pixels(
        f_clamp(showing->inset_y, 0.0f, PLACING_INSET_MAX) * height);
    const float across = f_max(width - 2.0f * left, 1.0f);
    const float down = f_max(height - 2.0f * top, 1.0f);
    struct placing placing = { .screen_width = width, .screen_height = height,
                               .width = turn & 1u ? down : across,
                               .height = turn & 1u ? across : down,
                               .xx = turn_x[turn], .yx = turn_y[turn],
                               .xy = 0.0f - turn_y[turn], .yy = turn_x[turn],
                               .light = f_clamp(showing->light, 0.0f, 1.0f) };
    placing.x = left + placing_whole_pixels(showing->shift_x * height) +
                (placing.xx + placing.xy < 0.0f ? across : 0.0f);
    placing.y = top + placing_whole_pixels(showing->shift_y * height) +
                (placing.yx + placing.yy < 0.0f ? down : 0.0f);
    return placing;
}

/* Where a point of the screen is on the picture; beside it, if it is. */
static inline void placing_look_back(const struct placing *placing, float *x, float *y)
{
    const float right = *x - placing->x, down = *y - placing->y;
    *x = placing->xx * right + placing->yx * down;
    *y = placing->xy * right + placing->yy * down;
}

/* The same forward, for OpenGL: a point of the picture at -1 .. 1 with y up is on the screen at
 * turn * point + move, in the same measure. `turn` is column-major. */
static inline void placing_clip(const struct placing *p, float turn[4], float move[2])
{
    const float w = 2.0f / p->screen_width, h = 2.0f / p->screen_height;
    turn[0] = 0.5f * w * p->xx * p->width;
    turn[1] = -0.5f * h * p->yx * p->width;
    turn[2] = -0.5f * w * p->xy * p->height;
    turn[3] = 0.5f * h * p->yy * p->height;
    move[0] = w * (p->x + 0.5f * (p->xx * p->width + p->xy * p->height)) - 1.0f;
    move[1] = 1.0f - h * (p->y + 0.5f * (p->yx * p->width + p->yy * p->height));
}

/* The part of the screen that the picture covers; it may reach over the screen's edge. */
struct placing_part {
    float left, top, right, bottom;
};

static inline struct placing_part placing_part_of(const struct placing *p)
{
    const float x = p->x + p->xx * p->width + p->xy * p->height;
    const float y = p->y + p->yx * p->width + p->yy * p->height;
    return (struct placing_part){ f_min(p->x, x), f_min(p->y, y), f_max(p->x, x), f_max(p->y, y) };
}

#endif
