/* storage_sim.c -- implements a store in memory with selectable faults. */
#include "drivers/sim/storage_sim.h"

#include <string.h>

#include "core/base/panic.h"

static int storage_sim_open(void *self)
{
    (void)self;
    return HAL_OK;
}

static int storage_sim_load(void *self, struct persistent_state *out)
{
    const struct storage_sim *sim = self;
    CORE_ASSERT(out);
    *out = sim->memory;
    return HAL_OK;
}

static int storage_sim_store_replay(void *self, uint32_t round_id, const uint8_t *bytes,
                                    size_t size)
{
    struct storage_sim *sim = self;
    CORE_ASSERT(bytes || size == 0);
    if (sim->replay == NULL) {
        return HAL_ERR_ABSENT;
    }
    if (size > sim->replay_room) {
        return HAL_ERR_IO;
    }
    memcpy(sim->replay, bytes, size);
    sim->replay_id = round_id;
    sim->replay_size = size;
    return HAL_OK;
}

static bool is_replay_done(struct storage_sim *sim)
{
    sim->replay_polls_left -= sim->replay_polls_left > 0;
    return sim->replay_polls_left == 0;
}

static uint32_t storage_sim_stored_replay_id(void *self)
{
    struct storage_sim *sim = self;
    return is_replay_done(sim) ? sim->replay_id : 0;
}

static int storage_sim_fetch_replay(void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                                    struct ledger_entry *round)
{
    struct storage_sim *sim = self;
    CORE_ASSERT(bytes && round);
    if (sim->replay == NULL) {
        return HAL_ERR_ABSENT;
    }
    sim->replay_requested_id = round_id;
    *round = round_id == sim->round.id ? sim->round : (struct ledger_entry){ 0 };
    if (round_id == sim->replay_id && size >= sim->replay_size) {
        memcpy(bytes, sim->replay, sim->replay_size);
    }
    return HAL_OK;
}

static int storage_sim_replay_fetched(void *self)
{
    struct storage_sim *sim = self;
    CORE_ASSERT(sim->replay_size <= sim->replay_room || !sim->replay);
    const bool is_there = sim->replay_id != 0 && sim->replay_requested_id == sim->replay_id;
    return !is_replay_done(sim) ? HAL_ERR_BUSY : is_there ? (int)sim->replay_size : HAL_ERR_ABSENT;
}

/* Takes one of the selected write faults, if any are left. Returns the error of the write, or
 * HAL_OK. */
static int take_fault(struct storage_sim *sim)
{
    uint32_t *left = sim->busy_left > 0 ? &sim->busy_left : &sim->fail_left;
    if (*left == 0) {
        return HAL_OK;
    }
    (*left)--;
    return left == &sim->busy_left ? HAL_ERR_BUSY : HAL_ERR_IO;
}

static int storage_sim_append(void *self, const struct ledger_entry *entry)
{
    struct storage_sim *sim = self;
    CORE_ASSERT(entry);
    const int result = take_fault(sim);
    if (result != HAL_OK) {
        sim->refused_count++;
        return result;
    }
    sim->entry = *entry;
    if (entry->kind == LEDGER_ROUND) {
        sim->record = entry->round;
        sim->round = *entry;
    }
    sim->accepted_count++;
    sim->polls_since = 0;
    return HAL_OK;
}

static uint32_t storage_sim_committed_id(void *self)
{
    struct storage_sim *sim = self;
    return sim->polls_since++ >= sim->delay_polls ? sim->entry.id : 0;
}

/* Stores an edit of a species. Returns HAL_ERR_BUSY or HAL_ERR_IO as long as the fault counters,
 * which append() also uses, are not 0. */
static int storage_sim_store_edit(void *self, const struct graph_edit_record *edit)
{
    struct storage_sim *sim = self;
    CORE_ASSERT(edit);
    const int result = take_fault(sim);
    sim->edit_failed = result == HAL_ERR_BUSY ? sim->edit_failed : result == HAL_ERR_IO;
    sim->edit = result == HAL_OK ? *edit : sim->edit;
    return result;
}

static uint32_t storage_sim_stored_edit_id(void *self)
{
    const struct storage_sim *sim = self;
    return sim->edit.id;
}

static bool storage_sim_edits_failed(void *self)
{
    const struct storage_sim *sim = self;
    return sim->edit_failed;
}

static bool storage_sim_is_healthy(void *self)
{
    return !storage_sim_edits_failed(self);
}

static const char *storage_sim_describe(void *self)
{
    (void)self;
    return "simulated store";
}

static uint32_t storage_sim_failed_count(void *self)
{
    const struct storage_sim *sim = self;
    return sim->write_refused_count;
}

static bool storage_sim_has_replay(void *self, uint32_t round_id)
{
    (void)self;
    (void)round_id;
    return false;
}

static uint32_t storage_sim_close(void *self)
{
    (void)self;
    return 0;
}

static bool storage_sim_needs_restart(void *self)
{
    const struct storage_sim *sim = self;
    return sim->needs_restart;
}

static int storage_sim_merge_offline(void *self, const struct balance_change *step,
                                     const struct ledger_entry *entries, uint32_t count)
{
    struct storage_sim *sim = self;
    CORE_ASSERT(step && (entries || count == 0));
    if (sim->late_polls_left > 0) {
        return HAL_ERR_BUSY;
    }
    for (uint32_t i = 0; i < count; i++) {
        audits_note(&sim->late, &entries[i]);
    }
    sim->late_balance.units += step->to.units - step->from.units;
    sim->late_balance.bonus_units += step->to.bonus_units - step->from.bonus_units;
    sim->late_balance.paid += step->to.paid - step->from.paid;
    sim->late_balance.service += step->to.service - step->from.service;
    sim->late_balance.unlogged += step->to.unlogged - step->from.unlogged;
    sim->late_polls_left = sim->late_polls;
    return HAL_OK;
}

static int storage_sim_offline_merged(void *self)
{
    struct storage_sim *sim = self;
    sim->late_polls_left -= sim->late_polls_left > 0;
    return sim->late_polls_left == 0 ? HAL_OK : HAL_ERR_BUSY;
}

struct hal_storage storage_sim_device(struct storage_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_ledger_ops ledger = {
        .open = storage_sim_open,
        .load = storage_sim_load,
        .append = storage_sim_append,
        .committed_id = storage_sim_committed_id,
        .failed_count = storage_sim_failed_count,
        .is_healthy = storage_sim_is_healthy,
        .needs_restart = storage_sim_needs_restart,
        .merge_offline = storage_sim_merge_offline,
        .offline_merged = storage_sim_offline_merged,
        .describe = storage_sim_describe,
        .close = storage_sim_close,
    };
    static const struct hal_replay_store_ops replays = {
        .store = storage_sim_store_replay,
        .stored_id = storage_sim_stored_replay_id,
        .fetch = storage_sim_fetch_replay,
        .fetched = storage_sim_replay_fetched,
        .has = storage_sim_has_replay,
    };
    static const struct hal_edit_store_ops edits = {
        .store = storage_sim_store_edit,
        .stored_id = storage_sim_stored_edit_id,
        .has_failed = storage_sim_edits_failed,
    };
    return (struct hal_storage){
        .ledger = { &ledger, sim },
        .replays = { &replays, sim },
        .edits = { &edits, sim },
    };
}
