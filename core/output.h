/* output.h -- the complete output of the core. The core appends to `struct output` and never reads
 * it back.
 *
 * The frame loop clears the sounds once per frame, runs the ticks, and then passes the output to
 * the devices. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/morph/species.h"

/* Largest number of sounds per frame. A listener could not distinguish more sounds. */
#define OUTPUT_SOUND_MAX 16u

enum sound {
    SOUND_NONE = 0,
    SOUND_DIP,     /* The ring enters the water. */
    SOUND_LIFT,    /* The ring leaves the water, dripping. */
    SOUND_CATCH,   /* A fish lands in the bowl. */
    SOUND_SLAP,    /* A tail hits the paper. */
    SOUND_TEAR,    /* A hole opens in the paper. */
    SOUND_GONE,    /* The paper becomes useless. */
    SOUND_START,   /* A round begins. */
    SOUND_TICK,    /* Countdown of the last seconds, one sound per second. */
    SOUND_RESULT,  /* The round is over. */
    SOUND_CALL,    /* Time announcement: one minute, two minutes, ten seconds left. */
    SOUND_FOUL,    /* Whistle for a foul. */
    SOUND_CHOOSE,  /* The selection moves to another mode. */
    SOUND_COIN,    /* A coin was accepted. */
    SOUND_CREAK,   /* The paper creaks before it tears. */
    SOUND_MISS,    /* A player almost caught a fish. */
    SOUND_WET,     /* Dry paper becomes wet. */
    SOUND_DRIP,    /* Drops fall from a lifted poi. */
    SOUND_PLOP,    /* A fish falls from a poi into the tank. */
    SOUND_ESCAPE,  /* A startled fish splashes at the surface. */
    SOUND_GULP,    /* A fish breathes air at the surface. */
    SOUND_KEY,     /* The selection in the menu moves. */
    SOUND_WIN,     /* The round is over, and a player caught fish. */
    SOUND_RECORD,  /* The round is over, and its score enters the ranking. */
    SOUND_WELCOME, /* The stall keeper calls the players at the start of a round. */
    SOUND_COUNT,
};

struct sound_event {
    uint8_t sound; /* Sound to play (enum sound). */
    float gain;    /* Gain of the sound, (0, 1]. */
    float pan;     /* Stereo position of the sound, from -1 (left) to 1 (right). */
};

/* Levels of the sources that the audio output mixes, each in [0, 1]. */
struct sound_levels {
    float effects;
    float music;
    float ambience; /* Sounds around the stall: crowd, cicadas, bubbles and water. */
    uint32_t song;  /* Seed of the music. A change starts the music from its first part. */
    bool has_pump;  /* True if the air pump bubbles. */
    /* True if the players see the air stone on the right, as on a portrait screen; else the stone
     * is on the left. */
    bool is_stone_right;
};

/* Force feedback for one poi. Force and torque are the reactions of water, fish and walls in world
 * axes, computed by the physics that moves the ring. The scalar levels `drag`, `slap` and `tear`
 * drive a simple rumble motor. */
struct poi_force {
    vec3 force_n; /* Force on the player's hand; each component within +-POI_FORCE_N_MAX. */
    /* Torque about the grip of the handle; each component within +-POI_TORQUE_N_M_MAX. */
    vec3 torque_n_m;
    float drag; /* Drag force of the water, [0, 1]; 1 at POI_DRAG_N_FULL. */
    float slap; /* Strength of the impact of a fish's tail in this tick, [0, 1]. */
    float tear; /* Amount of paper torn in this tick, [0, 1]; 1 means ten cells or more. */
};

#define POI_FORCE_N_MAX 20.0f /* The largest force that a wrist resists. */
/* Torque of POI_FORCE_N_MAX at the end of a 13 cm handle, times 1.5. */
#define POI_TORQUE_N_M_MAX 4.0f
/* Drag of a poi moved broadside at 0.8 m/s, which is the largest drag that paper withstands. */
#define POI_DRAG_N_FULL 2.0f

/* Commands of the operator for a controller. */
enum controller_command_kind {
    COMMAND_NONE = 0,
    /* Detach the controller from its present driver and use the controller as a poi. */
    COMMAND_CHOOSE,
    COMMAND_RELEASE, /* Return the controller to its driver and delete the learned mapping. */
    /* Start the learn wizard, which records a mapping from the controller's reports to the pose of
     * a poi. A controller that is not used as a poi yet is first taken as with COMMAND_CHOOSE. */
    COMMAND_LEARN,
    COMMAND_LEARN_NEXT, /* The operator has performed the current step of the wizard. */
    /* Save the learned mapping for the controller's vendor, product and serial number. */
    COMMAND_LEARN_KEEP,
    /* Discard the learned mapping. The controller returns to its previous driver if it was not used
     * as a poi before the wizard. */
    COMMAND_LEARN_END,
    COMMAND_RESTART, /* Restart the kiosk; applies to no controller. */
    COMMAND_REPLAY,  /* Show the replay of round `round_id`; applies to no controller. */
    /* Acknowledge the quarantined (damaged) databases, which the operator has seen in a list;
     * applies to no controller. */
    COMMAND_SEEN,
    COMMAND_UPDATE, /* Write the update on the USB stick; applies to no controller. */
};

struct controller_command {
    uint8_t kind; /* Kind of the command (enum controller_command_kind). */
    /* Row of the controller, < CONTROLLER_MAX, as in struct controller_status. */
    uint8_t row;
    uint32_t round_id; /* Ledger id of the round, for COMMAND_REPLAY only. */
};

/* Capacity of the ring buffer of commands. A person gives fewer commands in the longest frame
 * (FRAME_PACER_TICKS_MAX), so the shell reads each command before it is overwritten. */
#define CONTROLLER_COMMAND_MAX 8u

/* ---- Edited growth curves ----------------------------------------------------------------------
 *
 * The growth lab outputs a record of the edited growth curves of one species as plain data. The
 * store saves the record, and the next start loads it. */

/* Edited curves of one species. 540 bytes; the core keeps one per species. */
struct lab_edit {
    /* Template from which the graph was started (enum graph_template). Under TEMPLATE_OWN each body
     * part keeps its own curve. Under any other template every body part follows `graph`. */
    uint8_t template_id;
    /* Number of entries in `scale_knots`, as in struct species_card. 0 means that the growth curve
     * determines the scale. */
    uint8_t scale_knot_count;
    /* Deformation graph: weights of the key shapes of the whole fish over its life. */
    struct graph graph;
    struct scale_knot scale_knots[GRAPH_KNOT_MAX];
};

struct graph_edit_record {
    /* Id of the record. Each record has an id one higher than the previous record. 0 means that no
     * record needs to be saved. */
    uint32_t id;
    /* 1 if the species returns to its original curves and the store must delete the saved edit;
     * otherwise 0. */
    uint8_t is_own;
    uint8_t key_count; /* Number of key shapes of the species. */
    char species[SPECIES_NAME_SIZE];
    struct lab_edit edit;
};

/* ---- Complete output ------------------------------------------------------------------------- */

struct output {
    /* Number of sounds, at most OUTPUT_SOUND_MAX. output_sound() describes which sounds are dropped
     * if there are more. */
    uint32_t sound_count;
    struct sound_event sounds[OUTPUT_SOUND_MAX];
    struct poi_force poi[POI_MAX];
    uint32_t tick;       /* Number of ticks that the core has run. */
    uint32_t round_tick; /* Tick at which the newest round started. 0 means no round yet. */
    /* Phase of the game after the newest tick (enum scene_phase); PHASE_ATTRACT (0) before the
     * first tick. */
    uint8_t phase;
    /* 1 if the program may restart, because attract mode is active and the balance contains no open
     * game; otherwise 0. */
    uint8_t is_idle;
    uint8_t has_pump;     /* 1 while the air pump of the tank bubbles, otherwise 0. */
    uint8_t start_lamp;   /* 1 if the START button's lamp is lit, otherwise 0. */
    uint8_t coin_lockout; /* 1 if coins fall through to the return tray, otherwise 0. */
    /* Number of coins counted since the kiosk started. The coin meter in the cabinet receives one
     * pulse for each coin. */
    uint32_t coins_counted;
    /* Number of tickets requested since the kiosk started. The dispenser receives one pulse for
     * each ticket. The core requests the next ticket when input.tickets_done reaches `tickets`. */
    uint32_t tickets;
    /* Number of commands since the kiosk started. Command n, counted from 0, is in commands[n %
     * CONTROLLER_COMMAND_MAX]. */
    uint32_t command_count;
    struct controller_command commands[CONTROLLER_COMMAND_MAX];
    uint32_t entry_id; /* Id of the newest ledger entry. Entry n is in entries[n % LEDGER_RING]. */
    struct ledger_entry entries[LEDGER_RING];
    /* Newest graph edit of a species. The next edit overwrites this edit. An edit that the store
     * did not read in time is not saved, and is lost at the next start. */
    struct graph_edit_record edit;
};

/* Merges the force of one tick into `frame`, the force of the current frame. The frame loop clears
 * `frame` once per frame. The device receives the strongest impact and the largest tear of the
 * frame. Without an impact the device receives the latest force. */
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

/* Returns true for the many quiet sounds of water and fish, which give way to all other sounds. */
static inline bool sound_gives_way(uint8_t sound)
{
    return sound == SOUND_DRIP || sound == SOUND_GULP || sound == SOUND_ESCAPE;
}

/* Appends one sound. When the frame already has OUTPUT_SOUND_MAX sounds, the sound replaces the
 * first quiet sound of water or fish. If there is none, or if the sound is such a sound, the sound
 * is dropped. */
static inline void output_sound(struct output *output, enum sound sound, float gain, float pan)
{
    const struct sound_event event = { .sound = (uint8_t)sound, .gain = gain, .pan = pan };
    if (output->sound_count < OUTPUT_SOUND_MAX) {
        output->sounds[output->sound_count++] = event;
        return;
    }
    for (uint32_t i = 0; i < OUTPUT_SOUND_MAX && !sound_gives_way(event.sound); i++) {
        if (sound_gives_way(output->sounds[i].sound)) {
            output->sounds[i] = event;
            return;
        }
    }
}
