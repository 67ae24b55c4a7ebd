/* replay_initial_state.h -- serializes the initial state of a recording: the core's configuration
 * and the loaded persistent state.
 *
 * The growth lab's catalog is separate (replay_catalog.h). Most bytes are zero, and a run of zeros
 * takes one byte. Pure functions. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_INITIAL_STATE_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_INITIAL_STATE_H

#include <stddef.h>

#include "core/core.h"

/* Maximum size in bytes, twice the size of a full ranking with all audits. */
#define REPLAY_INITIAL_STATE_MAX (16u * 1024u)

/* Writes the initial state to `out`. Returns the number of bytes, which is never 0. */
size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX]);

/* Parses exactly `size` bytes, which may have any content, in format `version` (REPLAY_VERSION_MIN
 * .. REPLAY_VERSION of replay.h). Leaves the catalog and the lanes of `config` unchanged. Sets
 * fields that `version` lacks to 0; version 7 sets rules_7 to 1. Returns 1. Returns 0 and leaves an
 * invalid `config` if no recorder writes these bytes. */
int replay_initial_state_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                                uint32_t version);

#endif
