/* calibration.c -- computes the affine map by least squares, and applies the map to a pose. */
#include "core/game/control/calibration.h"

#include "core/base/fmath.h"
#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/control/input_validation.h"

#define MILLION 1000000.0f

_Static_assert(SET_CALIBRATION_END == SET_CALIBRATION + CALIBRATION_VALUES * (int)POI_MAX,
               "each value of each seat has its setting");

vec3 calibration_mark(vec3 tank_size_m, uint32_t corner)
{
    static const int8_t side[CALIBRATE_CORNERS][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    CORE_ASSERT(corner < CALIBRATE_CORNERS);
    return v3((float)side[corner][0] * (0.5f * tank_size_m.x - CALIBRATE_INSET_M), 0.0f,
              (float)side[corner][1] * (0.5f * tank_size_m.z - CALIBRATE_INSET_M));
}

/* ---- Checks of the corners ------------------------------------------------------------------ */

/* Sine of three degrees. If the direction changes by a smaller angle at a corner, three corners are
 * nearly on one line, and the calibration across that line cannot be computed. */
#define STRAIGHT_SIN 0.05f

/* Checks the shape of the measured corners. The sine of the change of direction at each corner is
 * computed, seen from above. If all four values have the same sign, the corners form a convex
 * quadrilateral. */
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

/* ---- Affine map ------------------------------------------------------------------------------ */

struct map {
    float xx, xz, x0, zx, zz, z0;
};

static vec3 map_point(const struct map *map, vec3 at_m)
{
    return v3(map->xx * at_m.x + map->xz * at_m.z + map->x0, at_m.y,
              map->zx * at_m.x + map->zz * at_m.z + map->z0);
}

/* Fits the map by the normal equations, which have a solution because the corners surround their
 * centre. The sums are relative to the centre, because float sums far from the origin would lose
 * the last millimetre. */
static struct map fit_corner_map(const vec3 *said_m, const vec3 *mark_m)
{
    vec3 from_m = v3(0.0f, 0.0f, 0.0f), to_m = v3(0.0f, 0.0f, 0.0f);
    float pxx = 0.0f, pxz = 0.0f, pzz = 0.0f, qxx = 0.0f, qxz = 0.0f, qzx = 0.0f, qzz = 0.0f;
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        from_m = v3_add(from_m, said_m[i]);
        to_m = v3_add(to_m, mark_m[i]);
    }
    from_m = v3_scale(from_m, 1.0f / (float)CALIBRATE_CORNERS);
    to_m = v3_scale(to_m, 1.0f / (float)CALIBRATE_CORNERS);
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const vec3 p = v3_sub(said_m[i], from_m), q = v3_sub(mark_m[i], to_m);
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

enum calibration_fault calibration_solve(const struct calibration_said *said, vec3 tank_size_m,
                                         int32_t out[CALIBRATION_VALUES])
{
    vec3 mark_m[CALIBRATE_CORNERS];
    const enum calibration_fault shape = shape_of(said->corner_m);
    if (shape != CALIBRATION_GOOD) {
        return shape;
    }
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        mark_m[i] = calibration_mark(tank_size_m, i);
    }
    const struct map map = fit_corner_map(said->corner_m, mark_m);
    const float pitch = said->has_wrist ? -f_wrap_angle(said->water.angles.pitch_rad) : 0.0f;
    const float roll = said->has_wrist ? -f_wrap_angle(said->water.angles.roll_rad) : 0.0f;
    const float value[CALIBRATION_VALUES] = {
        map.xx - 1.0f, map.xz, map.x0, map.zx, map.zz - 1.0f, map.z0, -said->water.position_m.y,
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
        const vec3 off_m = v3_sub(map_point(&map, said->corner_m[i]), mark_m[i]);
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

/* ---- Correction of a pose ------------------------------------------------------------------- */

/* If the settings are a mixture of old and new values, the check value still matches with a
 * probability of one in ten million. */
int32_t calibration_check(const int32_t value[CALIBRATION_VALUES])
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

static int32_t check_of(const struct settings *settings, uint32_t seat)
{
    CORE_ASSERT(seat < POI_MAX);
    return calibration_check(&settings->value[calibration_setting(seat)]);
}

int calibration_is_set(const struct settings *settings, uint32_t seat)
{
    const int32_t check = check_of(settings, seat);
    return check != 0 && check == settings->value[calibration_check_setting(seat)];
}

int calibration_is_torn(const struct settings *settings, uint32_t seat)
{
    const int32_t check = check_of(settings, seat);
    return check != 0 && check != settings->value[calibration_check_setting(seat)];
}

static float value_from_millionths(const int32_t *value, enum calibration_value which)
{
    CORE_ASSERT(which < CALIBRATION_VALUES);
    return (float)value[which] / MILLION;
}

void calibration_apply(const struct settings *settings, uint32_t seat, struct poi_input *poi)
{
    if (poi->link != POI_SOURCE_LIVE || !calibration_is_set(settings, seat) ||
        !input_pose_is_finite(&poi->target)) {
        return;
    }
    struct angles *angles = &poi->target.angles;
    const int32_t *value = &settings->value[calibration_setting(seat)];
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
    /* The handle's direction rotates with x and z. Yaw 0 points along -z. */
    const vec3 ahead = v3(-f_sin(angles->yaw_rad), 0.0f, -f_cos(angles->yaw_rad));
    const struct map turn = { map.xx, map.xz, 0.0f, map.zx, map.zz, 0.0f };
    const vec3 there = map_point(&turn, ahead);
    angles->yaw_rad = f_atan2(-there.x, -there.z);
    angles->pitch_rad += value_from_millionths(value, CALIBRATION_PITCH);
    angles->roll_rad += value_from_millionths(value, CALIBRATION_ROLL);
}
