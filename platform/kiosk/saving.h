/* saving.h -- passes ledger entries and edits to a store that may be busy, fail or be absent.
 *
 * Nothing counts as stored before the store accepts it. */
#ifndef KINGYO_PLATFORM_KIOSK_SAVING_H
#define KINGYO_PLATFORM_KIOSK_SAVING_H

#include <stdint.h>

#include "core/output.h"
#include "platform/hal.h"

struct saving {
    uint32_t accepted_id;      /* Newest ledger entry that the store accepted or never will
                                  accept. */
    uint32_t accepted_edit_id; /* Newest edit that the store accepted or never will accept. */
    uint32_t refused_seen;     /* Failed writes of the store that were already counted as faults. */
    uint64_t retry_ns;         /* Time before which nothing is offered. */
};

/* Offers the ledger's entries to the store, oldest first. Call once a frame. A busy store is
 * retried in the next frame, a failed one after a second, and an absent one never. Returns the
 * number of faults. */
uint32_t saving_put_entries(struct saving *saving, const struct hal_storage *storage,
                            const struct output *output, uint64_t now_ns);

/* Offers the newest edit of the growth lab to the store, in the same way. */
uint32_t saving_put_edit(struct saving *saving, const struct hal_storage *storage,
                         const struct output *output, uint64_t now_ns);

/* Returns the number of writes that failed in the store's thread since the last call. */
uint32_t saving_refused(struct saving *saving, const struct hal_storage *storage);

/* Returns 1 if the store accepted every entry, or never will accept them. */
static inline int saving_is_done(const struct saving *saving, const struct output *output)
{
    return saving->accepted_id == output->entry_id;
}

#endif
