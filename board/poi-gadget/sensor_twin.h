/* sensor_twin.h -- simulates a poi on its board: a hand that scoops without vision, and the
 * readings that the sensors would give for its poses. A kiosk can thus be tested without sensors.
 * The functions are pure.
 *
 * The readings are decoded with the same wire computation, filter and calibration as the readings
 * of a real poi.
 *
 * For each scoop, the hand presses START and holds the poi (a paper scoop) still above the water,
 * because its shade attracts fish. The poi then enters the water slanted, in the direction of its
 * paper's plane, glides under the fish, and is lifted level so that the water drains. Finally the
 * poi moves to the bowl of the first player in the festival tank and tips. The scoops enter the
 * water at different positions that cover the whole tank. */
#pragma once

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/pose_script.h"
#include "board/poi-gadget/run.h"

/* ---- Hand ------------------------------------------------------------------------------------ */

struct scoop {
    /* Number of strokes (single motions of the hand) since the start of the simulation. Each scoop
     * consists of SCOOP_STROKES strokes. */
    uint32_t stroke;
    struct pose_glide glide;
};

#define SCOOP_STROKES 8u

/* Advances the hand by `seconds` and writes its pose to `out`. All fields of `scoop` must be 0
 * before the first call. */
void sensor_twin_scoop(struct scoop *scoop, float seconds, struct poi_report *out);

/* ---- Sensors --------------------------------------------------------------------------------- */

struct sensor_twin {
    const struct poi_config *config;
    /* Amplitude of the simulated converter's noise in steps. One sample is wrong by at most this
     * amount. A reading is a mean of four samples and therefore has less noise. */
    float noise_steps;
    vec3 gyro_bias_rad_s; /* Simulated bias of the gyroscope in rad/s. */
    /* True if the simulated chip computes a quaternion, as a BNO055 does. False if the simulated
     * chip gives rotation rates and accelerations. */
    bool fuses;
    uint8_t begun; /* Number of steps so far, at most 2. */
    uint32_t step;
    struct quaternion before;
    vec3 place_m, speed_m_s;
};

/* Sets the calibration in `config` to that of a 12-bit converter whose range is one metre of wire.
 * The caller guarantees that `config` is valid. */
void sensor_twin_calibrate(struct poi_config *config);

/* Computes the sensor readings for a poi whose ring has the pose `pose`. `seconds` is the time
 * since the previous call and must be above 0. The caller guarantees that the position of the pose
 * is known. */
void sensor_twin_step(struct sensor_twin *twin, const struct poi_report *pose, float seconds,
                      struct readings *out);

struct sensor_twin_source {
    struct scoop scoop;
    struct sensor_twin twin;
    struct board_pose pose;
};

/* Returns a source of simulated sensors on a poi that the simulated hand moves. `config` must
 * outlive the source. */
struct pose_source sensor_twin_source(struct sensor_twin_source *source,
                                      const struct poi_config *config);
