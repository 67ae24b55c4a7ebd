/* commands.c -- measures the draw wires at each calibration mark, as a mean over one second, and
 * checks the parts of a poi. Each result of a check is printed immediately. */
#include "board/poi-gadget/commands.h"

#include <assert.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "board/poi-gadget/board_pose.h"
#include "board/poi-gadget/draw_wires.h"
#include "board/poi-gadget/motor.h"
#include "board/poi-gadget/sensors.h"
#include "platform/os/print.h"

/* ---- Calibration of the wires ---------------------------------------------------------------- */

#define READINGS 50u
#define BETWEEN_NS 20000000
/* Maximum range of the converter steps while the user holds the eye (the point where the wires
 * meet) on a mark. 20 steps are 5 mm of wire. */
#define STILL_STEPS 20.0f

/* Computes the mean and the range of the sensor readings during one second. Returns 1, or 0 if a
 * sensor does not respond. */
static int mean_readings(struct sensors *sensors, struct readings *mean, float spread[3])
{
    float low[3], high[3];
    *mean = (struct readings){ 0 };
    for (uint32_t n = 0; n < READINGS; n++) {
        struct readings one = { 0 };
        if (!sensors_read(sensors, &one)) {
            return 0;
        }
        for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
            low[i] = n == 0 ? one.wire[i] : f_min(low[i], one.wire[i]);
            high[i] = n == 0 ? one.wire[i] : f_max(high[i], one.wire[i]);
            mean->wire[i] += one.wire[i] / (float)READINGS;
            spread[i] = high[i] - low[i];
        }
        mean->fuses = one.fuses;
        mean->gyro_rad_s = v3_muladd(mean->gyro_rad_s, one.gyro_rad_s, 1.0f / (float)READINGS);
        nanosleep(&(struct timespec){ .tv_nsec = BETWEEN_NS }, NULL);
    }
    return 1;
}

static int wait_for_enter(void)
{
    int letter;
    do {
        letter = getchar();
    } while (letter != '\n' && letter != EOF);
    return letter != EOF;
}

/* Asks the user to hold the eye on a mark, measures the wires, and adds the mark to the fits of the
 * three wires. */
static int ask_mark(const struct poi_config *config, struct sensors *sensors, uint32_t mark,
                    struct wire_fit fits[DRAW_WIRE_COUNT], struct readings *mean)
{
    assert(mark < config->mark_count);
    const vec3 at_m = config->mark_m[mark];
    float length_m[DRAW_WIRE_COUNT], spread[DRAW_WIRE_COUNT];
    for (;;) {
        print_error("mark %u of %u: hold the eye still at %.0f %.0f %.0f mm, press Enter", mark + 1,
                    config->mark_count, (double)(at_m.x * 1000.0f), (double)(at_m.y * 1000.0f),
                    (double)(at_m.z * 1000.0f));
        if (!wait_for_enter() || !mean_readings(sensors, mean, spread)) {
            print_error("kingyo-poi: standard input or a sensor ended");
            return 0;
        }
        const float most = f_max(spread[0], f_max(spread[1], spread[2]));
        if (most < STILL_STEPS) {
            break;
        }
        print_error("  it moved by %.0f steps; once more", (double)most);
    }
    draw_wires_lengths(config->spool_m, at_m, length_m);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        draw_wires_fit_add(&fits[i], mean->wire[i], length_m[i]);
    }
    return 1;
}

static enum exit_code calibrate_print_result(const struct poi_config *config,
                                             struct wire_fit fits[DRAW_WIRE_COUNT],
                                             const struct readings *rest)
{
    enum exit_code code = EXIT_OK;
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        const char *why;
        if (!draw_wires_fit_solve(&fits[i], &why)) {
            print_error("wire%u: %s", i + 1, why);
            code = EXIT_NOT_SO;
            continue;
        }
        printf("wire%u = %.3f %.6f # worst mark %.2f mm off\n", i + 1,
               (double)(fits[i].zero_m * 1000.0f), (double)(fits[i].step_m * 1000.0f),
               (double)(fits[i].miss_m * 1000.0f));
    }
    if (code == EXIT_OK && !rest->fuses) {
        const vec3 bias = poi_config_from_chip(config, rest->gyro_rad_s);
        printf("gyro_bias = %.5f %.5f %.5f\n", (double)bias.x, (double)bias.y, (double)bias.z);
    }
    return code;
}

enum exit_code commands_calibrate(const struct poi_config *config, const char *root)
{
    struct wire_fit fits[DRAW_WIRE_COUNT] = { 0 };
    struct sensors sensors;
    struct readings rest = { 0 };
    char why[SENSORS_WHY_SIZE];
    float spread[DRAW_WIRE_COUNT];
    enum exit_code code = EXIT_IO;
    if (!sensors_open(&sensors, config, root, why)) {
        print_error("kingyo-poi: %s", why);
    } else {
        uint32_t mark = 0;
        while (mark < config->mark_count && ask_mark(config, &sensors, mark, fits, &rest)) {
            mark++;
        }
        if (mark == config->mark_count) {
            print_error("lay the poi down, press Enter");
            code = wait_for_enter() && mean_readings(&sensors, &rest, spread)
                       ? calibrate_print_result(config, fits, &rest)
                       : EXIT_IO;
        }
    }
    sensors_close(&sensors);
    return code;
}

/* ---- Self-test ------------------------------------------------------------------------------- */

#define LOOKS 50u /* Number of readings of the sensors while the poi is at rest. */
#define LOOK_S 0.02f
/* Maximum range of the converter steps while the poi is at rest. 8 steps are 2 mm of wire. With a
 * working converter, the means of four readings vary less. */
#define NOISE_STEPS_MAX 8.0f
/* Maximum difference between the measured gravity and g, as a fraction of g. A larger difference
 * means that the inertial chip is defective or that the poi moves. */
#define GRAVITY_OFF_MAX 0.08f
#define SPIN_REST_MAX 0.2f /* Maximum rotation rate in rad/s while the poi is at rest. */

struct verdicts {
    uint32_t good, bad;
};

/* Prints one line with "ok" or "FAIL", the name of the check, and the reason. Counts the result in
 * `verdicts`. */
__attribute__((format(printf, 4, 5))) static void
print_verdict(struct verdicts *verdicts, int good, const char *what, const char *format, ...)
{
    char why[PRINT_LINE_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    print_line(stdout, "%-4s  %-10s %s", good ? "ok" : "FAIL", what, why);
    fflush(stdout);
    if (good) {
        verdicts->good++;
    } else {
        verdicts->bad++;
    }
}

/* ---- Sensors at rest ------------------------------------------------------------------------- */

struct looks {
    struct readings last;
    float low[DRAW_WIRE_COUNT], high[DRAW_WIRE_COUNT];
    float spin_rad_s, pull_m_s2; /* Mean magnitude of the rotation rate and mean magnitude of the
                                    acceleration over all readings. */
    uint32_t missed;
    struct timespec began, ended;
};

static void observe_sensors(struct sensors *sensors, struct looks *looks)
{
    *looks = (struct looks){ 0 };
    clock_gettime(CLOCK_MONOTONIC, &looks->began);
    for (uint32_t n = 0; n < LOOKS; n++) {
        looks->missed += !sensors_read(sensors, &looks->last);
        for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
            const float wire = looks->last.wire[i];
            looks->low[i] = n == 0 ? wire : f_min(looks->low[i], wire);
            looks->high[i] = n == 0 ? wire : f_max(looks->high[i], wire);
        }
        looks->spin_rad_s += v3_length(looks->last.gyro_rad_s) / (float)LOOKS;
        looks->pull_m_s2 += v3_length(looks->last.accel_m_s2) / (float)LOOKS;
    }
    clock_gettime(CLOCK_MONOTONIC, &looks->ended);
}

static void judge_readings(struct verdicts *verdicts, const struct poi_config *config,
                           const struct looks *looks)
{
    const double seconds = (double)(looks->ended.tv_sec - looks->began.tv_sec) +
                           (double)(looks->ended.tv_nsec - looks->began.tv_nsec) * 1e-9;
    const double each_ms = seconds * 1000.0 / (double)LOOKS;
    assert(looks->missed <= LOOKS);
    print_verdict(verdicts, looks->missed == 0, "sensors", "%u of %u readings answered",
                  LOOKS - looks->missed, LOOKS);
    print_verdict(verdicts, each_ms < 4.0, "speed", "%.2f ms a reading: %.0f a second%s", each_ms,
                  1000.0 / each_ms, each_ms < 4.0 ? "" : "; raise the bus' clock, or lower --rate");
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        const float noise = looks->high[i] - looks->low[i];
        const int out = looks->low[i] >= BOARD_POSE_STEPS_MIN;
        char what[16];
        snprintf(what, sizeof what, "wire %u", i + 1);
        print_verdict(verdicts, noise <= NOISE_STEPS_MAX && out, what,
                      "channel %u says %.1f, within %.1f steps%s", config->channel[i],
                      (double)looks->last.wire[i], (double)noise,
                      noise > NOISE_STEPS_MAX ? "; hold the poi still, or shield the cable"
                      : out                   ? ""
                                              : "; that is its stop, or an open potentiometer");
    }
}

static void judge_turn(struct verdicts *verdicts, const struct poi_config *config,
                       const struct looks *looks)
{
    const struct quaternion q = looks->last.turn;
    if (looks->last.fuses) {
        const int alive = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z > 0.0f;
        print_verdict(verdicts, alive, "inertia", "%s fuses by itself%s", config->imu,
                      alive ? "" : ", but says nothing: write a fusing mode to its operation_mode");
        return;
    }
    const float off = f_abs(looks->pull_m_s2 / GRAVITY_M_S2 - 1.0f);
    print_verdict(verdicts, off < GRAVITY_OFF_MAX, "gravity", "%.2f m/s^2%s",
                  (double)looks->pull_m_s2,
                  off < GRAVITY_OFF_MAX ? "" : "; lay the poi down, and look at the chip's scale");
    print_verdict(verdicts, looks->spin_rad_s < SPIN_REST_MAX, "gyroscope", "%.3f rad/s at rest%s",
                  (double)looks->spin_rad_s,
                  looks->spin_rad_s < SPIN_REST_MAX ? "" : "; lay it down");
}

static void judge_place(struct verdicts *verdicts, const struct poi_config *config,
                        const struct looks *looks)
{
    struct board_pose pose;
    struct poi_report report = { 0 };
    if (!poi_config_is_calibrated(config)) {
        print_verdict(verdicts, 0, "place", "the wires are not calibrated: kingyo-poi calibrate");
        return;
    }
    board_pose_init(&pose, config);
    for (uint32_t i = 0; i < 3; i++) {
        board_pose_step(&pose, &looks->last, LOOK_S, &report);
    }
    const vec3 at_m = report.target.position_m;
    const int reach = v3_is_finite(at_m) && v3_length(at_m) < POI_REPORT_REACH_M;
    print_verdict(verdicts, pose.wires == DRAW_WIRES_OK && reach, "place",
                  "%s; ring at %.0f %.0f %.0f mm", draw_wires_text(pose.wires),
                  (double)(at_m.x * 1000.0f), (double)(at_m.y * 1000.0f),
                  (double)(at_m.z * 1000.0f));
}

static void judge_sensors(struct verdicts *verdicts, const struct poi_config *config,
                          const char *root)
{
    struct sensors sensors;
    struct looks looks;
    char why[SENSORS_WHY_SIZE];
    if (!sensors_open(&sensors, config, root, why)) {
        print_verdict(verdicts, 0, "sensors",
                      "%s; look at dtoverlay in config.txt and at the wiring", why);
    } else {
        observe_sensors(&sensors, &looks);
        judge_readings(verdicts, config, &looks);
        judge_turn(verdicts, config, &looks);
        judge_place(verdicts, config, &looks);
        print_verdict(verdicts, 1, "keys", "%u device%s of gpio-keys; held now: %02x",
                      sensors.keys.count, sensors.keys.count == 1 ? "" : "s", looks.last.buttons);
    }
    sensors_close(&sensors);
}

/* ---- Motor, light and USB -------------------------------------------------------------------- */

static void judge_motor(struct verdicts *verdicts, const struct poi_config *config,
                        const char *root)
{
    struct motor motor;
    char why[MOTOR_WHY_SIZE];
    const int named = config->pwm_chip >= 0 || config->light[0] != '\0';
    const int works = motor_open(&motor, config, root, why);
    print_verdict(verdicts, works, "motor", "%s",
                  !works  ? why
                  : named ? "did it hum, and the light shine?"
                          : "none named: the hand feels nothing");
    if (named) {
        motor_set(&motor, (struct feel_levels){ .motor = 0.8f, .light = 1.0f });
        nanosleep(&(struct timespec){ .tv_nsec = 500000000 }, NULL);
        motor_set(&motor, (struct feel_levels){ 0 });
    }
}

enum exit_code commands_self_test(const struct poi_config *config, const char *root,
                                  const char *device)
{
    struct verdicts verdicts = { 0 };
    judge_sensors(&verdicts, config, root);
    judge_motor(&verdicts, config, root);
    const int can = access(device, R_OK | W_OK) == 0;
    print_verdict(&verdicts, can, "cable", "%s%s%s", device, can ? "" : ": ",
                  can ? "" : strerror(errno));
    printf("%u ok, %u failed\n", verdicts.good, verdicts.bad);
    return verdicts.bad == 0 ? EXIT_OK : EXIT_NOT_SO;
}
