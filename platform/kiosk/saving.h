/* saving.h -- passes ledger entries and edits to a store that may be busy, fail or be absent.
 *
 * An entry or edit is offered again until the store accepts it. */
#ifndef KINGYO_PLATFORM_KIOSK_SAVING_H
#define KINGYO_PLATFORM_KIOSK_SAVING_H

#include <stdint.h>

#include "core/output.h"
#include "platform/hal.h"

struct saving {
    uint32_t accepted_id;      /* Id of the newest ledger entry that is settled: the store accepted
                                  the entry, or no store exists. */
    uint32_t accepted_edit_id; /* Id of the newest edit that is settled: the store accepted the
                                  edit, or no store exists. */
    uint32_t refused_seen;     /* Number of failed writes that were already counted as faults. */
    uint64_t retry_ns;         /* Time before which no data are offered to the store. */
};

/* Offers the ledger's entries to the store, oldest first. Call once per frame. A busy store is
 * retried in the next frame, a failed store after one second, and an absent store never. Returns
 * the number of faults. */
uint32_t saving_put_entries(struct saving *saving, const struct hal_ledger *store,
                            const struct output *output, uint64_t now_ns);

/* Offers the newest edit of the growth lab to the store. Retries and returns as
 * saving_put_entries() does. */
uint32_t saving_put_edit(struct saving *saving, const struct hal_edit_store *edits,
                         const struct output *output, uint64_t now_ns);

/* Returns the number of writes that failed in the store's thread since the last call of
 * saving_refused(). */
uint32_t saving_refused(struct saving *saving, const struct hal_ledger *store);

/* Returns 1 if every ledger entry is settled: the store accepted the entry, or no store exists.
 * Otherwise returns 0. */
static inline int saving_is_done(const struct saving *saving, const struct output *output)
{
    return saving->accepted_id == output->entry_id;
}

#endif
