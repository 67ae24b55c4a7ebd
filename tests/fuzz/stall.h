/* stall.h -- starts a game with the data of an untrusted file. */
#ifndef KINGYO_TESTS_FUZZ_STALL_H
#define KINGYO_TESTS_FUZZ_STALL_H

#include <stdint.h>

#include "core/core.h"

/* Starts a game with `config` and runs `ticks` ticks without controller input. Returns 1 if the
 * game started, and 0 if core_init() rejected `config`, which is allowed. A failed assertion of the
 * core ends the process. */
int stall_try(const struct core_config *config, uint32_t ticks);

/* Starts a game with the persistent state that a store has loaded, as the kiosk does. Settings that
 * are out of range are reset to their defaults first. */
void stall_try_memory(const struct persistent_state *memory, uint32_t ticks);

/* The core of the last stall_try(). Valid until the next call. */
extern struct core stall_core;

#endif
