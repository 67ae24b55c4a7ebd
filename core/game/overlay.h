/* overlay.h -- what lies over the tank's picture and is pointed at by a hand over its water.
 *
 * A canvas of 1280 x 720 lies on wide screens, one of 854 x 1400 on those that stand upright, x to
 * the right, y down, from its top left corner; each is as large as fits, centred. A canvas is
 * measured in the tank's camera: what is under a point of the water's plane is under that point's
 * place on the screen, whatever the screen's size. */
#ifndef KINGYO_CORE_GAME_OVERLAY_H
#define KINGYO_CORE_GAME_OVERLAY_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/view.h"

/* Narrower screens (width over height) take the upright canvas. */
#define OVERLAY_UPRIGHT_ASPECT 0.61f

#define OVERLAY_PRESS_Y_M 0.010f   /* A hand below this presses ... */
#define OVERLAY_RELEASE_Y_M 0.018f /* ... until it is above this: a mouse's hovers at 0.035. */
#define OVERLAY_STIR 14.0f         /* A hand that stays within this of where it was rests. */

struct overlay_box {
    float x, y, width, height;
};

struct overlay_point {
    float x, y;
};

struct overlay_point overlay_size(int upright); /* Its width and height. */

/* Whether a point is in a box or less than `room` beside it; in an empty box there is none. */
int overlay_is_inside(struct overlay_box box, float room, struct overlay_point at);

/* Where a point of the world is on the canvas. */
struct overlay_point overlay_point_of(const struct view *view, int upright, vec3 point_m);

/* A hand that points: where it is, clamped to the canvas, and how high. Absent: nobody's, or it
 * cannot be read. A leap loses nothing here, so no hand is doubted for one. */
struct overlay_hand {
    uint8_t present;
    uint8_t player;
    struct overlay_point at;
    float height_m;
};

struct core;

struct overlay_hand overlay_hand_of(const struct core *core, const struct input *input,
                                    int upright, uint32_t player);

/* That of the first who has a bowl at the tank. */
struct overlay_hand overlay_first_hand(const struct core *core, const struct input *input,
                                       int upright);

#endif
