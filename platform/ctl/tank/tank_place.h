/* tank_place.h -- places fish at start positions from a file, so that an encounter can be
 * reproduced. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_PLACE_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_PLACE_H

#include "core/tank/tank.h"
#include "platform/config/options.h"

struct tank_place {
    uint32_t count;
    struct tank_stage stage[TANK_FISH_MAX];
    uint32_t line[TANK_FISH_MAX]; /* Line number of each fish in the file, for error messages. */
    double tick;                  /* Number of the tick whose rows are used, if the file has a tick
                                     column. */
    uint32_t rows_left_out;       /* Number of rows that were skipped because they belong to another
                                     tick. */
};

/* Reads start positions in the CSV format of the trace. The columns x_cm, y_cm, z_cm and yaw_deg
 * are required. The columns pitch_deg, roll_deg, length_cm, speed_cm_s, gait and stamina are
 * optional. The other columns of the trace are ignored. If the file has a tick column, only the
 * rows of its first tick are used.
 *
 * Returns EXIT_OK, or prints one line that begins with `speaker` to standard error and returns
 * another exit code. */
enum exit_code tank_place_read(struct tank_place *place, const char *speaker, const char *file);

/* Places the fish in a tank that was opened for the same number of fish, and prints how many rows
 * were skipped. Returns EXIT_OK. If a body overlaps another body or is not completely in the water,
 * prints one line and returns EXIT_BAD_DATA. Only a fish that gulps air may have its snout above
 * the water. */
enum exit_code tank_place_stage(const struct tank_place *place, struct tank *tank,
                                const char *speaker, const char *file);

#endif
