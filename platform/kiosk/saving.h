/* saving.h -- the ledger's entries and the lab's graphs, brought to a store that may be busy, may
 * fail or be gone. Nothing is taken for kept before the store took it. */
#ifndef KINGYO_PLATFORM_KIOSK_SAVING_H
#define KINGYO_PLATFORM_KIOSK_SAVING_H

#include <stdint.h>

#include "core/output.h"
#include "platform/hal.h"

struct saving {
    uint32_t accepted_id;      /* Newest ledger entry that the store took, or will never take. */
    uint32_t accepted_edit_id; /* The same of graphs. */
    uint32_t refused_seen;     /* Of the store's failed writes, those already told as faults. */
    uint64_t retry_ns;         /* Before then nothing is offered. */
};

/* Once a frame: offers the ledger's entries, the oldest first, until the store takes them: busy,
 * next frame; failed, in a second. A store that is not there never will. Returns how many faults
 * it met. */
uint32_t saving_put_entries(struct saving *saving, const struct hal_storage *storage,
                            const struct output *output, uint64_t now_ns);

/* The same of the newest graph from the growth lab. */
uint32_t saving_put_edit(struct saving *saving, const struct hal_storage *storage,
                         const struct output *output, uint64_t now_ns);

/* A store writes on a thread of its own: returns how many writes failed there since this was asked
 * last. */
uint32_t saving_refused(struct saving *saving, const struct hal_storage *storage);

/* Whether the store took every entry, or will never take it. */
static inline int saving_is_done(const struct saving *saving, const struct output *output)
{
    return saving->accepted_id == output->entry_id;
}

#endif
