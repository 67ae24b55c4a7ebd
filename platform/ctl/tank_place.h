/* tank_place.h -- fish where a person wants them, so that an encounter can be staged. */
#ifndef KINGYO_PLATFORM_CTL_TANK_PLACE_H
#define KINGYO_PLATFORM_CTL_TANK_PLACE_H

#include "core/tank/tank.h"
#include "platform/kiosk/options.h"

struct tank_place {
    uint32_t count;
    struct tank_stage stage[TANK_FISH_MAX];
    uint32_t line[TANK_FISH_MAX]; /* Of the file, where that fish stands. */
    double tick;                  /* Of the fish, in a file with ticks ... */
    uint32_t rows_left_out;       /* ... and how many rows belong to other ticks. */
};

/* Reads rows like the trace's: x_cm, y_cm, z_cm and yaw_deg, and where the file has them pitch_deg,
 * roll_deg, length_cm, speed_cm_s, gait and stamina; the trace's other columns may be there. Of a
 * file with ticks the rows of the first are taken. EXIT_OK, or told in a line that begins with
 * `speaker`. */
enum exit_code tank_place_read(struct tank_place *place, const char *speaker, const char *file);

/* Stages them in a tank that was opened for as many fish, and tells whose rows were left out.
 * Bodies that are not all in the water (a gulper's snout need not be), or lie in each other, are
 * refused: EXIT_BAD_DATA, told. */
enum exit_code tank_place_stage(const struct tank_place *place, struct tank *tank,
                                const char *speaker, const char *file);

#endif
