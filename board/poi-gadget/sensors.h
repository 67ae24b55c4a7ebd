/* sensors.h -- reads the sensors of the poi's board: the analog-to-digital converter of the draw
 * wires, the inertial chip and the keys. */
#ifndef KINGYO_BOARD_POI_GADGET_SENSORS_H
#define KINGYO_BOARD_POI_GADGET_SENSORS_H

#include "board/poi-gadget/board_pose.h"
#include "board/poi-gadget/iio.h"
#include "board/poi-gadget/keys.h"

/* Number of samples of each wire in one reading. The mean of four samples has half the noise of one
 * sample. */
#define SENSORS_SAMPLES 4u

struct sensors {
    int wire_fd[DRAW_WIRE_COUNT];
    /* File descriptor of the quaternion, or -1 if the chip does not compute a quaternion. */
    int turn_fd;
    int gyro_fd[3], accel_fd[3];
    /* Size of one step of the gyroscope in rad/s (`gyro_scale`) and of the accelerometer in m/s^2
     * (`accel_scale`). */
    float gyro_scale, accel_scale;
    /* 1 if the driver writes the scalar part of the quaternion first, 0 if last (see sensors.c). */
    uint8_t scalar_first;
    struct keys keys;
    uint32_t failed_count; /* Number of readings that failed because a chip did not respond. */
};

/* Size in bytes of the error text of sensors_open().
 *
 * sensors_open() opens the sensors that `config` names. `root` is the prefix of all paths: "" for
 * this machine, or a test folder. Returns 1. If a sensor is missing, writes one line to `why` and
 * returns 0. The caller must call sensors_close() in either case. */
#define SENSORS_WHY_SIZE 160u
int sensors_open(struct sensors *sensors, const struct poi_config *config, const char *root,
                 char why[SENSORS_WHY_SIZE]);

/* Reads all sensors. Returns 1 if all sensors responded. Otherwise returns 0, and `out` contains
 * the readings of the sensors that responded. */
int sensors_read(struct sensors *sensors, struct readings *out);

/* Closes all sensors. */
void sensors_close(struct sensors *sensors);

#endif
