/* menu_calibrate.h -- the menu page on which the operator calibrates a slot's poi, one mark after
 * the other, without buttons.
 *
 * The operator needs both hands for the poi, so a pose is accepted when it is held still for 1.5 s.
 * The poi must then move away before the next pose can be accepted. The result takes effect
 * immediately, and the page shows the corrected position. While the menu is open, the operator can
 * restore the previous calibration, and can also undo the restoration. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_CALIBRATE_H
#define KINGYO_CORE_GAME_MENU_MENU_CALIBRATE_H

#include <stdint.h>

#include "core/game/control/calibration.h"
#include "core/output.h"

#define CALIBRATE_STILL_TICKS (CORE_TICK_HZ + CORE_TICK_HZ / 2u)
/* Tolerance for the position of a poi that is held still, for an arm that rests on the tank's
 * rim. */
#define CALIBRATE_STILL_M 0.008f
#define CALIBRATE_STILL_TURN 0.15f
/* Distance from the last accepted pose that the poi must move before the next pose. */
#define CALIBRATE_MOVE_M 0.03f

enum calibrate_step {
    CALIBRATE_IDLE = 0,
    CALIBRATE_CORNER, /* First of four steps, one for each corner. */
    CALIBRATE_WATER = CALIBRATE_CORNER + (int)CALIBRATE_CORNERS,
    CALIBRATE_DONE,
    CALIBRATE_REFUSED, /* The calibration was rejected and is unchanged. `fault` is the reason. */
    CALIBRATE_STEPS,
};

struct calibrate {
    uint8_t seat;
    uint8_t step;       /* Current step (enum calibrate_step). */
    uint8_t fault;      /* Reason for the rejection (enum calibration_fault). */
    uint8_t present;    /* Bit mask of the slots with a controller. */
    uint8_t is_set;     /* Bit mask of the slots with a stored calibration, including incomplete
                           calibrations. */
    uint8_t has_before; /* Bit mask of the slots whose previous calibration is in `before`. */
    int32_t before[POI_MAX][CALIBRATION_VALUES];
    uint8_t has_anchor, must_move;
    uint16_t still_ticks;
    struct poi_target anchor; /* Pose at which the poi came to rest. Deviations are measured from
                                 it. */
    struct poi_target sum;    /* Sum of the deviations from `anchor` over the ticks in which the poi
                                 was still. */
    struct calibration_said said;
};

struct game;
struct world;
struct core_config;

/* Returns 1 while the operator moves the poi from mark to mark, otherwise 0. During that time the
 * poi does not point at items. */
int menu_calibrate_is_running(const struct calibrate *calibrate);

/* Returns the progress of holding the poi still, [0, 1]. */
float menu_calibrate_progress(const struct calibrate *calibrate);

/* Evaluates the uncorrected poses of the controllers. Call once per tick. The function has an
 * effect only while the calibration page of the menu is open. */
void menu_calibrate_tick(struct game *game, const struct world *world, struct core_config *config,
                         const struct input *said, struct output *output);

uint64_t menu_calibrate_hash(uint64_t hash, const struct calibrate *calibrate);

#endif
