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

static int are_near(const vec3 *corner_m)
{
    float least_m = 2.0f * CALIBRATE_NEAR_M;
    for (uint32_t a = 0; a < CALIBRATE_CORNERS; a++) {
        for (uint32_t b = a + 1u; b < CALIBRATE_CORNERS; b++) {
            const vec3 way_m = v3_sub(corner_m[b], corner_m[a]);
            least_m = f_min(least_m, v3_length(v3(way_m.x, 0.0f, way_m.z)));
        }
    }
    return least_m < CALIBRATE_NEAR_M;
}

/* Returns the sine of the change of direction at a corner, seen from above. If all four values have
 * the same sign, the corners form a convex quadrilateral. */
static float turn_at(const vec3 *corner_m, uint32_t corner)
{
    const vec3 here_m = corner_m[corner];
    const vec3 from_m = v3_sub(here_m, corner_m[(corner + 3u) % CALIBRATE_CORNERS]);
    const vec3 to_m = v3_sub(corner_m[(corner + 1u) % CALIBRATE_CORNERS], here_m);
    const float lengths =
        f_sqrt((from_m.x * from_m.x + from_m.z * from_m.z) * (to_m.x * to_m.x + to_m.z * to_m.z));
    return (from_m.x * to_m.z - from_m.z * to_m.x) / lengths;
}

/* Sine of three degrees. If the change of direction is smaller, three corners are nearly on one
 * line, and the map across that line is undetermined. */
#define STRAIGHT_SIN 0.05f

static enum calibration_fault shape_of(const vec3 *corner_m)
{
    uint32_t right = 0, wrong = 0;
    if (are_near(corner_m)) {
        return CALIBRATION_NEAR;
    }
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const float turn = turn_at(corner_m, i);
        right += turn > STRAIGHT_SIN;
        wrong += turn < -STRAIGHT_SIN;
    }
    return right == CALIBRATE_CORNERS   ? CALIBRATION_GOOD
           : wrong == CALIBRATE_CORNERS ? CALIBRATION_MIRRORED
                                        : CALIBRATION_CROSSED;
}

/* ---- Affine map
 * ------------------------------------------------------------------------------- */

struct map {
    float xx, xz, x0, zx, zz, z0;
};

static vec3 map_point(const struct map *map, vec3 at_m)
{
    return v3(map->xx * at_m.x + map->xz * at_m.z + map->x0, at_m.y,
              map->zx * at_m.x + map->zz * at_m.z + map->z0);
}

static vec3 middle_of(const vec3 *corner_m)
{
    vec3 sum_m = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        sum_m = v3_add(sum_m, corner_m[i]);
    }
    return v3_scale(sum_m, 1.0f / (float)CALIBRATE_CORNERS);
}

/* Fits the map by the normal equations, which have a solution because the corners surround their
 * centre. The sums are relative to the centre, because float sums far from the origin would lose
 * the last millimetre. */
static struct map fit(const vec3 *said_m, const vec3 *mark_m)
{
    const vec3 from_m = middle_of(said_m), to_m = middle_of(mark_m);
    float pxx = 0.0f, pxz = 0.0f, pzz = 0.0f, qxx = 0.0f, qxz = 0.0f, qzx = 0.0f, qzz = 0.0f;
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

static float residual_m(const struct map *map, const vec3 *said_m, const vec3 *mark_m)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const vec3 off_m = v3_sub(map_point(map, said_m[i]), mark_m[i]);
        sum += off_m.x * off_m.x + off_m.z * off_m.z;
    }
    return f_sqrt(sum / (float)CALIBRATE_CORNERS);
}

static int32_t millionths(float value)
{
    return (int32_t)f_floor(value * MILLION + 0.5f);
}

static int can_hold(const float value[CALIBRATION_VALUES])
{
    const float most = (float)settings_entry(SET_CALIBRATION)->max / MILLION;
    int good = 1;
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        good &= f_is_finite(value[i]) && f_abs(value[i]) <= most;
    }
    return good;
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
    const struct map map = fit(said->corner_m, mark_m);
    const float pitch = said->has_wrist ? -f_wrap_angle(said->water.angles.pitch_rad) : 0.0f;
    const float roll = said->has_wrist ? -f_wrap_angle(said->water.angles.roll_rad) : 0.0f;
    const float value[CALIBRATION_VALUES] = {
        map.xx - 1.0f, map.xz, map.x0, map.zx, map.zz - 1.0f, map.z0, -said->water.position_m.y,
        pitch,         roll
    };
    if (!can_hold(value)) {
        return CALIBRATION_FAR;
    }
    if (residual_m(&map, said->corner_m, mark_m) > CALIBRATE_RESIDUAL_M) {
        return CALIBRATION_UNEVEN;
    }
    if (f_max(f_abs(pitch), f_abs(roll)) > CALIBRATE_TILT_RAD) {
        return CALIBRATION_TILTED;
    }
    for (uint32_t i = 0; i < CALIBRATION_VALUES; i++) {
        out[i] = millionths(value[i]);
    }
    return CALIBRATION_GOOD;
}

/* ---- Correction of a pose ------------------------------------------------------------------- */

/* A mixture of old and new settings has a matching check value with a probability of one in ten
 * million. */
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

static float whole(const int32_t *value, enum calibration_value which)
{
    return (float)value[which] / MILLION;
}

/* Returns the yaw of the handle's corrected direction. Yaw 0 points along -z. */
static float turned_yaw(const struct map *map, float yaw_rad)
{
    const vec3 ahead = v3(-f_sin(yaw_rad), 0.0f, -f_cos(yaw_rad));
    const struct map turn = { map->xx, map->xz, 0.0f, map->zx, map->zz, 0.0f };
    const vec3 there = map_point(&turn, ahead);
    return f_atan2(-there.x, -there.z);
}

void calibration_apply(const struct settings *settings, uint32_t seat, struct poi_input *poi)
{
    if (poi->link != POI_SOURCE_LIVE || !calibration_is_set(settings, seat) ||
        !input_pose_is_finite(&poi->target)) {
        return;
    }
    const int32_t *value = &settings->value[calibration_setting(seat)];
    const struct map map = {
        1.0f + whole(value, CALIBRATION_XX), whole(value, CALIBRATION_XZ),
        whole(value, CALIBRATION_X0),        whole(value, CALIBRATION_ZX),
        1.0f + whole(value, CALIBRATION_ZZ), whole(value, CALIBRATION_Z0),
    };
    poi->target.position_m = map_point(&map, poi->target.position_m);
    poi->target.position_m.y += whole(value, CALIBRATION_Y0);
    poi->target.angles.yaw_rad = turned_yaw(&map, poi->target.angles.yaw_rad);
    poi->target.angles.pitch_rad += whole(value, CALIBRATION_PITCH);
    poi->target.angles.roll_rad += whole(value, CALIBRATION_ROLL);
}
