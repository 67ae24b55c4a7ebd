/* offline_flush.h -- transfers offline credits to a store that appears later. Offline credits are
 * coins and credits that the kiosk received while it had no store.
 *
 * A kiosk that started without a store must restart to use a store that appears later. The restart
 * would lose data that are only in memory: coins, the credits that the coins bought, and service
 * credits. Therefore the kiosk first transfers these data to the store. Each transfer contains only
 * amounts that no earlier transfer contained. Coins that are inserted during a transfer wait for
 * the next transfer. Each coin is therefore stored exactly once. */
#pragma once

#include <stdbool.h>

#include "core/core.h"
#include "platform/hal.h"

/* State of the transfer. A structure of zeros means that nothing has been transferred. */
struct offline_flush {
    /* Audit counts of this kiosk that the store has already written to disk. */
    struct audits stored;
    /* Balance of this kiosk that the store has already written to disk. */
    struct balance stored_balance;
    /* Audit counts of this kiosk that will be on disk when the current write succeeds. */
    struct audits sent;
    struct balance sent_balance;
    bool is_sending; /* True while the store writes the amounts in `sent`. */
};

/* Transfers the amounts that are not yet on disk. Call once per frame while a new store exists and
 * no game runs. Returns true if all amounts are on disk, so that the kiosk may restart in this
 * frame. */
bool offline_flush_step(struct offline_flush *flush, const struct hal_ledger *store,
                        const struct core *core);

/* Returns the number of ledger entries with coins, credits and tickets that are not on disk. Call
 * after the store was closed, which writes a started transfer. The number is 0 if only the balance
 * differs. It counts at most 16 entries. */
uint32_t offline_flush_missing(struct offline_flush *flush, const struct hal_ledger *store,
                               const struct core *core);
