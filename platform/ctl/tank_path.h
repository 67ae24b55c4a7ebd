/* tank_path.h -- where a hand leads a poi: a table of poses, read from CSV. */
#ifndef KINGYO_PLATFORM_CTL_TANK_PATH_H
#define KINGYO_PLATFORM_CTL_TANK_PATH_H

#include <stdint.h>

#include "core/input.h"
#include "platform/kiosk/options.h"

#define TANK_PATH_MAX 20000u

struct tank_path_row {
    double t_s;
    struct poi_target target;
};

struct tank_path {
    uint32_t count, newest; /* The row that the last asked time came after: times only grow. */
    struct tank_path_row row[TANK_PATH_MAX];
};

/* Reads t_s,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg; times grow from row to row. EXIT_OK, or told
 * in a line that begins with `speaker`. */
enum exit_code tank_path_read(struct tank_path *path, const char *speaker, const char *file);

/* The pose at `t_s`, which never goes back: linear between rows, the first before them, the last
 * after them. Needs count > 0. */
struct poi_target tank_path_at(struct tank_path *path, double t_s);

#endif
