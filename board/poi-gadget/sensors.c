/* sensors.c -- reads the sensor attributes in sequence. Each attribute is a text file that is read
 * again from its start. A complete reading takes about twenty system calls. If the kernel reports
 * that key events were lost, the state of all keys is read again. */
#include "board/poi-gadget/sensors.h"

#include <assert.h>
#include <fcntl.h>
#include <linux/input.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "drivers/hid/poi_report.h"
#include "platform/os/file.h"

/* ---- Attributes of IIO devices --------------------------------------------------------------- */

#define IIO_PATH_SIZE 256u

/* Maximum number of IIO devices that are searched. A board has only a few devices. */
#define DEVICES_MAX 32

static bool read_text(int fd, char *text, size_t size)
{
    const ssize_t got = pread(fd, text, size - 1, 0);
    text[got > 0 ? got : 0] = '\0';
    return got > 0;
}

/* Opens an attribute of a device for repeated reads. Returns the file descriptor, or -1 after an
 * error. */
static int iio_open(const char *device_path, const char *attribute)
{
    char path[IIO_PATH_SIZE];
    const int length = snprintf(path, sizeof path, "%s/%s", device_path, attribute);
    return length < (int)sizeof path ? open(path, O_RDONLY | O_CLOEXEC) : -1;
}

/* Finds the folder of the IIO device whose kernel name is `name`, and writes the folder's path to
 * `path`. `root` is the prefix of all paths: "" for this machine, or a test folder. If several
 * devices have the name, the device with the lowest number is used. Returns true, or false if there
 * is no such device. */
static bool iio_find(char path[IIO_PATH_SIZE], const char *root, const char *name)
{
    for (int i = 0; i < DEVICES_MAX; i++) {
        char text[64], name_path[IIO_PATH_SIZE + sizeof "/name"];
        const int length =
            snprintf(path, IIO_PATH_SIZE, "%s/sys/bus/iio/devices/iio:device%d", root, i);
        snprintf(name_path, sizeof name_path, "%s/name", path);
        file_first_line(name_path, text, sizeof text);
        if (length < (int)IIO_PATH_SIZE && strcmp(text, name) == 0) {
            return true;
        }
    }
    return false;
}

/* Reads the present numbers of an attribute. Returns true if the attribute contains exactly `count`
 * numbers. `count` is at most 4. */
static bool iio_read(int fd, uint32_t count, float *out)
{
    char text[96];
    assert(count > 0 && count <= 4);
    if (fd < 0 || !read_text(fd, text, sizeof text)) {
        return false;
    }
    const char *at = text;
    for (uint32_t i = 0; i < count; i++) {
        char *end;
        out[i] = strtof(at, &end);
        if (end == at) {
            return false;
        }
        at = end;
    }
    return at[strspn(at, " \n")] == '\0';
}

/* ---- Keys ------------------------------------------------------------------------------------ */

#define EVENT_DEVICES 32u
/* Maximum number of events in one read. Even a bouncing key sends fewer events. */
#define EVENTS_MAX 16

static const struct key_code {
    uint16_t code;
    uint8_t button;
} codes[] = {
    { BTN_TRIGGER, POI_BUTTON_OK },     { BTN_START, POI_BUTTON_START },
    { BTN_DPAD_LEFT, POI_BUTTON_LEFT }, { BTN_DPAD_RIGHT, POI_BUTTON_RIGHT },
    { BTN_THUMB, POI_BUTTON_FAN },
};
#define CODE_COUNT (sizeof codes / sizeof codes[0])

/* Adds to `held` the keys that the kernel reports as pressed. If the kernel returns an error,
 * `held` is unchanged. */
static void read_key_levels(struct keys *keys, int fd)
{
    uint8_t bits[KEY_MAX / 8 + 1] = { 0 };
    if (ioctl(fd, EVIOCGKEY(sizeof bits), bits) < 0) {
        return;
    }
    for (size_t k = 0; k < CODE_COUNT; k++) {
        if (bits[codes[k].code / 8] >> codes[k].code % 8 & 1) {
            keys->held |= codes[k].button;
        }
    }
}

void sensors_open_keys(struct keys *keys, const char *root)
{
    *keys = (struct keys){ 0 };
    for (uint32_t i = 0; i < EVENT_DEVICES && keys->count < KEYS_DEVICES_MAX; i++) {
        char path[256], phys[32];
        snprintf(path, sizeof path, "%s/sys/class/input/event%u/device/phys", root, i);
        file_first_line(path, phys, sizeof phys);
        const bool is_keys = strncmp(phys, "gpio-keys/", 10) == 0;
        snprintf(path, sizeof path, "%s/dev/input/event%u", root, i);
        const int fd = is_keys ? open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC) : -1;
        if (fd >= 0) {
            keys->fd[keys->count++] = fd;
            read_key_levels(keys, fd);
        }
    }
}

uint8_t sensors_held_keys(struct keys *keys)
{
    assert(keys->count <= KEYS_DEVICES_MAX);
    for (uint32_t i = 0; i < keys->count; i++) {
        struct input_event events[EVENTS_MAX];
        const ssize_t size = read(keys->fd[i], events, sizeof events);
        for (ssize_t e = 0; e < size / (ssize_t)sizeof events[0]; e++) {
            const struct input_event *event = &events[e];
            if (event->type == EV_SYN && event->code == SYN_DROPPED) {
                keys->held = 0;
                for (uint32_t k = 0; k < keys->count; k++) {
                    read_key_levels(keys, keys->fd[k]);
                }
            }
            for (size_t k = 0; k < CODE_COUNT && event->type == EV_KEY; k++) {
                const uint32_t bit = codes[k].code == event->code ? codes[k].button : 0u;
                keys->held = event->value ? keys->held | bit : keys->held & ~bit;
            }
        }
    }
    return (uint8_t)keys->held;
}

void sensors_close_keys(struct keys *keys)
{
    for (uint32_t i = 0; i < keys->count; i++) {
        close(keys->fd[i]);
    }
    keys->count = 0;
}

/* ---- All sensors ----------------------------------------------------------------------------- */

static bool open_wires(struct sensors *sensors, const struct poi_config *config, const char *root,
                       char why[SENSORS_WHY_SIZE])
{
    char path[IIO_PATH_SIZE], name[32];
    if (!iio_find(path, root, config->adc)) {
        snprintf(why, SENSORS_WHY_SIZE, "no converter '%s' in %s/sys/bus/iio/devices", config->adc,
                 root);
        return false;
    }
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        snprintf(name, sizeof name, "in_voltage%u_raw", config->channel[i]);
        sensors->fd[SENSORS_WIRE + i] = iio_open(path, name);
        if (sensors->fd[SENSORS_WIRE + i] < 0) {
            snprintf(why, SENSORS_WHY_SIZE, "'%s' has no %s for spool %u", config->adc, name,
                     i + 1);
            return false;
        }
    }
    return true;
}

static bool open_three(int fd[3], const char *path, const char *quantity, float *scale)
{
    char name[32];
    for (uint32_t i = 0; i < 3; i++) {
        snprintf(name, sizeof name, "in_%s_%c_raw", quantity, "xyz"[i]);
        fd[i] = iio_open(path, name);
        if (fd[i] < 0) {
            return false;
        }
    }
    snprintf(name, sizeof name, "in_%s_scale", quantity);
    const int scale_fd = iio_open(path, name);
    const bool got = iio_read(scale_fd, 1, scale);
    if (scale_fd >= 0) {
        close(scale_fd);
    }
    return got && *scale != 0.0f;
}

/* Opens the inertial chip. By the sysfs-bus-iio ABI, the order of a quaternion is x y z w. Linux's
 * bno055 driver instead writes the order of the chip's registers, w x y z. */
static bool open_imu(struct sensors *sensors, const struct poi_config *config, const char *root,
                     char why[SENSORS_WHY_SIZE])
{
    char path[IIO_PATH_SIZE];
    int *fd = sensors->fd;
    if (!iio_find(path, root, config->imu)) {
        snprintf(why, SENSORS_WHY_SIZE, "no inertial sensor '%s' in %s/sys/bus/iio/devices",
                 config->imu, root);
        return false;
    }
    sensors->scalar_first = strcmp(config->imu, "bno055") == 0;
    fd[SENSORS_TURN] = iio_open(path, "in_rot_quaternion_raw");
    if (fd[SENSORS_TURN] < 0 &&
        (!open_three(&fd[SENSORS_GYRO], path, "anglvel", &sensors->gyro_scale) ||
         !open_three(&fd[SENSORS_ACCEL], path, "accel", &sensors->accel_scale))) {
        snprintf(why, SENSORS_WHY_SIZE,
                 "'%s' gives neither in_rot_quaternion_raw nor in_anglvel_ and in_accel_ x y z",
                 config->imu);
        return false;
    }
    return true;
}

bool sensors_open(struct sensors *sensors, const struct poi_config *config, const char *root,
                  char why[SENSORS_WHY_SIZE])
{
    *sensors = (struct sensors){ 0 };
    memset(sensors->fd, -1, sizeof sensors->fd);
    sensors_open_keys(&sensors->keys, root);
    return open_wires(sensors, config, root, why) && open_imu(sensors, config, root, why);
}

static bool read_three(const int fd[3], float scale, vec3 *out)
{
    float n[3];
    for (uint32_t i = 0; i < 3; i++) {
        if (!iio_read(fd[i], 1, &n[i])) {
            return false;
        }
    }
    *out = v3_scale(v3(n[0], n[1], n[2]), scale);
    return true;
}

static bool read_turn(struct sensors *sensors, struct readings *out)
{
    const int *fd = sensors->fd;
    float n[4];
    out->fuses = fd[SENSORS_TURN] >= 0;
    if (!out->fuses) {
        return read_three(&fd[SENSORS_GYRO], sensors->gyro_scale, &out->gyro_rad_s) &&
               read_three(&fd[SENSORS_ACCEL], sensors->accel_scale, &out->accel_m_s2);
    }
    if (!iio_read(fd[SENSORS_TURN], 4, n)) {
        return false;
    }
    out->turn = sensors->scalar_first ? (struct quaternion){ n[0], n[1], n[2], n[3] }
                                      : (struct quaternion){ n[3], n[0], n[1], n[2] };
    return true;
}

bool sensors_read(struct sensors *sensors, struct readings *out)
{
    bool all = read_turn(sensors, out);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        float sum = 0.0f, one = 0.0f;
        bool good = true;
        for (uint32_t k = 0; k < SENSORS_SAMPLES && good; k++) {
            good = iio_read(sensors->fd[SENSORS_WIRE + i], 1, &one);
            sum += one;
        }
        out->wire[i] = good ? sum / (float)SENSORS_SAMPLES : out->wire[i];
        all = all && good;
    }
    out->buttons = sensors_held_keys(&sensors->keys);
    sensors->failed_count += all ? 0u : 1u;
    return all;
}

void sensors_close(struct sensors *sensors)
{
    for (uint32_t i = 0; i < SENSORS_FD_COUNT; i++) {
        if (sensors->fd[i] >= 0) {
            close(sensors->fd[i]);
        }
        sensors->fd[i] = -1;
    }
    sensors_close_keys(&sensors->keys);
}

/* ---- Source of poses ------------------------------------------------------------------------- */

static enum pose_result sensors_step(void *self, float seconds, struct poi_report *out)
{
    struct sensor_source *source = self;
    source->missed = sensors_read(&source->sensors, &source->readings) ? 0 : source->missed + 1;
    board_pose_step(&source->pose, &source->readings, seconds, out);
    if (source->missed > SENSOR_GONE_BEATS) {
        out->target.position_m.x = __builtin_nanf("");
    }
    return POSE_NEW;
}

struct pose_source sensors_source(struct sensor_source *source, const struct poi_config *config)
{
    board_pose_init(&source->pose, config);
    source->missed = 0;
    return (struct pose_source){ .step = sensors_step, .self = source };
}
