/* core.h -- the complete state of the simulation and the functions that advance it.
 *
 * The caller owns `struct core`. The struct holds no pointers, so an assignment is a snapshot.
 * Equal seeds and equal inputs give equal hashes on every board. The core calls no code outside
 * core/: core_tick() reads one `struct input`, changes `struct core` and appends to `struct
 * output`. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/config.h"
#include "core/game/game.h"
#include "core/game/lesson/lesson.h"
#include "core/input.h"
#include "core/output.h"
#include "core/poi/world.h"
#include "core/scene.h"

#define KINGYO_VERSION "0.1.0"

struct vision;

enum core_error {
    CORE_OK = 0,
    CORE_ERR_RANGE = -1, /* A config field lies outside its documented range. */
    /* The calling thread flushes denormal numbers to zero or does not round to nearest
     * (core/base/float_env.h). Every result would be wrong. */
    CORE_ERR_FLOAT = -2,
};

/* The complete simulated state. Only the functions of core.h take the complete state. The functions
 * that they call take only the parts on which they work. */
struct core {
    struct core_config config;
    struct game game;
    struct world world;
    /* Aids for players. The lessons are for display only, so no hash contains them. */
    struct lessons lessons;
};

/* Initializes `core` from `config` in attract mode. Returns CORE_OK, or CORE_ERR_RANGE or
 * CORE_ERR_FLOAT; on an error `core` is unchanged. */
enum core_error core_init(struct core *core, const struct core_config *config);

/* Advances the simulation by one tick in the fixed order game, poi, water, fish, catch, score.
 * Returns CORE_OK, or CORE_ERR_FLOAT; on an error `core` and `output` are unchanged. The first tick
 * of each second checks the calling thread's floating-point mode. The caller must set that mode
 * before (platform/cpu.h). */
enum core_error core_tick(struct core *core, const struct input *input, struct output *output);

/* Returns true if `core` is in exactly the state that core_init() makes from `core->config`, so
 * that a recording can start at this tick. Each session (the time between two initializations of
 * the core) starts at such a tick. */
bool core_is_fresh(const struct core *core);

/* Progress of one player in the running round. */
struct core_player_status {
    bool plays;    /* True if the player has had a poi in use in this round. */
    uint8_t fouls; /* Number of the player's counted fouls. */
    uint32_t caught;
    struct poi_target target_pose; /* Target pose of the player's poi in the last tick. */
};

/* Copy of the values that recordings, the store and the status file read after a tick. */
struct core_status {
    uint32_t tick;        /* Number of ticks that the core has run. */
    uint32_t entry_id;    /* Id of the newest ledger entry. */
    uint32_t round_count; /* Number of started rounds. */
    uint32_t round_s;     /* Length of the running round in seconds. */
    uint32_t fish_count;  /* Number of fish in the tank. */
    uint16_t day, minute; /* Date and time of the newest input, as in struct input. */
    uint8_t phase;        /* Phase of the game (enum scene_phase). */
    uint8_t mode;         /* Mode of the running round (enum game_mode). */
    /* True while the operator's menu shows a page on which a PIN is typed. Inputs of this time may
     * contain digits of the PIN. */
    bool takes_pin;
    struct balance balance;
    struct core_player_status player[POI_MAX];
};

/* Returns the present status of `core`. The function asserts nothing, so a panic handler may call
 * it. */
struct core_status core_status(const struct core *core);

/* Returns a pointer to the audit counters in `core`, which change with each tick. */
const struct audits *core_audits(const struct core *core);

/* Returns the record of the running round, or of the last round if no round runs. The member `id`
 * of the record is 0. */
struct round_record core_round_record(const struct core *core);

/* Returns what a bot that controls player `player` can see (core/game/bot/vision.h). The returned
 * struct contains pointers to `core`. */
struct vision core_vision(const struct core *core, uint32_t player);

/* Returns a pointer to the leaderboards of all modes and periods in `core`, which change with each
 * tick. */
const struct ranking *core_ranking(const struct core *core);

/* Writes the health entry for a regular end of the program to `out`. The entry contains the uptime
 * and the counts of `input`. Returns true. Returns false if the kiosk has no store, or if the
 * ledger has no id left (LEDGER_ID_MAX); `out` must then not be used. */
bool core_final_entry(const struct core *core, const struct input *input, struct ledger_entry *out);

/* Fills every field of `scene` from `core`. The state in `core` is not changed. */
void core_scene(const struct core *core, struct scene *scene);

/* Returns a hash over every simulated field, without struct padding. */
uint64_t core_hash(const struct core *core);

/* Returns a hash over the state that changes every tick: game, pois and fish. The hash excludes the
 * paper cells and the ripples. The function takes a tenth of the time of core_hash(), so recordings
 * can store one hash per tick. */
uint64_t core_hash_quick(const struct core *core);
