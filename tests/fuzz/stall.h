/* stall.h -- a stall that begins with data from a hostile file. */
#ifndef KINGYO_TESTS_FUZZ_STALL_H
#define KINGYO_TESTS_FUZZ_STALL_H

#include <stdint.h>

#include "core/core.h"

/* Begins the stall of `config` and runs `ticks` ticks without a hand. A config that core_init()
 * refuses is no finding; an assertion of the core is one. Returns 1 when the stall began. */
int stall_try(const struct core_config *config, uint32_t ticks);

/* The stall that a store's memory starts, as the kiosk makes it: settings that are out of range
 * are reset first. */
void stall_try_memory(const struct memory *memory, uint32_t ticks);

/* The core that stall_try() runs; valid until the next call. */
extern struct core stall_core;

#endif
