/* poi_config.c -- parses the configuration file with a table of setting names and their types. */
#include "board/poi-gadget/poi_config.h"

#include <assert.h>
#include <errno.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/os/print.h"
#include "platform/os/file.h"

#define MM 0.001f
#define NUMBERS_MAX 4u
/* Maximum coordinate of a position in mm, in the positive and in the negative direction of each
 * axis. */
#define PLACE_MAX_MM 3000.0f

void poi_config_init(struct poi_config *config)
{
    *config = (struct poi_config){
        .adc = "mcp3208",
        .imu = "bno055",
        .channel = { 0, 1, 2 },
        .spool_m = { { -0.45f, 0.75f, -0.30f }, { 0.45f, 0.75f, -0.30f }, { 0.0f, 0.75f, 0.35f } },
        .ring_m = { 0.0f, -0.015f, -0.060f },
        .imu_row = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
        .ahead_s = 30.0f,
        .pwm_chip = -1,
        .motor_hz = 200,
        .motor_least = 0.2f,
    };
}

/* ---- Settings -------------------------------------------------------------------------------- */

/* Describes one setting of the configuration file. `set` parses the value and returns true. An
 * invalid value gives false. */
struct setting {
    const char *name;
    bool (*set)(struct poi_config *config, const struct setting *setting, const char *value);
    const char *expects; /* Text that describes the valid values in an error message. */
    /* Index of the spool or of the wire whose value `set` stores. For all other settings, the
     * offset of the field in struct poi_config. */
    size_t at;
    /* Used by read_floats(): `count` is the number of values, `least` and `most` are the limits of
     * each value, and `unit` is the factor that converts a value to the stored unit. */
    uint32_t count;
    float least, most, unit;
};

/* Parses exactly `count` numbers, each from `least` to `most`. Returns true, or false if the
 * text is invalid. */
static bool read_numbers(const char *text, uint32_t count, float least, float most,
                         float out[NUMBERS_MAX])
{
    assert(count <= NUMBERS_MAX);
    for (uint32_t i = 0; i < count; i++) {
        char *end;
        out[i] = strtof(text, &end);
        if (end == text || !f_is_finite(out[i]) || out[i] < least || out[i] > most) {
            return false;
        }
        text = end;
    }
    return text[strspn(text, " \t")] == '\0';
}

/* Parses `setting->count` numbers and stores them one after the other at the offset `setting->at`.
 * Each number is multiplied by `setting->unit`. */
static bool read_floats(struct poi_config *config, const struct setting *setting, const char *value)
{
    float n[NUMBERS_MAX];
    assert(setting->at + setting->count * sizeof n[0] <= sizeof *config);
    if (!read_numbers(value, setting->count, setting->least, setting->most, n)) {
        return false;
    }
    for (uint32_t i = 0; i < setting->count; i++) {
        n[i] *= setting->unit;
    }
    memcpy((char *)config + setting->at, n, setting->count * sizeof n[0]);
    return true;
}

static bool poi_config_is_whole(float number, float most)
{
    return number >= 0.0f && number <= most && number == f_floor(number);
}

static bool read_spool(struct poi_config *config, const struct setting *setting, const char *value)
{
    float n[NUMBERS_MAX];
    assert(setting->at < DRAW_WIRE_COUNT);
    if (!read_numbers(value, 4, -PLACE_MAX_MM, PLACE_MAX_MM, n) ||
        !poi_config_is_whole(n[0], POI_CONFIG_CHANNEL_MAX)) {
        return false;
    }
    config->channel[setting->at] = (uint32_t)n[0];
    config->spool_m[setting->at] = v3_scale(v3(n[1], n[2], n[3]), MM);
    return true;
}

static bool poi_config_read_wire(struct poi_config *config, const struct setting *setting,
                                 const char *value)
{
    float n[NUMBERS_MAX];
    assert(setting->at < DRAW_WIRE_COUNT);
    if (!read_numbers(value, 2, -10000.0f, 10000.0f, n) || n[1] == 0.0f) {
        return false;
    }
    config->zero_m[setting->at] = n[0] * MM;
    config->step_m[setting->at] = n[1] * MM;
    return true;
}

/* Parses three axes of the inertial chip, for example "+x -z +y". Returns true, or false if the
 * axes do not form a rotation matrix. A reflection is invalid. */
static bool read_axes(struct poi_config *config, const struct setting *setting, const char *value)
{
    (void)setting;
    vec3 row[3];
    for (uint32_t i = 0; i < 3; i++) {
        value += strspn(value, " \t");
        if ((value[0] != '+' && value[0] != '-') || value[1] < 'x' || value[1] > 'z') {
            return false;
        }
        const float sign = value[0] == '+' ? 1.0f : -1.0f;
        row[i] = v3(value[1] == 'x' ? sign : 0.0f, value[1] == 'y' ? sign : 0.0f,
                    value[1] == 'z' ? sign : 0.0f);
        value += 2;
    }
    if (*value != '\0' || v3_dot(v3_cross(row[0], row[1]), row[2]) < 0.5f) {
        return false;
    }
    memcpy(config->imu_row, row, sizeof row);
    return true;
}

static bool read_name(struct poi_config *config, const struct setting *setting, const char *value)
{
    if (strlen(value) >= POI_CONFIG_NAME_SIZE || strchr(value, '/')) {
        return false;
    }
    snprintf((char *)config + setting->at, POI_CONFIG_NAME_SIZE, "%s", value);
    return true;
}

static bool read_motor(struct poi_config *config, const struct setting *setting, const char *value)
{
    (void)setting;
    float n[NUMBERS_MAX];
    if (strcmp(value, "none") == 0) {
        config->pwm_chip = -1;
        return true;
    }
    if (!read_numbers(value, 4, 0.0f, 100000.0f, n) || !poi_config_is_whole(n[0], 63.0f) ||
        !poi_config_is_whole(n[1], 15.0f) || !poi_config_is_whole(n[2], 100000.0f) ||
        n[2] < 20.0f || n[3] >= 1.0f) {
        return false;
    }
    config->pwm_chip = (int32_t)n[0];
    config->pwm_channel = (uint32_t)n[1];
    config->motor_hz = (uint32_t)n[2];
    config->motor_least = n[3];
    return true;
}

static bool read_mark(struct poi_config *config, const struct setting *setting, const char *value)
{
    (void)setting;
    float n[NUMBERS_MAX];
    if (config->mark_count == POI_CONFIG_MARK_MAX ||
        !read_numbers(value, 3, -PLACE_MAX_MM, PLACE_MAX_MM, n)) {
        return false;
    }
    config->mark_m[config->mark_count++] = v3_scale(v3(n[0], n[1], n[2]), MM);
    return true;
}

#define FIELD(name) offsetof(struct poi_config, name)
#define SPOOL_TEXT "a spool is a channel and X Y Z in mm"
#define WIRE_TEXT "a wire is its length at 0 and its length a step, in mm"

static const struct setting settings[] = {
    { "adc", read_name, "adc is the name of an IIO device, at most 31 letters", .at = FIELD(adc) },
    { "imu", read_name, "imu is the name of an IIO device, at most 31 letters", .at = FIELD(imu) },
    { "light", read_name, "light is a name of /sys/class/leds, at most 31 letters",
      .at = FIELD(light) },
    { "spool1", read_spool, SPOOL_TEXT, .at = 0 },
    { "spool2", read_spool, SPOOL_TEXT, .at = 1 },
    { "spool3", read_spool, SPOOL_TEXT, .at = 2 },
    { "wire1", poi_config_read_wire, WIRE_TEXT, .at = 0 },
    { "wire2", poi_config_read_wire, WIRE_TEXT, .at = 1 },
    { "wire3", poi_config_read_wire, WIRE_TEXT, .at = 2 },
    { "ring", read_floats, "ring is X Y Z in mm", FIELD(ring_m), 3, -PLACE_MAX_MM, PLACE_MAX_MM,
      MM },
    { "imu_axes", read_axes, "imu_axes is a turn such as +x +y +z or +x +z -y", .at = 0 },
    { "gyro_bias", read_floats, "gyro_bias is three numbers of rad/s within +-0.2",
      FIELD(gyro_bias_rad_s), 3, -0.2f, 0.2f, 1.0f },
    { "ahead_s", read_floats, "ahead_s is seconds, 0 .. 3600", FIELD(ahead_s), 1, 0.0f, 3600.0f,
      1.0f },
    { "motor", read_motor, "motor is none, or chip, channel, Hz and least duty: 0 0 200 0.2",
      .at = 0 },
    { "mark", read_mark, "a mark is X Y Z in mm, and there are at most 8", .at = 0 },
};

/* ---- Parsing lines --------------------------------------------------------------------------- */

int poi_config_line(struct poi_config *config, const char *line, const char **why)
{
    char copy[POI_CONFIG_LINE_SIZE];
    if ((size_t)snprintf(copy, sizeof copy, "%s", line) >= sizeof copy) {
        *why = "the line is longer than 159 bytes";
        return -1;
    }
    copy[strcspn(copy, "#")] = '\0';
    char *name = file_trim(copy);
    if (*name == '\0') {
        return 0;
    }
    *why = "a line is: name = value";
    const char *value = file_cut_value(name);
    if (!value) {
        return -1;
    }
    *why = "no such name; poi.conf lists them";
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (strcmp(settings[i].name, name) == 0) {
            *why = settings[i].expects;
            return settings[i].set(config, &settings[i], value) ? 1 : -1;
        }
    }
    return -1;
}

bool poi_config_is_sound(const struct poi_config *config, const char **why)
{
    if (!draw_wires_is_determined(config->spool_m)) {
        *why = "the spools must hang apart, in a plane that is more level than steep";
        return false;
    }
    const uint32_t *channel = config->channel;
    if (channel[0] == channel[1] || channel[1] == channel[2] || channel[0] == channel[2]) {
        *why = "two spools are on one channel";
        return false;
    }
    return true;
}

bool poi_config_is_calibrated(const struct poi_config *config)
{
    return config->step_m[0] != 0.0f && config->step_m[1] != 0.0f && config->step_m[2] != 0.0f;
}

vec3 poi_config_from_chip(const struct poi_config *config, vec3 chip)
{
    return v3(v3_dot(config->imu_row[0], chip), v3_dot(config->imu_row[1], chip),
              v3_dot(config->imu_row[2], chip));
}

bool poi_config_load(struct poi_config *config, const char *path)
{
    char line[POI_CONFIG_LINE_SIZE + 1];
    const char *why = NULL;
    uint32_t number = 0;
    FILE *file = file_open(path, POI_CONFIG_SIZE_MAX);
    if (!file) {
        print_error("%s: %s", path, file_error(errno));
        return false;
    }
    int result = 0;
    enum file_line end;
    while (result >= 0 && (end = file_read_line(file, line, sizeof line)) != FILE_LINE_END) {
        number++;
        why = "the line is too long or has a zero byte";
        result = end == FILE_LINE_BAD ? -1 : poi_config_line(config, line, &why);
    }
    const int read_error = ferror(file) ? errno : 0;
    fclose(file);
    if (result >= 0 && read_error) {
        print_error("%s: %s", path, file_error(read_error));
        return false;
    }
    if (result >= 0 && !poi_config_is_sound(config, &why)) {
        result = -1;
    }
    if (result < 0) {
        print_error("%s:%u: %s", path, number, why);
    }
    return result >= 0;
}
