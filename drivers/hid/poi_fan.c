/* poi_fan.c -- implements the rules by which a controller moves either the poi or the fan. */
#include "drivers/hid/poi_fan.h"

#include "drivers/pointer/pointer_fan.h"

/* Z coordinate of the idle fan: in front of the player, beyond the near edge of every tank. */
#define LAP_Z_M 0.75f

void poi_fan_init(struct poi_fan *fan)
{
    *fan = (struct poi_fan){ .back = 1.0f };
}

static void go_to_time(struct poi_fan *fan, uint64_t time_ns)
{
    if (time_ns <= fan->time_ns) {
        return;
    }
    const float dt_s = fan->time_ns > 0 ? (float)(time_ns - fan->time_ns) * 1e-9f : 0.0f;
    const float swing = dt_s / POINTER_FAN_SWING_S;
    fan->swing = f_clamp(fan->swing + (fan->held ? swing : -swing), 0.0f, 1.0f);
    fan->back = fan->held ? fan->back : f_min(1.0f, fan->back + dt_s / POI_FAN_BACK_S);
    fan->time_ns = time_ns;
}

/* Interpolates an angle in the shorter direction. A value that is not finite is returned unchanged,
 * so that the core rejects it. */
static float turned(float from_rad, float to_rad, float share)
{
    const float way_rad = to_rad - from_rad;
    return f_is_finite(way_rad) && f_abs(way_rad) < 1000.0f
               ? from_rad + share * f_wrap_angle(way_rad)
               : to_rad;
}

struct poi_target poi_fan_pose(const struct poi_fan *fan)
{
    const float share = f_smoothstep(0.0f, 1.0f, fan->back);
    const struct poi_target *from = &fan->waits, *to = &fan->hand;
    if (fan->back >= 1.0f) {
        return *to;
    }
    return (struct poi_target){
        .position_m = v3_lerp(from->position_m, to->position_m, share),
        .angles = { .yaw_rad = turned(from->angles.yaw_rad, to->angles.yaw_rad, share),
                    .pitch_rad = turned(from->angles.pitch_rad, to->angles.pitch_rad, share),
                    .roll_rad = turned(from->angles.roll_rad, to->angles.roll_rad, share) },
    };
}

void poi_fan_move(struct poi_fan *fan, const struct poi_target *hand, int held, uint64_t time_ns)
{
    go_to_time(fan, time_ns);
    if (held && !fan->held) {
        fan->waits = poi_fan_pose(fan); /* The pose from before the current report is stored,
                                           because the report may also move the controller. */
        fan->back = 0.0f;
    }
    fan->held = held != 0;
    fan->hand = *hand;
}

struct shade_input poi_fan_shade(struct poi_fan *fan, uint64_t time_ns)
{
    go_to_time(fan, time_ns);
    const float share = f_smoothstep(0.0f, 1.0f, fan->swing);
    const vec3 at_m = fan->hand.position_m;
    return (struct shade_input){
        .present = fan->swing > 0.0f,
        .x_m = at_m.x,
        .z_m = f_lerp(f_max(LAP_Z_M, at_m.z), at_m.z, share),
        .radius_m = POINTER_FAN_RADIUS_M,
    };
}
