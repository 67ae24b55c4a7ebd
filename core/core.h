/* core.h -- the whole stall as one value.
 *
 * The caller owns `struct core`. It holds no pointers, so assignment is a snapshot, and equal seeds
 * and inputs give equal hashes on every board. The core never calls out: it turns one `struct
 * input` into changes of itself and lines appended to `struct output`. */
#ifndef KINGYO_CORE_CORE_H
#define KINGYO_CORE_CORE_H

#include <stdint.h>

#include "core/game/chapter.h"
#include "core/game/credit.h"
#include "core/game/game.h"
#include "core/input.h"
#include "core/memory.h"
#include "core/output.h"
#include "core/poi/bowl.h"
#include "core/poi/poi.h"
#include "core/scene.h"
#include "core/tank/tank.h"

#define KINGYO_VERSION "0.1.0"

enum core_error {
    CORE_OK = 0,
    CORE_ERR_RANGE = -1, /* A config field lies outside its documented range. */
    CORE_ERR_FLOAT = -2, /* The calling thread flushes denormal numbers to zero or does not round
                            to nearest (core/base/float_env.h): every result would be wrong. */
};

struct core_config {
    uint32_t seed;       /* Any value. */
    uint8_t preset;      /* enum tank_preset_id */
    uint32_t fish_count; /* 0: the preset's own; else 1 .. tank_preset_fish_max(). */
    uint8_t language;    /* enum language */
    uint32_t round_s;    /* 0: the mode's own; else 10 .. 600. */
    uint8_t modes;       /* Offered, a bit (1 << enum game_mode, or CHOICE_LAB) each; 0: only the
                            festival. Of one there is nothing to choose. */
    uint8_t grade;       /* Of the paper, 4 .. 7, in a mode whose rules leave it open or that is the
                            only one offered; 0: the mode's own, else 6. */
    uint8_t players;     /* Bowls at the tank, 1 .. POI_MAX; 0: 1. */
    uint8_t credit_coins; /* Units that a round costs, .. CREDIT_COINS_MAX; 0: free play. */
    uint8_t ticket_fish; /* Fish that a player has a ticket for, .. CREDIT_TICKET_FISH_MAX; 0: there
                            are none. */
    uint8_t rules_7;     /* 1: a recording of format 7, which keeps the rules of its time
                            (replay_start_decode()); hashes leave it out, as that time did. */
    uint8_t lanes;       /* 4 or, on x86-64 with AVX2, 8 floats at once; 0: 4. Changes no result, so
                            neither hashes nor recordings know of it. */
    struct memory memory; /* What outlived the last power cut; its settings overrule nothing here:
                             see settings_apply(). */
    struct chapter chapter; /* Goes on from the one before; zero: the kiosk begins. */
    struct lab_book book; /* Makers' species and saved graphs, as the data folder has them. */
};

struct core {
    uint32_t tick;
    struct core_config config;
    struct game game;
    struct poi poi[POI_MAX];
    struct bowl bowl[POI_MAX];
    struct tank tank;
};

/* Fills `core` with a fresh stall in attract mode. On an error it is untouched. */
enum core_error core_init(struct core *core, const struct core_config *config);

/* Advances one tick, in this order and no other: game -> poi -> water -> fish -> catch -> score.
 * Returns CORE_OK, or CORE_ERR_FLOAT: then `core` and `output` are unchanged. The first tick of
 * each second checks the thread's floating point; the caller sets it up (platform/cpu.h). */
enum core_error core_tick(struct core *core, const struct input *input, struct output *output);

/* Whether a chapter begins here: core_init() of `core->config` makes this very state. */
int core_is_fresh(const struct core *core);

/* Rebuilds the whole picture; reads the state, never changes it. */
void core_scene(const struct core *core, struct scene *scene);

/* Over every simulated field, padding excluded. */
uint64_t core_hash(const struct core *core);

/* Over what moves each tick (game, pois, fish), without the paper's cells and the ripples: a tenth
 * of the work, for a digest of every tick in a recording. */
uint64_t core_hash_quick(const struct core *core);

#endif
