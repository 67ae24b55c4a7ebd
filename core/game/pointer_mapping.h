/* pointer_mapping.h -- maps a pose over the water to a pointer on a canvas. The canvas is the
 * drawing area of menus, over the tank's picture.
 *
 * Wide screens use a canvas of 1280 x 720, portrait screens a canvas of 854 x 1400. The origin is
 * the top left corner, with x to the right and y down. Each canvas is centred and as large as the
 * screen permits. The mapping uses the tank's camera. A point on the water surface maps to the
 * canvas point that is drawn over the point, independent of the screen's size. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/view.h"

/* Screens with a smaller aspect ratio (width over height) use the portrait canvas. */
#define POINTER_UPRIGHT_ASPECT 0.78f

/* Height of a controller's pose below which its pointer presses. */
#define POINTER_PRESS_Y_M 0.010f
/* Height of a controller's pose above which a press of its pointer ends. The pose of a mouse hovers
 * at 0.035 m. */
#define POINTER_RELEASE_Y_M 0.018f
/* Distance on the canvas. A pointer counts as resting if it moves less than this distance. */
#define POINTER_MOVE_MIN 14.0f

struct layout_box {
    float x, y, width, height;
};

struct layout_point {
    float x, y;
};

/* Returns the width and height of the portrait canvas (`upright`) or of the wide canvas. */
struct layout_point pointer_layout_size(bool upright);

/* Returns true if the point `at` is in the box or less than `room` outside its edges. Always
 * returns false for an empty box. */
bool pointer_is_inside(struct layout_box box, float room, struct layout_point at);

/* Returns the canvas point at which the world point `point_m` is drawn. */
struct layout_point pointer_project(const struct view *view, bool upright, vec3 point_m);

/* State of a player's pointer. `at` is the position, clamped to the canvas, and `height_m` is the
 * height of the pose. `present` is 0 if no controller is connected or its pose is invalid. Jumps of
 * the pointer are not filtered, because a jump of a pointer does no damage. */
struct pointer_state {
    uint8_t present;
    uint8_t player;
    struct layout_point at;
    float height_m;
};

struct world;

/* Returns the pointer of `player`, computed from the pose of the player's controller. If the
 * controller measures rotation, the floor plan of the tank is mapped to the canvas. Otherwise the
 * pointer is at the canvas point at which the camera shows the pose. */
struct pointer_state pointer_of_player(const struct world *world, const struct input *input,
                                       bool upright, uint32_t player);
