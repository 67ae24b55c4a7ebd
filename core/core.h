/* core.h -- the complete state of the simulation and the functions that advance it.
 *
 * The caller owns `struct core`. The struct holds no pointers, so an assignment is a snapshot.
 * Equal seeds and equal inputs give equal hashes on every board. The core calls no code outside
 * core/: core_tick() reads one `struct input`, changes `struct core` and appends to `struct
 * output`. */
#ifndef KINGYO_CORE_CORE_H
#define KINGYO_CORE_CORE_H

#include <stdbool.h>
#include <stdint.h>

#include "core/config.h"
#include "core/game/game.h"
#include "core/input.h"
#include "core/output.h"
#include "core/poi/world.h"
#include "core/scene.h"

#define KINGYO_VERSION "0.1.0"

enum core_error {
    CORE_OK = 0,
    CORE_ERR_RANGE = -1, /* A config field lies outside its documented range. */
    CORE_ERR_FLOAT = -2, /* The calling thread flushes denormal numbers to zero or does not round to
                            nearest (core/base/float_env.h). Every result would be wrong. */
};

/* The complete simulated state. Only the functions of core.h take the complete state. The functions
 * that they call take only the parts on which they work. */
struct core {
    struct core_config config;
    struct game game;
    struct world world;
};

/* Initializes `core` from `config` in attract mode. Returns CORE_OK, or CORE_ERR_RANGE or
 * CORE_ERR_FLOAT; on an error `core` is unchanged. */
enum core_error core_init(struct core *core, const struct core_config *config);

/* Advances the simulation by one tick in the fixed order game, poi, water, fish, catch, score.
 * Returns CORE_OK, or CORE_ERR_FLOAT; on an error `core` and `output` are unchanged. The first tick
 * of each second checks the calling thread's floating-point mode. The caller must set that mode
 * before (platform/cpu.h). */
enum core_error core_tick(struct core *core, const struct input *input, struct output *output);

/* Returns true if a session starts at the current tick. At the start of a session core_init() with
 * `core->config` produces exactly the state in `core`. */
bool core_is_fresh(const struct core *core);

/* Returns the ranking of all modes and periods. The ranking changes with each tick. */
const struct ranking *core_ranking(const struct core *core);

/* Writes the health entry for a regular end of the program to `out`. The entry contains the uptime
 * and the counts of `input`. Returns true, or false if the kiosk has no store. */
bool core_final_entry(const struct core *core, const struct input *input, struct ledger_entry *out);

/* Fills every field of `scene` from `core`. The state in `core` is not changed. */
void core_scene(const struct core *core, struct scene *scene);

/* Returns a hash over every simulated field, without struct padding. */
uint64_t core_hash(const struct core *core);

/* Returns a hash over the state that changes every tick: game, pois and fish. The hash excludes the
 * paper cells and the ripples. The function takes a tenth of the time of core_hash(), so recordings
 * can store one hash per tick. */
uint64_t core_hash_quick(const struct core *core);

#endif
