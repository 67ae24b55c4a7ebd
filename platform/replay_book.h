/* replay_book.h -- the growth lab's book (makers' species, saved graphs) as bytes of a recording:
 * without it a play through the lab would not come back. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_BOOK_H
#define KINGYO_PLATFORM_REPLAY_BOOK_H

#include <stddef.h>

#include "core/game/lab_book.h"

/* Eight cards and fifteen graphs, field by field, are 25 KB. */
#define REPLAY_BOOK_MAX (32u * 1024u)

/* Returns how many bytes it took; 0 for a book with nothing in it. */
size_t replay_book_encode(const struct lab_book *book, uint8_t out[REPLAY_BOOK_MAX]);

/* Reads exactly `size` bytes of any content. 1, or 0 when they are no sound book of this program's
 * species; `book` is then empty. */
int replay_book_decode(struct lab_book *book, const uint8_t *bytes, size_t size);

#endif
