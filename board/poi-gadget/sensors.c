/* sensors.c -- reads the sensor attributes in sequence. A complete reading takes about twenty
 * system calls. */
#include "board/poi-gadget/sensors.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char axis_of[3] = { 'x', 'y', 'z' };

static int open_wires(struct sensors *sensors, const struct poi_config *config, const char *root,
                      char why[SENSORS_WHY_SIZE])
{
    char path[IIO_PATH_SIZE], name[32];
    if (!iio_find(path, root, config->adc)) {
        snprintf(why, SENSORS_WHY_SIZE, "no converter '%s' in %s/sys/bus/iio/devices", config->adc,
                 root);
        return 0;
    }
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        snprintf(name, sizeof name, "in_voltage%u_raw", config->channel[i]);
        sensors->wire_fd[i] = iio_open(path, name);
        if (sensors->wire_fd[i] < 0) {
            snprintf(why, SENSORS_WHY_SIZE, "'%s' has no %s for spool %u", config->adc, name,
                     i + 1);
            return 0;
        }
    }
    return 1;
}

static int open_three(int fd[3], const char *path, const char *quantity, float *scale)
{
    char name[32];
    for (uint32_t i = 0; i < 3; i++) {
        snprintf(name, sizeof name, "in_%s_%c_raw", quantity, axis_of[i]);
        fd[i] = iio_open(path, name);
        if (fd[i] < 0) {
            return 0;
        }
    }
    snprintf(name, sizeof name, "in_%s_scale", quantity);
    return iio_read_once(path, name, 1, scale) && *scale != 0.0f;
}

/* Opens the inertial chip. By the sysfs-bus-iio ABI, the order of a quaternion is x y z w. Linux's
 * bno055 driver instead writes the order of the chip's registers, w x y z. */
static int open_imu(struct sensors *sensors, const struct poi_config *config, const char *root,
                    char why[SENSORS_WHY_SIZE])
{
    char path[IIO_PATH_SIZE];
    if (!iio_find(path, root, config->imu)) {
        snprintf(why, SENSORS_WHY_SIZE, "no inertial sensor '%s' in %s/sys/bus/iio/devices",
                 config->imu, root);
        return 0;
    }
    sensors->scalar_first = strcmp(config->imu, "bno055") == 0;
    sensors->turn_fd = iio_open(path, "in_rot_quaternion_raw");
    if (sensors->turn_fd >= 0) {
        return 1;
    }
    if (!open_three(sensors->gyro_fd, path, "anglvel", &sensors->gyro_scale) ||
        !open_three(sensors->accel_fd, path, "accel", &sensors->accel_scale)) {
        snprintf(why, SENSORS_WHY_SIZE,
                 "'%s' gives neither in_rot_quaternion_raw nor in_anglvel_ and in_accel_ x y z",
                 config->imu);
        return 0;
    }
    return 1;
}

int sensors_open(struct sensors *sensors, const struct poi_config *config, const char *root,
                 char why[SENSORS_WHY_SIZE])
{
    *sensors = (struct sensors){ .turn_fd = -1 };
    for (uint32_t i = 0; i < 3; i++) {
        sensors->wire_fd[i] = sensors->gyro_fd[i] = sensors->accel_fd[i] = -1;
    }
    keys_open(&sensors->keys, root);
    return open_wires(sensors, config, root, why) && open_imu(sensors, config, root, why);
}

static int read_three(const int fd[3], float scale, vec3 *out)
{
    float n[3];
    for (uint32_t i = 0; i < 3; i++) {
        if (!iio_read(fd[i], 1, &n[i])) {
            return 0;
        }
    }
    *out = v3_scale(v3(n[0], n[1], n[2]), scale);
    return 1;
}

static int read_turn(struct sensors *sensors, struct readings *out)
{
    float n[4];
    out->fuses = sensors->turn_fd >= 0;
    if (!out->fuses) {
        return read_three(sensors->gyro_fd, sensors->gyro_scale, &out->gyro_rad_s) &&
               read_three(sensors->accel_fd, sensors->accel_scale, &out->accel_m_s2);
    }
    if (!iio_read(sensors->turn_fd, 4, n)) {
        return 0;
    }
    out->turn = sensors->scalar_first ? (struct quaternion){ n[0], n[1], n[2], n[3] }
                                      : (struct quaternion){ n[3], n[0], n[1], n[2] };
    return 1;
}

static int sensors_read_wire(int fd, float *out)
{
    float sum = 0.0f, one;
    for (uint32_t i = 0; i < SENSORS_SAMPLES; i++) {
        if (!iio_read(fd, 1, &one)) {
            return 0;
        }
        sum += one;
    }
    *out = sum / (float)SENSORS_SAMPLES;
    return 1;
}

int sensors_read(struct sensors *sensors, struct readings *out)
{
    int all = read_turn(sensors, out);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        all &= sensors_read_wire(sensors->wire_fd[i], &out->wire[i]);
    }
    out->buttons = keys_held(&sensors->keys);
    sensors->failed_count += !all;
    return all;
}

static void close_one(int *fd)
{
    if (*fd >= 0) {
        close(*fd);
    }
    *fd = -1;
}

void sensors_close(struct sensors *sensors)
{
    for (uint32_t i = 0; i < 3; i++) {
        close_one(&sensors->wire_fd[i]);
        close_one(&sensors->gyro_fd[i]);
        close_one(&sensors->accel_fd[i]);
    }
    close_one(&sensors->turn_fd);
    keys_close(&sensors->keys);
}
