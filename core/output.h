/* output.h -- everything the core asks of the world. The core appends and never reads it back.
 *
 * The frame loop clears the sounds once a frame, lets the ticks append, then serves them. */
#ifndef KINGYO_CORE_OUTPUT_H
#define KINGYO_CORE_OUTPUT_H

#include <stdint.h>

#include "core/edit.h"
#include "core/input.h"
#include "core/ledger.h"

#define OUTPUT_SOUND_MAX 16u /* A frame's worth; more in one frame could not be told apart. */

enum sound {
    SOUND_NONE = 0,
    SOUND_DIP,     /* The ring enters the water. */
    SOUND_LIFT,    /* The ring leaves it, dripping. */
    SOUND_CATCH,   /* A fish lands in the bowl. */
    SOUND_SLAP,    /* A tail hits the paper. */
    SOUND_TEAR,    /* A hole opens. */
    SOUND_GONE,    /* The paper can hold nothing any more. */
    SOUND_START,   /* A round begins. */
    SOUND_TICK,    /* Each of the last seconds. */
    SOUND_RESULT,  /* The round is over. */
    SOUND_CALL,    /* The keeper calls the time: a minute, two, ten seconds left. */
    SOUND_FOUL,    /* The umpire's whistle. */
    SOUND_CHOOSE,  /* Another mode is pointed at. */
    SOUND_COIN,    /* A coin was taken. */
    SOUND_COUNT,
};

struct sound_event {
    uint8_t sound; /* enum sound */
    float gain;    /* (0, 1] */
    float pan;     /* -1 left .. 1 right */
};

/* What the hand that holds the poi feels: the reaction of water, fish and walls, in world axes,
 * from the same physics that moves the ring; and three plain levels for a motor that only hums. */
struct poi_force {
    vec3 force_n;    /* On the hand; each part within +-POI_FORCE_N_MAX. */
    vec3 torque_n_m; /* About the grip; within +-POI_TORQUE_N_M_MAX. */
    float drag;      /* [0, 1] of the water's push, 1 at POI_DRAG_N_FULL. */
    float slap;      /* [0, 1] of a tail's blow in this tick. */
    float tear;      /* [0, 1] of the paper that tore in this tick, 1 from ten cells on. */
};

#define POI_FORCE_N_MAX 20.0f    /* As much as a wrist gives. */
#define POI_TORQUE_N_M_MAX 4.0f  /* That at the end of a handle of 13 cm, and half as much again. */
#define POI_DRAG_N_FULL 2.0f     /* Broadside at 0.8 m/s: what paper bears at most. */

/* What the operator orders of a controller. */
enum desk_order_kind {
    DESK_NOTHING = 0,
    DESK_CHOOSE,     /* Take it from whoever has it; it is a poi from now on. */
    DESK_RELEASE,    /* Give it back, and forget what was learned. */
    DESK_LEARN,      /* Begin to learn it; it is chosen while that lasts. */
    DESK_LEARN_NEXT, /* Whoever holds it says that he did as he was told. */
    DESK_LEARN_KEEP, /* Keep what was learned for this vendor:product:serial. */
    DESK_LEARN_END,  /* Forget it, and give back who was not chosen before. */
    DESK_RESTART,    /* Of no controller: the kiosk ends and begins anew. */
    DESK_REPLAY,     /* No controller's: show the replay of the round `round_id`. */
    DESK_SEEN,       /* Nor this: the operator has seen which databases were set aside. */
};

struct desk_order {
    uint8_t kind; /* enum desk_order_kind */
    uint8_t row;  /* < CONTROLLER_MAX, as in desk_input. */
    uint32_t round_id; /* Of DESK_REPLAY: its entry in the ledger. */
};

#define DESK_ORDER_MAX 8u /* More than a hand gives in the longest frame (PACE_TICKS_MAX), so that
                             the oldest is told before its place is taken. */

struct output {
    uint32_t sound_count; /* <= OUTPUT_SOUND_MAX; further sounds of the frame are not heard. */
    struct sound_event sounds[OUTPUT_SOUND_MAX];
    struct poi_force poi[POI_MAX];
    uint8_t start_lamp;     /* Level. */
    uint8_t coin_lockout;   /* Level: coins fall through to the return. */
    uint32_t coins_counted; /* Since the start: the meter in the cabinet gets a pulse for each. */
    uint32_t tickets;       /* Since the start: the dispenser gets a pulse for each. The next is
                               asked for once input.tickets_done has reached this number. */
    uint32_t order_count;   /* Since the start; order n, from 0, lies at n % DESK_ORDER_MAX. */
    struct desk_order orders[DESK_ORDER_MAX];
    uint32_t entry_id;      /* The newest entry's; entry n lies at n % LEDGER_RING. */
    struct ledger_entry entries[LEDGER_RING];
    struct round_record record; /* The newest finished round, for who only looks on. */
    struct edit_record edit;    /* Likewise; what the store did not take by then is this run's. */
};

/* Adds a tick's force to its frame's, which the frame loop cleared: a device is told of the hardest
 * blow and tear of a frame, and of the latest pull where there is no blow. */
static inline void output_feel(struct poi_force *frame, const struct poi_force *tick)
{
    const struct poi_force before = *frame;
    if (tick->slap >= before.slap) {
        *frame = *tick;
    }
    frame->drag = f_max(before.drag, tick->drag);
    frame->slap = f_max(before.slap, tick->slap);
    frame->tear = f_max(before.tear, tick->tear);
}

/* Appends one sound, or drops it when the frame already has OUTPUT_SOUND_MAX. */
static inline void output_sound(struct output *output, enum sound sound, float gain, float pan)
{
    if (output->sound_count < OUTPUT_SOUND_MAX) {
        output->sounds[output->sound_count++] =
            (struct sound_event){ .sound = (uint8_t)sound, .gain = gain, .pan = pan };
    }
}

#endif
