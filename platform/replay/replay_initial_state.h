/* replay_initial_state.h -- serializes the initial state of a recording: the core's configuration
 * and the persistent state that was loaded.
 *
 * The growth lab's catalog is separate (replay_catalog.h). Most bytes are zero, and a run of zeros
 * takes one byte. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_INITIAL_STATE_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_INITIAL_STATE_H

#include <stddef.h>

#include "core/core.h"

/* Twice the size of a full ranking with all audits. */
#define REPLAY_INITIAL_STATE_MAX (16u * 1024u)

/* Returns the number of bytes written, never 0. */
size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX]);

/* Parses exactly `size` bytes of any content, written in format `version` (REPLAY_VERSION_MIN ..
 * REPLAY_VERSION of replay.h). The catalog and the lanes of `config` are unchanged. Fields that
 * `version` lacks become 0, and version 7 sets rules_7. Returns 1, or 0 with an invalid `config` if
 * no recorder writes these bytes. */
int replay_initial_state_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                                uint32_t version);

#endif
