/* replay_initial_state.h -- serializes the initial state of a recording: the core's configuration
 * and the loaded persistent state.
 *
 * The growth lab's catalog (installed species and saved graphs) is a separate part. Without the
 * catalog, a game that used the growth lab could not be replayed. Most bytes of the initial state
 * are zero, and a run of zeros takes one byte. Pure functions. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_INITIAL_STATE_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_INITIAL_STATE_H

#include <stddef.h>

#include "core/core.h"
#include "core/game/lab/lab_edit.h"

/* Maximum size of the serialized initial state in bytes. A full leaderboard with all audits takes
 * half of this size. */
#define REPLAY_INITIAL_STATE_MAX (16u * 1024u)

/* Writes the initial state to `out`. Returns the number of bytes, which is never 0. */
size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX]);

/* Parses exactly `size` bytes, which may have any content, in format `version` (REPLAY_VERSION_MIN
 * .. REPLAY_VERSION of replay.h). Leaves the catalog and the lanes of `config` unchanged. Sets
 * fields that `version` lacks to 0. For version 7, sets rules_7 to 1. Returns 1 on success. Returns
 * 0 and leaves an invalid `config` if no recorder writes these bytes. */
int replay_initial_state_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                                uint32_t version);

/* Maximum size of a catalog in bytes. Eight species and fifteen graphs take 25 KB. */
#define REPLAY_CATALOG_MAX (32u * 1024u)

/* Writes the catalog to `out`. Returns the number of bytes. Returns 0 for an empty catalog. */
size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX]);

/* Parses exactly `size` bytes, which may have any content. Returns 1. Returns 0 and empties `book`
 * if the bytes are not a valid catalog for the species of this program. */
int replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size);

#endif
