/* drift.c -- gentle ways, tick by tick. */
#include "core/game/drift.h"

#include "core/base/fmath.h"

#define RISE_M_S 0.12f         /* Broadside 0.04 N: a tenth of what tears wet paper of grade 7. */
#define TURN_RAD_S 1.5f
#define SLANT_RAD (45.0f * F_DEG)
#define SLANT_NEAR_RAD (10.0f * F_DEG) /* Turned so far, it sets off. */
#define BACK_DRY_M_S 1.0f
#define BACK_WET_M_S 0.25f
#define WET_BELOW_M 0.035f     /* Some of a tilted ring is under water. */
#define BACK_TURN_RAD_S 4.0f
#define BACK_NEAR_M 0.002f
#define BACK_NEAR_RAD 0.02f

static float toward(float from, float to, float step)
{
    return from + f_clamp(to - from, -step, step);
}

/* The short way round. */
static float turn_toward(float from_rad, float to_rad, float share, float step_rad)
{
    const float way_rad = f_wrap_angle(to_rad - from_rad) * share;
    return f_wrap_angle(from_rad + f_clamp(way_rad, -step_rad, step_rad));
}

static struct angles turn_all(struct angles from, struct angles to, float share, float step_rad)
{
    return (struct angles){
        .yaw_rad = turn_toward(from.yaw_rad, to.yaw_rad, share, step_rad),
        .pitch_rad = turn_toward(from.pitch_rad, to.pitch_rad, share, step_rad),
        .roll_rad = turn_toward(from.roll_rad, to.roll_rad, share, step_rad),
    };
}

/* Its far edge first where there is more room beyond, else its near edge. Once it has set off it
 * keeps its way, or it would swing to and fro over the middle. */
static float way_out(struct poi_target hand)
{
    const float pitch_rad = hand.angles.pitch_rad;
    const int is_off = f_abs(pitch_rad) > SLANT_RAD - SLANT_NEAR_RAD;
    const float lean = is_off ? pitch_rad : hand.position_m.z * f_cos(hand.angles.yaw_rad);
    return lean >= 0.0f ? 1.0f : -1.0f;
}

static struct poi_target slip_out(struct poi_target hand)
{
    const float way = way_out(hand);
    const struct angles goal = { hand.angles.yaw_rad, way * SLANT_RAD, 0.0f };
    hand.angles = turn_all(hand.angles, goal, 1.0f, TURN_RAD_S * CORE_TICK_S);
    if (f_abs(hand.angles.pitch_rad - goal.pitch_rad) < SLANT_NEAR_RAD) {
        const vec3 back = basis_from_angles(hand.angles).back;
        hand.position_m = v3_mad(hand.position_m, back, -way * RISE_M_S * CORE_TICK_S);
    }
    return hand;
}

static struct poi_target lift_level(struct poi_target hand)
{
    const struct angles level = { hand.angles.yaw_rad, 0.0f, 0.0f };
    const float high_m = f_max(hand.position_m.y, DRIFT_HOVER_M);
    hand.angles = turn_all(hand.angles, level, 1.0f, TURN_RAD_S * CORE_TICK_S);
    hand.position_m.y = toward(hand.position_m.y, high_m, RISE_M_S * CORE_TICK_S);
    return hand;
}

struct poi_target drift_out(const struct poi *poi, struct poi_target hand)
{
    const int in_water = poi->immersed > 0.0f && hand.position_m.y < DRIFT_HOVER_M;
    return in_water && poi->rider_count == 0 ? slip_out(hand) : lift_level(hand);
}

struct poi_target drift_back(struct poi_target hand, struct poi_target wanted, uint32_t ticks)
{
    const float age = f_min((float)ticks / (float)DRIFT_BACK_TICKS_MIN, 1.0f);
    const float share = age * age * age;
    const float low_m = f_min(hand.position_m.y, wanted.position_m.y);
    const float haste = 1.0f + (float)ticks / (float)CORE_TICK_HZ;
    const float pace_m_s = haste * (low_m < WET_BELOW_M ? BACK_WET_M_S : BACK_DRY_M_S);
    const vec3 way_m = v3_scale(v3_sub(wanted.position_m, hand.position_m), share);
    return (struct poi_target){
        .position_m = v3_add(hand.position_m, v3_limit(way_m, pace_m_s * CORE_TICK_S)),
        .angles = turn_all(hand.angles, wanted.angles, share, BACK_TURN_RAD_S * CORE_TICK_S),
    };
}

int drift_is_back(struct poi_target hand, struct poi_target wanted, uint32_t ticks)
{
    const vec3 way_m = v3_sub(wanted.position_m, hand.position_m);
    const float turn_rad =
        f_max(f_abs(f_wrap_angle(wanted.angles.yaw_rad - hand.angles.yaw_rad)),
              f_max(f_abs(f_wrap_angle(wanted.angles.pitch_rad - hand.angles.pitch_rad)),
                    f_abs(f_wrap_angle(wanted.angles.roll_rad - hand.angles.roll_rad))));
    const int is_near = v3_length(way_m) < BACK_NEAR_M && turn_rad < BACK_NEAR_RAD;
    return ticks >= DRIFT_BACK_TICKS_MIN && is_near;
}
