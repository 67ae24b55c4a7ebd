/* stall.h -- starts a stall with the data of a hostile file. */
#ifndef KINGYO_TESTS_FUZZ_STALL_H
#define KINGYO_TESTS_FUZZ_STALL_H

#include <stdint.h>

#include "core/core.h"

/* Starts the stall of `config` and runs `ticks` ticks without controller input. Returns 1 if the
 * stall started. A config that core_init() refuses is no finding. A failed assertion of the core is
 * a finding. */
int stall_try(const struct core_config *config, uint32_t ticks);

/* Starts a stall with the persistent state of a store, as the kiosk does. Settings that are out of
 * range are reset first. */
void stall_try_memory(const struct persistent_state *memory, uint32_t ticks);

/* The core that stall_try() runs. The core is valid until the next call. */
extern struct core stall_core;

#endif
