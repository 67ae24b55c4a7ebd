/* failsafe.c -- computes the failsafe motion, one step per tick. */
#include "core/game/control/failsafe.h"

#include "core/base/fmath.h"
#include "core/poi/pose.h"

/* Deceleration at which a fish on level paper does not slide. */
#define COAST_M_S2 2.0f
#define COAST_LAG_S 0.025f /* Time by which the ring lags behind its target in air. */
#define COAST_DONE_M_S 0.15f
/* Speed upward that half-wet paper of grade 7 withstands broadside (test_drift). */
#define RISE_M_S 0.08f
#define TURN_RAD_S 1.5f
#define SLANT_RAD (45.0f * F_DEG)
#define SLANT_NEAR_RAD (10.0f * F_DEG) /* Tilt at which the upward motion starts. */
/* Speed above the water, enough to move from the bowl to the far corner within a second. */
#define BACK_DRY_M_S 1.0f
/* Speed downward into the water, which the paper also withstands broadside. */
#define BACK_WET_M_S 0.10f
#define WET_BELOW_M 0.035f /* Height below which part of a tilted ring may be under water. */
#define BACK_TURN_RAD_S 4.0f
/* Share of the remaining distance that the poi moves per tick. The poi therefore slows down near
 * its goal. */
#define BACK_SHARE 0.08f
/* Increase of the speed factor for each second after the damage immunity ends. */
#define BACK_HASTE_PER_S 5.0f
/* Increase of BACK_SHARE for each second after the damage immunity ends. */
#define BACK_SHARE_PER_S 0.5f
/* Distance that the spring between the controller's pose and the poi covers without an impact. */
#define BACK_NEAR_M 0.006f
#define BACK_NEAR_RAD 0.02f
/* Horizontal distance to the goal above which the poi leaves the water before it moves sideways. */
#define BACK_FAR_M 0.15f
#define BACK_ASIDE_M 0.03f /* Horizontal distance to the goal within which the poi may move down. */

static float toward(float from, float to, float step)
{
    return from + f_clamp(to - from, -step, step);
}

/* Returns the edge that leaves the water first: 1 means the far edge, -1 the near edge. For a
 * tilted ring the result is the higher edge. For a level ring the result is the edge that lets the
 * poi leave toward the middle of the tank. */
static float first_edge(struct poi_target hand)
{
    if (f_abs(hand.angles.pitch_rad) > SLANT_NEAR_RAD) {
        return hand.angles.pitch_rad > 0.0f ? 1.0f : -1.0f;
    }
    return hand.position_m.z * f_cos(hand.angles.yaw_rad) >= 0.0f ? 1.0f : -1.0f;
}

static struct poi_target slip_out(struct poi_target hand)
{
    const float way = first_edge(hand);
    const struct angles goal = { hand.angles.yaw_rad, way * SLANT_RAD, 0.0f };
    hand.angles = pose_toward(hand.angles, goal, 1.0f, TURN_RAD_S * CORE_TICK_S);
    if (f_abs(hand.angles.pitch_rad - goal.pitch_rad) < SLANT_NEAR_RAD) {
        const vec3 back = vec_basis_from_angles(hand.angles).back;
        hand.position_m = v3_muladd(hand.position_m, back, -way * RISE_M_S * CORE_TICK_S);
    }
    return hand;
}

static struct poi_target lift_level(struct poi_target hand)
{
    const struct angles level = { hand.angles.yaw_rad, 0.0f, 0.0f };
    const float high_m = f_max(hand.position_m.y, FAILSAFE_HOVER_M);
    hand.angles = pose_toward(hand.angles, level, 1.0f, TURN_RAD_S * CORE_TICK_S);
    hand.position_m.y = toward(hand.position_m.y, high_m, RISE_M_S * CORE_TICK_S);
    return hand;
}

struct poi_target failsafe_begin(const struct poi *poi, struct poi_target hand)
{
    hand.position_m = poi->position_m;
    hand.angles = poi->tip > 0.0f ? hand.angles : poi->angles;
    return hand;
}

struct poi_target failsafe_withdraw(const struct poi *poi, struct poi_target hand)
{
    const float speed_m_s = v3_length(poi->velocity_m_s);
    if (speed_m_s > COAST_DONE_M_S) {
        const vec3 next = v3_limit(poi->velocity_m_s, speed_m_s - COAST_M_S2 * CORE_TICK_S);
        hand.position_m = v3_muladd(poi->position_m, next, COAST_LAG_S + CORE_TICK_S);
        return hand;
    }
    const int in_water = poi->immersed > 0.0f && hand.position_m.y < FAILSAFE_HOVER_M;
    return in_water && poi->carried_count == 0 ? slip_out(hand) : lift_level(hand);
}

/* Returns the direction and distance of the next part of the path. On a long path the poi first
 * leaves the water, then moves above the goal, and then moves down. */
static vec3 way_back(vec3 from_m, vec3 to_m)
{
    const vec3 way_m = v3_sub(to_m, from_m);
    const float aside_m = f_sqrt(way_m.x * way_m.x + way_m.z * way_m.z);
    if (from_m.y < WET_BELOW_M) {
        return aside_m > BACK_FAR_M ? v3(0.0f, FAILSAFE_HOVER_M - from_m.y, 0.0f) : way_m;
    }
    return aside_m > BACK_ASIDE_M && way_m.y < 0.0f ? v3(way_m.x, 0.0f, way_m.z) : way_m;
}

/* After the immunity ends the poi moves faster, so that the return always completes. */
struct poi_target failsafe_return(struct poi_target hand, struct poi_target wanted, uint32_t ticks)
{
    const float age = f_min((float)ticks / (float)FAILSAFE_RETURN_TICKS_MIN, 1.0f);
    const float late_s = ticks > FAILSAFE_IMMUNITY_TICKS_MAX
                             ? (float)(ticks - FAILSAFE_IMMUNITY_TICKS_MAX) * CORE_TICK_S
                             : 0.0f;
    const float share = age * age * f_min(BACK_SHARE + BACK_SHARE_PER_S * late_s, 1.0f);
    const vec3 way_m = way_back(hand.position_m, wanted.position_m);
    const int is_wet = hand.position_m.y < WET_BELOW_M || way_m.y < 0.0f;
    const float pace_m_s =
        (1.0f + BACK_HASTE_PER_S * late_s) * (is_wet ? BACK_WET_M_S : BACK_DRY_M_S);
    const vec3 step_m = v3_limit(v3_scale(way_m, share), pace_m_s * CORE_TICK_S);
    return (struct poi_target){
        .position_m = v3_add(hand.position_m, step_m),
        .angles = pose_toward(hand.angles, wanted.angles, share, BACK_TURN_RAD_S * CORE_TICK_S),
    };
}

int failsafe_is_returned(struct poi_target hand, struct poi_target wanted, uint32_t ticks)
{
    const vec3 way_m = v3_sub(wanted.position_m, hand.position_m);
    const float turn_rad =
        f_max(f_abs(f_wrap_angle(wanted.angles.yaw_rad - hand.angles.yaw_rad)),
              f_max(f_abs(f_wrap_angle(wanted.angles.pitch_rad - hand.angles.pitch_rad)),
                    f_abs(f_wrap_angle(wanted.angles.roll_rad - hand.angles.roll_rad))));
    const int is_near = v3_length(way_m) < BACK_NEAR_M && turn_rad < BACK_NEAR_RAD;
    return ticks >= FAILSAFE_RETURN_TICKS_MIN && is_near;
}
