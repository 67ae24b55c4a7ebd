/* tank_files.c -- reads the path of a poi and the start positions of fish, and places the fish in
 * the tank. */
#include "platform/ctl/tank/tank_files.h"

#include <math.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/csv.h"
#include "platform/ctl/tank/overlap.h"
#include "platform/os/print.h"

/* Multiplies by 0.01. Used to convert centimetres to metres, and to convert stamina from the
 * thesis' scale 0 .. 100 to 0 .. 1. */
static float hundredth(double value)
{
    return (float)(0.01 * value);
}

static float radians(double degrees)
{
    return (float)(degrees * (3.14159265358979323846 / 180.0));
}

/* ---- Path of a poi --------------------------------------------------------------------------- */

enum { PATH_T_S, PATH_X_CM, PATH_Y_CM, PATH_Z_CM, PATH_YAW, PATH_PITCH, PATH_ROLL, PATH_COLUMNS };

/* Columns of the path file. The position ranges exceed every tank by the length of an arm. The
 * angle ranges allow ten full turns of the wrist. */
static const struct csv_column path_columns[PATH_COLUMNS] = {
    [PATH_T_S] = { .name = "t_s", .min = 0, .max = 36000 },
    [PATH_X_CM] = { .name = "x_cm", .min = -1000, .max = 1000 },
    [PATH_Y_CM] = { .name = "y_cm", .min = -100, .max = 100 },
    [PATH_Z_CM] = { .name = "z_cm", .min = -1000, .max = 1000 },
    [PATH_YAW] = { .name = "yaw_deg", .min = -3600, .max = 3600 },
    [PATH_PITCH] = { .name = "pitch_deg", .min = -3600, .max = 3600 },
    [PATH_ROLL] = { .name = "roll_deg", .min = -3600, .max = 3600 },
};

static enum exit_code tank_path_take_row(void *self, const struct csv *csv, const double *value)
{
    struct tank_path *path = self;
    CORE_ASSERT(path->count <= TANK_PATH_MAX);
    if (path->count == TANK_PATH_MAX) {
        return csv_error(csv, PATH_T_S, "more than %u rows", TANK_PATH_MAX);
    }
    if (path->count > 0 && value[PATH_T_S] <= path->row[path->count - 1u].t_s) {
        return csv_error(csv, PATH_T_S, "%g s is not after the row before, %g s", value[PATH_T_S],
                         path->row[path->count - 1u].t_s);
    }
    path->row[path->count++] = (struct tank_path_row){
        .t_s = value[PATH_T_S],
        .target = {
            .position_m = { hundredth(value[PATH_X_CM]), hundredth(value[PATH_Y_CM]),
                            hundredth(value[PATH_Z_CM]) },
            .angles = { radians(value[PATH_YAW]), radians(value[PATH_PITCH]),
                        radians(value[PATH_ROLL]) },
        },
    };
    return EXIT_OK;
}

enum exit_code tank_path_read(struct tank_path *path, const char *prefix, const char *file)
{
    struct csv csv = {
        .prefix = prefix, .path = file, .columns = path_columns, .column_count = PATH_COLUMNS
    };
    path->count = path->newest = 0;
    return csv_read(&csv, tank_path_take_row, path);
}

struct poi_target tank_path_at(struct tank_path *path, double t_s)
{
    CORE_ASSERT(path->count >= 1 && path->newest < path->count);
    while (path->newest + 1u < path->count && path->row[path->newest + 1u].t_s <= t_s) {
        path->newest++;
    }
    const struct tank_path_row *from = &path->row[path->newest];
    if (t_s <= from->t_s || path->newest + 1u == path->count) {
        return from->target;
    }
    const struct tank_path_row *to = from + 1;
    const float share = (float)((t_s - from->t_s) / (to->t_s - from->t_s));
    const struct angles a = from->target.angles, b = to->target.angles;
    return (struct poi_target){
        .position_m = v3_lerp(from->target.position_m, to->target.position_m, share),
        .angles = { f_lerp(a.yaw_rad, b.yaw_rad, share), f_lerp(a.pitch_rad, b.pitch_rad, share),
                    f_lerp(a.roll_rad, b.roll_rad, share) },
    };
}

/* ---- Start positions of fish ----------------------------------------------------------------- */

/* Tolerance in metres for bodies that touch a wall. The tolerance is needed because the numbers in
 * a trace are rounded. */
#define TOUCH_M 0.0001

enum {
    TICK,
    FISH,
    X_CM,
    Y_CM,
    Z_CM,
    YAW_DEG,
    PITCH_DEG,
    ROLL_DEG,
    LENGTH_CM,
    HEIGHT_CM,
    WIDTH_CM,
    SPEED_CM_S,
    TAIL_HZ,
    GAIT,
    STAMINA,
    AVOIDING,
    COLUMN_COUNT,
};

/* Gaits of the trace. `gaits` contains the gait with which a fish starts for each word. An escaping
 * fish starts with a burst, because the file does not contain the cause of the escape. GAIT_HELD is
 * rejected, because the tank has no poi or bowl that could hold a fish. */
static const char *const gait_words[] = {
    "rest", "swim", "burst", "escape", "surface", "held", NULL
};
static const uint8_t gaits[] = { GAIT_REST,  GAIT_SWIM,    GAIT_BURST,
                                 GAIT_BURST, GAIT_SURFACE, GAIT_HELD };
#define GAIT_BY_SPEED (-1.0)

/* Columns of the trace (tank_report.c). The size of a fish is computed from its length. The file
 * contains neither the phase of the tail beat nor the avoidance, so each fish starts with the
 * initial values. */
static const struct csv_column columns[COLUMN_COUNT] = {
    [TICK] = { .name = "tick", .min = 0, .max = UINT32_MAX, .may_miss = true },
    [FISH] = { .name = "fish", .may_miss = true, .unread = true },
    [X_CM] = { .name = "x_cm", .min = -1000, .max = 1000 },
    [Y_CM] = { .name = "y_cm", .min = -100, .max = 100 },
    [Z_CM] = { .name = "z_cm", .min = -1000, .max = 1000 },
    [YAW_DEG] = { .name = "yaw_deg", .min = -360, .max = 360 },
    [PITCH_DEG] = { .name = "pitch_deg", .min = -90, .max = 90, .may_miss = true },
    [ROLL_DEG] = { .name = "roll_deg", .min = -180, .max = 180, .may_miss = true },
    [LENGTH_CM] = { .name = "length_cm", .min = 1, .max = 20, .may_miss = true },
    [HEIGHT_CM] = { .name = "height_cm", .may_miss = true, .unread = true },
    [WIDTH_CM] = { .name = "width_cm", .may_miss = true, .unread = true },
    [SPEED_CM_S] = { .name = "speed_cm_s", .min = 0, .max = 1000, .may_miss = true },
    [TAIL_HZ] = { .name = "tail_hz", .may_miss = true, .unread = true },
    [GAIT] = { .name = "gait", .words = gait_words, .may_miss = true, .otherwise = GAIT_BY_SPEED },
    [STAMINA] = { .name = "stamina", .min = 0, .max = 100, .may_miss = true, .otherwise = 100 },
    [AVOIDING] = { .name = "avoiding", .may_miss = true, .unread = true },
};

static enum exit_code tank_place_take_row(void *self, const struct csv *csv, const double *value)
{
    struct tank_place *place = self;
    if (place->count > 0 && value[TICK] != place->tick) {
        place->rows_left_out++;
        return EXIT_OK;
    }
    const uint8_t by_speed = value[SPEED_CM_S] > 0.0 ? GAIT_SWIM : GAIT_REST;
    const struct tank_stage stage = {
        .position_m = { hundredth(value[X_CM]), hundredth(value[Y_CM]), hundredth(value[Z_CM]) },
        .angles = { f_wrap_angle(radians(value[YAW_DEG])), radians(value[PITCH_DEG]),
                    radians(value[ROLL_DEG]) },
        .length_m = hundredth(value[LENGTH_CM]),
        .speed_m_s = hundredth(value[SPEED_CM_S]),
        .stamina = hundredth(value[STAMINA]),
        .gait = value[GAIT] < 0.0 ? by_speed : gaits[(uint32_t)value[GAIT]],
    };
    if (stage.gait == GAIT_HELD) {
        return csv_error(csv, GAIT, "no poi holds this fish; remove the row, or change the gait");
    }
    if (place->count == TANK_FISH_MAX) {
        return csv_error(csv, X_CM, "more than %u fish", TANK_FISH_MAX);
    }
    place->tick = value[TICK];
    place->line[place->count] = csv->line;
    place->stage[place->count++] = stage;
    return EXIT_OK;
}

enum exit_code tank_place_read(struct tank_place *place, const char *prefix, const char *file)
{
    struct csv csv = {
        .prefix = prefix, .path = file, .columns = columns, .column_count = COLUMN_COUNT
    };
    place->count = place->rows_left_out = 0;
    return csv_read(&csv, tank_place_take_row, place);
}

/* Returns half of the size of the axis-aligned box around an oriented box, in metres. `along` is
 * the axis: 0 for x, 1 for y, 2 for z. */
static double extent_m(const struct overlap_box *box, int along)
{
    return box->half_m[0] * fabs(box->axis[0][along]) + box->half_m[1] * fabs(box->axis[1][along]) +
           box->half_m[2] * fabs(box->axis[2][along]);
}

/* Returns true if the box is in the water. The box may extend above the water surface by up to
 * `emerges_m` metres. */
static bool is_in_water(const struct overlap_box *box, vec3 size_m, double emerges_m)
{
    const double side[3] = { 0.5 * (double)size_m.x, (double)size_m.y, 0.5 * (double)size_m.z };
    return fabs(box->centre_m[0]) + extent_m(box, 0) <= side[0] + TOUCH_M &&
           fabs(box->centre_m[2]) + extent_m(box, 2) <= side[2] + TOUCH_M &&
           box->centre_m[1] + extent_m(box, 1) <= emerges_m + TOUCH_M &&
           box->centre_m[1] - extent_m(box, 1) >= -side[1] - TOUCH_M;
}

enum exit_code tank_place_stage(const struct tank_place *place, struct tank *tank,
                                const char *prefix, const char *file)
{
    CORE_ASSERT(place->count >= 1 && place->count == tank->fish_count);
    tank_stage_all(tank, place->stage, place->count);
    for (uint32_t i = 0; i < place->count; i++) {
        const struct fish *fish = &tank->fish[i];
        const struct overlap_box box = overlap_box_of(fish);
        const double emerges_m =
            place->stage[i].gait == GAIT_SURFACE ? (double)fish_emerges_m(fish) : 0.0;
        if (!is_in_water(&box, tank->size_m, emerges_m)) {
            return print_fail(
                EXIT_BAD_DATA,
                "%s: %s: line %u: fish %u is not completely in the water of %g x %g cm, %g cm "
                "deep",
                prefix, file, place->line[i], i, 100.0 * (double)tank->size_m.x,
                100.0 * (double)tank->size_m.z, 100.0 * (double)tank->size_m.y);
        }
        for (uint32_t j = 0; j < i; j++) {
            const struct overlap_box other = overlap_box_of(&tank->fish[j]);
            const double depth_mm = 1000.0 * overlap_depth_m(&box, &other);
            if (depth_mm > OVERLAP_DEEP_MM) {
                return print_fail(EXIT_BAD_DATA,
                                  "%s: %s: line %u: fish %u and %u overlap by %.1f mm", prefix,
                                  file, place->line[i], j, i, depth_mm);
            }
        }
    }
    if (place->rows_left_out > 0) {
        print_error("%s: %s: the %u fish of the first tick, %.0f, are placed; %u rows of "
                    "other ticks are skipped",
                    prefix, file, place->count, place->tick, place->rows_left_out);
    }
    return EXIT_OK;
}
