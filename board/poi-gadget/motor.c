/* motor.c -- computes the level of the vibration motor from the decaying levels of drag, slap and
 * tear. Writes the duty of the motor and the brightness of the light as text to sysfs files. A file
 * is written only if its value has changed. */
#include "board/poi-gadget/motor.h"

#include <assert.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "platform/os/file.h"
#include "platform/os/number.h"

/* ---- Levels ---------------------------------------------------------------------------------- */

struct feel_levels motor_mix_step(struct motor_mix *mix, const struct poi_force *newest,
                                  float seconds)
{
    assert(seconds >= 0.0f);
    mix->slap *= f_exp(-seconds / FEEL_SLAP_S);
    mix->tear *= f_exp(-seconds / FEEL_TEAR_S);
    mix->silent_s = newest ? 0.0f : mix->silent_s + seconds;
    if (newest) {
        mix->drag = f_clamp(newest->drag, 0.0f, 1.0f);
        mix->slap = f_max(mix->slap, f_clamp(newest->slap, 0.0f, 1.0f));
        mix->tear = f_max(mix->tear, f_clamp(newest->tear, 0.0f, 1.0f));
    }
    if (mix->silent_s > FEEL_SILENT_S) {
        mix->drag = 0.0f;
    }
    mix->rattle_s = mix->tear > 0.02f ? mix->rattle_s + seconds : 0.0f;
    const float beat = mix->rattle_s * FEEL_RATTLE_HZ;
    const float rattle = beat - f_floor(beat) < 0.5f ? mix->tear : 0.0f;
    const float blow = f_max(mix->slap, rattle);
    return (struct feel_levels){
        .motor = f_min(FEEL_DRAG_SHARE * mix->drag + blow, 1.0f),
        .light = f_max(mix->slap, mix->tear),
    };
}

/* ---- Files of sysfs -------------------------------------------------------------------------- */

#define PATH_SIZE 256
/* Maximum number of attempts to open the exported files, 10 ms apart. udev sets the permissions of
 * the files some time after the export. */
#define EXPORT_TRIES 20

/* Writes a number to the start of an open file. Returns true, or false after an error. */
static bool write_number(int fd, uint32_t value)
{
    char text[16];
    const int size = snprintf(text, sizeof text, "%u", value);
    return pwrite(fd, text, (size_t)size, 0) == size;
}

/* Writes a number to the file `name` in `folder`. Returns true, or false after an error. */
static bool put_number(const char *folder, const char *name, uint32_t value)
{
    char path[PATH_SIZE + 32];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    const int fd = open(path, O_WRONLY | O_CLOEXEC);
    const bool wrote = fd >= 0 && write_number(fd, value);
    if (fd >= 0) {
        close(fd);
    }
    return wrote;
}

static void put_again(int fd, uint32_t *last, uint32_t value)
{
    if (fd >= 0 && value != *last && write_number(fd, value)) {
        *last = value;
    }
}

static bool open_pwm(struct motor *motor, const struct poi_config *config, const char *root,
                     char why[MOTOR_WHY_SIZE])
{
    char chip[PATH_SIZE], pwm[PATH_SIZE], path[PATH_SIZE + 32];
    assert(config->pwm_chip >= 0);
    assert(config->motor_hz > 0);
    snprintf(chip, sizeof chip, "%.200s/sys/class/pwm/pwmchip%d", root, config->pwm_chip);
    snprintf(pwm, sizeof pwm, "%.240s/pwm%u", chip, config->pwm_channel);
    snprintf(path, sizeof path, "%s/duty_cycle", pwm);
    if (access(path, F_OK) != 0 && !put_number(chip, "export", config->pwm_channel)) {
        snprintf(why, MOTOR_WHY_SIZE, "motor: cannot write %.120s/export", chip);
        return false;
    }
    motor->duty_fd = open(path, O_WRONLY | O_CLOEXEC);
    for (int i = 1; i < EXPORT_TRIES && motor->duty_fd < 0; i++) {
        nanosleep(&(struct timespec){ .tv_nsec = 10000000 }, NULL);
        motor->duty_fd = open(path, O_WRONLY | O_CLOEXEC);
    }
    motor->period_ns = 1000000000u / config->motor_hz;
    motor->least = config->motor_least;
    motor->duty_ns = UINT32_MAX;
    /* The duty is set to 0 before the period is set, because the kernel rejects a period that is
     * shorter than the duty. */
    put_again(motor->duty_fd, &motor->duty_ns, 0);
    const bool has_period = put_number(pwm, "period", motor->period_ns);
    if (motor->duty_fd < 0 || !has_period || !put_number(pwm, "enable", 1)) {
        snprintf(why, MOTOR_WHY_SIZE, "motor: cannot set up %.110s", pwm);
        return false;
    }
    return true;
}

static bool open_light(struct motor *motor, const struct poi_config *config, const char *root,
                       char why[MOTOR_WHY_SIZE])
{
    char path[PATH_SIZE], text[32];
    snprintf(path, sizeof path, "%s/sys/class/leds/%s/max_brightness", root, config->light);
    file_first_line(path, text, sizeof text);
    snprintf(path, sizeof path, "%s/sys/class/leds/%s/brightness", root, config->light);
    if (number_parse(text, 0, UINT32_MAX, &motor->light_most)) {
        motor->light_fd = open(path, O_WRONLY | O_CLOEXEC);
    }
    if (motor->light_fd < 0) {
        snprintf(why, MOTOR_WHY_SIZE, "light: no LED '%s' that may be written", config->light);
    }
    return motor->light_fd >= 0;
}

bool motor_open(struct motor *motor, const struct poi_config *config, const char *root,
                char why[MOTOR_WHY_SIZE])
{
    *motor = (struct motor){ .duty_fd = -1, .light_fd = -1, .light_value = UINT32_MAX };
    const bool turns = config->pwm_chip < 0 || open_pwm(motor, config, root, why);
    const bool shines = config->light[0] == '\0' || open_light(motor, config, root, why);
    motor_set(motor, (struct feel_levels){ 0 });
    return turns && shines;
}

void motor_set(struct motor *motor, struct feel_levels levels)
{
    assert(motor->least >= 0.0f && motor->least < 1.0f);
    const float level = f_clamp(levels.motor, 0.0f, 1.0f);
    const float duty = level < 0.02f ? 0.0f : motor->least + (1.0f - motor->least) * level;
    put_again(motor->duty_fd, &motor->duty_ns, (uint32_t)(duty * (float)motor->period_ns));
    const float light = f_clamp(levels.light, 0.0f, 1.0f) * (float)motor->light_most;
    put_again(motor->light_fd, &motor->light_value, (uint32_t)(light + 0.5f));
}

static void motor_force(void *self, const struct poi_force *newest, float seconds)
{
    struct motor *motor = self;
    motor_set(motor, motor_mix_step(&motor->mix, newest, seconds));
}

static void motor_stop(void *self)
{
    motor_set(self, (struct feel_levels){ 0 });
}

struct force_sink motor_sink(struct motor *motor)
{
    return (struct force_sink){ .feel = motor_force, .stop = motor_stop, .self = motor };
}
