/* sensor_twin.h -- sensors made of arithmetic: the readings that a pose would give. Pure.
 *
 * Under the decoder, not in place of it: a simulated poi goes through the same wires, filter and
 * calibration as a real one. */
#ifndef KINGYO_POI_GADGET_SENSOR_TWIN_H
#define KINGYO_POI_GADGET_SENSOR_TWIN_H

#include "board/poi-gadget/board_pose.h"

struct sensor_twin {
    const struct poi_config *config;
    float noise_steps;    /* Of the converter, to either side; means of four have a quarter. */
    vec3 gyro_bias_rad_s; /* That the gyroscope has in truth. */
    uint8_t fuses;        /* As a BNO055. */
    uint8_t begun;
    uint32_t step;
    struct quaternion before;
    vec3 place_m, speed_m_s;
};

/* A calibrated config for a converter of 12 bits over a metre of wire, on any sound `config`. */
void sensor_twin_calibrate(struct poi_config *config);

/* What the sensors say `seconds` > 0 later of a poi whose ring is at `pose`, which has a place. */
void sensor_twin_step(struct sensor_twin *twin, const struct poi_report *pose, float seconds,
                      struct readings *out);

#endif
