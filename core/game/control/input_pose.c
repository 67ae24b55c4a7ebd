/* input_pose.c -- detects invalid or lost input, computes the calibration by least squares, and
 * applies the calibration to a pose. */
#include "core/game/control/input_pose.h"

#include "core/base/fmath.h"
#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/poi/pose.h"

/* Distance beyond the speed limit of an arm that the jump test tolerates, because reports arrive at
 * uneven intervals. A motion at 3 m/s with one missing report exceeds the limit by 3.4 cm. */
#define ARM_LEAP_M 0.035f
#define POINTER_LEAP_M 0.30f
/* Highest rotation rate that the jump test accepts, as the distance per second that the tip of a
 * unit axis of the pose moves (input_turn()). The rate equals rad/s for small rotations. */
#define WRIST_PER_S 40.0f
/* Rotation beyond the rate WRIST_PER_S that the jump test tolerates. WRIST_PER_S and LEAP_TURN
 * together permit a rotation of 36 degrees in one tick. */
#define LEAP_TURN 0.3f
#define CREDIT_KEEP 0.95f

static bool is_within_limit(float value, float limit)
{
    CORE_ASSERT(limit > 0.0f);
    return f_is_finite(value) && f_abs(value) <= limit;
}

bool input_pose_is_finite(const struct poi_target *target)
{
    return is_within_limit(target->position_m.x, INPUT_RANGE_M_MAX) &&
           is_within_limit(target->position_m.y, INPUT_RANGE_M_MAX) &&
           is_within_limit(target->position_m.z, INPUT_RANGE_M_MAX) &&
           is_within_limit(target->angles.yaw_rad, INPUT_ANGLE_RAD_MAX) &&
           is_within_limit(target->angles.pitch_rad, INPUT_ANGLE_RAD_MAX) &&
           is_within_limit(target->angles.roll_rad, INPUT_ANGLE_RAD_MAX);
}

float input_turn(struct angles from, struct angles to)
{
    const struct basis a = vec_basis_from_angles(from), b = vec_basis_from_angles(to);
    return f_max(v3_length(v3_sub(a.up, b.up)), v3_length(v3_sub(a.back, b.back)));
}

bool input_pose_is_jump(const struct poi_target *from, const struct poi_target *to, float seconds,
                        bool has_wrist)
{
    CORE_ASSERT(seconds >= 0.0f);
    const float pace_m_s = has_wrist ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX;
    const float way_m = v3_length(v3_sub(to->position_m, from->position_m));
    return way_m > pace_m_s * seconds + (has_wrist ? ARM_LEAP_M : POINTER_LEAP_M) ||
           input_turn(from->angles, to->angles) > WRIST_PER_S * seconds + LEAP_TURN;
}

struct poi_target input_pose_between(const struct poi_target *from, const struct poi_target *to,
                                     float share, float seconds, bool has_wrist)
{
    CORE_ASSERT(share >= 0.0f && share <= 1.0f);
    if (!input_pose_is_finite(from)) {
        return *to;
    }
    if (!input_pose_is_finite(to) || input_pose_is_jump(from, to, seconds, has_wrist)) {
        return share < 1.0f ? *from : *to;
    }
    return pose_between(*from, *to, share);
}

/* Returns the new sum of excess motion, which is motion beyond the speed limit. `before` is the sum
 * of the last tick, `step` the motion of this tick, and `free` the motion that is allowed per tick.
 * A negative sum is a credit of motion for ticks without reports. The credit decays by the factor
 * CREDIT_KEEP per tick. */
static float excess_motion_sum(float before, float step, float free)
{
    CORE_ASSERT(free >= 0.0f);
    const float sum = before + step - free;
    return sum >= 0.0f ? sum : CREDIT_KEEP * f_min(before + step, 0.0f);
}

/* Updates the sums of excess motion and rotation. Returns true if the pose of a controller with
 * rotation jumps. */
static bool detect_pose_jump(struct input_validation *validation, const struct poi_input *input)
{
    CORE_ASSERT(validation->has_newest);
    const float pace = input->has_wrist ? INPUT_ARM_M_S_MAX : INPUT_POINTER_M_S_MAX;
    const float leap_m = input->has_wrist ? ARM_LEAP_M : POINTER_LEAP_M;
    const float unseen_s = (float)validation->silent_ticks * CORE_TICK_S;
    const vec3 way_m = v3_sub(input->target.position_m, validation->newest.position_m);
    const float turn = input_turn(validation->newest.angles, input->target.angles);
    if (unseen_s > 0.0f) {
        validation->excess_m = f_min(validation->excess_m, -pace * unseen_s);
        validation->spin = f_min(validation->spin, -WRIST_PER_S * unseen_s);
    }
    validation->excess_m =
        excess_motion_sum(validation->excess_m, v3_length(way_m), pace * CORE_TICK_S);
    validation->spin = excess_motion_sum(validation->spin, turn, WRIST_PER_S * CORE_TICK_S);
    const bool is_jump = validation->excess_m > leap_m || validation->spin > LEAP_TURN;
    if (is_jump) {
        /* After a jump, reset both sums, because the sensor may stay at the new pose. */
        validation->excess_m = validation->spin = 0.0f;
    }
    return is_jump && input->has_wrist;
}

static uint16_t next_count(bool continues, uint16_t count, uint16_t most)
{
    return !continues ? 0u : count < most ? (uint16_t)(count + 1u) : most;
}

/* Returns true if the current input is consistent with the earlier input. The tests for a frozen
 * sensor and for a jump both run in every tick, because each test updates counters. */
static bool is_consistent(struct input_validation *validation, const struct poi_input *input)
{
    bool is_sane = true;
    if (input->link != POI_SOURCE_LIVE || !input_pose_is_finite(&input->target)) {
        return false;
    }
    if (validation->has_newest) {
        const bool same = memcmp(&validation->newest, &input->target, sizeof input->target) == 0;
        validation->same_ticks = next_count(same, validation->same_ticks, UINT16_MAX);
        is_sane = !detect_pose_jump(validation, input) &&
                  !(input->trembles && validation->same_ticks > INPUT_STUCK_TICKS);
    }
    validation->has_newest = 1;
    validation->newest = input->target;
    return is_sane && input->age_ticks <= INPUT_SILENT_TICKS;
}

float input_validation_blend(const struct input_validation *validation)
{
    return validation->late_ticks > 1 ? 1.0f / (float)validation->late_ticks : 1.0f;
}

/* Validates one tick's input of a controller. After late reports, the poi catches up with the
 * missed motion in three quarters of the missed time. The poi then follows a straight line, which
 * is shorter than the actual path of the controller. In the full time, the poi would therefore be
 * slower than the controller, and late reports would reduce the wear of the paper. */
enum input_status input_validation_tick(struct input_validation *validation,
                                        const struct poi_input *input)
{
    if (input->link == POI_SOURCE_ABSENT || input->link == POI_SOURCE_BOT) {
        *validation = (struct input_validation){ .verdict = INPUT_ABSENT };
        return INPUT_ABSENT;
    }
    /* If the motion was not observed for a while (`has_gap`), treat the reports as missing for the
     * longest allowed time. */
    validation->silent_ticks = input->has_gap ? INPUT_SILENT_TICKS : validation->silent_ticks;
    const bool was_lost = validation->verdict == INPUT_LOST;
    const uint16_t before = validation->silent_ticks;
    const bool agreed = is_consistent(validation, input);
    if (input->has_gap || (input->age_ticks < before && before <= INPUT_SILENT_TICKS)) {
        validation->late_ticks = (uint16_t)(3u * (before + 1u) / 4u);
    } else if (validation->late_ticks > 0) {
        validation->late_ticks--;
    }
    validation->silent_ticks = input->age_ticks >= INPUT_LATE_TICKS ? input->age_ticks : 0u;
    validation->agree_ticks = next_count(agreed, validation->agree_ticks, INPUT_AGREE_TICKS);
    const bool lost = !agreed || (was_lost && validation->agree_ticks < INPUT_AGREE_TICKS);
    validation->verdict = lost ? INPUT_LOST : INPUT_VALID;
    CORE_ASSERT(lost || validation->has_newest);
    return (enum input_status)validation->verdict;
}

/* ---- Calibration ----------------------------------------------------------------------------- */

#define MILLION 1000000.0f

_Static_assert(SET_CALIBRATION_END == SET_CALIBRATION + CALIBRATION_VALUES * (int)POI_MAX,
               "each value of each slot has its setting");

vec3 input_calibration_mark(vec3 tank_size_m, uint32_t corner)
{
    static const int8_t side[CALIBRATE_CORNERS][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    CORE_ASSERT(corner < CALIBRATE_CORNERS);
    return v3((float)side[corner][0] * (0.5f * tank_size_m.x - CALIBRATE_INSET_M), 0.0f,
              (float)side[corner][1] * (0.5f * tank_size_m.z - CALIBRATE_INSET_M));
}

/* ---- Checks of the corners measured for a calibration ---------------------------------------- */

/* Sine of three degrees. If the direction changes by a smaller angle at a corner, three corners are
 * nearly on one line, and the calibration across that line cannot be computed. */
#define STRAIGHT_SIN 0.05f

/* Returns CALIBRATION_GOOD if the measured corners form a convex quadrilateral, otherwise the
 * fault. The function computes the sine of the change of direction at each corner, seen from above.
 * If all four sines have the same sign, the quadrilateral is convex. */
static enum calibration_fault shape_of(const vec3 *corner_m)
{
    uint32_t right = 0, wrong = 0;
    float least_m = 2.0f * CALIBRATE_NEAR_M;
    for (uint32_t a = 0; a < CALIBRATE_CORNERS; a++) {
        for (uint32_t b = a + 1u; b < CALIBRATE_CORNERS; b++) {
            const vec3 way_m = v3_sub(corner_m[b], corner_m[a]);
            least_m = f_min(least_m, v3_length(v3(way_m.x, 0.0f, way_m.z)));
        }
    }
    if (least_m < CALIBRATE_NEAR_M) {
        return CALIBRATION_NEAR;
    }
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const vec3 from_m = v3_sub(corner_m[i], corner_m[(i + 3u) % CALIBRATE_CORNERS]);
        const vec3 to_m = v3_sub(corner_m[(i + 1u) % CALIBRATE_CORNERS], corner_m[i]);
        const float lengths = f_sqrt((from_m.x * from_m.x + from_m.z * from_m.z) *
                                     (to_m.x * to_m.x + to_m.z * to_m.z));
        const float turn = (from_m.x * to_m.z - from_m.z * to_m.x) / lengths;
        right += turn > STRAIGHT_SIN;
        wrong += turn < -STRAIGHT_SIN;
    }
    return right == CALIBRATE_CORNERS   ? CALIBRATION_GOOD
           : wrong == CALIBRATE_CORNERS ? CALIBRATION_MIRRORED
                                        : CALIBRATION_CROSSED;
}

/* ---- Affine map from the measured corners to the marks --------------------------------------- */

struct map {
    float xx, xz, x0, zx, zz, z0;
};

static vec3 map_point(const struct map *map, vec3 at_m)
{
    return v3(map->xx * at_m.x + map->xz * at_m.z + map->x0, at_m.y,
              map->zx * at_m.x + map->zz * at_m.z + map->z0);
}

/* Computes the map from the measured corners to the marks by least squares. The normal equations
 * have a solution because the corners surround their centre. The sums are relative to the centre,
 * because float sums far from the origin would lose the last millimetre. */
static struct map fit_corner_map(const vec3 *sampled_m, const vec3 *mark_m)
{
    vec3 from_m = v3(0.0f, 0.0f, 0.0f), to_m = v3(0.0f, 0.0f, 0.0f);
    float pxx = 0.0f, pxz = 0.0f, pzz = 0.0f, qxx = 0.0f, qxz = 0.0f, qzx = 0.0f, qzz = 0.0f;
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        from_m = v3_add(from_m, sampled_m[i]);
        to_m = v3_add(to_m, mark_m[i]);
    }
    from_m = v3_scale(from_m, 1.0f / (float)CALIBRATE_CORNERS);
    to_m = v3_scale(to_m, 1.0f / (float)CALIBRATE_CORNERS);
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const vec3 p = v3_sub(sampled_m[i], from_m), q = v3_sub(mark_m[i], to_m);
        pxx += p.x * p.x;
        pxz += p.x * p.z;
        pzz += p.z * p.z;
        qxx += q.x * p.x;
        qxz += q.x * p.z;
        qzx += q.z * p.x;
        qzz += q.z * p.z;
    }
    const float whole = pxx * pzz - pxz * pxz;
    struct map map = {
        .xx = (qxx * pzz - qxz * pxz) / whole,
        .xz = (qxz * pxx - qxx * pxz) / whole,
        .zx = (qzx * pzz - qzz * pxz) / whole,
        .zz = (qzz * pxx - qzx * pxz) / whole,
    };
    const vec3 moved_m = map_point(&map, from_m);
    map.x0 = to_m.x - moved_m.x;
    map.z0 = to_m.z - moved_m.z;
    return map;
}

enum calibration_fault input_calibration_solve(const struct calibration_sample *sample,
                                               vec3 tank_size_m, int32_t out[CALIBRATION_VALUES])
{
    vec3 mark_m[CALIBRATE_CORNERS];
    const enum calibration_fault shape = shape_of(sample->corner_m);
    if (shape != CALIBRATION_GOOD) {
        return shape;
    }
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        mark_m[i] = input_calibration_mark(tank_size_m, i);
    }
    const struct map map = fit_corner_map(sample->corner_m, mark_m);
    const float pitch = sample->has_wrist ? -f_wrap_angle(sample->water.angles.pitch_rad) : 0.0f;
    const float roll = sample->has_wrist ? -f_wrap_angle(sample->water.angles.roll_rad) : 0.0f;
    const float value[CALIBRATION_VALUES] = {
        map.xx - 1.0f, map.xz, map.x0, map.zx, map.zz - 1.0f, map.z0, -sample->water.position_m.y,
        pitch,         roll
    };
    const float most = (float)settings_entry(SET_CALIBRATION)->max / MILLION;
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        if (!f_is_finite(value[i]) || f_abs(value[i]) > most) {
            return CALIBRATION_FAR;
        }
    }
    float sum_m2 = 0.0f; /* Sum of the squared distances of the mapped corners from their marks. */
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const vec3 off_m = v3_sub(map_point(&map, sample->corner_m[i]), mark_m[i]);
        sum_m2 += off_m.x * off_m.x + off_m.z * off_m.z;
    }
    if (f_sqrt(sum_m2 / (float)CALIBRATE_CORNERS) > CALIBRATE_RESIDUAL_M) {
        return CALIBRATION_UNEVEN;
    }
    if (f_max(f_abs(pitch), f_abs(roll)) > CALIBRATE_TILT_RAD) {
        return CALIBRATION_TILTED;
    }
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        out[i] = (int32_t)f_floor(value[i] * MILLION + 0.5f);
    }
    return CALIBRATION_GOOD;
}

/* ---- Correction of a pose by the calibration ------------------------------------------------- */

/* Returns the check value, which is a hash of the calibration values. If the settings are a mixture
 * of old and new values, the check value still matches with a probability of one in ten million. */
int32_t input_calibration_check(const int32_t value[CALIBRATION_VALUES])
{
    const uint64_t most = (uint64_t)settings_entry(SET_CALIBRATION_CHECK)->max;
    uint64_t hash = HASH_START;
    int32_t any = 0;
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        hash = hash_u32(hash, (uint32_t)value[i]);
        any |= value[i];
    }
    return any != 0 ? 1 + (int32_t)(hash % most) : 0;
}

static int32_t check_of(const struct settings *settings, uint32_t slot)
{
    CORE_ASSERT(slot < POI_MAX);
    return input_calibration_check(&settings->value[input_calibration_setting(slot)]);
}

bool input_calibration_is_set(const struct settings *settings, uint32_t slot)
{
    const int32_t check = check_of(settings, slot);
    return check != 0 && check == settings->value[input_calibration_check_setting(slot)];
}

bool input_calibration_is_torn(const struct settings *settings, uint32_t slot)
{
    const int32_t check = check_of(settings, slot);
    return check != 0 && check != settings->value[input_calibration_check_setting(slot)];
}

static float value_from_millionths(const int32_t *value, enum calibration_value which)
{
    CORE_ASSERT(which < CALIBRATION_VALUES);
    return (float)value[which] / MILLION;
}

void input_calibration_apply(const struct settings *settings, uint32_t slot, struct poi_input *poi)
{
    if (poi->link != POI_SOURCE_LIVE || !input_calibration_is_set(settings, slot) ||
        !input_pose_is_finite(&poi->target)) {
        return;
    }
    struct angles *angles = &poi->target.angles;
    const int32_t *value = &settings->value[input_calibration_setting(slot)];
    const struct map map = {
        1.0f + value_from_millionths(value, CALIBRATION_XX),
        value_from_millionths(value, CALIBRATION_XZ),
        value_from_millionths(value, CALIBRATION_X0),
        value_from_millionths(value, CALIBRATION_ZX),
        1.0f + value_from_millionths(value, CALIBRATION_ZZ),
        value_from_millionths(value, CALIBRATION_Z0),
    };
    poi->target.position_m = map_point(&map, poi->target.position_m);
    poi->target.position_m.y += value_from_millionths(value, CALIBRATION_Y0);
    /* Apply the x and z part of the calibration map to the direction of the poi's handle too. Yaw 0
     * points along -z. */
    const vec3 ahead = v3(-f_sin(angles->yaw_rad), 0.0f, -f_cos(angles->yaw_rad));
    const struct map turn = { map.xx, map.xz, 0.0f, map.zx, map.zz, 0.0f };
    const vec3 there = map_point(&turn, ahead);
    angles->yaw_rad = f_atan2(-there.x, -there.z);
    angles->pitch_rad += value_from_millionths(value, CALIBRATION_PITCH);
    angles->roll_rad += value_from_millionths(value, CALIBRATION_ROLL);
}
