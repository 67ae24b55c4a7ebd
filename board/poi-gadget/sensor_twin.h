/* sensor_twin.h -- simulates the sensors of a poi: computes the readings that the sensors would
 * give for a pose. The functions are pure.
 *
 * Only the sensors are simulated. The readings are decoded with the same wire computation, filter
 * and calibration as the readings of a real poi. */
#ifndef KINGYO_BOARD_POI_GADGET_SENSOR_TWIN_H
#define KINGYO_BOARD_POI_GADGET_SENSOR_TWIN_H

#include "board/poi-gadget/board_pose.h"

struct sensor_twin {
    const struct poi_config *config;
    /* Amplitude of the converter's noise in steps. One sample is wrong by at most this amount in
     * each direction. A reading is a mean of four samples and therefore has less noise. */
    float noise_steps;
    vec3 gyro_bias_rad_s; /* Simulated bias of the gyroscope in rad/s. */
    uint8_t fuses;        /* 1 if the simulated chip computes a quaternion, as a BNO055 does. 0 if
                             the simulated chip gives rotation rates and accelerations. */
    uint8_t begun;
    uint32_t step;
    struct quaternion before;
    vec3 place_m, speed_m_s;
};

/* Sets the calibration in `config` for a 12-bit converter whose range is one metre of wire. The
 * caller guarantees that `config` is valid. */
void sensor_twin_calibrate(struct poi_config *config);

/* Computes the readings for a ring at `pose`. `seconds` is the time since the previous call and
 * must be above 0. The position of the pose must be known. */
void sensor_twin_step(struct sensor_twin *twin, const struct poi_report *pose, float seconds,
                      struct readings *out);

#endif
