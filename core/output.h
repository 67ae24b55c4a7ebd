/* output.h -- the complete output of the core. The core appends to it and never reads it back.
 *
 * The frame loop clears the sounds once per frame, runs the ticks, and then passes the output to
 * the devices. */
#ifndef KINGYO_CORE_OUTPUT_H
#define KINGYO_CORE_OUTPUT_H

#include <stdint.h>

#include "core/input.h"
#include "core/lab_edit_record.h"
#include "core/ledger.h"

/* Capacity for one frame; more sounds in one frame cannot be distinguished. */
#define OUTPUT_SOUND_MAX 16u

enum sound {
    SOUND_NONE = 0,
    SOUND_DIP,    /* The ring enters the water. */
    SOUND_LIFT,   /* The ring leaves the water, dripping. */
    SOUND_CATCH,  /* A fish lands in the bowl. */
    SOUND_SLAP,   /* A tail hits the paper. */
    SOUND_TEAR,   /* A hole opens. */
    SOUND_GONE,   /* The paper becomes useless. */
    SOUND_START,  /* A round begins. */
    SOUND_TICK,   /* Countdown of the last seconds, one sound per second. */
    SOUND_RESULT, /* The round is over. */
    SOUND_CALL,   /* Time announcement: one minute, two minutes, ten seconds left. */
    SOUND_FOUL,   /* Whistle for a foul. */
    SOUND_CHOOSE, /* The selection moves to another mode. */
    SOUND_COIN,   /* A coin was accepted. */
    SOUND_COUNT,
};

struct sound_event {
    uint8_t sound; /* enum sound */
    float gain;    /* (0, 1] */
    float pan;     /* -1 left .. 1 right */
};

/* Force feedback for one poi: the reaction of water, fish and walls in world axes, from the same
 * physics that moves the ring. Three scalar levels drive a simple rumble motor. */
struct poi_force {
    vec3 force_n;    /* Force on the player's hand; each component within +-POI_FORCE_N_MAX. */
    vec3 torque_n_m; /* Torque about the grip; each component within +-POI_TORQUE_N_M_MAX. */
    float drag;      /* Drag force of the water, [0, 1]; 1 at POI_DRAG_N_FULL. */
    float slap;      /* Strength of a tail's impact in this tick, [0, 1]. */
    float tear;      /* Amount of paper torn in this tick, [0, 1]; 1 from ten cells on. */
};

#define POI_FORCE_N_MAX 20.0f   /* The largest force that a wrist resists. */
#define POI_TORQUE_N_M_MAX 4.0f /* POI_FORCE_N_MAX at the end of a 13 cm handle, times 1.5. */
/* Drag broadside at 0.8 m/s, which is the most that paper withstands. */
#define POI_DRAG_N_FULL 2.0f

/* Commands of the operator for a controller. */
enum controller_command_kind {
    COMMAND_NONE = 0,
    COMMAND_CHOOSE,  /* Detach the controller from its driver; the controller is a poi from now
                        on. */
    COMMAND_RELEASE, /* Return the controller to its driver and delete the learned mapping. */
    COMMAND_LEARN,   /* Start the learn wizard; the controller is attached while the wizard runs. */
    COMMAND_LEARN_NEXT, /* The operator has performed the current step of the wizard. */
    COMMAND_LEARN_KEEP, /* Save the learned mapping for this vendor:product:serial. */
    COMMAND_LEARN_END,  /* Discard the learned mapping, and return the controller to its driver
                           if it was not attached before. */
    COMMAND_RESTART,    /* Restart the kiosk; applies to no controller. */
    COMMAND_REPLAY,     /* Show the replay of round `round_id`; applies to no controller. */
    COMMAND_SEEN,       /* The operator has read which databases were quarantined; applies to no
                           controller. */
};

struct controller_command {
    uint8_t kind;      /* enum controller_command_kind */
    uint8_t row;       /* Row < CONTROLLER_MAX, as in struct controller_status. */
    uint32_t round_id; /* Ledger id of the round, for COMMAND_REPLAY only. */
};

/* More commands than a person gives in the longest frame (FRAME_PACER_TICKS_MAX), so that the
 * shell reads the oldest command before it is overwritten. */
#define CONTROLLER_COMMAND_MAX 8u

struct output {
    uint32_t sound_count; /* <= OUTPUT_SOUND_MAX; further sounds of the frame are dropped. */
    struct sound_event sounds[OUTPUT_SOUND_MAX];
    struct poi_force poi[POI_MAX];
    uint8_t start_lamp;     /* Level of the start button's lamp, 0 or 1. */
    uint8_t coin_lockout;   /* 1: coins fall through to the return tray. */
    uint32_t coins_counted; /* Coins counted since the start. The meter in the cabinet receives one
                               pulse for each. */
    uint32_t tickets;       /* Tickets requested since the start; the dispenser receives one pulse
                               for each. The next ticket is requested when input.tickets_done
                               reaches this number. */
    uint32_t command_count; /* Commands since the start; command n, from 0, is in orders[n %
                               CONTROLLER_COMMAND_MAX]. */
    struct controller_command commands[CONTROLLER_COMMAND_MAX];
    uint32_t entry_id; /* Id of the newest entry; entry n is in entries[n % LEDGER_RING]. */
    struct ledger_entry entries[LEDGER_RING];
    struct round_record record;    /* The newest finished round, for readers that do not need the
                                      ledger. */
    struct graph_edit_record edit; /* The newest edit of a species. An edit that the store did
                                      not read before the next edit is not saved, and is lost at
                                      the next start. */
};

/* Merges the force of one tick into the force of its frame, which the frame loop clears. The device
 * receives the strongest impact and tear of the frame; without an impact, the latest force. */
static inline void output_merge_force(struct poi_force *frame, const struct poi_force *tick)
{
    const struct poi_force before = *frame;
    if (tick->slap >= before.slap) {
        *frame = *tick;
    }
    frame->drag = f_max(before.drag, tick->drag);
    frame->slap = f_max(before.slap, tick->slap);
    frame->tear = f_max(before.tear, tick->tear);
}

/* Appends one sound. The sound is dropped when the frame already has OUTPUT_SOUND_MAX sounds. */
static inline void output_sound(struct output *output, enum sound sound, float gain, float pan)
{
    if (output->sound_count < OUTPUT_SOUND_MAX) {
        output->sounds[output->sound_count++] =
            (struct sound_event){ .sound = (uint8_t)sound, .gain = gain, .pan = pan };
    }
}

#endif
