/* ledger_range.h -- whether what was read from a file lies in the ranges that this core writes.
 *
 * A checksum only proves that a record is as it was written, not that Kingyo wrote it. Values out
 * of range would index beyond tables or wrap counters, so each reader (database, tail, backup,
 * replay) and core_init() reject them. */
#ifndef KINGYO_CORE_GAME_LEDGER_RANGE_H
#define KINGYO_CORE_GAME_LEDGER_RANGE_H

#include "core/core.h"
#include "core/ledger.h"

/* Returns 1 if every field of the entry is in its range, else 0. */
int ledger_entry_is_good(const struct ledger_entry *entry);

/* Returns 1 if ledger start, purse and ranking are in their ranges, else 0. Settings are mended by
 * settings_mend(), and any audit count is allowed. */
int ledger_memory_is_good(const struct memory *memory);

/* The same for what goes on from the chapter before. */
int ledger_chapter_is_good(const struct chapter *chapter);

#endif
