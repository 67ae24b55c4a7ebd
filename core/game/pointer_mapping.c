/* pointer_mapping.c -- the two canvases, and the mapping of poses to pointers on a canvas. */
#include "core/game/pointer_mapping.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "core/poi/world.h"
#include "core/game/control/input_pose.h"

#define WIDE_WIDTH 1280.0f
#define WIDE_HEIGHT 720.0f
#define UPRIGHT_WIDTH 854.0f
#define UPRIGHT_HEIGHT 1400.0f
/* Smallest distance in front of the camera that is projected. Nearer points are not visible. */
#define DEPTH_MIN_M 0.05f

struct layout_point pointer_layout_size(bool upright)
{
    return upright ? (struct layout_point){ UPRIGHT_WIDTH, UPRIGHT_HEIGHT }
                   : (struct layout_point){ WIDE_WIDTH, WIDE_HEIGHT };
}

bool pointer_is_inside(struct layout_box box, float room, struct layout_point at)
{
    CORE_ASSERT(room >= 0.0f);
    return box.width > 0.0f && at.x >= box.x - room && at.x <= box.x + box.width + room &&
           at.y >= box.y - room && at.y <= box.y + box.height + room;
}

/* Returns the canvas point at which the camera shows `point_m`. On a screen of aspect ratio
 * `aspect_min` or more, `half_height_tan` is the tangent of half the vertical angle of view. On a
 * narrower screen, aspect_min * half_height_tan is the tangent of half the horizontal angle of
 * view. Recordings of older versions show the camera for wide screens on the portrait canvas. */
struct layout_point pointer_project(const struct view *view, bool upright, vec3 point_m)
{
    CORE_ASSERT(view->half_height_tan > 0.0f && view->aspect_min > 0.0f);
    const struct basis axes = view_basis(view);
    const vec3 from_eye_m = v3_sub(point_m, view->eye_m);
    const float depth_m = f_max(-v3_dot(from_eye_m, axes.back), DEPTH_MIN_M);
    const float right = v3_dot(from_eye_m, axes.right) / (depth_m * view->half_height_tan);
    const float up = v3_dot(from_eye_m, axes.up) / (depth_m * view->half_height_tan);
    const struct layout_point canvas = pointer_layout_size(upright);
    const float unit = upright ? 0.5f * canvas.x / view->aspect_min : 0.5f * canvas.y;
    return (struct layout_point){ 0.5f * canvas.x + unit * right, 0.5f * canvas.y - unit * up };
}

/* Returns the pointer of a player. The floor plan of the tank is mapped to the canvas if the
 * controller measures rotation, because the player then aims at a place in the tank and not along a
 * camera ray. The player then need not reach behind the tank for items at the top of the screen.
 * The pose of a mouse is projected by the camera, because the mouse points at the screen. */
struct pointer_state pointer_of_player(const struct world *world, const struct input *input,
                                       bool upright, uint32_t player)
{
    CORE_ASSERT(player < POI_MAX);
    const struct poi_input *reported = &input->poi[player];
    if (reported->link != POI_SOURCE_LIVE || !input_pose_is_finite(&reported->target)) {
        return (struct pointer_state){ 0 };
    }
    const bool is_turned = input->is_turned != 0;
    const struct tank_preset *const preset = tank_preset(world->tank.preset);
    const vec3 hand_m = view_from_world(is_turned, reported->target.position_m);
    const vec3 tank_m = view_from_world(is_turned, world->tank.size_m);
    const struct layout_point canvas = pointer_layout_size(upright);
    struct layout_point at = { canvas.x * (0.5f + hand_m.x / f_abs(tank_m.x)),
                               canvas.y * (0.5f + hand_m.z / f_abs(tank_m.z)) };
    if (!reported->has_wrist) {
        at = pointer_project(is_turned ? &preset->turned_view : &preset->view, upright, hand_m);
    }
    return (struct pointer_state){
        .present = 1,
        .player = (uint8_t)player,
        .at = { f_clamp(at.x, 0.0f, canvas.x), f_clamp(at.y, 0.0f, canvas.y) },
        .height_m = hand_m.y,
    };
}
