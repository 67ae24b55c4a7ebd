/* health_log.h -- the health log: ledger entries about starts, crashes, uptime and faults.
 *
 * The first entry of each start is LEDGER_BOOT. A round that was open at that time was interrupted
 * by a crash or a power cut, and its credit is refunded if it is refundable. A LEDGER_HEALTH is
 * logged every two minutes and whenever the operator opens the menu. Each LEDGER_HEALTH contains
 * the uptime and the faults since the previous LEDGER_HEALTH. */
#ifndef KINGYO_CORE_GAME_HEALTH_LOG_H
#define KINGYO_CORE_GAME_HEALTH_LOG_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"

/* Interval of the LEDGER_HEALTH entries. A power cut removes at most one interval from the
 * statistics. */
#define HEALTH_LOG_TICKS (120u * CORE_TICK_HZ)

struct health_log {
    uint8_t is_told;                       /* 1 if the LEDGER_BOOT of this start is written,
                                              otherwise 0. */
    uint32_t told_tick;                    /* Tick of the last LEDGER_HEALTH. */
    uint32_t dropped_ticks, device_faults; /* Values of `input->dropped_ticks` and
                                              `input->device_faults` at the last LEDGER_HEALTH. */
    uint32_t told_shakes;
    uint32_t away_ticks[POI_MAX]; /* Number of ticks for which each slot in play has been without
                                     its controller. */
    uint32_t loss_tick[POI_MAX];  /* Tick at which each slot last lost its controller in a round; 0
                                     means never. */
};

/* Time without a controller that counts as a loss. A shorter interruption is treated as a
 * glitch. */
#define HEALTH_LOG_LOSS_TICKS CORE_TICK_HZ
/* A loss within this time after the previous loss of the same slot is logged as a repeated loss
 * (LEDGER_LOSS). */
#define HEALTH_LOG_LOSS_AGAIN_TICKS (600u * CORE_TICK_HZ)

struct game;
struct accounts;
struct world;
struct core_config;

/* Logs repeated losses of each slot's controller. Call once per tick of the round, after
 * pause_tick(). */
void health_log_note_losses(struct game *game, const struct world *world,
                            const struct core_config *config, struct output *output);

/* Logs the boot entry and the health entries at their scheduled times. Call once per tick, before
 * any other entry of the tick. */
void health_log_tick(struct game *game, const struct core_config *config, const struct input *input,
                     struct output *output);

/* Logs a LEDGER_HEALTH immediately. */
void health_log_write(struct accounts *accounts, struct health_log *health_log, uint32_t tick,
                      const struct input *input, struct output *output);

/* Fills `out` with the final LEDGER_HEALTH for a shutdown after the last tick, with the next id.
 * The core's state does not change, so the state still matches the session's recording. Returns 1,
 * or 0 if the kiosk has no store. */
int health_log_final(const struct accounts *accounts, const struct health_log *health_log,
                     uint32_t tick, const struct input *input, struct ledger_entry *out);

uint64_t health_log_hash(uint64_t hash, const struct health_log *health_log);

#endif
