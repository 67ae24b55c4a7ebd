/* poi_report.c -- encodes and decodes the reports of Kingyo's poi controller. */
#include "drivers/hid/poi_report.h"

#include "core/base/fmath.h"

#define FULL 32767.0f
#define NONE (-32768)

static void put_i16(uint8_t *bytes, int32_t value)
{
    const uint32_t bits = (uint32_t)value;
    bytes[0] = (uint8_t)(bits & 255u);
    bytes[1] = (uint8_t)(bits >> 8 & 255u);
}

static int32_t get_i16(const uint8_t *bytes)
{
    const int32_t bits = bytes[0] | bytes[1] << 8;
    return bits < 32768 ? bits : bits - 65536;
}

/* Returns `value` as a 16-bit field with the range +-`most`, or `otherwise` if it is not finite.
 * Halves are rounded away from 0, so that opposite forces have opposite encodings. */
static int32_t steps_of(float value, float most, int32_t otherwise)
{
    if (!f_is_finite(value)) {
        return otherwise;
    }
    const float steps = f_clamp(value / most, -1.0f, 1.0f) * FULL;
    return (int32_t)(steps < 0.0f ? steps - 0.5f : steps + 0.5f);
}

static void put_three(uint8_t *bytes, vec3 v, float most, int32_t otherwise)
{
    put_i16(bytes, steps_of(v.x, most, otherwise));
    put_i16(bytes + 2, steps_of(v.y, most, otherwise));
    put_i16(bytes + 4, steps_of(v.z, most, otherwise));
}

/* Decodes three 16-bit fields with the range +-`most`. Returns 0 if a field has the code for "no
 * value", otherwise 1. */
static int get_three(const uint8_t *bytes, float most, vec3 *out)
{
    const int32_t x = get_i16(bytes), y = get_i16(bytes + 2), z = get_i16(bytes + 4);
    const float step = most / FULL;
    *out = v3((float)x * step, (float)y * step, (float)z * step);
    return x != NONE && y != NONE && z != NONE;
}

static int is_report(const uint8_t *bytes, uint32_t size, uint32_t id, uint32_t id_size)
{
    return size == id_size && bytes[0] == id;
}

int poi_report_decode(const uint8_t *bytes, uint32_t size, struct poi_report *out)
{
    vec3 place_m, turn_rad;
    if (!is_report(bytes, size, POI_REPORT_ID, POI_REPORT_SIZE) ||
        !get_three(bytes + 2, POI_REPORT_REACH_M, &place_m) ||
        !get_three(bytes + 8, F_PI, &turn_rad)) {
        return 0;
    }
    *out = (struct poi_report){
        .target = { .position_m = place_m,
                    .angles = { .yaw_rad = turn_rad.y,
                                .pitch_rad = turn_rad.x,
                                .roll_rad = turn_rad.z } },
        .buttons = bytes[14],
        .sequence = bytes[1],
    };
    return 1;
}

void poi_report_encode(const struct poi_report *report, uint8_t bytes[POI_REPORT_SIZE])
{
    const struct angles angles = report->target.angles;
    bytes[0] = POI_REPORT_ID;
    bytes[1] = report->sequence;
    put_three(bytes + 2, report->target.position_m, POI_REPORT_REACH_M, NONE);
    put_three(bytes + 8, v3(angles.pitch_rad, angles.yaw_rad, angles.roll_rad), F_PI, NONE);
    bytes[14] = report->buttons;
}

static uint8_t level_of(float share)
{
    return f_is_finite(share) ? (uint8_t)(int32_t)(f_clamp(share, 0.0f, 1.0f) * 255.0f + 0.5f) : 0;
}

void poi_feel_encode(const struct poi_force *force, uint8_t sequence, uint8_t bytes[POI_FEEL_SIZE])
{
    bytes[0] = POI_FEEL_ID;
    bytes[1] = sequence;
    put_three(bytes + 2, force->force_n, POI_FORCE_N_MAX, 0);
    put_three(bytes + 8, force->torque_n_m, POI_TORQUE_N_M_MAX, 0);
    bytes[14] = level_of(force->drag);
    bytes[15] = level_of(force->slap);
    bytes[16] = level_of(force->tear);
}

int poi_feel_decode(const uint8_t *bytes, uint32_t size, struct poi_force *out, uint8_t *sequence)
{
    vec3 force_n, torque_n_m;
    if (!is_report(bytes, size, POI_FEEL_ID, POI_FEEL_SIZE) ||
        !get_three(bytes + 2, POI_FORCE_N_MAX, &force_n) ||
        !get_three(bytes + 8, POI_TORQUE_N_M_MAX, &torque_n_m)) {
        return 0;
    }
    *out = (struct poi_force){
        .force_n = force_n,
        .torque_n_m = torque_n_m,
        .drag = (float)bytes[14] / 255.0f,
        .slap = (float)bytes[15] / 255.0f,
        .tear = (float)bytes[16] / 255.0f,
    };
    if (sequence) {
        *sequence = bytes[1];
    }
    return 1;
}
