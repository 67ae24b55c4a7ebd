/* replay_catalog.h -- serializes the growth lab's catalog (installed species and saved graphs) for
 * a recording.
 *
 * Without the catalog, a game that used the growth lab could not be replayed. Pure functions. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_CATALOG_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_CATALOG_H

#include <stddef.h>

#include "core/game/lab/lab_book.h"

/* Maximum size of a catalog in bytes. Eight species and fifteen graphs take 25 KB. */
#define REPLAY_CATALOG_MAX (32u * 1024u)

/* Writes the catalog to `out`. Returns the number of bytes. Returns 0 for an empty catalog. */
size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX]);

/* Parses exactly `size` bytes, which may have any content. Returns 1. Returns 0 and empties `book`
 * if the bytes are not a valid catalog for the species of this program. */
int replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size);

#endif
