/* tank_place.c -- rows into fish, and a look whether they fit the water and each other. */
#include "platform/ctl/tank_place.h"

#include <math.h>
#include <stdio.h>

#include "platform/ctl/csv.h"
#include "platform/ctl/overlap.h"

#define TOUCH_M 0.0001 /* What rounding to a trace's decimals may put into a wall. */

enum {
    X_CM, Y_CM, Z_CM, YAW_DEG, PITCH_DEG, ROLL_DEG, LENGTH_CM, SPEED_CM_S, GAIT, STAMINA,
    COLUMN_COUNT,
};

/* The gaits that a fish can be told to begin with; in the order of `gaits`. */
static const char *const gait_words[] = { "rest", "swim", "burst", NULL };
static const uint8_t gaits[] = { GAIT_REST, GAIT_SWIM, GAIT_BURST };
#define GAIT_BY_SPEED (-1.0)

static const struct csv_column columns[COLUMN_COUNT] = {
    [X_CM] = { .name = "x_cm", .min = -1000, .max = 1000 },
    [Y_CM] = { .name = "y_cm", .min = -100, .max = 0 },
    [Z_CM] = { .name = "z_cm", .min = -1000, .max = 1000 },
    [YAW_DEG] = { .name = "yaw_deg", .min = -360, .max = 360 },
    [PITCH_DEG] = { .name = "pitch_deg", .min = -90, .max = 90, .may_miss = 1 },
    [ROLL_DEG] = { .name = "roll_deg", .min = -180, .max = 180, .may_miss = 1 },
    [LENGTH_CM] = { .name = "length_cm", .min = 1, .max = 20, .may_miss = 1 },
    [SPEED_CM_S] = { .name = "speed_cm_s", .min = 0, .max = 100, .may_miss = 1 },
    [GAIT] = { .name = "gait", .words = gait_words, .may_miss = 1, .otherwise = GAIT_BY_SPEED },
    [STAMINA] = { .name = "stamina", .min = 0, .max = 100, .may_miss = 1, .otherwise = 100 },
};

/* Of cm, or of the thesis' stamina. */
static float hundredth(double value)
{
    return (float)(0.01 * value);
}

static float radians(double degrees)
{
    return (float)(degrees * (3.14159265358979323846 / 180.0));
}

static struct tank_stage stage_of(const double value[COLUMN_COUNT])
{
    const uint8_t by_speed = value[SPEED_CM_S] > 0.0 ? GAIT_SWIM : GAIT_REST;
    return (struct tank_stage){
        .position_m = { hundredth(value[X_CM]), hundredth(value[Y_CM]), hundredth(value[Z_CM]) },
        .angles = { f_wrap_angle(radians(value[YAW_DEG])), radians(value[PITCH_DEG]),
                    radians(value[ROLL_DEG]) },
        .length_m = hundredth(value[LENGTH_CM]),
        .speed_m_s = hundredth(value[SPEED_CM_S]),
        .stamina = hundredth(value[STAMINA]),
        .gait = value[GAIT] < 0.0 ? by_speed : gaits[(uint32_t)value[GAIT]],
    };
}

enum exit_code tank_place_read(struct tank_place *place, const char *speaker, const char *file)
{
    struct csv csv;
    double value[COLUMN_COUNT];
    int is_end = 0;
    place->count = 0;
    enum exit_code code = csv_open(&csv, speaker, file, columns, COLUMN_COUNT);
    while (code == EXIT_OK && !is_end) {
        code = csv_row(&csv, value, &is_end);
        if (code == EXIT_OK && !is_end && place->count == TANK_FISH_MAX) {
            code = csv_refuse(&csv, X_CM, "more than %u fish", TANK_FISH_MAX);
        } else if (code == EXIT_OK && !is_end) {
            place->stage[place->count++] = stage_of(value);
        }
    }
    if (code == EXIT_OK && place->count == 0) {
        fprintf(stderr, "%s: %s: line %u: a row with a fish is missing\n", speaker, file, csv.line);
        code = EXIT_BAD_DATA;
    }
    csv_close(&csv);
    return code;
}

/* Half of the upright box around a body, along x, y or z. */
static double extent_m(const struct overlap_box *box, int along)
{
    return box->half_m[0] * fabs(box->axis[0][along]) + box->half_m[1] * fabs(box->axis[1][along]) +
           box->half_m[2] * fabs(box->axis[2][along]);
}

static int is_in_water(const struct overlap_box *box, vec3 size_m)
{
    const double side[3] = { 0.5 * (double)size_m.x, (double)size_m.y, 0.5 * (double)size_m.z };
    return fabs(box->centre_m[0]) + extent_m(box, 0) <= side[0] + TOUCH_M &&
           fabs(box->centre_m[2]) + extent_m(box, 2) <= side[2] + TOUCH_M &&
           box->centre_m[1] + extent_m(box, 1) <= TOUCH_M &&
           box->centre_m[1] - extent_m(box, 1) >= -side[1] - TOUCH_M;
}

enum exit_code tank_place_stage(const struct tank_place *place, struct tank *tank,
                                const char *speaker, const char *file)
{
    tank_stage_all(tank, place->stage, place->count);
    for (uint32_t i = 0; i < place->count; i++) {
        const struct overlap_box box = overlap_box_of(&tank->fish[i]);
        if (!is_in_water(&box, tank->size_m)) {
            fprintf(stderr, "%s: %s: fish %u is not all in the water: %g x %g cm, %g cm deep\n",
                    speaker, file, i, 100.0 * (double)tank->size_m.x,
                    100.0 * (double)tank->size_m.z, 100.0 * (double)tank->size_m.y);
            return EXIT_BAD_DATA;
        }
        for (uint32_t j = 0; j < i; j++) {
            const struct overlap_box other = overlap_box_of(&tank->fish[j]);
            const double depth_mm = 1000.0 * overlap_depth_m(&box, &other);
            if (depth_mm > OVERLAP_DEEP_MM) {
                fprintf(stderr, "%s: %s: fish %u and %u are %.1f mm in each other\n", speaker,
                        file, j, i, depth_mm);
                return EXIT_BAD_DATA;
            }
        }
    }
    return EXIT_OK;
}
