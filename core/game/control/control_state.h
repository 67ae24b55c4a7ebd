/* control_state.h -- the state that the control of a poi keeps from one tick to the next. The
 * functions are in controller.c, parking.c and input_pose.c. */
#pragma once

#include <stdint.h>

#include "core/game/control/input_pose.h"
#include "core/input.h"

/* Control of the poi of one player slot. */
struct control {
    /* Source that controlled the poi in the last tick (enum poi_source). */
    uint8_t holder;
    uint32_t grip_tick; /* Tick at which the current source took control of the poi. */
    /* Target pose of the poi in the last tick, after smoothing and failsafe. */
    struct poi_target target_pose;
    /* Height of the controller's pose in the last tick, or -1 if the input was invalid. A dip is a
     * downward crossing of RULES_DIP_Y_M. */
    float live_y_m;
    struct input_validation validation; /* State of the validation of the controller's input. */
    /* Ticks since the poi began to return to its controller's pose; 0 means that the poi follows
     * the controller. */
    uint32_t return_ticks;
    /* 1 while the poi returns after an input loss, otherwise 0. The paper cannot be damaged until
     * the poi arrives. */
    uint8_t was_lost;
    /* Ticks of damage immunity that the poi has used while it returned to its controller's pose.
     * The number decreases while the player controls the poi. */
    uint32_t immunity_ticks;
    /* Number of ticks for which the reported pose has required a motion that no arm can make (an
     * outlier). */
    uint32_t outlier_ticks;
    /* Number of consecutive ticks in which the player has not used the poi. */
    uint32_t rest_ticks;
};
