/* offline_flush.h -- offline credits: gives a store that appears after the start the coins and
 * credits of the time without a store.
 *
 * A kiosk that started without its store must restart to use it. The restart would lose data that
 * is only in memory: coins, the credits they bought and service credits. Therefore the store first
 * gets all of them, and amounts already transferred are subtracted. Coins inserted during a write
 * are queued for the next transaction, so that each coin is stored exactly once. */
#ifndef KINGYO_PLATFORM_KIOSK_OFFLINE_FLUSH_H
#define KINGYO_PLATFORM_KIOSK_OFFLINE_FLUSH_H

#include "core/core.h"
#include "platform/hal.h"

/* State of the transfer. Zero: nothing was transferred yet. */
struct offline_flush {
    struct audits told;        /* Audits of this kiosk that are on disk in the store. */
    struct balance told_purse; /* Balance of this kiosk that is on disk in the store. */
    struct audits asked;       /* Audits that will be on disk when the current write succeeds. */
    struct balance asked_purse;
    uint8_t is_asked;
};

/* Transfers the remaining amounts. Call once a frame, while such a store exists and no game runs.
 * Returns 1 if everything is on disk, so that the kiosk may restart in this frame. */
int offline_flush_step(struct offline_flush *flush, const struct hal_storage *storage,
                       const struct core *core);

#endif
