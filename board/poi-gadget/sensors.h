/* sensors.h -- reads the sensors of the poi's board: the analog-to-digital converter of the draw
 * wires, the inertial chip and the keys, and computes the pose from the readings.
 *
 * The converter and the chip are devices of Linux's industrial I/O subsystem (IIO) and are found by
 * their names. Their sysfs files stay open between readings. The keys on the poi's handle are GPIO
 * lines that the kernel's gpio-keys driver debounces. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/run.h"

/* Maximum number of gpio-keys devices that are opened. A handle has one device. */
#define KEYS_DEVICES_MAX 8u

struct keys {
    int fd[KEYS_DEVICES_MAX];
    uint32_t count;
    uint32_t held; /* Bit mask of the pressed keys (enum poi_button). */
};

/* Opens each input device of the gpio-keys driver. `root` is the prefix of all paths: "" for this
 * machine, or a test folder. A handle without keys is not an error. */
void sensors_open_keys(struct keys *keys, const char *root);

/* Returns the pressed keys as a bit mask of enum poi_button. BTN_TRIGGER is OK, BTN_START is START,
 * BTN_DPAD_LEFT is LEFT, BTN_DPAD_RIGHT is RIGHT, and BTN_THUMB is FAN. These key codes were chosen
 * because a text console does not interpret them as letters. */
uint8_t sensors_held_keys(struct keys *keys);

/* Closes all input devices. */
void sensors_close_keys(struct keys *keys);

/* Number of samples of each wire in one reading. The mean of four samples has half the noise of one
 * sample. */
#define SENSORS_SAMPLES 4u

/* Indices of struct sensors.fd. The wires and the axes x, y and z have adjacent indices. */
enum sensors_fd {
    SENSORS_WIRE = 0,                              /* First of the draw wires. */
    SENSORS_GYRO = SENSORS_WIRE + DRAW_WIRE_COUNT, /* First of three axes of the gyroscope. */
    SENSORS_ACCEL = SENSORS_GYRO + 3,              /* First of three axes of the accelerometer. */
    SENSORS_TURN = SENSORS_ACCEL + 3,              /* The quaternion. */
    SENSORS_FD_COUNT,
};

struct sensors {
    /* File descriptors of the attributes (enum sensors_fd). -1 means that the attribute is absent,
     * for example because the inertial chip computes a quaternion instead. */
    int fd[SENSORS_FD_COUNT];
    /* Size of one step of the gyroscope in rad/s (`gyro_scale`) and of the accelerometer in m/s^2
     * (`accel_scale`). */
    float gyro_scale, accel_scale;
    /* True if the driver writes the scalar part of the quaternion first, false if the driver writes
     * the scalar part last (see sensors.c). */
    bool scalar_first;
    struct keys keys;
    uint32_t failed_count; /* Number of readings that failed because a chip did not respond. */
};

/* Size in bytes of the buffer for the error text of sensors_open(). */
#define SENSORS_WHY_SIZE 160u

/* Opens the sensors that `config` names. `root` is the prefix of all paths: "" for this machine, or
 * a test folder. `why` is a buffer of SENSORS_WHY_SIZE bytes. Returns true. If a sensor is missing,
 * writes one line to `why` and returns false. The caller must call sensors_close() in either
 * case. */
bool sensors_open(struct sensors *sensors, const struct poi_config *config, const char *root,
                  char why[SENSORS_WHY_SIZE]);

/* Reads all sensors. Returns true if all sensors responded. Otherwise returns false, and `out`
 * contains the readings of the sensors that responded. */
bool sensors_read(struct sensors *sensors, struct readings *out);

/* After this number of consecutive failed readings of the sensors, the poi's position counts as
 * unknown. */
#define SENSOR_GONE_BEATS 25u

struct sensor_source {
    struct board_pose pose;
    struct sensors sensors;
    struct readings readings;
    uint32_t missed; /* Number of consecutive failed readings so far. */
};

/* Returns a source that reads the board's sensors. `source->sensors` must be open. `config` must
 * outlive the source. The caller guarantees that `config` is valid and calibrated. */
struct pose_source sensors_source(struct sensor_source *source, const struct poi_config *config);

/* Closes all sensors. */
void sensors_close(struct sensors *sensors);
