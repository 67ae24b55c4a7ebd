/* failsafe.c -- computes the failsafe motion, one step per tick. If a poi disappears, converts its
 * carried fish to falling fish. */
#include "core/game/control/controller.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "core/poi/catch/capture.h"
#include "core/poi/pose.h"

/* Deceleration at which a fish on level paper does not slide. */
#define COAST_M_S2 2.0f
#define THROW_M_S_MAX 0.3f /* Highest speed of a released fish, so that the fish is not thrown. */
#define COAST_LAG_S 0.025f /* Time by which the ring lags behind its target position in air. */
#define COAST_DONE_M_S 0.15f
/* Highest upward speed that half-wet paper of grade 7 withstands broadside (test_failsafe). */
#define RISE_M_S 0.08f
#define TURN_RAD_S 1.5f
#define SLANT_RAD (45.0f * F_DEG)
#define SLANT_NEAR_RAD (10.0f * F_DEG) /* Tilt at which the upward motion starts. */
/* Speed of a returning poi above the water. At this speed the poi moves from the bowl to the far
 * corner within a second. */
#define BACK_DRY_M_S 1.0f
/* Downward speed of a returning poi in the water. The paper withstands this speed even
 * broadside. */
#define BACK_WET_M_S 0.10f
#define WET_BELOW_M 0.035f /* Height below which part of a tilted ring may be under water. */
#define BACK_TURN_RAD_S 4.0f
/* Fraction of the remaining distance that a returning poi moves per tick. The poi therefore slows
 * down near its goal. */
#define BACK_SHARE 0.08f
/* Increase of the speed factor for each second after the damage immunity ends. */
#define BACK_HASTE_PER_S 5.0f
/* Increase of BACK_SHARE for each second after the damage immunity ends. */
#define BACK_SHARE_PER_S 0.5f
/* Distance to the controller's pose at which a return is complete. The spring between pose and poi
 * covers this distance without an impact. */
#define BACK_NEAR_M 0.006f
#define BACK_NEAR_RAD 0.02f
/* Horizontal distance to the controller's pose above which a returning poi leaves the water before
 * it moves sideways. */
#define BACK_FAR_M 0.15f
/* Horizontal distance to the controller's pose within which a returning poi may move down. */
#define BACK_ASIDE_M 0.03f

struct poi_target failsafe_begin(const struct poi *poi, struct poi_target hand)
{
    CORE_ASSERT(v3_is_finite(poi->position_m));
    hand.position_m = poi->position_m;
    hand.angles = poi->tip > 0.0f ? hand.angles : poi->angles;
    return hand;
}

/* Moves a poi without fish out of the water along its own plane. For a tilted ring the higher edge
 * leaves the water first. For a level ring, the edge nearer to the middle of the tank leaves the
 * water first. */
static struct poi_target slip_out(struct poi_target hand)
{
    const float pitch_rad = hand.angles.pitch_rad;
    const int is_tilted = f_abs(pitch_rad) > SLANT_NEAR_RAD;
    const float middle = hand.position_m.z * f_cos(hand.angles.yaw_rad);
    /* 1 means that the far edge leaves the water first, -1 the near edge. */
    const float edge = (is_tilted ? pitch_rad > 0.0f : middle >= 0.0f) ? 1.0f : -1.0f;
    const struct angles goal = { hand.angles.yaw_rad, edge * SLANT_RAD, 0.0f };
    hand.angles = pose_toward(hand.angles, goal, 1.0f, TURN_RAD_S * CORE_TICK_S);
    if (f_abs(hand.angles.pitch_rad - goal.pitch_rad) < SLANT_NEAR_RAD) {
        const vec3 back = vec_basis_from_angles(hand.angles).back;
        hand.position_m = v3_muladd(hand.position_m, back, -edge * RISE_M_S * CORE_TICK_S);
    }
    return hand;
}

struct poi_target failsafe_withdraw(const struct poi *poi, struct poi_target hand)
{
    const float speed_m_s = v3_length(poi->velocity_m_s);
    CORE_ASSERT(v3_is_finite(hand.position_m) && f_is_finite(speed_m_s));
    if (speed_m_s > COAST_DONE_M_S) {
        const vec3 next = v3_limit(poi->velocity_m_s, speed_m_s - COAST_M_S2 * CORE_TICK_S);
        hand.position_m = v3_muladd(poi->position_m, next, COAST_LAG_S + CORE_TICK_S);
        return hand;
    }
    if (poi->immersed > 0.0f && hand.position_m.y < FAILSAFE_HOVER_M && poi->carried_count == 0) {
        return slip_out(hand);
    }
    const struct angles level = { hand.angles.yaw_rad, 0.0f, 0.0f };
    const float high_m = f_max(hand.position_m.y, FAILSAFE_HOVER_M);
    const float step_m = RISE_M_S * CORE_TICK_S;
    hand.angles = pose_toward(hand.angles, level, 1.0f, TURN_RAD_S * CORE_TICK_S);
    hand.position_m.y += f_clamp(high_m - hand.position_m.y, -step_m, step_m);
    return hand;
}

/* On a long path the poi first leaves the water, then moves above the goal, and then moves down.
 * After the immunity ends the poi moves faster, so that the return always completes. */
struct poi_target failsafe_return(struct poi_target hand, struct poi_target wanted, uint32_t ticks)
{
    const float age = f_min((float)ticks / (float)FAILSAFE_RETURN_TICKS_MIN, 1.0f);
    const float late_s = ticks > FAILSAFE_IMMUNITY_TICKS_MAX
                             ? (float)(ticks - FAILSAFE_IMMUNITY_TICKS_MAX) * CORE_TICK_S
                             : 0.0f;
    const float share = age * age * f_min(BACK_SHARE + BACK_SHARE_PER_S * late_s, 1.0f);
    vec3 way_m = v3_sub(wanted.position_m, hand.position_m); /* Next part of the path. */
    const float aside_m = f_sqrt(way_m.x * way_m.x + way_m.z * way_m.z);
    const int is_low = hand.position_m.y < WET_BELOW_M;
    CORE_ASSERT(v3_is_finite(way_m));
    if (is_low && aside_m > BACK_FAR_M) {
        way_m = v3(0.0f, FAILSAFE_HOVER_M - hand.position_m.y, 0.0f);
    } else if (!is_low && aside_m > BACK_ASIDE_M && way_m.y < 0.0f) {
        way_m.y = 0.0f;
    }
    const int is_wet = is_low || way_m.y < 0.0f;
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
    CORE_ASSERT(v3_is_finite(hand.position_m) && v3_is_finite(wanted.position_m));
    const vec3 way_m = v3_sub(wanted.position_m, hand.position_m);
    const float turn_rad =
        f_max(f_abs(f_wrap_angle(wanted.angles.yaw_rad - hand.angles.yaw_rad)),
              f_max(f_abs(f_wrap_angle(wanted.angles.pitch_rad - hand.angles.pitch_rad)),
                    f_abs(f_wrap_angle(wanted.angles.roll_rad - hand.angles.roll_rad))));
    const int is_near = v3_length(way_m) < BACK_NEAR_M && turn_rad < BACK_NEAR_RAD;
    return ticks >= FAILSAFE_RETURN_TICKS_MIN && is_near;
}

/* ---- Release of fish ------------------------------------------------------------------------- */

void failsafe_release_all(struct poi *poi, const struct tank *tank)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        struct carried_fish *carried = &poi->carried_fish[i];
        if (carried->state == CARRIED_LYING) {
            const vec3 velocity_m_s = tank->fish[carried->fish].velocity_m_s;
            catch_fall_begin(carried, v3_limit(velocity_m_s, THROW_M_S_MAX));
        }
        carried->state = CARRIED_RELEASED;
    }
    poi->carried_kg = 0.0f;
    poi->load_count = 0;
}

static int is_fish_held_by(const struct fish *fish, uint32_t poi_index)
{
    return fish->gait == GAIT_HELD && fish->holder == poi_index;
}

void failsafe_release_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall,
                           struct catch_result results[POI_MAX])
{
    CORE_ASSERT(poi_index < POI_MAX);
    struct tank *tank = stall->tank;
    uint32_t i = 0;
    failsafe_release_all(poi, tank);
    while (i < poi->carried_count) {
        struct carried_fish *carried = &poi->carried_fish[i];
        const int is_ours = is_fish_held_by(&tank->fish[carried->fish], poi_index);
        uint32_t bowl = 0;
        const enum fall_end end =
            is_ours ? catch_fall_tick(carried, stall, &bowl) : FALL_INTO_WATER;
        if (end == FALL_INTO_BOWL) {
            catch_count(carried, poi_index, bowl, results);
        }
        if (end == FALL_GOES_ON) {
            i++;
        } else {
            poi->carried_count--;
            *carried = poi->carried_fish[poi->carried_count];
        }
    }
    /* Fish that are marked as held but are missing in the poi's list are set free, because no other
     * code would let them fall. */
    for (uint32_t fish = 0; fish < tank->fish_count; fish++) {
        if (is_fish_held_by(&tank->fish[fish], poi_index) && !catch_has_carried(poi, fish)) {
            catch_set_free(tank, &tank->fish[fish], v3(0.0f, 0.0f, 0.0f));
        }
    }
}
