/* sensors.h -- the board's own sensors: a converter for the wires, an inertial chip, keys. */
#ifndef KINGYO_POI_GADGET_SENSORS_H
#define KINGYO_POI_GADGET_SENSORS_H

#include "board/poi-gadget/board_pose.h"
#include "board/poi-gadget/iio.h"
#include "board/poi-gadget/keys.h"

#define SENSORS_SAMPLES 4u /* Of each wire a reading: half of a converter's noise. */

struct sensors {
    int wire_fd[DRAW_WIRE_COUNT];
    int turn_fd;                    /* -1: the chip does not fuse. */
    int gyro_fd[3], accel_fd[3];
    float gyro_scale, accel_scale;  /* A step in rad/s and m/s^2. */
    uint8_t scalar_first;           /* Of the quaternion; see sensors.c. */
    struct keys keys;
    uint32_t failed_count;          /* Readings that a chip did not answer. */
};

/* Opens what `config` names, under `root`. 0, and one line in `why`, where a sensor is missing;
 * what was opened stays open for sensors_close(). */
#define SENSORS_WHY_SIZE 160u
int sensors_open(struct sensors *sensors, const struct poi_config *config, const char *root,
                 char why[SENSORS_WHY_SIZE]);

/* Reads all. 0 where one did not answer; `out` then holds what did. */
int sensors_read(struct sensors *sensors, struct readings *out);

void sensors_close(struct sensors *sensors);

#endif
