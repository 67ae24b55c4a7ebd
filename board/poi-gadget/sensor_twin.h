/* sensor_twin.h -- simulated sensors, which compute the readings for a given pose. The functions
 * are pure.
 *
 * The simulation replaces the sensors and not the decoder. A simulated poi therefore uses the same
 * wire computation, filter and calibration as a real poi. */
#ifndef KINGYO_BOARD_POI_GADGET_SENSOR_TWIN_H
#define KINGYO_BOARD_POI_GADGET_SENSOR_TWIN_H

#include "board/poi-gadget/board_pose.h"

struct sensor_twin {
    const struct poi_config *config;
    /* Noise amplitude of the converter in both directions, in steps. Each reading is a mean of four
     * samples and has less noise. */
    float noise_steps;
    vec3 gyro_bias_rad_s; /* Simulated bias of the gyroscope. */
    uint8_t fuses;        /* 1 if the chip computes a quaternion, as a BNO055 does. */
    uint8_t begun;
    uint32_t step;
    struct quaternion before;
    vec3 place_m, speed_m_s;
};

/* Sets the calibration in `config` to a 12-bit converter over one metre of wire. The caller
 * guarantees a valid `config`. */
void sensor_twin_calibrate(struct poi_config *config);

/* Computes the readings `seconds` > 0 after the previous call, for a ring at `pose`. The pose must
 * have a position. */
void sensor_twin_step(struct sensor_twin *twin, const struct poi_report *pose, float seconds,
                      struct readings *out);

#endif
