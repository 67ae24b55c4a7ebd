/* attitude.c -- computes the orientation of the poi with quaternions, which have no singularities,
 * and the pose of the poi's ring. The draw wires give the position of the eye (the point on the
 * poi's neck at which the wires meet). The inertial chip gives the direction from the eye to the
 * ring. */
#include "board/poi-gadget/attitude.h"

#include <assert.h>

/* Correction rate of the orientation by gravity, in 1/s. With this rate, an error is corrected in
 * about one second. */
#define PULL_PER_S 1.0f
/* Maximum difference between the measured acceleration and the gravity g, as a fraction of g, at
 * which the acceleration is used as the vertical direction. */
#define ACCEL_TOLERANCE_G 0.15f
/* Rotation rate in rad/s below which the poi counts as still. The value is 3 degrees per second. A
 * poi that is held in a hand rotates faster. */
#define STILL_RAD_S 0.05f
#define STILL_S 1.0f
#define BIAS_PER_S 0.5f
/* Maximum plausible bias of the gyroscope in rad/s. The value is 11 degrees per second. Cheap chips
 * have at most this bias. */
#define BIAS_MAX_RAD_S 0.2f

struct quaternion attitude_quaternion_product(struct quaternion a, struct quaternion b)
{
    return (struct quaternion){
        .w = a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
        .x = a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
        .y = a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        .z = a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    };
}

static struct quaternion normalized(struct quaternion q)
{
    const float square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (!(square > 1e-12f) || !f_is_finite(square)) {
        return (struct quaternion){ .w = 1.0f };
    }
    const float s = 1.0f / f_sqrt(square);
    return (struct quaternion){ q.w * s, q.x * s, q.y * s, q.z * s };
}

/* Returns a rotation by the angle 2 * `half_rad` about the unit axis (x, y, z). */
static struct quaternion rotation_about_axis(float half_rad, float x, float y, float z)
{
    const float s = f_sin(half_rad);
    return (struct quaternion){ f_cos(half_rad), x * s, y * s, z * s };
}

/* Converts yaw, pitch and roll to a quaternion. The rotations are yaw about +y, then pitch about
 * +x, then roll about -z. A positive roll lowers the right side. */
struct quaternion attitude_quaternion_of_angles(struct angles angles)
{
    const struct quaternion yaw = rotation_about_axis(0.5f * angles.yaw_rad, 0.0f, 1.0f, 0.0f);
    const struct quaternion pitch = rotation_about_axis(0.5f * angles.pitch_rad, 1.0f, 0.0f, 0.0f);
    const struct quaternion roll = rotation_about_axis(0.5f * angles.roll_rad, 0.0f, 0.0f, -1.0f);
    return attitude_quaternion_product(attitude_quaternion_product(yaw, pitch), roll);
}

/* Converts a quaternion to yaw, pitch and roll. The columns of the rotation matrix are the axes of
 * the poi in world coordinates. */
struct angles attitude_quaternion_angles(struct quaternion q)
{
    const float right_y = 2.0f * (q.x * q.y + q.w * q.z);
    const float up_y = 1.0f - 2.0f * (q.x * q.x + q.z * q.z);
    const vec3 back = v3(2.0f * (q.x * q.z + q.w * q.y), 2.0f * (q.y * q.z - q.w * q.x),
                         1.0f - 2.0f * (q.x * q.x + q.y * q.y));
    const float level = f_sqrt(back.x * back.x + back.z * back.z);
    return (struct angles){ .yaw_rad = f_atan2(back.x, back.z),
                            .pitch_rad = f_atan2(-back.y, level),
                            .roll_rad = f_atan2(-right_y, up_y) };
}

static void learn_bias(struct attitude *attitude, vec3 gyro_rad_s, float weight, float seconds)
{
    const vec3 rest = v3_sub(gyro_rad_s, attitude->bias_rad_s);
    attitude->still_s =
        v3_length(rest) < STILL_RAD_S && weight > 0.5f ? attitude->still_s + seconds : 0.0f;
    if (attitude->still_s > STILL_S) {
        const float share = f_min(BIAS_PER_S * seconds, 1.0f);
        attitude->bias_rad_s =
            v3_limit(v3_muladd(attitude->bias_rad_s, rest, share), BIAS_MAX_RAD_S);
    }
}

void attitude_add_motion(struct attitude *attitude, vec3 gyro_rad_s, vec3 accel_m_s2, float seconds)
{
    assert(seconds >= 0.0f);
    if (!v3_is_finite(gyro_rad_s) || !v3_is_finite(accel_m_s2)) {
        return;
    }
    const float pull = v3_length(accel_m_s2) / GRAVITY_M_S2;
    const float weight = f_clamp(1.0f - f_abs(pull - 1.0f) / ACCEL_TOLERANCE_G, 0.0f, 1.0f);
    const vec3 up = v3_normalize_or(accel_m_s2, v3(0.0f, 1.0f, 0.0f));
    if (!attitude->is_valid) {
        /* The initial orientation is the shortest rotation that turns `up` to the world's upward
         * direction. If `up` points down, the rotation is a half turn about x. */
        attitude->turn = up.y < -0.9999f
                             ? (struct quaternion){ .x = 1.0f }
                             : normalized((struct quaternion){ 1.0f + up.y, -up.z, 0.0f, up.x });
        attitude->is_valid = weight > 0.0f;
        return;
    }
    learn_bias(attitude, gyro_rad_s, weight, seconds);
    /* `world_up` is the middle row of the rotation matrix, which is the world's up direction in the
     * axes of the poi. */
    const struct quaternion q = attitude->turn;
    const vec3 world_up = v3(2.0f * (q.x * q.y + q.w * q.z), 1.0f - 2.0f * (q.x * q.x + q.z * q.z),
                             2.0f * (q.y * q.z - q.w * q.x));
    const vec3 off = v3_cross(up, world_up);
    const vec3 rate = v3_muladd(v3_sub(gyro_rad_s, attitude->bias_rad_s), off, PULL_PER_S * weight);
    const float angle = v3_length(rate) * seconds;
    const vec3 axis = v3_normalize_or(rate, v3(0.0f, 0.0f, 0.0f));
    const struct quaternion step =
        rotation_about_axis(0.5f * f_min(angle, F_PI), axis.x, axis.y, axis.z);
    attitude->turn = normalized(attitude_quaternion_product(attitude->turn, step));
}

void attitude_set(struct attitude *attitude, struct quaternion turn)
{
    attitude->turn = normalized(turn);
    attitude->is_valid = true;
}

struct angles attitude_angles(struct attitude *attitude, float ahead_s, float seconds)
{
    assert(ahead_s >= 0.0f);
    assert(seconds >= 0.0f);
    struct angles angles = attitude_quaternion_angles(attitude->turn);
    if (!attitude->has_ahead && attitude->is_valid) {
        attitude->ahead_rad = angles.yaw_rad;
        attitude->has_ahead = true;
    }
    const float off_rad = f_wrap_angle(angles.yaw_rad - attitude->ahead_rad);
    if (ahead_s > 0.0f) {
        const float share = f_min(seconds / ahead_s, 1.0f);
        attitude->ahead_rad = f_wrap_angle(attitude->ahead_rad + share * off_rad);
    }
    angles.yaw_rad = f_wrap_angle(angles.yaw_rad - attitude->ahead_rad);
    return angles;
}

/* ---- Pose ------------------------------------------------------------------------------------ */

#define STEADY_REST_HZ 4.0f /* Corner frequency of the position filter at rest, in Hz. */
/* Increase of the position filter's corner frequency in Hz for each m/s of speed. */
#define STEADY_HZ_PER_M_S 60.0f
#define STEADY_SPEED_HZ 6.0f /* Corner frequency of the speed filter, in Hz. */

/* Returns the weight of the new value in one step of a first-order low-pass filter with the corner
 * frequency `corner_hz`. `seconds` is the duration of the step. */
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
        *steady = (struct steady){ .begun = true, .place_m = raw_m, .raw_m = raw_m };
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
    const struct quaternion turns[4] = {
        { half, wx, wy, wz }, { wx, half, xy, xz }, { wy, xy, half, yz }, { wz, xz, yz, half }
    };
    return turns[most];
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
static enum draw_wires_result locate_eye(struct board_pose *pose, const struct readings *readings)
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
    pose->wires = locate_eye(pose, readings);
    if (pose->wires != DRAW_WIRES_OK || !pose->attitude.is_valid) {
        pose->steady.begun = false;
        out->target.position_m.x = __builtin_nanf("");
        return;
    }
    const struct basis axes = vec_basis_from_angles(out->target.angles);
    const vec3 eye_m = steady_step(&pose->steady, pose->eye_m, seconds);
    out->target.position_m = v3_add(eye_m, vec_basis_to_world(&axes, config->ring_m));
}
