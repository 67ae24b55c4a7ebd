/* pose_glide.c -- moves a simulated hand between two poses along a polynomial of degree five. */
#include "board/poi-gadget/pose_glide.h"

#include <assert.h>

/* Tolerance in seconds for the end of a motion, because the sum of ten steps of 0.01 s is not
 * exactly 0.1 s in binary floating point. */
#define ROUNDING_S 1e-4f

int pose_glide_is_there(const struct pose_glide *glide)
{
    return !glide->begun || glide->at_s >= glide->to.glide_s - ROUNDING_S;
}

void pose_glide_send(struct pose_glide *glide, const struct pose_line *to)
{
    glide->from = glide->begun && !glide->to.lost ? glide->to : *to;
    glide->to = *to;
    glide->at_s = 0.0f;
    glide->begun = 1;
}

/* Returns the completed share of the motion at the share `t` of its duration. The two values are in
 * [0, 1]. The speed and the acceleration are 0 at the start and at the end. */
static float smooth(float t)
{
    return t * t * t * (10.0f - t * (15.0f - 6.0f * t));
}

/* Interpolates between two angles in the direction of the smaller rotation. */
static float turn_between(float from_rad, float to_rad, float t)
{
    return f_wrap_angle(from_rad + t * f_wrap_angle(to_rad - from_rad));
}

void pose_glide_step(struct pose_glide *glide, float seconds, struct poi_report *out)
{
    assert(glide->begun && seconds >= 0.0f);
    const struct poi_target *from = &glide->from.target, *to = &glide->to.target;
    glide->at_s += seconds;
    const float t = pose_glide_is_there(glide) ? 1.0f : smooth(glide->at_s / glide->to.glide_s);
    out->target.position_m = v3_lerp(from->position_m, to->position_m, t);
    out->target.angles = (struct angles){
        .yaw_rad = turn_between(from->angles.yaw_rad, to->angles.yaw_rad, t),
        .pitch_rad = turn_between(from->angles.pitch_rad, to->angles.pitch_rad, t),
        .roll_rad = turn_between(from->angles.roll_rad, to->angles.roll_rad, t),
    };
    if (glide->to.lost) {
        out->target.position_m.x = __builtin_nanf("");
    }
    out->buttons = glide->to.buttons;
}
