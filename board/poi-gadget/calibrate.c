/* calibrate.c -- measures the draw wires at each calibration mark, as a mean over one second. */
#include "board/poi-gadget/calibrate.h"

#include <stdio.h>
#include <time.h>

#include "board/poi-gadget/sensors.h"
#include "board/poi-gadget/wire_fit.h"
#include "platform/os/print.h"

#define READINGS 50u
#define BETWEEN_NS 20000000
/* Greatest range of the converter steps while the user holds the eye on a mark. 20 steps are 5 mm
 * of wire. */
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
        wire_fit_add(&fits[i], mean->wire[i], length_m[i]);
    }
    return 1;
}

static vec3 in_poi_axes(const struct poi_config *config, vec3 chip)
{
    return v3(v3_dot(config->imu_row[0], chip), v3_dot(config->imu_row[1], chip),
              v3_dot(config->imu_row[2], chip));
}

static enum exit_code calibrate_print_result(const struct poi_config *config,
                                             struct wire_fit fits[DRAW_WIRE_COUNT],
                                             const struct readings *rest)
{
    enum exit_code code = EXIT_OK;
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        const char *why;
        if (!wire_fit_solve(&fits[i], &why)) {
            print_error("wire%u: %s", i + 1, why);
            code = EXIT_NOT_SO;
            continue;
        }
        printf("wire%u = %.3f %.6f # worst mark %.2f mm off\n", i + 1,
               (double)(fits[i].zero_m * 1000.0f), (double)(fits[i].step_m * 1000.0f),
               (double)(fits[i].miss_m * 1000.0f));
    }
    if (code == EXIT_OK && !rest->fuses) {
        const vec3 bias = in_poi_axes(config, rest->gyro_rad_s);
        printf("gyro_bias = %.5f %.5f %.5f\n", (double)bias.x, (double)bias.y, (double)bias.z);
    }
    return code;
}

enum exit_code calibrate(const struct poi_config *config, const char *root)
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
