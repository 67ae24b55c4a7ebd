/* display_geometry.h -- the transform from the picture to the screen: rotation, inset, shift and
 * brightness.
 *
 * Like the camera (view.h), the transform is used by two parts of the program that must agree. The
 * display draws with the transform, and pointer devices use its inverse. The core itself does not
 * use the transform. Screen and picture are measured in pixels from their top left corners, x to
 * the right, y down. */
#pragma once

#include <stdint.h>

#include "core/base/fmath.h"

/* Largest inset, as a share of the screen's width or height; a larger inset would leave no
 * picture. */
#define DISPLAY_INSET_MAX 0.25f

/* Options of the display and of the pointers on it. If all fields are 0, the picture covers the
 * whole screen, unrotated, with brightness 0 (dark). */
struct display_settings {
    /* Clockwise rotation of the picture on the screen, in quarter turns, 0 .. 3. */
    uint32_t rotation;
    /* Black margin at each side of the screen, [0, DISPLAY_INSET_MAX], as a share of the screen's
     * width (x) and height (y). */
    float inset_x, inset_y;
    /* Shift of the picture, [-0.01, 0.01] of the screen's height. The caller changes the shift
     * regularly to prevent burn-in of the screen. */
    float shift_x, shift_y;
    float light; /* Brightness [0, 1]; at 0 the display may skip drawing. */
    /* How a mouse or a touch screen acts on the picture (drivers/pointer/pointer_poi.h): 1 if one
     * click dips and the next click lifts, and the reach in per cent; 0 means 100. */
    uint32_t dips_by_click, reach_percent;
    uint32_t has_white_bowls; /* 1 if the bowls are classic white, 0 with bands of colour. */
    uint32_t is_day; /* 1 if the stall is drawn in daylight, 0 at night with bulbs and lanterns. */
};

/* Transform for one screen size. */
struct display_transform {
    float screen_width, screen_height; /* Screen size in pixels, > 0. */
    /* Width and height of the picture in pixels before its rotation, > 0. */
    float width, height;
    /* Position of the picture's top left corner on the screen, in pixels. */
    float x, y;
    /* Axes of the picture on the screen: (xx, yx) is its x axis, (xy, yy) its y axis. */
    float xx, xy, yx, yy;
    float light; /* Brightness, as in struct display_settings. */
};

static inline float display_round_pixels(float pixels)
{
    return f_floor(pixels + 0.5f);
}

/* Returns the transform for `display_settings` on a screen of `width` x `height` pixels. Offsets
 * are rounded to whole pixels, so that the picture is as sharp as a full-screen picture. */
static inline struct display_transform
display_transform_of(const struct display_settings *display_settings, float width, float height)
{
    /* x component of the picture's x axis on the screen, for each number of quarter turns. */
    static const float turn_x[4] = { 1.0f, 0.0f, -1.0f, 0.0f };
    /* y component of the picture's x axis on the screen. The picture's y axis is the x axis turned
     * clockwise by one more quarter turn. */
    static const float turn_y[4] = { 0.0f, 1.0f, 0.0f, -1.0f };
    const uint32_t turn = display_settings->rotation & 3u;
    const float left =
        display_round_pixels(f_clamp(display_settings->inset_x, 0.0f, DISPLAY_INSET_MAX) * width);
    const float top =
        display_round_pixels(f_clamp(display_settings->inset_y, 0.0f, DISPLAY_INSET_MAX) * height);
    const float across = f_max(width - 2.0f * left, 1.0f);
    const float down = f_max(height - 2.0f * top, 1.0f);
    struct display_transform transform = { .screen_width = width,
                                           .screen_height = height,
                                           .width = turn & 1u ? down : across,
                                           .height = turn & 1u ? across : down,
                                           .xx = turn_x[turn],
                                           .yx = turn_y[turn],
                                           .xy = 0.0f - turn_y[turn],
                                           .yy = turn_x[turn],
                                           .light = f_clamp(display_settings->light, 0.0f, 1.0f) };
    transform.x = left + display_round_pixels(display_settings->shift_x * height) +
                  (transform.xx + transform.xy < 0.0f ? across : 0.0f);
    transform.y = top + display_round_pixels(display_settings->shift_y * height) +
                  (transform.yx + transform.yy < 0.0f ? down : 0.0f);
    return transform;
}

/* Converts the screen point (`*x`, `*y`) to picture coordinates in place. If the screen point lies
 * outside the picture, the converted point does too. */
static inline void display_to_picture(const struct display_transform *transform, float *x, float *y)
{
    const float right = *x - transform->x, down = *y - transform->y;
    *x = transform->xx * right + transform->yx * down;
    *y = transform->xy * right + transform->yy * down;
}

/* Computes the display transform in OpenGL clip coordinates, where x and y run from -1 to 1 and y
 * points up. A point p of the picture is shown at the screen point `turn` * p + `move`. `turn` is a
 * column-major 2 x 2 matrix. */
static inline void display_clip_matrix(const struct display_transform *p, float turn[4],
                                       float move[2])
{
    const float w = 2.0f / p->screen_width, h = 2.0f / p->screen_height;
    turn[0] = 0.5f * w * p->xx * p->width;
    turn[1] = -0.5f * h * p->yx * p->width;
    turn[2] = -0.5f * w * p->xy * p->height;
    turn[3] = 0.5f * h * p->yy * p->height;
    move[0] = w * (p->x + 0.5f * (p->xx * p->width + p->xy * p->height)) - 1.0f;
    move[1] = 1.0f - h * (p->y + 0.5f * (p->yx * p->width + p->yy * p->height));
}

/* Rectangle of the screen that the picture covers, in pixels. The rectangle may extend beyond the
 * screen's edge. */
struct display_rect {
    float left, top, right, bottom;
};

static inline struct display_rect display_picture_rect(const struct display_transform *p)
{
    const float x = p->x + p->xx * p->width + p->xy * p->height;
    const float y = p->y + p->yx * p->width + p->yy * p->height;
    return (struct display_rect){ f_min(p->x, x), f_min(p->y, y), f_max(p->x, x), f_max(p->y, y) };
}
