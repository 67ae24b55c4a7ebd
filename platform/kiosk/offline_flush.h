/* offline_flush.h -- transfers offline credits to the store: coins and credits from the time in
 * which no store was available.
 *
 * A kiosk that started without a store must restart to use a store that appears later. The restart
 * would lose data that is only in memory: coins, the credits that the coins bought, and service
 * credits. Therefore the kiosk first transfers these data to the store. Amounts that were already
 * transferred are subtracted. Coins inserted during a write are queued for the next transaction, so
 * that each coin is stored exactly once. */
#ifndef KINGYO_PLATFORM_KIOSK_OFFLINE_FLUSH_H
#define KINGYO_PLATFORM_KIOSK_OFFLINE_FLUSH_H

#include "core/core.h"
#include "platform/hal.h"

/* State of the transfer. A structure of zeros means that nothing was transferred yet. */
struct offline_flush {
    struct audits told;        /* Part of this kiosk's audits that the store has written to disk. */
    struct balance told_purse; /* Part of this kiosk's balance that the store has written to
                                  disk. */
    struct audits asked;       /* Part of this kiosk's audits that will be on disk when the current
                                  write succeeds. */
    struct balance asked_purse;
    uint8_t is_asked;
};

/* Transfers the remaining amounts. Call once per frame while a new store exists and no game runs.
 * Returns 1 if all amounts are on disk, so that the kiosk may restart in this frame. Otherwise
 * returns 0. */
int offline_flush_step(struct offline_flush *flush, const struct hal_storage *storage,
                       const struct core *core);

#endif
