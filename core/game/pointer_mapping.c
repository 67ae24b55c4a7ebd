/* pointer_mapping.c -- the two canvases, and the mapping of poses to pointers on them. */
#include "core/game/pointer_mapping.h"

#include "core/base/fmath.h"
#include "core/poi/world.h"
#include "core/game/control/input_validation.h"

#define WIDE_WIDTH 1280.0f
#define WIDE_HEIGHT 720.0f
#define UPRIGHT_WIDTH 854.0f
#define UPRIGHT_HEIGHT 1400.0f
/* Smallest distance in front of the camera. Nearer points are not visible. */
#define DEPTH_MIN_M 0.05f

struct layout_point pointer_layout_size(int upright)
{
    return upright ? (struct layout_point){ UPRIGHT_WIDTH, UPRIGHT_HEIGHT }
                   : (struct layout_point){ WIDE_WIDTH, WIDE_HEIGHT };
}

int pointer_is_inside(struct layout_box box, float room, struct layout_point at)
{
    return box.width > 0.0f && at.x >= box.x - room && at.x <= box.x + box.width + room &&
           at.y >= box.y - room && at.y <= box.y + box.height + room;
}

/* On a screen of aspect ratio `aspect_min` or more, the tangent of the visible angle above and
 * below the middle is `half_height_tan`. On a narrower screen the tangent to each side is
 * aspect_min * half_height_tan. */
struct layout_point pointer_project(const struct view *view, int upright, vec3 point_m)
{
    const struct basis axes = view_basis(view);
    const vec3 from_eye_m = v3_sub(point_m, view->eye_m);
    const float depth_m = f_max(-v3_dot(from_eye_m, axes.back), DEPTH_MIN_M);
    const float right = v3_dot(from_eye_m, axes.right) / (depth_m * view->half_height_tan);
    const float up = v3_dot(from_eye_m, axes.up) / (depth_m * view->half_height_tan);
    const struct layout_point canvas = pointer_layout_size(upright);
    const float unit = upright ? 0.5f * canvas.x / view->aspect_min : 0.5f * canvas.y;
    return (struct layout_point){ 0.5f * canvas.x + unit * right, 0.5f * canvas.y - unit * up };
}

/* Maps the pose of a controller with rotation by the tank's floor plan, because the player aims at
 * a place in the tank and not along a camera ray. The player therefore need not reach behind the
 * tank for items at the top of the screen. */
static struct layout_point plan_point(const struct world *world, int upright, vec3 hand_m)
{
    const struct layout_point canvas = pointer_layout_size(upright);
    return (struct layout_point){ canvas.x * (0.5f + hand_m.x / world->tank.size_m.x),
                                  canvas.y * (0.5f + hand_m.z / world->tank.size_m.z) };
}

struct pointer_state pointer_of_player(const struct world *world, const struct input *input,
                                       int upright, uint32_t player)
{
    const struct poi_input *says = &input->poi[player];
    if (says->link != POI_SOURCE_LIVE || !input_pose_is_finite(&says->target)) {
        return (struct pointer_state){ 0 };
    }
    const vec3 hand_m = says->target.position_m;
    const struct layout_point canvas = pointer_layout_size(upright);
    const struct layout_point at =
        says->has_wrist ? plan_point(world, upright, hand_m)
                        : pointer_project(&tank_preset(world->tank.preset)->view, upright, hand_m);
    return (struct pointer_state){
        .present = 1,
        .player = (uint8_t)player,
        .at = { f_clamp(at.x, 0.0f, canvas.x), f_clamp(at.y, 0.0f, canvas.y) },
        .height_m = hand_m.y,
    };
}

struct pointer_state pointer_first(const struct world *world, const struct input *input,
                                   int upright)
{
    struct pointer_state hand = { 0 };
    for (uint32_t i = 0; i < POI_MAX && !hand.present; i++) {
        if (world->bowl[i].present) {
            hand = pointer_of_player(world, input, upright, i);
        }
    }
    return hand;
}
