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

/* The tank takes 1 MiB at most, whatever swims in it; game, pois and bowls a sixteenth of that, and
 * the growth lab half as much: eight makers' species with all their curves (19 KiB), and a graph
 * for each of 15, as it was at start and as it is (8 KiB each). The smallest board keeps so much
 * for them, and as much again for the scene. */
_Static_assert(sizeof(struct tank) <= 1024u * 1024u, "the tank outgrew its budget");
_Static_assert(sizeof(struct core) <= 1120u * 1024u, "the core's state outgrew its budget");
_Static_assert(TANK_FISH_MAX == SCENE_FISH_MAX, "every fish can be shown");
_Static_assert(sizeof(struct scene) <= 1024u * 1024u, "the scene outgrew its budget");

/* Fills `core` with a fresh stall in attract mode. On an error it is untouched. */
enum core_error core_init(struct core *core, const struct core_config *config);

/* Advances one tick, in this order and no other: game -> poi -> water -> fish -> catch -> score. */
void core_tick(struct core *core, const struct input *input, struct output *output);

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
