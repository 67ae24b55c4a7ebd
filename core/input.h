/* input.h -- the complete input of the core for exactly one tick.
 *
 * The frame loop fills one `struct input` for each tick that is due. A recorded game is a list of
 * these structs. Results of devices (a record that reached the disk, an unplugged poi) arrive here
 * as data, never as a call. All zero is a valid input: no button pressed, no poi. */
#ifndef KINGYO_CORE_INPUT_H
#define KINGYO_CORE_INPUT_H

#include <stdint.h>

#include "core/base/vec.h"

/* Ticks per second. The step length is fixed: two ticks per frame at 60 Hz. */
#define CORE_TICK_HZ 120u

/* Longest time that a round is paused for lost pois, and that the slot of a lost poi is
 * reserved. */
#define POI_WAIT_TICKS_MAX (120u * CORE_TICK_HZ)
#define CORE_TICK_S (1.0f / 120.0f)

#define POI_MAX 4u   /* Largest number of players at one tank, as at a real stall. */
#define SHADE_MAX 4u /* Largest number of fans and hands over the water: one per player. */

enum input_button {
    INPUT_START = 1u << 0,
    INPUT_LEFT = 1u << 1,
    INPUT_RIGHT = 1u << 2,
    INPUT_OK = 1u << 3,
    INPUT_LANGUAGE = 1u << 4,
    INPUT_TEST = 1u << 5,    /* Opens the operator's menu, and selects the highlighted item
                                there. */
    INPUT_SERVICE = 1u << 6, /* Adds a credit without payment; in the menu, moves to the next
                                item. */
    INPUT_TILT = 1u << 7,    /* The cabinet was shaken or tilted. */
    INPUT_DOOR = 1u << 8,    /* The cabinet door is open. */
    INPUT_BUTTON_ALL = (1u << 9) - 1u,
};
#define INPUT_BUTTON_COUNT 9u

/* Coin acceptors report small, middle and large coins on one line each. */
#define COIN_LINE_COUNT 3u

#define CONTROLLER_MAX 8u /* Four controllers in play and four spare controllers. */

/* State of a plugged-in USB controller, for the operator's menu. The core stores no controller
 * names; the shell adds names to the scene (scene.h). */
enum controller_state {
    CONTROLLER_NONE = 0,
    CONTROLLER_FREE,   /* Another driver uses the controller and keeps it unless the operator
                          selects the controller. */
    CONTROLLER_ACTIVE, /* Attached: the controller supplies, or can supply, the pose of a poi. */
    CONTROLLER_LOST,   /* The controller was a poi and is disconnected. */
    CONTROLLER_UNSUPPORTED, /* Never usable: a boot keyboard, a hub, or a device without input
                               fields. */
    CONTROLLER_DENIED, /* The operator selected the controller, but the process has no permission
                          to open it. */
    CONTROLLER_STATE_COUNT,
};

/* Steps of the learn wizard for an unknown controller, in this order. Each step requires one action
 * of the operator. */
enum learn_step {
    LEARN_NONE = 0, /* No learn wizard is active. */
    LEARN_REST,     /* Hold the controller still. */
    LEARN_LEFT,
    LEARN_RIGHT,
    LEARN_FAR,
    LEARN_NEAR,
    LEARN_DIP,
    LEARN_TRY,    /* The poi follows the learned mapping; the operator saves the mapping or starts
                     again. */
    LEARN_FAILED, /* The controller's reports cannot be mapped to a poi. */
    LEARN_NOT_SAVED, /* The poi follows the learned mapping, but the mapping could not be saved. */
    LEARN_STEP_COUNT,
};

struct controller_status {
    uint8_t state[CONTROLLER_MAX]; /* enum controller_state of each row. A controller keeps its row
                                      while it is plugged in. */
    uint8_t learn_step;            /* enum learn_step */
    uint8_t learn_row;             /* Row of the controller that is being learned. */
    uint8_t learn_progress;        /* Progress of the current step, 0 .. 255. */
    uint8_t file_count;            /* Number of rows on the menu's file page. The shell supplies the
                                      text of each row. */
};

enum poi_source {
    POI_SOURCE_ABSENT = 0, /* No controller is assigned. */
    POI_SOURCE_LOST = 1,   /* The controller was connected before; the poi moves out of the water
                              and waits. */
    POI_SOURCE_LIVE = 2,   /* `target` is up to date. */
    POI_SOURCE_BOT = 3,    /* The core's own bot controls this poi. */
};

/* Target pose of the ring's centre. A spring pulls the poi to this pose, so the poi may lag. */
struct poi_target {
    vec3 position_m;      /* World coordinates. The core clamps the position to arm's reach; a value
                             beyond +-100 m is invalid. */
    struct angles angles; /* Yaw 0: the handle points toward the player. Pitch > 0 raises the far
                             edge. Whole turns are removed; a value beyond +-1,000 rad is
                             invalid. */
};

struct poi_input {
    uint8_t link;             /* enum poi_source */
    uint8_t has_wrist;        /* 0: the controller cannot tilt the poi, so the core tilts the poi at
                                 the bowl. */
    uint8_t trembles;         /* 1: the sensor is noisy, so bit-identical values in a row mean a
                                 frozen sensor. */
    uint16_t age_ticks;       /* Ticks since the newest report. A pointer that does not move keeps
                                 age 0. */
    struct poi_target target; /* Ignored unless `link` is POI_SOURCE_LIVE. Any bits are accepted:
                                 NaN, an absurd value or a jump faster than an arm stops only this
                                 player's input (core/game/control/input_validation.h), not the
                                 game. */
};

/* A fan (uchiwa) or a hand held over the water. Light falls vertically, so the shaded volume is the
 * cylinder of water below the fan. */
struct shade_input {
    uint8_t present;
    float x_m, z_m; /* Centre, world coordinates; any finite value. The core clamps the centre to 1
                       m beyond the tank walls, where a fan enters the picture. */
    float radius_m; /* Any finite value; the core clamps the radius to SHADE_RADIUS_MIN_M ..
                       SHADE_RADIUS_MAX_M. */
};

#define SHADE_RADIUS_MIN_M 0.01f /* Radius of a finger. */
#define SHADE_RADIUS_MAX_M 0.30f /* Radius of a person who leans over the tank. */

struct input {
    uint32_t held;    /* Buttons that are down, as bits of enum input_button. */
    uint32_t pressed; /* Buttons that went down, as bits of enum input_button. Each press appears
                         in exactly one tick's input. */
    uint32_t coin_count[COIN_LINE_COUNT]; /* Pulses of each coin line since the last tick. Each
                                             pulse appears in exactly one tick's input. */
    uint32_t record_saved_id; /* Id of the newest ledger entry (core/ledger.h) that is confirmed on
                                 disk. */
    uint8_t store_well;       /* 1 while the store accepts entries and its last write succeeded. */
    uint16_t day;             /* Days since 2000-01-01, local time; 0: the clock was never set. Used
                                 as a hint only. */
    uint16_t minute;          /* Minute of the day, 0 .. 1439. */
    uint32_t dropped_ticks;   /* Ticks dropped since the start of the kiosk. */
    uint32_t device_faults;   /* Device faults since the start of the kiosk. */
    uint32_t tickets_done;    /* Finished pulses of the ticket dispenser since the start. Each
                                 matches one of output.tickets. Without a dispenser the shell
                                 reports each pulse as finished at once. */
    uint32_t edit_saved_id;   /* Id of the newest output.edit that is confirmed on disk. */
    uint8_t edit_refused;     /* 1: the store saves no edits, or its last attempt failed. */
    uint8_t upright;          /* 1: portrait screen, narrower than POINTER_UPRIGHT_ASPECT. */
    struct controller_status controllers; /* State of the controllers for the operator's menu. */
    struct poi_input poi[POI_MAX];
    struct shade_input shade[SHADE_MAX];
};

/* Returns the sum of the pulses of all coin lines, saturated at UINT32_MAX. */
static inline uint32_t input_coin_pulses(const struct input *input)
{
    uint32_t sum = 0;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t room = UINT32_MAX - sum;
        sum += input->coin_count[line] < room ? input->coin_count[line] : room;
    }
    return sum;
}

#endif
