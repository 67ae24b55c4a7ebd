/* poi_config.c -- parses the configuration file with a table of setting names and their types. */
#include "board/poi-gadget/poi_config.h"

#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/os/print.h"
#include "platform/os/regular_file.h"

#define MM 0.001f
#define NUMBERS_MAX 4u

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

/* ---- Parsing values -------------------------------------------------------------------------- */

/* Parses exactly `count` numbers, each in [-`most`, `most`]. Returns 1, or 0 if the text is
 * invalid. */
static int read_numbers(const char *text, uint32_t count, float most, float out[NUMBERS_MAX])
{
    for (uint32_t i = 0; i < count; i++) {
        char *end;
        out[i] = strtof(text, &end);
        if (end == text || !f_is_finite(out[i]) || f_abs(out[i]) > most) {
            return 0;
        }
        text = end;
    }
    return text[strspn(text, " \t")] == '\0';
}

static int read_place(const char *value, vec3 *out)
{
    float n[NUMBERS_MAX];
    if (!read_numbers(value, 3, 3000.0f, n)) {
        return 0;
    }
    *out = v3_scale(v3(n[0], n[1], n[2]), MM);
    return 1;
}

static int poi_config_is_whole(float number, float most)
{
    return number >= 0.0f && number <= most && number == f_floor(number);
}

static int read_spool(struct poi_config *config, uint32_t index, const char *value)
{
    float n[NUMBERS_MAX];
    if (!read_numbers(value, 4, 3000.0f, n) || !poi_config_is_whole(n[0], POI_CONFIG_CHANNEL_MAX)) {
        return 0;
    }
    config->channel[index] = (uint32_t)n[0];
    config->spool_m[index] = v3_scale(v3(n[1], n[2], n[3]), MM);
    return 1;
}

static int poi_config_read_wire(struct poi_config *config, uint32_t index, const char *value)
{
    float n[NUMBERS_MAX];
    if (!read_numbers(value, 2, 10000.0f, n) || n[1] == 0.0f) {
        return 0;
    }
    config->zero_m[index] = n[0] * MM;
    config->step_m[index] = n[1] * MM;
    return 1;
}

/* Parses three axes of the chip, for example "+x -z +y". Returns 1, or 0 if the axes do not form a
 * rotation matrix. A reflection is invalid. */
static int read_axes(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    vec3 row[3];
    for (uint32_t i = 0; i < 3; i++) {
        value += strspn(value, " \t");
        if ((value[0] != '+' && value[0] != '-') || value[1] < 'x' || value[1] > 'z') {
            return 0;
        }
        const float sign = value[0] == '+' ? 1.0f : -1.0f;
        row[i] = v3(value[1] == 'x' ? sign : 0.0f, value[1] == 'y' ? sign : 0.0f,
                    value[1] == 'z' ? sign : 0.0f);
        value += 2;
    }
    if (*value != '\0' || v3_dot(v3_cross(row[0], row[1]), row[2]) < 0.5f) {
        return 0;
    }
    memcpy(config->imu_row, row, sizeof row);
    return 1;
}

static int read_ring(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    return read_place(value, &config->ring_m);
}

static int read_name(char out[POI_CONFIG_NAME_SIZE], const char *value)
{
    if (strlen(value) >= POI_CONFIG_NAME_SIZE || strchr(value, '/')) {
        return 0;
    }
    strcpy(out, value);
    return 1;
}

static int read_adc(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    return read_name(config->adc, value);
}

static int read_imu(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    return read_name(config->imu, value);
}

static int read_light(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    return read_name(config->light, value);
}

static int read_motor(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    float n[NUMBERS_MAX];
    if (strcmp(value, "none") == 0) {
        config->pwm_chip = -1;
        return 1;
    }
    if (!read_numbers(value, 4, 100000.0f, n) || !poi_config_is_whole(n[0], 63.0f) ||
        !poi_config_is_whole(n[1], 15.0f) || !poi_config_is_whole(n[2], 100000.0f) ||
        n[2] < 20.0f || n[3] < 0.0f || n[3] >= 1.0f) {
        return 0;
    }
    config->pwm_chip = (int32_t)n[0];
    config->pwm_channel = (uint32_t)n[1];
    config->motor_hz = (uint32_t)n[2];
    config->motor_least = n[3];
    return 1;
}

static int read_mark(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    if (config->mark_count == POI_CONFIG_MARK_MAX ||
        !read_place(value, &config->mark_m[config->mark_count])) {
        return 0;
    }
    config->mark_count++;
    return 1;
}

static int read_bias(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    float n[NUMBERS_MAX];
    if (!read_numbers(value, 3, 0.2f, n)) {
        return 0;
    }
    config->gyro_bias_rad_s = v3(n[0], n[1], n[2]);
    return 1;
}

static int read_ahead(struct poi_config *config, uint32_t index, const char *value)
{
    (void)index;
    float n[NUMBERS_MAX];
    if (!read_numbers(value, 1, 3600.0f, n) || n[0] < 0.0f) {
        return 0;
    }
    config->ahead_s = n[0];
    return 1;
}

/* ---- Parsing lines --------------------------------------------------------------------------- */

/* Table of the settings. `index` is the number of a spool or of a wire. Settings without a number
 * ignore `index`. */
static const struct setting {
    const char *name;
    int (*set)(struct poi_config *config, uint32_t index, const char *value);
    uint32_t index;
    const char *expects;
} settings[] = {
    { "adc", read_adc, 0, "adc is the name of an IIO device, at most 31 letters" },
    { "imu", read_imu, 0, "imu is the name of an IIO device, at most 31 letters" },
    { "light", read_light, 0, "light is a name of /sys/class/leds, at most 31 letters" },
    { "spool1", read_spool, 0, "a spool is a channel and X Y Z in mm" },
    { "spool2", read_spool, 1, "a spool is a channel and X Y Z in mm" },
    { "spool3", read_spool, 2, "a spool is a channel and X Y Z in mm" },
    { "wire1", poi_config_read_wire, 0, "a wire is its length at 0 and its length a step, in mm" },
    { "wire2", poi_config_read_wire, 1, "a wire is its length at 0 and its length a step, in mm" },
    { "wire3", poi_config_read_wire, 2, "a wire is its length at 0 and its length a step, in mm" },
    { "ring", read_ring, 0, "ring is X Y Z in mm" },
    { "imu_axes", read_axes, 0, "imu_axes is a turn such as +x +y +z or +x +z -y" },
    { "gyro_bias", read_bias, 0, "gyro_bias is three numbers of rad/s within +-0.2" },
    { "ahead_s", read_ahead, 0, "ahead_s is seconds, 0 .. 3600" },
    { "motor", read_motor, 0, "motor is none, or chip, channel, Hz and least duty: 0 0 200 0.2" },
    { "mark", read_mark, 0, "a mark is X Y Z in mm, and there are at most 8" },
};

/* Removes the comment and the white space around the text. Returns the first remaining
 * character. */
static char *poi_config_trim(char *text)
{
    text[strcspn(text, "#\r\n")] = '\0';
    text += strspn(text, " \t");
    size_t size = strlen(text);
    while (size > 0 && (text[size - 1] == ' ' || text[size - 1] == '\t')) {
        text[--size] = '\0';
    }
    return text;
}

int poi_config_line(struct poi_config *config, const char *line, const char **why)
{
    char copy[POI_CONFIG_LINE_SIZE];
    if (strlen(line) >= sizeof copy) {
        *why = "the line is longer than 159 bytes";
        return -1;
    }
    strcpy(copy, line);
    char *name = poi_config_trim(copy), *equals = strchr(name, '=');
    if (*name == '\0') {
        return 0;
    }
    *why = "a line is: name = value";
    if (!equals) {
        return -1;
    }
    *equals = '\0';
    const char *value = poi_config_trim(equals + 1);
    name = poi_config_trim(name);
    *why = "no such name; poi.conf lists them";
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (strcmp(settings[i].name, name) == 0) {
            *why = settings[i].expects;
            return settings[i].set(config, settings[i].index, value) ? 1 : -1;
        }
    }
    return -1;
}

int poi_config_is_sound(const struct poi_config *config, const char **why)
{
    if (!draw_wires_is_determined(config->spool_m)) {
        *why = "the spools must hang apart, in a plane that is more level than steep";
        return 0;
    }
    const uint32_t *channel = config->channel;
    if (channel[0] == channel[1] || channel[1] == channel[2] || channel[0] == channel[2]) {
        *why = "two spools are on one channel";
        return 0;
    }
    return 1;
}

int poi_config_is_calibrated(const struct poi_config *config)
{
    return config->step_m[0] != 0.0f && config->step_m[1] != 0.0f && config->step_m[2] != 0.0f;
}

int poi_config_load(struct poi_config *config, const char *path)
{
    char line[POI_CONFIG_LINE_SIZE + 1];
    const char *why = NULL;
    uint32_t number = 0;
    FILE *file = regular_file_open(path, POI_CONFIG_SIZE_MAX);
    if (!file) {
        print_error("%s: %s", path, regular_file_error(errno));
        return 0;
    }
    int result = 0;
    while (result >= 0 && fgets(line, sizeof line, file)) {
        number++;
        result = poi_config_line(config, line, &why);
    }
    fclose(file);
    if (result >= 0 && !poi_config_is_sound(config, &why)) {
        result = -1;
    }
    if (result < 0) {
        print_error("%s:%u: %s", path, number, why);
    }
    return result >= 0;
}
