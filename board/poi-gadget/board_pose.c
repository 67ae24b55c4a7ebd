/* board_pose.c -- computes the pose of the poi's ring. The draw wires give the position of the eye
 * (the point on the poi's neck at which the wires meet). The inertial chip gives the direction from
 * the eye to the ring. */
#include "board/poi-gadget/board_pose.h"

#include <assert.h>

#define STEADY_REST_HZ 4.0f /* Corner frequency of the position filter at rest, in Hz. */
/* Increase of the position filter's corner frequency in Hz for each m/s of speed. */
#define STEADY_HZ_PER_M_S 60.0f
#define STEADY_SPEED_HZ 6.0f /* Corner frequency of the speed filter, in Hz. */

/* Returns the weight of the new value in one step of a first-order low-pass filter. */
static float steady_share_of(float corner_hz, float seconds)
{
    const float t = F_TAU * corner_hz * seconds;
    return t / (1.0f + t);
}

/* Returns the filtered position for the unfiltered position `raw_m`. `seconds` is the time since
 * the previous call and must be above 0. The corner frequency of the position filter depends on the
 * filtered speed. */
static vec3 steady_step(struct steady *steady, vec3 raw_m, float seconds)
{
    if (!steady->begun) {
        *steady = (struct steady){ .begun = 1, .place_m = raw_m, .raw_m = raw_m };
        return raw_m;
    }
    const vec3 speed_m_s = v3_scale(v3_sub(raw_m, steady->raw_m), 1.0f / seconds);
    steady->raw_m = raw_m;
    steady->speed_m_s =
        v3_lerp(steady->speed_m_s, speed_m_s, steady_share_of(STEADY_SPEED_HZ, seconds));
    const float corner_hz = STEADY_REST_HZ + STEADY_HZ_PER_M_S * v3_length(steady->speed_m_s);
    steady->place_m = v3_lerp(steady->place_m, raw_m, steady_share_of(corner_hz, seconds));
    return steady->place_m;
}
/* Converts a rotation matrix to a quaternion. The computation divides by the largest of the four
 * components, because the largest component is never near 0 (Shepperd 1978). */
struct quaternion board_pose_quaternion_of_rows(const vec3 row[3])
{
    const float xx = row[0].x, yy = row[1].y, zz = row[2].z;
    const float four[4] = { 1.0f + xx + yy + zz, 1.0f + xx - yy - zz, 1.0f - xx + yy - zz,
                            1.0f - xx - yy + zz };
    uint32_t most = 0;
    for (uint32_t i = 1; i < 4; i++) {
        most = four[i] > four[most] ? i : most;
    }
    assert(four[most] > 0.0f);
    const float s = 0.5f / f_sqrt(four[most]), half = 0.5f * f_sqrt(four[most]);
    const float wx = (row[2].y - row[1].z) * s, wy = (row[0].z - row[2].x) * s,
                wz = (row[1].x - row[0].y) * s;
    const float xy = (row[0].y + row[1].x) * s, xz = (row[0].z + row[2].x) * s,
                yz = (row[1].z + row[2].y) * s;
    switch (most) {
    case 0:
        return (struct quaternion){ half, wx, wy, wz };
    case 1:
        return (struct quaternion){ wx, half, xy, xz };
    case 2:
        return (struct quaternion){ wy, xy, half, yz };
    default:
        return (struct quaternion){ wz, xz, yz, half };
    }
}

void board_pose_init(struct board_pose *pose, const struct poi_config *config)
{
    assert(poi_config_is_calibrated(config));
    assert(draw_wires_is_determined(config->spool_m));
    *pose = (struct board_pose){ .config = config,
                                 .mount = board_pose_quaternion_of_rows(config->imu_row) };
    pose->attitude.bias_rad_s = config->gyro_bias_rad_s;
}

/* Computes the position of the eye, where the draw wires meet, from the lengths of the wires. The
 * length of a wire is invalid in two cases. A broken or released wire is pulled to the end stop of
 * its potentiometer. A wire that is not connected gives no reading. */
static enum draw_wires_result feel_wires(struct board_pose *pose, const struct readings *readings)
{
    const struct poi_config *config = pose->config;
    float length_m[DRAW_WIRE_COUNT];
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        if (!(readings->wire[i] >= BOARD_POSE_STEPS_MIN)) {
            return DRAW_WIRES_LENGTH;
        }
        length_m[i] = config->zero_m[i] + config->step_m[i] * readings->wire[i];
    }
    return draw_wires_meet(config->spool_m, length_m, &pose->eye_m);
}

void board_pose_step(struct board_pose *pose, const struct readings *readings, float seconds,
                     struct poi_report *out)
{
    const struct poi_config *config = pose->config;
    assert(seconds > 0.0f);
    if (readings->fuses) {
        /* In the inertial chip's world, +z points up. In Kingyo's world, +y points up. A quarter
         * turn about x converts between the two worlds. `back` converts from the axes of the poi to
         * the axes of the chip. */
        const struct quaternion upright = { 0.70710678f, -0.70710678f, 0.0f, 0.0f };
        const struct quaternion mount = pose->mount,
                                back = { mount.w, -mount.x, -mount.y, -mount.z };
        const struct quaternion chip = attitude_quaternion_product(upright, readings->turn);
        attitude_set(&pose->attitude, attitude_quaternion_product(chip, back));
    } else {
        attitude_add_motion(&pose->attitude, poi_config_from_chip(config, readings->gyro_rad_s),
                            poi_config_from_chip(config, readings->accel_m_s2), seconds);
    }
    out->buttons = readings->buttons;
    out->target.angles = attitude_angles(&pose->attitude, config->ahead_s, seconds);
    pose->wires = feel_wires(pose, readings);
    if (pose->wires != DRAW_WIRES_OK || !pose->attitude.knows) {
        pose->steady.begun = 0;
        out->target.position_m.x = __builtin_nanf("");
        return;
    }
    const struct basis axes = vec_basis_from_angles(out->target.angles);
    const vec3 eye_m = steady_step(&pose->steady, pose->eye_m, seconds);
    out->target.position_m = v3_add(eye_m, vec_basis_to_world(&axes, config->ring_m));
}
