/* replay_start.h -- what a core began with, as bytes of a recording: its configuration and all that
 * the store remembered, without which no play would come back. The growth lab's book stands apart
 * (replay_book.h). Most of it is zero, and runs of zeros cost a byte. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_START_H
#define KINGYO_PLATFORM_REPLAY_START_H

#include <stddef.h>

#include "core/core.h"

#define REPLAY_START_MAX (16u * 1024u) /* The fullest ranking and audits are half of that. */

/* Returns how many bytes it took, never 0. */
size_t replay_start_encode(const struct core_config *config, uint8_t out[REPLAY_START_MAX]);

/* Reads exactly `size` bytes of any content, written in format `version` (REPLAY_VERSION_MIN ..
 * REPLAY_VERSION of replay.h). The book and the lanes of `config` stay as they are. Fields that
 * `version` lacks become 0, and version 7 sets rules_7. Returns 1, or 0 when no recorder writes
 * these bytes: `config` is then invalid. */
int replay_start_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                        uint32_t version);

#endif
