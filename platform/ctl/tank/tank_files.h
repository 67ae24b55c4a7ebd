/* tank_files.h -- the two CSV files that a tank simulation reads: the path of a hand that moves a
 * poi (a paper scoop), and the start positions of fish, with which an encounter can be
 * reproduced. */
#pragma once

#include <stdint.h>

#include "core/input.h"
#include "core/tank/tank.h"
#include "platform/config/options.h"

#define TANK_PATH_MAX 20000u

struct tank_path_row {
    double t_s;
    struct poi_target target;
};

struct tank_path {
    /* `count` is the number of rows. `newest` is the index of the row at which tank_path_at()
     * starts its next search, because the requested times never decrease. */
    uint32_t count, newest;
    struct tank_path_row row[TANK_PATH_MAX];
};

/* Reads the columns t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg. The times must increase from row
 * to row. Returns EXIT_OK, or prints one line that begins with `prefix` to standard error and
 * returns another exit code. */
enum exit_code tank_path_read(struct tank_path *path, const char *prefix, const char *file);

/* Returns the pose at the time `t_s`, which must not decrease from call to call. The pose is
 * interpolated linearly between two rows. The first row applies before its time, and the last row
 * applies after its time. The path must have at least one row. */
struct poi_target tank_path_at(struct tank_path *path, double t_s);

struct tank_place {
    uint32_t count;
    struct tank_stage stage[TANK_FISH_MAX];
    uint32_t line[TANK_FISH_MAX]; /* Line number of each fish in the file, for error messages. */
    /* If the file has a tick column, the number of the tick whose rows are used. */
    double tick;
    /* Number of rows that were skipped because they belong to another tick. */
    uint32_t rows_left_out;
};

/* Reads start positions in the CSV format of the trace. The columns x_cm, y_cm, z_cm and yaw_deg
 * are required. The columns pitch_deg, roll_deg, length_cm, speed_cm_s, gait and stamina are
 * optional. The other columns of the trace are ignored. If the file has a tick column, only the
 * rows of its first tick are used.
 *
 * Returns EXIT_OK, or prints one line that begins with `prefix` to standard error and returns
 * another exit code. */
enum exit_code tank_place_read(struct tank_place *place, const char *prefix, const char *file);

/* Places the fish in a tank that was opened for the same number of fish, and prints how many rows
 * were skipped. Returns EXIT_OK. If a body overlaps another body or is not completely in the water,
 * prints one line and returns EXIT_BAD_DATA. Only a fish that gulps air may have its snout above
 * the water. */
enum exit_code tank_place_stage(const struct tank_place *place, struct tank *tank,
                                const char *prefix, const char *file);
