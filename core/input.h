/* input.h -- everything the world tells the core, for exactly one tick.
 *
 * The frame loop fills one `struct input` per owed tick; a recorded game is the list of them. What
 * a device answers (a record now on disk, a poi unplugged) comes in here as data, never as a call.
 * Zero is a valid input: nothing pressed, no poi. */
#ifndef KINGYO_CORE_INPUT_H
#define KINGYO_CORE_INPUT_H

#include <stdint.h>

#include "core/base/vec.h"

#define CORE_TICK_HZ 120u /* The only step length there is. Two ticks a frame at 60 Hz. */

/* A round waits no longer for pois that are lost; so long a lost one's seat is kept for it. */
#define POI_WAIT_TICKS_MAX (120u * CORE_TICK_HZ)
#define CORE_TICK_S (1.0f / 120.0f)

#define POI_MAX 4u   /* Players at one tank, as at a real stall. */
#define SHADE_MAX 4u /* Fans and hands over the water: one a player. */

enum input_button {
    INPUT_START = 1u << 0,
    INPUT_LEFT = 1u << 1,
    INPUT_RIGHT = 1u << 2,
    INPUT_OK = 1u << 3,
    INPUT_LANGUAGE = 1u << 4,
    INPUT_TEST = 1u << 5,    /* Opens the operator's menu, and takes what it points at there. */
    INPUT_SERVICE = 1u << 6, /* A credit that nobody paid for; in the menu, the next tag. */
    INPUT_TILT = 1u << 7,    /* The cabinet was shaken or leant. */
    INPUT_DOOR = 1u << 8,    /* The cabinet stands open. */
    INPUT_BUTTON_ALL = (1u << 9) - 1u,
};
#define INPUT_BUTTON_COUNT 9u

#define COIN_LINE_COUNT 3u /* Acceptors say small, middle and large coins on a line each. */

#define CONTROLLER_MAX 8u /* Four that play, and four that lie ready. */

/* A USB controller that is plugged in, as the operator's menu may deal with it. What it is called
 * is no concern of the core: the shell dresses the scene with names (scene.h). */
enum controller_state {
    CONTROLLER_NONE = 0,
    CONTROLLER_FREE,    /* Another driver has it, which it will keep unless it is chosen. */
    CONTROLLER_PLAYS,   /* It is a poi, or will be when it is asked for. */
    CONTROLLER_LOST,    /* It was a poi and is away. */
    CONTROLLER_BARRED,  /* Never taken: a boot keyboard, a hub's, no input fields. */
    CONTROLLER_DENIED,  /* Chosen, but we may not open it. */
    CONTROLLER_STATE_COUNT,
};

/* What a controller that is being learned wants of whoever holds it, in this order. */
enum learn_step {
    LEARN_NONE = 0, /* Nothing is learned. */
    LEARN_REST,     /* Keep it still. */
    LEARN_LEFT,
    LEARN_RIGHT,
    LEARN_FAR,
    LEARN_NEAR,
    LEARN_DIP,
    LEARN_TRY,      /* It plays with what was learned: keep it, or begin again? */
    LEARN_FAILED,   /* What it said cannot be a poi. */
    LEARN_UNKEPT,   /* It plays with what was learned, which could not be written down. */
    LEARN_STEP_COUNT,
};

struct desk_input {
    uint8_t state[CONTROLLER_MAX]; /* enum controller_state; a row keeps its place. */
    uint8_t learn_step;            /* enum learn_step */
    uint8_t learn_row;             /* Of the controller that is learned. */
    uint8_t learn_progress;        /* 0 .. 255 of the present step. */
    uint8_t file_count;            /* Rows of the files' page: what each says is the shell's. */
};

enum poi_link {
    POI_LINK_ABSENT = 0, /* No such controller. */
    POI_LINK_LOST = 1,   /* It was here; the poi drifts out of the water and waits. */
    POI_LINK_LIVE = 2,   /* `target` is fresh. */
    POI_LINK_BOT = 3,    /* The core's own bot holds this poi. */
};

/* Where a hand wants the ring's centre to be. The poi is pulled there by a spring and may lag. */
struct poi_target {
    vec3 position_m;      /* World; clamped to the reach of an arm by the core, and absurd beyond
                             +-100 m. */
    struct angles angles; /* Yaw 0: handle toward the player. Pitch > 0 lifts the far edge. Whole
                             turns are taken off; absurd beyond +-1,000 rad. */
};

struct poi_input {
    uint8_t link;             /* enum poi_link */
    uint8_t has_wrist;        /* 0: the controller cannot turn; the core does it at the bowl. */
    uint8_t trembles;         /* A sensor that never repeats itself: one that does is frozen. */
    uint16_t age_ticks;       /* Since its newest report came; a pointer at rest is not old. */
    struct poi_target target; /* Ignored unless link is POI_LINK_LIVE. Any bits: a number that is
                                 none or absurd, or a leap that no arm makes, loses the hand, not
                                 the game (core/game/trust.h). */
};

/* A fan (uchiwa) or a hand that someone holds over the water. Light falls from straight above, so
 * what it shades is the round column of water under it. */
struct shade_input {
    uint8_t present;
    float x_m, z_m; /* Its middle, world; any finite value. The core clamps it to 1 m beyond the
                       tank's walls, whence it swings in. */
    float radius_m; /* Any finite value, clamped to SHADE_RADIUS_MIN_M .. _MAX_M by the core. */
};

#define SHADE_RADIUS_MIN_M 0.01f /* A finger. */
#define SHADE_RADIUS_MAX_M 0.30f /* Who leans over the tank. */

struct input {
    uint32_t held;            /* enum input_button levels. */
    uint32_t pressed;         /* Edges; each press is in exactly one tick's input. */
    uint32_t coin_count[COIN_LINE_COUNT]; /* Pulses of each coin line since the last tick, each in
                                             exactly one tick's input. */
    uint32_t record_saved_id; /* Newest ledger entry (core/ledger.h) known to be on disk. */
    uint8_t store_well;       /* Level: the store keeps entries, and its last try went well. */
    uint16_t day;             /* Since 2000-01-01, local; 0: the clock was never set. A hint. */
    uint16_t minute;          /* Of that day, 0 .. 1439. */
    uint32_t dropped_ticks;   /* Since the start; */
    uint32_t device_faults;   /* likewise. */
    uint32_t tickets_done;    /* Pulses of the ticket dispenser that have ended, since the start.
                                 Each is one of output.tickets; a cabinet without a dispenser ends
                                 them at once. */
    uint32_t edit_saved_id;   /* The same of output.edit. */
    uint8_t edit_refused;     /* 1: the store keeps no edit, or its last try to failed. */
    uint8_t upright;          /* The screen stands: narrower than OVERLAY_UPRIGHT_ASPECT. */
    struct desk_input desk;   /* What the operator's menu shows of controllers. */
    struct poi_input poi[POI_MAX];
    struct shade_input shade[SHADE_MAX];
};

/* Of all lines together, which stops at UINT32_MAX. */
static inline uint32_t coin_pulses(const struct input *input)
{
    uint32_t sum = 0;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t room = UINT32_MAX - sum;
        sum += input->coin_count[line] < room ? input->coin_count[line] : room;
    }
    return sum;
}

#endif
