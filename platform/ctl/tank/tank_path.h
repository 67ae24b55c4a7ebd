/* tank_path.h -- the path of a hand that moves a poi (a paper scoop), read from a CSV file as a
 * table of poses. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_PATH_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_PATH_H

#include <stdint.h>

#include "core/input.h"
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
 * to row. Returns EXIT_OK, or prints one line that begins with `speaker` to standard error and
 * returns another exit code. */
enum exit_code tank_path_read(struct tank_path *path, const char *speaker, const char *file);

/* Returns the pose at the time `t_s`, which must not decrease from call to call. The pose is
 * interpolated linearly between two rows. The first row applies before its time, and the last row
 * applies after its time. The path must have at least one row. */
struct poi_target tank_path_at(struct tank_path *path, double t_s);

#endif
