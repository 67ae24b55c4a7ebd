/* trust.c -- the checks that detect invalid or lost input. */
#include "core/game/trust.h"

#include "core/base/fmath.h"
#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/vec.h"

/* Tolerance of the jump test. Reports arrive a little unevenly: a motion at 3 m/s with one missing
 * report exceeds the limit by 3.4 cm. */
#define ARM_LEAP_M 0.035f
#define POINTER_LEAP_M 0.30f
#define WRIST_PER_S 40.0f /* Limit for the motion of the unit axes' tips per second; equals rad/s
                             for small rotations. */
#define LEAP_TURN 0.3f    /* 36 degrees in one tick. */
#define CREDIT_KEEP 0.95f

static int within(float value, float limit)
{
    return f_is_finite(value) && f_abs(value) <= limit;
}

int trust_can_read(const struct poi_target *target)
{
    return within(target->position_m.x, TRUST_RANGE_M) &&
           within(target->position_m.y, TRUST_RANGE_M) &&
           within(target->position_m.z, TRUST_RANGE_M) &&
           within(target->angles.yaw_rad, TRUST_ANGLE_RAD) &&
           within(target->angles.pitch_rad, TRUST_ANGLE_RAD) &&
           within(target->angles.roll_rad, TRUST_ANGLE_RAD);
}

float trust_turn(struct angles from, struct angles to)
{
    const struct basis a = basis_from_angles(from), b = basis_from_angles(to);
    return f_max(v3_length(v3_sub(a.up, b.up)), v3_length(v3_sub(a.back, b.back)));
}

static float pace_m_s(int has_wrist)
{
    return has_wrist ? TRUST_ARM_M_S : TRUST_POINTER_M_S;
}

static float leap_m(int has_wrist)
{
    return has_wrist ? ARM_LEAP_M : POINTER_LEAP_M;
}

int trust_is_leap(const struct poi_target *from, const struct poi_target *to, float seconds,
                  int has_wrist)
{
    const float way_m = v3_length(v3_sub(to->position_m, from->position_m));
    return way_m > pace_m_s(has_wrist) * seconds + leap_m(has_wrist) ||
           trust_turn(from->angles, to->angles) > WRIST_PER_S * seconds + LEAP_TURN;
}

/* Accumulates the motion beyond the allowed pace `free`, and reduces the sum at that pace. A
 * negative sum is an allowance for unseen motion, which decays within the frame that catches up. */
static float beyond(float before, float step, float free)
{
    const float sum = before + step - free;
    return sum >= 0.0f ? sum : CREDIT_KEEP * f_min(before + step, 0.0f);
}

static int leaps(struct trust *trust, const struct poi_input *input)
{
    const float pace = pace_m_s(input->has_wrist);
    const float unseen_s = (float)trust->silent_ticks * CORE_TICK_S;
    const vec3 way_m = v3_sub(input->target.position_m, trust->newest.position_m);
    const float turn = trust_turn(trust->newest.angles, input->target.angles);
    trust->rush_m = f_min(trust->rush_m, unseen_s > 0.0f ? -pace * unseen_s : trust->rush_m);
    trust->spin = f_min(trust->spin, unseen_s > 0.0f ? -WRIST_PER_S * unseen_s : trust->spin);
    trust->rush_m = beyond(trust->rush_m, v3_length(way_m), pace * CORE_TICK_S);
    trust->spin = beyond(trust->spin, turn, WRIST_PER_S * CORE_TICK_S);
    const int leapt = trust->rush_m > leap_m(input->has_wrist) || trust->spin > LEAP_TURN;
    if (leapt) {
        trust->rush_m = trust->spin = 0.0f; /* Restart from the new pose, in case it stays. */
    }
    return leapt && input->has_wrist;
}

static int is_stuck(struct trust *trust, const struct poi_input *input)
{
    const int same = memcmp(&trust->newest, &input->target, sizeof input->target) == 0;
    trust->same_ticks = same && trust->same_ticks < UINT16_MAX ? trust->same_ticks + 1u
                        : same                                 ? UINT16_MAX
                                                               : 0u;
    return input->trembles && trust->same_ticks > TRUST_STUCK_TICKS;
}

/* Runs both checks in every tick, because each updates counters. */
static int goes_on(struct trust *trust, const struct poi_input *input)
{
    const int stuck = is_stuck(trust, input);
    const int leapt = leaps(trust, input);
    return !stuck && !leapt;
}

/* Returns 1 if the current input is consistent with the earlier input. */
static int agrees(struct trust *trust, const struct poi_input *input)
{
    if (input->link != POI_LINK_LIVE || !trust_can_read(&input->target)) {
        return 0;
    }
    const int is_sane = !trust->knows || goes_on(trust, input);
    trust->knows = 1;
    trust->newest = input->target;
    return is_sane && input->age_ticks <= TRUST_SILENT_TICKS;
}

/* After late reports the missed motion is replayed in three quarters of its duration. Straight
 * pieces make the path shorter, so a full-time replay would be slower and wear the paper less. */
static void count_late(struct trust *trust, const struct poi_input *input)
{
    const uint16_t before = trust->silent_ticks;
    const uint16_t now = input->age_ticks >= TRUST_LATE_TICKS ? input->age_ticks : 0u;
    if (input->age_ticks < before && before <= TRUST_SILENT_TICKS) {
        trust->late_ticks = (uint16_t)(3u * (before + 1u) / 4u);
    } else if (trust->late_ticks > 0) {
        trust->late_ticks--;
    }
    trust->silent_ticks = now;
}

float trust_share(const struct trust *trust)
{
    return trust->late_ticks > 1 ? 1.0f / (float)trust->late_ticks : 1.0f;
}

enum trust_verdict trust_tick(struct trust *trust, const struct poi_input *input)
{
    if (input->link == POI_LINK_ABSENT || input->link == POI_LINK_BOT) {
        *trust = (struct trust){ .verdict = TRUST_ABSENT };
        return TRUST_ABSENT;
    }
    const int was_lost = trust->verdict == TRUST_LOST;
    const int agreed = agrees(trust, input);
    count_late(trust, input);
    trust->agree_ticks = agreed && trust->agree_ticks < TRUST_AGREE_TICKS ? trust->agree_ticks + 1u
                         : agreed                                         ? TRUST_AGREE_TICKS
                                                                          : 0u;
    const int lost = !agreed || (was_lost && trust->agree_ticks < TRUST_AGREE_TICKS);
    trust->verdict = lost ? TRUST_LOST : TRUST_BELIEVED;
    return (enum trust_verdict)trust->verdict;
}

uint64_t trust_hash(uint64_t hash, const struct trust *trust)
{
    hash = hash_u32(hash, trust->verdict);
    hash = hash_u32(hash, trust->knows);
    hash = hash_u32(hash, trust->same_ticks);
    hash = hash_u32(hash, trust->agree_ticks);
    hash = hash_u32(hash, trust->silent_ticks);
    hash = hash_u32(hash, trust->late_ticks);
    hash = hash_float(hash, trust->rush_m);
    hash = hash_float(hash, trust->spin);
    hash = hash_vec3(hash, trust->newest.position_m);
    return hash_vec3(hash, v3(trust->newest.angles.yaw_rad, trust->newest.angles.pitch_rad,
                              trust->newest.angles.roll_rad));
}
