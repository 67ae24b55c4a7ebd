/* tank_place.h -- places fish at positions from a file, so that an encounter can be reproduced. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_PLACE_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_PLACE_H

#include "core/tank/tank.h"
#include "platform/config/options.h"

struct tank_place {
    uint32_t count;
    struct tank_stage stage[TANK_FISH_MAX];
    uint32_t line[TANK_FISH_MAX]; /* Line of the file that contains each fish. */
    double tick;                  /* Tick of the fish, if the file has ticks. */
    uint32_t rows_left_out;       /* Number of rows that belong to other ticks. */
};

/* Reads rows in the format of the trace. The columns x_cm, y_cm, z_cm and yaw_deg are required. The
 * columns pitch_deg, roll_deg, length_cm, speed_cm_s, gait and stamina are optional, and other
 * columns of the trace are ignored. If the file has ticks, only the rows of the first tick are
 * used. Returns EXIT_OK, or prints one line that begins with `speaker` to standard error and
 * returns another code. */
enum exit_code tank_place_read(struct tank_place *place, const char *speaker, const char *file);

/* Places the fish in a tank that was opened for the same number of fish, and prints how many rows
 * were left out. Returns EXIT_OK. Prints one line and returns EXIT_BAD_DATA if a body is not
 * completely in the water or overlaps another body. The snout of a fish that gulps air may be above
 * the water. */
enum exit_code tank_place_stage(const struct tank_place *place, struct tank *tank,
                                const char *speaker, const char *file);

#endif
