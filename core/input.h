/* input.h -- the complete input of the core for exactly one tick.
 *
 * The frame loop fills one `struct input` for each tick that it runs. A recorded game is a list of
 * these structs. Events of devices, such as a ledger entry that reached the disk or an unplugged
 * poi, arrive in `struct input` as data, never as a call. A struct with all fields 0 is a valid
 * input: no button is pressed, and no poi is connected. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"

/* Number of ticks per second. The step length is fixed: two ticks per frame at 60 Hz. */
#define CORE_TICK_HZ 120u

/* Longest time for which a round is paused while controllers of pois are disconnected. The slot of
 * a disconnected controller is reserved for the same time. */
#define POI_WAIT_TICKS_MAX (120u * CORE_TICK_HZ)
#define CORE_TICK_S (1.0f / 120.0f)

#define POI_MAX 4u   /* Largest number of players at one tank, as at a real stall. */
#define SHADE_MAX 4u /* Largest number of fans and hands that shade the water: one per player. */

enum input_button {
    INPUT_START = 1u << 0,
    INPUT_LEFT = 1u << 1,
    INPUT_RIGHT = 1u << 2,
    INPUT_OK = 1u << 3,
    INPUT_LANGUAGE = 1u << 4,
    /* Opens the operator's menu. In the menu the button selects the highlighted item. */
    INPUT_TEST = 1u << 5,
    /* Adds a credit without payment. In the menu the button moves the highlight to the next
     * item. */
    INPUT_SERVICE = 1u << 6,
    INPUT_TILT = 1u << 7, /* The cabinet was shaken or tilted. */
    INPUT_DOOR = 1u << 8, /* The cabinet door is open. */
    /* Directions up and down of a keyboard or a direction pad, which also report INPUT_OK. Only the
     * operator's menu reads them, and moves the highlight to the previous or the next item. */
    INPUT_UP = 1u << 9,
    INPUT_DOWN = 1u << 10,
    INPUT_BUTTON_ALL = (1u << 11) - 1u,
};
/* Number of the first buttons of enum input_button. A cabinet can have a line for each of them. */
#define INPUT_BUTTON_COUNT 9u

/* Number of coin lines: coin acceptors report small, middle and large coins on one line each. */
#define COIN_LINE_COUNT 3u

#define CONTROLLER_MAX 8u /* Four controllers in play and four spare controllers. */

/* State of a plugged-in USB controller, for the operator's menu. The core stores no controller
 * names. The shell (the program around the core) adds names to the scene (scene.h). */
enum controller_state {
    CONTROLLER_NONE = 0,
    /* Another driver uses the controller. Kingyo attaches the controller only if the operator
     * selects it. */
    CONTROLLER_FREE,
    /* The controller is attached, and supplies or can supply the pose of a poi. */
    CONTROLLER_ACTIVE,
    CONTROLLER_LOST, /* The controller controlled a poi and is now disconnected. */
    /* The device can never be used: a boot keyboard, a hub, or a device without input fields. */
    CONTROLLER_UNSUPPORTED,
    /* The operator selected the controller, but the process has no permission to open it. */
    CONTROLLER_DENIED,
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
    /* The poi follows the learned mapping. The operator saves the mapping or restarts the
     * wizard. */
    LEARN_TRY,
    LEARN_FAILED,    /* The controller's reports cannot be mapped to a poi. */
    LEARN_NOT_SAVED, /* The poi follows the learned mapping, but the mapping could not be saved. */
    LEARN_STEP_COUNT,
};

/* State of the update by USB stick (board/image/UPDATE.md). */
enum update_state {
    UPDATE_NONE = 0, /* The machine cannot be updated, and the menu has no update page. */
    UPDATE_IDLE,
    UPDATE_READY, /* A verified update waits for the operator. */
    UPDATE_BUSY,  /* An update is being written. */
    UPDATE_STATE_COUNT,
};

struct controller_status {
    /* State of the controller in each row of the menu page that lists the controllers (enum
     * controller_state). A controller keeps its row while it is plugged in. */
    uint8_t state[CONTROLLER_MAX];
    uint8_t learn_step;     /* Current step of the learn wizard (enum learn_step). */
    uint8_t learn_row;      /* Row of the controller that is being learned. */
    uint8_t learn_progress; /* Progress of the current step of the learn wizard, 0 .. 255. */
    /* Number of rows on the menu's file page. The shell supplies the text of each row. */
    uint8_t file_count;
    /* State of the update by USB stick (enum update_state); 0 in recordings of older programs. */
    uint8_t update;
};

enum poi_source {
    POI_SOURCE_ABSENT = 0, /* No controller is assigned to the poi. */
    /* The poi's controller is disconnected. The poi moves out of the water and waits. */
    POI_SOURCE_LOST = 1,
    /* The poi's controller is connected, and `target` in struct poi_input is up to date. */
    POI_SOURCE_LIVE = 2,
    POI_SOURCE_BOT = 3, /* The core's built-in bot controls the poi. */
};

/* Target pose of a poi, given at the ring's centre. A spring pulls the poi to the target pose, so
 * the poi may lag behind it. */
struct poi_target {
    /* Position in world coordinates. The core clamps the position to arm's reach. A coordinate
     * beyond +-100 m is invalid. */
    vec3 position_m;
    /* Orientation. Yaw 0 means that the handle points toward the player; pitch > 0 raises the far
     * edge. The core removes whole turns from each angle. An angle beyond +-1,000 rad is
     * invalid. */
    struct angles angles;
};

struct poi_input {
    uint8_t link; /* Source of the poi's pose (enum poi_source). */
    /* 1 if the controller measures angles. 0 means that the controller cannot tilt the poi, so the
     * core tilts the poi at the bowl. */
    uint8_t has_wrist;
    /* 1 if the sensor is noisy. For a noisy sensor, bit-identical values in a row mean that the
     * sensor is frozen. */
    uint8_t trembles;
    /* 1 if the controller's motion since the last tick was not observed, because the kiosk was
     * delayed. 0 in older recordings. */
    uint8_t has_gap;
    /* Age of the newest report in ticks. A pointer that does not move keeps age 0. */
    uint16_t age_ticks;
    /* Target pose, ignored unless `link` is POI_SOURCE_LIVE. Any bits are accepted. A NaN, an
     * absurd value or a jump faster than an arm stops only the input of this player
     * (core/game/control/input_pose.h), not the game. */
    struct poi_target target;
};

/* Fan (uchiwa) or hand held over the water. Light falls vertically, so the shaded volume is the
 * cylinder of water below the fan or hand. */
struct shade_input {
    uint8_t present;
    /* Centre of the fan in world coordinates; any finite value. The core clamps the centre to 1 m
     * beyond the tank walls, where a fan enters the picture. */
    float x_m, z_m;
    /* Radius of the fan; any finite value. The core clamps the radius to SHADE_RADIUS_MIN_M ..
     * SHADE_RADIUS_MAX_M. */
    float radius_m;
};

#define SHADE_RADIUS_MIN_M 0.01f /* Radius of a finger. */
#define SHADE_RADIUS_MAX_M 0.30f /* Radius of a person who leans over the tank. */

struct input {
    uint32_t held; /* Bit mask of the buttons that are held down (enum input_button). */
    /* Bit mask of the buttons that were pressed since the last tick (enum input_button). Each press
     * appears in exactly one tick's input. */
    uint32_t pressed;
    /* Pulses of each coin line since the last tick. Each pulse appears in exactly one tick's
     * input. */
    uint32_t coin_count[COIN_LINE_COUNT];
    /* Id of the newest ledger entry (core/ledger.h) that is confirmed on disk. */
    uint32_t record_saved_id;
    /* 1 if the store accepts entries and its last write succeeded, otherwise 0. */
    uint8_t store_well;
    /* Days since 2000-01-01, local time; 0 means that the clock was never set. The date may be
     * wrong, so the core uses it only as a hint. */
    uint16_t day;
    uint16_t minute;        /* Minute of the day, 0 .. 1439. */
    uint32_t dropped_ticks; /* Number of dropped ticks since the kiosk started. */
    uint32_t device_faults; /* Number of device faults since the kiosk started. */
    /* Number of finished pulses of the ticket dispenser since the kiosk started. Each pulse matches
     * one ticket of output.tickets. Without a dispenser the shell reports each pulse as finished
     * immediately. */
    uint32_t tickets_done;
    /* Id of the newest graph edit (output.edit) that is confirmed on disk. */
    uint32_t edit_saved_id;
    /* 1 if the store cannot save graph edits or its last attempt failed, otherwise 0. */
    uint8_t edit_refused;
    /* 1 if the screen is in portrait format, narrower than POINTER_UPRIGHT_ASPECT; otherwise 0. */
    uint8_t upright;
    /* 1 if the picture shows the tank from its short side (core/view.h), otherwise 0. The poses are
     * in the axes of the world in both cases. */
    uint8_t is_turned;
    struct controller_status controllers; /* State of the controllers for the operator's menu. */
    struct poi_input poi[POI_MAX];
    struct shade_input shade[SHADE_MAX];
};

/* Returns the sum of the pulses of all coin lines in `input`, saturated at UINT32_MAX. */
static inline uint32_t input_coin_pulses(const struct input *input)
{
    uint32_t sum = 0;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t room = UINT32_MAX - sum;
        sum += input->coin_count[line] < room ? input->coin_count[line] : room;
    }
    return sum;
}
