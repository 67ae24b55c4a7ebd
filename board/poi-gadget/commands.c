/* commands.c -- measures the draw wires at each calibration mark, as a mean over one second, and
 * checks the parts of a poi. Each result of a check is printed immediately. */
#include "board/poi-gadget/run.h"

#include <assert.h>
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/draw_wires.h"
#include "board/poi-gadget/motor.h"
#include "board/poi-gadget/sensors.h"
#include "platform/os/clock.h"
#include "platform/os/print.h"

/* ---- Observation of the sensors -------------------------------------------------------------- */

#define OBSERVATION_READINGS 50u /* Number of readings of the sensors in one observation. */
/* Pause in ns between two readings during the calibration. OBSERVATION_READINGS readings then take
 * one second. */
#define CALIBRATE_PAUSE_NS 20000000

/* Holds the result of OBSERVATION_READINGS readings of all sensors. */
struct observation {
    struct readings last;
    /* Mean, least and greatest converter steps of each wire. */
    float mean[DRAW_WIRE_COUNT], low[DRAW_WIRE_COUNT], high[DRAW_WIRE_COUNT];
    vec3 gyro_rad_s;             /* Mean rotation rate in the axes of the inertial chip. */
    float spin_rad_s, pull_m_s2; /* Mean magnitude of the rotation rate and mean magnitude of the
                                    acceleration over all readings. */
    uint32_t missed;             /* Number of readings in which a sensor did not respond. */
    double seconds;              /* Duration of the observation in seconds. */
};

static void observe_sensors(struct sensors *sensors, long pause_ns, struct observation *observed)
{
    const float part = 1.0f / (float)OBSERVATION_READINGS;
    *observed = (struct observation){ 0 };
    const uint64_t began_ns = clock_ns(CLOCK_MONOTONIC);
    for (uint32_t n = 0; n < OBSERVATION_READINGS; n++) {
        observed->missed += !sensors_read(sensors, &observed->last);
        for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
            const float wire = observed->last.wire[i];
            observed->low[i] = n == 0 ? wire : f_min(observed->low[i], wire);
            observed->high[i] = n == 0 ? wire : f_max(observed->high[i], wire);
            observed->mean[i] += wire * part;
        }
        observed->gyro_rad_s = v3_muladd(observed->gyro_rad_s, observed->last.gyro_rad_s, part);
        observed->spin_rad_s += v3_length(observed->last.gyro_rad_s) * part;
        observed->pull_m_s2 += v3_length(observed->last.accel_m_s2) * part;
        if (pause_ns > 0) {
            nanosleep(&(struct timespec){ .tv_nsec = pause_ns }, NULL);
        }
    }
    observed->seconds = (double)(clock_ns(CLOCK_MONOTONIC) - began_ns) * 1e-9;
}

/* ---- Calibration of the wires ---------------------------------------------------------------- */

/* The calibration accepts a mark only if the converter steps of each wire vary by at most this
 * number while the user holds the eye (the point where the wires meet) on the mark. 20 steps are 5
 * mm of wire. */
#define STILL_STEPS 20.0f

/* Prints an instruction, waits until the user presses Enter, and observes the sensors for one
 * second. Returns true, or false if standard input has ended or a sensor did not respond. */
__attribute__((format(printf, 3, 4))) static bool
observe_after_enter(struct sensors *sensors, struct observation *observed, const char *format, ...)
{
    char words[PRINT_LINE_MAX];
    int letter;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    print_error("%s, press Enter", words);
    do {
        letter = getchar();
    } while (letter != '\n' && letter != EOF);
    if (letter != EOF) {
        observe_sensors(sensors, CALIBRATE_PAUSE_NS, observed);
    }
    if (letter == EOF || observed->missed > 0) {
        print_error("kingyo-poi: standard input has ended, or a sensor did not respond");
        return false;
    }
    return true;
}

/* Asks the user to hold the eye (the point on the poi's neck at which the three wires meet) on a
 * mark. Then measures the wires and adds the mark to the calibration fits of the three wires. */
static bool measure_mark(const struct poi_config *config, struct sensors *sensors, uint32_t mark,
                         struct wire_fit fits[DRAW_WIRE_COUNT])
{
    assert(mark < config->mark_count);
    const vec3 at_m = config->mark_m[mark];
    float length_m[DRAW_WIRE_COUNT], most;
    struct observation observed;
    do {
        if (!observe_after_enter(sensors, &observed,
                                 "mark %u of %u: hold the eye still at %.0f %.0f %.0f mm", mark + 1,
                                 config->mark_count, (double)(at_m.x * 1000.0f),
                                 (double)(at_m.y * 1000.0f), (double)(at_m.z * 1000.0f))) {
            return false;
        }
        most = 0.0f;
        for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
            most = f_max(most, observed.high[i] - observed.low[i]);
        }
        if (most >= STILL_STEPS) {
            print_error("  the eye moved by %.0f steps; hold it still once more", (double)most);
        }
    } while (most >= STILL_STEPS);
    draw_wires_lengths(config->spool_m, at_m, length_m);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        draw_wires_fit_add(&fits[i], observed.mean[i], length_m[i]);
    }
    return true;
}

static enum exit_code calibrate_print_result(const struct poi_config *config,
                                             struct wire_fit fits[DRAW_WIRE_COUNT],
                                             const struct observation *rest)
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
    if (code == EXIT_OK && !rest->last.fuses) {
        const vec3 bias = poi_config_from_chip(config, rest->gyro_rad_s);
        printf("gyro_bias = %.5f %.5f %.5f\n", (double)bias.x, (double)bias.y, (double)bias.z);
    }
    return code;
}

enum exit_code commands_calibrate(const struct poi_config *config, const char *root)
{
    struct wire_fit fits[DRAW_WIRE_COUNT] = { 0 };
    struct sensors sensors;
    struct observation rest;
    char why[SENSORS_WHY_SIZE];
    enum exit_code code = EXIT_IO;
    if (!sensors_open(&sensors, config, root, why)) {
        print_error("kingyo-poi: %s", why);
    } else {
        uint32_t mark = 0;
        while (mark < config->mark_count && measure_mark(config, &sensors, mark, fits)) {
            mark++;
        }
        if (mark == config->mark_count &&
            observe_after_enter(&sensors, &rest, "lay the poi down")) {
            code = calibrate_print_result(config, fits, &rest);
        }
    }
    sensors_close(&sensors);
    return code;
}

/* ---- Self-test ------------------------------------------------------------------------------- */

#define OBSERVATION_STEP_S 0.02f
/* Largest accepted variation of a wire's converter steps while the poi is at rest. 8 steps are 2 mm
 * of wire. With a working converter, the means of four readings vary less. */
#define NOISE_STEPS_MAX 8.0f
/* Maximum difference between the measured gravity and g, as a fraction of g. A larger difference
 * means that the inertial chip is defective or that the poi moves. */
#define GRAVITY_OFF_MAX 0.08f
#define SPIN_REST_MAX 0.2f /* Maximum rotation rate in rad/s while the poi is at rest. */

static uint32_t failed_count, passed_count; /* Numbers of failed and of passed checks. */

/* Prints one line with "ok" or "FAIL", the name of the check, and the reason, and counts the
 * result. */
__attribute__((format(printf, 3, 4))) static void print_verdict(bool good, const char *what,
                                                                const char *format, ...)
{
    char why[PRINT_LINE_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    print_line(stdout, "%-4s  %-10s %s", good ? "ok" : "FAIL", what, why);
    fflush(stdout);
    ++*(good ? &passed_count : &failed_count);
}

/* ---- Sensors at rest ------------------------------------------------------------------------- */

static void check_readings(const struct poi_config *config, const struct observation *observed)
{
    const double each_ms = observed->seconds * 1000.0 / (double)OBSERVATION_READINGS;
    assert(observed->missed <= OBSERVATION_READINGS);
    print_verdict(observed->missed == 0, "sensors", "%u of %u readings succeeded",
                  OBSERVATION_READINGS - observed->missed, OBSERVATION_READINGS);
    print_verdict(each_ms < 4.0, "speed", "%.2f ms per reading, %.0f readings per second%s",
                  each_ms, 1000.0 / each_ms,
                  each_ms < 4.0 ? "" : "; increase the bus clock, or decrease --rate");
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        const float noise = observed->high[i] - observed->low[i];
        const bool out = observed->low[i] >= BOARD_POSE_STEPS_MIN;
        char what[16];
        snprintf(what, sizeof what, "wire %u", i + 1);
        print_verdict(noise <= NOISE_STEPS_MAX && out, what,
                      "channel %u reads %.1f steps, with a range of %.1f%s", config->channel[i],
                      (double)observed->last.wire[i], (double)noise,
                      noise > NOISE_STEPS_MAX ? "; hold the poi still, or shield the cable"
                      : out                   ? ""
                            : "; the wire is at its stop, or the potentiometer is not connected");
    }
}

static void check_turn(const struct poi_config *config, const struct observation *observed)
{
    const struct quaternion q = observed->last.turn;
    if (observed->last.fuses) {
        const bool alive = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z > 0.0f;
        print_verdict(alive, "inertia", "%s computes the orientation%s", config->imu,
                      alive ? ""
                            : ", but gives no values: write a fusion mode to its operation_mode");
        return;
    }
    const float off = f_abs(observed->pull_m_s2 / GRAVITY_M_S2 - 1.0f);
    print_verdict(off < GRAVITY_OFF_MAX, "gravity", "%.2f m/s^2%s", (double)observed->pull_m_s2,
                  off < GRAVITY_OFF_MAX ? ""
                                        : "; lay the poi down, or check the scale of the chip");
    print_verdict(observed->spin_rad_s < SPIN_REST_MAX, "gyroscope", "%.3f rad/s at rest%s",
                  (double)observed->spin_rad_s,
                  observed->spin_rad_s < SPIN_REST_MAX ? "" : "; lay the poi down");
}

static void check_place(const struct poi_config *config, const struct observation *observed)
{
    struct board_pose pose;
    struct poi_report report = { 0 };
    if (!poi_config_is_calibrated(config)) {
        print_verdict(false, "place", "the wires are not calibrated; run 'kingyo-poi calibrate'");
        return;
    }
    board_pose_init(&pose, config);
    for (uint32_t i = 0; i < 3; i++) {
        board_pose_step(&pose, &observed->last, OBSERVATION_STEP_S, &report);
    }
    const vec3 at_m = report.target.position_m;
    const bool reach = v3_is_finite(at_m) && v3_length(at_m) < POI_REPORT_REACH_M;
    print_verdict(pose.wires == DRAW_WIRES_OK && reach, "place", "%s; ring at %.0f %.0f %.0f mm",
                  draw_wires_text(pose.wires), (double)(at_m.x * 1000.0f),
                  (double)(at_m.y * 1000.0f), (double)(at_m.z * 1000.0f));
}

static void check_sensors(const struct poi_config *config, const char *root)
{
    struct sensors sensors;
    struct observation observed;
    char why[SENSORS_WHY_SIZE];
    if (!sensors_open(&sensors, config, root, why)) {
        print_verdict(false, "sensors", "%s; check dtoverlay in config.txt and the wiring", why);
    } else {
        observe_sensors(&sensors, 0, &observed);
        check_readings(config, &observed);
        check_turn(config, &observed);
        check_place(config, &observed);
        print_verdict(true, "keys", "%u device%s of gpio-keys; pressed keys: %02x",
                      sensors.keys.count, sensors.keys.count == 1 ? "" : "s",
                      observed.last.buttons);
    }
    sensors_close(&sensors);
}

/* ---- Motor, light and USB -------------------------------------------------------------------- */

static void check_motor(const struct poi_config *config, const char *root)
{
    struct motor motor;
    char why[MOTOR_WHY_SIZE];
    const bool named = config->pwm_chip >= 0 || config->light[0] != '\0';
    const bool works = motor_open(&motor, config, root, why);
    print_verdict(works, "motor", "%s",
                  !works  ? why
                  : named ? "check that the motor hummed and that the light was on"
                          : "no motor or light is configured, so there is no force feedback");
    if (named) {
        motor_set(&motor, (struct feel_levels){ .motor = 0.8f, .light = 1.0f });
        nanosleep(&(struct timespec){ .tv_nsec = 500000000 }, NULL);
        motor_set(&motor, (struct feel_levels){ 0 });
    }
}

enum exit_code commands_self_test(const struct poi_config *config, const char *root,
                                  const char *device)
{
    check_sensors(config, root);
    check_motor(config, root);
    const bool can = access(device, R_OK | W_OK) == 0;
    print_verdict(can, "cable", "%s%s%s", device, can ? "" : ": ", can ? "" : strerror(errno));
    printf("%u ok, %u failed\n", passed_count, failed_count);
    return failed_count == 0 ? EXIT_OK : EXIT_NOT_SO;
}
