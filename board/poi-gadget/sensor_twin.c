/* sensor_twin.c -- computes simulated readings by inverting board_pose.c, and adds quantization and
 * noise. */
#include "board/poi-gadget/sensor_twin.h"

#include "core/base/rng.h"

#define STEPS 4096.0f /* Number of steps of a 12-bit converter. */
/* Change of the wire's length in metres over the full range of the converter. The potentiometer
 * makes ten turns, and the drum has a circumference of 100 mm. */
#define WIRE_SPAN_M 1.0f
#define WIRE_LEAST_M 0.25f
#define SAMPLES 4u

void sensor_twin_calibrate(struct poi_config *config)
{
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        config->zero_m[i] = WIRE_LEAST_M;
        config->step_m[i] = WIRE_SPAN_M / STEPS;
    }
}

/* Returns the mean of several samples with noise. Each sample is rounded to a whole step, as by a
 * real converter. */
static float converted(struct sensor_twin *twin, float steps, uint32_t wire)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < SAMPLES; i++) {
        const struct rng_key key = { twin->step, wire, i, RNG_TEST };
        const float noise = rng_range(key, -twin->noise_steps, twin->noise_steps);
        sum += f_clamp(f_floor(steps + noise + 0.5f), 0.0f, STEPS - 1.0f);
    }
    return sum / (float)SAMPLES;
}

static vec3 to_chip(const struct poi_config *config, vec3 poi)
{
    return v3_muladd(v3_muladd(v3_scale(config->imu_row[0], poi.x), config->imu_row[1], poi.y),
                     config->imu_row[2], poi.z);
}

static struct quaternion back_of(struct quaternion q)
{
    return (struct quaternion){ q.w, -q.x, -q.y, -q.z };
}

/* Returns the rotation rate from `from` to `to` in rad/s, in the axes of the poi. For a small
 * rotation, the angle is twice the vector part of the quaternion. */
static vec3 rate_between(struct quaternion from, struct quaternion to, float seconds)
{
    const struct quaternion d = attitude_quaternion_product(back_of(from), to);
    const float twice = (d.w < 0.0f ? -2.0f : 2.0f) / seconds;
    return v3_scale(v3(d.x, d.y, d.z), twice);
}

static void feel(struct sensor_twin *twin, const struct basis *axes, struct quaternion turn,
                 vec3 place_m, float seconds, struct readings *out)
{
    const vec3 speed_m_s = v3_scale(v3_sub(place_m, twin->place_m), 1.0f / seconds);
    const vec3 force = v3_scale(v3_sub(speed_m_s, twin->speed_m_s), 1.0f / seconds);
    const vec3 pull = v3_add(twin->begun > 1 ? force : v3(0, 0, 0), v3(0.0f, GRAVITY_M_S2, 0.0f));
    const vec3 rate = twin->begun ? rate_between(twin->before, turn, seconds) : v3(0, 0, 0);
    out->gyro_rad_s = to_chip(twin->config, v3_add(rate, twin->gyro_bias_rad_s));
    out->accel_m_s2 = to_chip(twin->config, vec_basis_to_body(axes, pull));
    twin->speed_m_s = twin->begun ? speed_m_s : v3(0, 0, 0);
    twin->place_m = place_m;
    twin->before = turn;
    twin->begun = twin->begun < 2 ? (uint8_t)(twin->begun + 1) : 2;
}

void sensor_twin_step(struct sensor_twin *twin, const struct poi_report *pose, float seconds,
                      struct readings *out)
{
    const struct poi_config *config = twin->config;
    const struct basis axes = vec_basis_from_angles(pose->target.angles);
    const struct quaternion turn = attitude_quaternion_of_angles(pose->target.angles);
    const vec3 eye_m = v3_sub(pose->target.position_m, vec_basis_to_world(&axes, config->ring_m));
    float length_m[DRAW_WIRE_COUNT];
    draw_wires_lengths(config->spool_m, eye_m, length_m);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        const float steps = (length_m[i] - config->zero_m[i]) / config->step_m[i];
        out->wire[i] = converted(twin, steps, i);
    }
    feel(twin, &axes, turn, eye_m, seconds, out);
    /* Combines three rotations: from the chip to the poi, from the poi to the world with +y up, and
     * to the world with +z up. */
    const struct quaternion lying = { 0.70710678f, 0.70710678f, 0.0f, 0.0f };
    out->turn = attitude_quaternion_product(attitude_quaternion_product(lying, turn),
                                            board_pose_quaternion_of_rows(config->imu_row));
    out->fuses = twin->fuses;
    out->buttons = pose->buttons;
    twin->step++;
}
