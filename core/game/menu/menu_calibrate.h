/* menu_calibrate.h -- calibration of a slot's poi by the operator, one mark after the other,
 * without buttons.
 *
 * The operator needs both hands for the poi, so a pose counts when it is held still for 1.5 s. The
 * poi must then move away before the next pose counts. The result takes effect at once, and the
 * page shows the corrected position. While the menu is open the previous calibration can be
 * restored, and that step can be undone too. */
#ifndef KINGYO_CORE_GAME_MENU_MENU_CALIBRATE_H
#define KINGYO_CORE_GAME_MENU_MENU_CALIBRATE_H

#include <stdint.h>

#include "core/game/control/calibration.h"
#include "core/output.h"

#define CALIBRATE_STILL_TICKS (CORE_TICK_HZ + CORE_TICK_HZ / 2u)
#define CALIBRATE_STILL_M 0.008f /* Tolerance for an arm that rests on the tank's rim. */
#define CALIBRATE_STILL_TURN 0.15f
/* Distance from the last pose after which the next pose can count. */
#define CALIBRATE_MOVE_M 0.03f

enum calibrate_step {
    CALIBRATE_IDLE = 0,
    CALIBRATE_CORNER, /* First of the four corners. */
    CALIBRATE_WATER = CALIBRATE_CORNER + (int)CALIBRATE_CORNERS,
    CALIBRATE_DONE,
    CALIBRATE_REFUSED, /* `fault` is the reason; the calibration is unchanged. */
    CALIBRATE_STEPS,
};

struct calibrate {
    uint8_t seat;
    uint8_t step;       /* enum calibrate_step */
    uint8_t fault;      /* enum calibration_fault */
    uint8_t present;    /* Bit mask of the slots with a controller. */
    uint8_t is_set;     /* Bit mask of the slots with a stored calibration, damaged ones
                           included. */
    uint8_t has_before; /* Bit mask of the slots whose previous calibration is in `before`. */
    int32_t before[POI_MAX][CALIBRATION_VALUES];
    uint8_t has_anchor, must_move;
    uint16_t still_ticks;
    struct poi_target anchor; /* Pose at which the poi came to rest. */
    struct poi_target sum;    /* Sum of the deviations from `anchor` over the still ticks. */
    struct calibration_said said;
};

struct game;
struct world;
struct core_config;

/* Returns 1 while a poi moves from mark to mark, so that the poi does not point at items. */
int menu_calibrate_is_running(const struct calibrate *calibrate);

/* Returns the progress of holding still, [0, 1]. */
float menu_calibrate_progress(const struct calibrate *calibrate);

/* Evaluates the uncorrected poses of the controllers. Call once per tick; the function acts only
 * while its page of the menu is open. */
void menu_calibrate_tick(struct game *game, const struct world *world, struct core_config *config,
                         const struct input *said, struct output *output);

uint64_t menu_calibrate_hash(uint64_t hash, const struct calibrate *calibrate);

#endif
