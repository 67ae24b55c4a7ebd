/* saving.h -- passes ledger entries and edits to a store that may be busy, fail or be absent. The
 * module also transfers offline credits to a store that appears later. An entry or edit is passed
 * to the store again and again until the store accepts it. */
#ifndef KINGYO_PLATFORM_KIOSK_SAVING_H
#define KINGYO_PLATFORM_KIOSK_SAVING_H

#include <stdint.h>

#include "core/core.h"
#include "core/output.h"
#include "platform/hal.h"

struct saving {
    uint32_t accepted_id;      /* Id of the newest ledger entry that is settled: the store accepted
                                  the entry, or no store exists. */
    uint32_t accepted_edit_id; /* Id of the newest edit that is settled: the store accepted the
                                  edit, or no store exists. */
    uint32_t refused_seen;     /* Number of failed writes that were already counted as faults. */
    uint64_t retry_ns;         /* Time until which no data are passed to the store, because a
                                  previous attempt failed. */
};

/* Passes the ledger's entries to the store, oldest first. Call once per frame. If the store is
 * busy, the function tries again in the next frame. If the store failed, the function tries
 * again after one second. If no store exists, the entries count as settled. Returns the number
 * of faults. */
uint32_t saving_put_entries(struct saving *saving, const struct hal_ledger *store,
                            const struct output *output, uint64_t now_ns);

/* Passes the newest edit of the growth lab to the store. Retries and returns as
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

/* ---- Offline credits ----------------------------------------------------------------------- */

/* Transfers offline credits to the store. Offline credits are coins and credits that the kiosk
 * received while it had no store.
 *
 * A kiosk that started without a store must restart to use a store that appears later. The restart
 * would lose data that are only in memory: coins, the credits that the coins bought, and service
 * credits. Therefore the kiosk first transfers these data to the store. Each transfer contains
 * only amounts that no earlier transfer contained. Coins that are inserted during a transfer wait
 * for the next transfer. Each coin is therefore stored exactly once. */

/* State of the transfer. A structure of zeros means that nothing has been transferred. */
struct offline_flush {
    struct audits told; /* Audit counts of this kiosk that the store has already written to disk. */
    struct balance told_balance; /* Balance of this kiosk that the store has already written to
                                    disk. */
    struct audits asked; /* Audit counts of this kiosk that will be on disk when the current write
                            succeeds. */
    struct balance asked_balance;
    uint8_t is_asked;
};

/* Transfers the amounts that are not yet on disk. Call once per frame while a new store exists and
 * no game runs. Returns 1 if all amounts are on disk, so that the kiosk may restart in this frame.
 * Otherwise returns 0. */
int saving_flush_offline(struct offline_flush *flush, const struct hal_ledger *store,
                         const struct core *core);

#endif
