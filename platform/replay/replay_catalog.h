/* replay_catalog.h -- serializes the growth lab's catalog (makers' species, saved graphs) for a
 * recording.
 *
 * A game that used the growth lab could not be replayed without the catalog. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_CATALOG_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_CATALOG_H

#include <stddef.h>

#include "core/game/lab/lab_book.h"

/* Eight species and fifteen graphs take 25 KB. */
#define REPLAY_CATALOG_MAX (32u * 1024u)

/* Returns the number of bytes written; 0 for an empty catalog. */
size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX]);

/* Parses exactly `size` bytes of any content. Returns 1, or 0 with an empty `book` if the bytes are
 * no valid catalog for this program's species. */
int replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size);

#endif
