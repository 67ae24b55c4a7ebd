/* board_pose.c -- computes the pose of the ring. The draw wires give the position of the eye on the
 * poi's neck, and the inertial chip gives the direction from the eye to the ring. */
#include "board/poi-gadget/board_pose.h"

#include <assert.h>

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
    assert(poi_config_is_calibrated(config) && draw_wires_is_determined(config->spool_m));
    *pose = (struct board_pose){ .config = config,
                                 .mount = board_pose_quaternion_of_rows(config->imu_row) };
    pose->attitude.bias_rad_s = config->gyro_bias_rad_s;
}

static vec3 to_poi(const struct poi_config *config, vec3 chip)
{
    return v3(v3_dot(config->imu_row[0], chip), v3_dot(config->imu_row[1], chip),
              v3_dot(config->imu_row[2], chip));
}

static void feel_attitude(struct board_pose *pose, const struct readings *readings, float seconds)
{
    if (!readings->fuses) {
        attitude_add_motion(&pose->attitude, to_poi(pose->config, readings->gyro_rad_s),
                            to_poi(pose->config, readings->accel_m_s2), seconds);
        return;
    }
    /* In the chip's world +z points up, and in Kingyo's world +y points up. A quarter turn about x
     * converts between the two worlds. `back` converts from the axes of the poi to the axes of the
     * chip. */
    const struct quaternion upright = { 0.70710678f, -0.70710678f, 0.0f, 0.0f };
    const struct quaternion back = { pose->mount.w, -pose->mount.x, -pose->mount.y,
                                     -pose->mount.z };
    attitude_set(&pose->attitude, attitude_quaternion_product(
                                      attitude_quaternion_product(upright, readings->turn), back));
}

/* Computes the position of the eye, where the draw wires meet, from the lengths of the wires. A
 * broken or released wire is pulled to the end stop of its potentiometer. A wire that is not
 * connected gives no reading. In these two cases, the length of the wire is invalid. */
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
    feel_attitude(pose, readings, seconds);
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
