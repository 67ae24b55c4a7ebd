/* sensors.h -- the sensors of the board: a converter for the wires, an inertial chip and keys. */
#ifndef KINGYO_BOARD_POI_GADGET_SENSORS_H
#define KINGYO_BOARD_POI_GADGET_SENSORS_H

#include "board/poi-gadget/board_pose.h"
#include "board/poi-gadget/iio.h"
#include "board/poi-gadget/keys.h"

/* Number of samples of each wire in a reading. Four samples halve the noise of the converter. */
#define SENSORS_SAMPLES 4u

struct sensors {
    int wire_fd[DRAW_WIRE_COUNT];
    /* File descriptor of the quaternion, or -1 if the chip does not compute a quaternion. */
    int turn_fd;
    int gyro_fd[3], accel_fd[3];
    /* Size of one step of the gyroscope in rad/s and of the accelerometer in m/s^2. */
    float gyro_scale, accel_scale;
    /* 1 if the quaternion's scalar part is first (see sensors.c). */
    uint8_t scalar_first;
    struct keys keys;
    uint32_t failed_count; /* Number of readings in which a chip did not answer. */
};

/* Opens the sensors that `config` names, under `root`. Returns 1. Returns 0 and writes one line to
 * `why` if a sensor is missing. The opened files stay open until sensors_close(). */
#define SENSORS_WHY_SIZE 160u
int sensors_open(struct sensors *sensors, const struct poi_config *config, const char *root,
                 char why[SENSORS_WHY_SIZE]);

/* Reads all sensors. Returns 1, or 0 if a sensor did not answer. `out` then contains the readings
 * of the other sensors. */
int sensors_read(struct sensors *sensors, struct readings *out);

/* Closes all sensors. */
void sensors_close(struct sensors *sensors);

#endif
