/* core.h -- the complete state of the simulation and the functions that advance it.
 *
 * The caller owns `struct core`. The struct holds no pointers, so an assignment is a snapshot.
 * Equal seeds and equal inputs give equal hashes on every board. The core calls no code outside
 * core/: core_tick() reads one `struct input`, changes `struct core` and appends to `struct
 * output`. */
#ifndef KINGYO_CORE_CORE_H
#define KINGYO_CORE_CORE_H

#include <stdint.h>

#include "core/game/accounting/credit.h"
#include "core/game/game.h"
#include "core/game/session.h"
#include "core/input.h"
#include "core/output.h"
#include "core/persistent_state.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/scene.h"
#include "core/tank/tank.h"

#define KINGYO_VERSION "0.1.0"

enum core_error {
    CORE_OK = 0,
    CORE_ERR_RANGE = -1, /* A config field lies outside its documented range. */
    CORE_ERR_FLOAT = -2, /* The calling thread flushes denormal numbers to zero or does not round to
                            nearest (core/base/float_env.h). Every result would be wrong. */
};

struct core_config {
    uint32_t seed;       /* Seed of the random numbers; any value. */
    uint8_t preset;      /* enum tank_preset_id */
    uint32_t fish_count; /* Number of fish, 1 .. tank_preset_fish_max(); 0: the preset's default. */
    uint8_t language;    /* enum language */
    uint32_t round_s;    /* Length of a round, 10 .. 600 s; 0: the mode's default. */
    uint8_t modes;       /* Modes on offer, one bit each (1 << enum game_mode, or 1 << CHOICE_LAB);
                            0: only the festival mode. With a single mode the selection screen is
                            skipped. */
    uint8_t grade;       /* Paper grade, 4 .. 7, used if the mode's rules leave the grade open or if
                            only one mode is on offer; 0: the mode's default, else 6. */
    uint8_t players;     /* Number of bowls at the tank, 1 .. POI_MAX; 0 counts as 1. */
    uint8_t credit_coins; /* Price of a round in units, 1 .. CREDIT_COINS_MAX; 0: free play. */
    uint8_t ticket_fish;  /* Fish per ticket, 1 .. CREDIT_TICKET_FISH_MAX; 0: no tickets. */
    uint8_t rules_7;      /* 1: the configuration comes from a recording of format 7 and uses the
                             rules of that format (replay_initial_state_decode()). Hashes exclude
                             this field because hashes of format 7 did not contain it. */
    uint8_t lanes;        /* SIMD width in floats: 4, or 8 on x86-64 with AVX2; 0 counts as 4.
                             The width changes no result, so hashes and recordings exclude it. */
    struct persistent_state
        persistent; /* Persistent state that the store loaded at startup. The settings in it do
                       not override the fields above; see settings_apply(). */
    struct game_session session; /* State carried over from the previous session; all zero at the
                                    start of the kiosk. */
    struct lab_book book;        /* Custom species and saved growth graphs, as loaded from the
                                    data folder. */
};

struct core {
    uint32_t tick;
    struct core_config config;
    struct game game;
    struct poi poi[POI_MAX];
    struct bowl bowl[POI_MAX];
    struct tank tank;
};

/* Initializes `core` from `config` in attract mode. Returns CORE_OK, or CORE_ERR_RANGE or
 * CORE_ERR_FLOAT; on an error `core` is unchanged. */
enum core_error core_init(struct core *core, const struct core_config *config);

/* Advances the simulation by one tick in the fixed order game, poi, water, fish, catch, score.
 * Returns CORE_OK, or CORE_ERR_FLOAT; on an error `core` and `output` are unchanged. The first tick
 * of each second checks the floating-point mode of the thread. The caller sets that mode
 * (platform/cpu.h). */
enum core_error core_tick(struct core *core, const struct input *input, struct output *output);

/* Returns 1 if a session starts at this tick, so that core_init() with `core->config` produces this
 * exact state; else 0. */
int core_is_fresh(const struct core *core);

/* Fills `scene` completely from the state. The state is not changed. */
void core_scene(const struct core *core, struct scene *scene);

/* Returns a hash over every simulated field, without struct padding. */
uint64_t core_hash(const struct core *core);

/* Returns a hash over the state that changes every tick (game, pois, fish), without the paper cells
 * and the ripples. The cost is a tenth of core_hash(), so recordings can store one per tick. */
uint64_t core_hash_quick(const struct core *core);

#endif
