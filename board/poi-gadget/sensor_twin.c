/* sensor_twin.c -- moves the simulated hand through a table of strokes, each scoop at a different
 * target position. Computes the readings that the sensors would give for each pose. This
 * computation is the inverse of attitude.c, which computes a pose from the readings. Adds
 * quantization and noise to the wire readings. */
#include "board/poi-gadget/sensor_twin.h"

#include <assert.h>

#include "core/base/rng.h"

/* ---- Hand ------------------------------------------------------------------------------------ */

#define DEG F_DEG

/* Region of the target positions in metres. The festival tank is 0.85 m by 0.55 m, and 0.12 m deep.
 * The bowl of the first player floats at the near right corner, and its rim is 12 mm above the
 * water. The region keeps a distance from the bowl and from the walls. */
#define SPOT_LEFT_M (-0.30f)
#define SPOT_RIGHT_M 0.16f
#define SPOT_FAR_M (-0.12f)
#define SPOT_NEAR_M 0.12f
/* Position in metres at which the poi is tipped over the bowl. The position is left of the bowl's
 * centre, because a fish slides sideways off a ring that is tilted by 58 degrees. */
#define BOWL_X_M 0.289f
#define BOWL_Y_M 0.062f
#define BOWL_Z_M 0.185f

/* Table of the strokes of one scoop. Positions are relative to the target position, or to the bowl
 * if `at_bowl` is true. */
static const struct stroke {
    bool at_bowl;
    uint8_t buttons;
    float seconds;
    float x_m, y_m, z_m;
    float pitch_deg, roll_deg;
} strokes[SCOOP_STROKES] = {
    { false, POI_BUTTON_START, 0.9f, 0.00f, 0.045f, 0.06f, -38.0f, 0.0f },
    /* Holds the poi still above the water, because its shade attracts fish. */
    { false, 0, 1.2f, 0.00f, 0.045f, 0.06f, -38.0f, 0.0f },
    /* Moves the poi edge first into the water, in the direction of the paper's plane. */
    { false, 0, 0.6f, 0.00f, -0.070f, -0.06f, -38.0f, 0.0f },
    /* Moves the poi forward under the fish. */
    { false, 0, 0.5f, 0.00f, -0.070f, -0.10f, 0.0f, 0.0f },
    /* Lifts the poi level, so that the water drains from the paper. */
    { false, 0, 0.9f, 0.00f, 0.060f, -0.09f, 2.0f, 0.0f },
    { true, 0, 1.1f, 0.00f, 0.020f, 0.00f, 2.0f, 0.0f },
    /* Tips the poi to the right over the bowl, so that the fish slides off the paper. */
    { true, POI_BUTTON_OK, 0.5f, 0.00f, 0.000f, 0.00f, 0.0f, 58.0f },
    { true, 0, 0.6f, -0.03f, 0.030f, 0.00f, 0.0f, 0.0f },
};

void sensor_twin_scoop(struct scoop *scoop, float seconds, struct poi_report *out)
{
    if (pose_glide_is_there(&scoop->glide)) {
        const struct stroke *stroke = &strokes[scoop->stroke % SCOOP_STROKES];
        /* Powers of the plastic number (about 1.3247) give a low-discrepancy sequence. The sequence
         * places the target positions evenly in the region without repetition. */
        const uint32_t number = scoop->stroke / SCOOP_STROKES % 4096u;
        const float u = 0.5f + (float)number * 0.7548777f, v = 0.5f + (float)number * 0.5698403f;
        const vec3 spot_m = v3(f_lerp(SPOT_LEFT_M, SPOT_RIGHT_M, u - f_floor(u)), 0.0f,
                               f_lerp(SPOT_FAR_M, SPOT_NEAR_M, v - f_floor(v)));
        const vec3 base_m = stroke->at_bowl ? v3(BOWL_X_M, BOWL_Y_M, BOWL_Z_M) : spot_m;
        const struct pose_line next = {
            .glide_s = stroke->seconds,
            .buttons = stroke->buttons,
            .target = { .position_m = v3_add(base_m, v3(stroke->x_m, stroke->y_m, stroke->z_m)),
                        .angles = { .pitch_rad = stroke->pitch_deg * DEG,
                                    .roll_rad = stroke->roll_deg * DEG } },
        };
        pose_glide_send(&scoop->glide, &next);
        scoop->stroke++;
    }
    pose_glide_step(&scoop->glide, seconds, out);
}

/* ---- Sensors --------------------------------------------------------------------------------- */

/* Number of different values (steps) of a 12-bit analog-to-digital converter. */
#define STEPS 4096.0f
/* Change of the wire's length in metres over the full range of the converter. The potentiometer
 * makes ten turns, and the wire's drum has a circumference of 100 mm. */
#define WIRE_SPAN_M 1.0f
#define WIRE_LEAST_M 0.25f
#define SAMPLES 4u
#define TWIN_NOISE_STEPS 1.5f /* Noise in steps of a 12-bit converter with a cheap potentiometer. */

void sensor_twin_calibrate(struct poi_config *config)
{
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        config->zero_m[i] = WIRE_LEAST_M;
        config->step_m[i] = WIRE_SPAN_M / STEPS;
    }
}

/* Returns the mean of several noisy samples of a wire whose exact converter value is `steps`. Each
 * sample is rounded to a whole step, as by a real converter. */
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

static void compute_readings(struct sensor_twin *twin, const struct basis *axes,
                             struct quaternion turn, vec3 place_m, float seconds,
                             struct readings *out)
{
    const vec3 speed_m_s = v3_scale(v3_sub(place_m, twin->place_m), 1.0f / seconds);
    const vec3 force = v3_scale(v3_sub(speed_m_s, twin->speed_m_s), 1.0f / seconds);
    const vec3 pull = v3_add(twin->begun > 1 ? force : v3(0, 0, 0), v3(0.0f, GRAVITY_M_S2, 0.0f));
    /* The gyroscope measures the rotation since the previous reading. For a small rotation, the
     * angle is twice the vector part of the quaternion. */
    const struct quaternion back = { twin->before.w, -twin->before.x, -twin->before.y,
                                     -twin->before.z };
    const struct quaternion d = attitude_quaternion_product(back, turn);
    const float twice = (d.w < 0.0f ? -2.0f : 2.0f) / seconds;
    const vec3 rate = twin->begun ? v3_scale(v3(d.x, d.y, d.z), twice) : v3(0, 0, 0);
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
    assert(seconds > 0.0f);
    assert(v3_is_finite(pose->target.position_m));
    assert(poi_config_is_calibrated(config));
    const struct basis axes = vec_basis_from_angles(pose->target.angles);
    const struct quaternion turn = attitude_quaternion_of_angles(pose->target.angles);
    const vec3 eye_m = v3_sub(pose->target.position_m, vec_basis_to_world(&axes, config->ring_m));
    float length_m[DRAW_WIRE_COUNT];
    draw_wires_lengths(config->spool_m, eye_m, length_m);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        const float steps = (length_m[i] - config->zero_m[i]) / config->step_m[i];
        out->wire[i] = converted(twin, steps, i);
    }
    compute_readings(twin, &axes, turn, eye_m, seconds, out);
    /* Combines three rotations. The first leads from the axes of the chip to the axes of the poi.
     * The second leads to Kingyo's world, in which +y points up. The third leads to the chip's
     * world, in which +z points up. */
    const struct quaternion lying = { 0.70710678f, 0.70710678f, 0.0f, 0.0f };
    out->turn = attitude_quaternion_product(attitude_quaternion_product(lying, turn),
                                            board_pose_quaternion_of_rows(config->imu_row));
    out->fuses = twin->fuses;
    out->buttons = pose->buttons;
    twin->step++;
}

static enum pose_result sensor_twin_source_step(void *self, float seconds, struct poi_report *out)
{
    struct sensor_twin_source *source = self;
    struct poi_report hand = { 0 };
    struct readings readings;
    sensor_twin_scoop(&source->scoop, seconds, &hand);
    sensor_twin_step(&source->twin, &hand, seconds, &readings);
    board_pose_step(&source->pose, &readings, seconds, out);
    return POSE_NEW;
}

struct pose_source sensor_twin_source(struct sensor_twin_source *source,
                                      const struct poi_config *config)
{
    *source = (struct sensor_twin_source){
        .twin = { .config = config, .noise_steps = TWIN_NOISE_STEPS },
    };
    board_pose_init(&source->pose, config);
    return (struct pose_source){ .step = sensor_twin_source_step, .self = source };
}
