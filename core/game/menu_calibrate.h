/* menu_calibrate.h -- how an operator calibrates a seat's poi: a mark after the other, hands free.
 *
 * Nobody has a hand left for a button who holds a poi on a mark: held still there for a second and
 * a half it is taken, and then it must move on before the next counts. What was learned counts at
 * once, so that the page shows where the poi is now; what was before it can be had back, and that
 * again, as long as the menu is open. */
#ifndef KINGYO_CORE_GAME_MENU_CALIBRATE_H
#define KINGYO_CORE_GAME_MENU_CALIBRATE_H

#include <stdint.h>

#include "core/game/calibrate.h"
#include "core/output.h"

#define CALIBRATE_STILL_TICKS (CORE_TICK_HZ + CORE_TICK_HZ / 2u)
#define CALIBRATE_STILL_M 0.008f /* As still as a hand that leans on a rim. */
#define CALIBRATE_STILL_TURN 0.15f
#define CALIBRATE_MOVE_M 0.03f   /* Farther away than that it is on its way to the next. */

enum calibrate_step {
    CALIBRATE_IDLE = 0,
    CALIBRATE_CORNER, /* The first of four; the others follow. */
    CALIBRATE_WATER = CALIBRATE_CORNER + (int)CALIBRATE_CORNERS,
    CALIBRATE_DONE,
    CALIBRATE_REFUSED, /* `fault` says why; all is as it was. */
    CALIBRATE_STEPS,
};

struct calibrate {
    uint8_t seat;
    uint8_t step;       /* enum calibrate_step */
    uint8_t fault;      /* enum calibration_fault */
    uint8_t present;    /* Seats that have a controller, a bit each; */
    uint8_t is_set;     /* those that have a calibration, be it a torn one, */
    uint8_t has_before; /* and those that had another in this menu: */
    int32_t before[POI_MAX][CALIBRATION_VALUES];
    uint8_t has_anchor, must_move;
    uint16_t still_ticks;
    struct poi_target anchor; /* Where it came to rest; */
    struct poi_target sum;    /* of each still tick, how far off that it was. */
    struct calibration_said said;
};

struct core;

/* While a poi is led from mark to mark it points at no tag. */
int calibrate_runs(const struct calibrate *calibrate);

/* [0, 1]: how long it has been still. */
float calibrate_progress(const struct calibrate *calibrate);

/* Looks at what controllers say before it is set right. Once a tick; only its page of the open menu
 * heeds it. */
void calibrate_tick(struct core *core, const struct input *said, struct output *output);

uint64_t calibrate_hash(uint64_t hash, const struct calibrate *calibrate);

#endif
