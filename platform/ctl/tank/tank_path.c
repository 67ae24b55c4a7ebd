/* tank_path.c -- reads the path of a hand from a CSV file, and interpolates the pose between two
 * rows of the file. */
#include "platform/ctl/tank/tank_path.h"

#include "platform/ctl/lib/csv.h"
#include "platform/os/print.h"

enum { T_S, X_CM, Y_CM, Z_CM, YAW_DEG, PITCH_DEG, ROLL_DEG, COLUMN_COUNT };

/* Columns of the path file. The position ranges exceed every tank by the length of an arm. The
 * angle ranges allow ten full turns of the wrist. */
static const struct csv_column columns[COLUMN_COUNT] = {
    [T_S] = { .name = "t_s", .min = 0, .max = 36000 },
    [X_CM] = { .name = "x_cm", .min = -1000, .max = 1000 },
    [Y_CM] = { .name = "y_cm", .min = -100, .max = 100 },
    [Z_CM] = { .name = "z_cm", .min = -1000, .max = 1000 },
    [YAW_DEG] = { .name = "yaw_deg", .min = -3600, .max = 3600 },
    [PITCH_DEG] = { .name = "pitch_deg", .min = -3600, .max = 3600 },
    [ROLL_DEG] = { .name = "roll_deg", .min = -3600, .max = 3600 },
};

static float metres(double cm)
{
    return (float)(0.01 * cm);
}

static float radians(double degrees)
{
    return (float)(degrees * (3.14159265358979323846 / 180.0));
}

static struct tank_path_row row_of(const double value[COLUMN_COUNT])
{
    return (struct tank_path_row){
        .t_s = value[T_S],
        .target = {
            .position_m = { metres(value[X_CM]), metres(value[Y_CM]), metres(value[Z_CM]) },
            .angles = { radians(value[YAW_DEG]), radians(value[PITCH_DEG]),
                        radians(value[ROLL_DEG]) },
        },
    };
}

static enum exit_code tank_path_take_row(struct tank_path *path, const struct csv *csv,
                                         const double value[COLUMN_COUNT])
{
    if (path->count == TANK_PATH_MAX) {
        return csv_error(csv, T_S, "more than %u rows", TANK_PATH_MAX);
    }
    if (path->count > 0 && value[T_S] <= path->row[path->count - 1u].t_s) {
        return csv_error(csv, T_S, "%g s is not after the row before, %g s", value[T_S],
                         path->row[path->count - 1u].t_s);
    }
    path->row[path->count++] = row_of(value);
    return EXIT_OK;
}

enum exit_code tank_path_read(struct tank_path *path, const char *speaker, const char *file)
{
    struct csv csv;
    double value[COLUMN_COUNT];
    int is_end = 0;
    path->count = path->newest = 0;
    enum exit_code code = csv_open(&csv, speaker, file, columns, COLUMN_COUNT);
    while (code == EXIT_OK && !is_end) {
        code = csv_row(&csv, value, &is_end);
        if (code == EXIT_OK && !is_end) {
            code = tank_path_take_row(path, &csv, value);
        }
    }
    if (code == EXIT_OK && path->count == 0) {
        print_error("%s: %s: line %u: a row of numbers is missing", speaker, file, csv.line);
        code = EXIT_BAD_DATA;
    }
    csv_close(&csv);
    return code;
}

struct poi_target tank_path_at(struct tank_path *path, double t_s)
{
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
