/* storage_sim.h -- simulates the kiosk's database in memory.
 *
 * A test selects how many writes return HAL_ERR_BUSY or HAL_ERR_IO, and how many polls pass until
 * an entry counts as written to disk. */
#pragma once

#include "core/persistent_state.h"
#include "platform/hal.h"

struct storage_sim {
    struct ledger_entry entry;     /* Last accepted ledger entry. */
    struct round_record record;    /* Record of the last round. */
    struct ledger_entry round;     /* Ledger entry of the last round. */
    struct graph_edit_record edit; /* Last accepted edit of a species. */
    uint32_t accepted_count;
    uint32_t refused_count;
    /* Result of failed_count(): the number of entries that could not be written to disk. */
    uint32_t write_refused_count;
    uint32_t busy_left; /* Number of further writes that return HAL_ERR_BUSY. */
    bool edit_failed;   /* True if the last edit could not be stored. */
    /* Number of further writes that return HAL_ERR_IO, after the writes that return
     * HAL_ERR_BUSY. */
    uint32_t fail_left;
    /* An accepted entry counts as written to disk after this number of committed_id() calls. */
    uint32_t delay_polls;
    uint32_t polls_since; /* Number of committed_id() calls after the last accepted entry. */
    /* Buffer for one replay, owned by the caller. Null means that replays are not stored. */
    uint8_t *replay;
    size_t replay_room;
    uint32_t replay_id; /* Id of the round whose replay is stored. 0 means none. */
    size_t replay_size;
    /* Number of further calls of stored_id() or fetched() until the replay is stored
     * or fetched. */
    uint32_t replay_polls_left;
    uint32_t replay_requested_id;   /* Round id in the last call of fetch(). */
    struct persistent_state memory; /* Result of load(): the state at the program start. */
    /* Result of needs_restart(): true if a store became available after the program start. */
    bool needs_restart;
    struct audits late;          /* Sums of the ledger entries that merge_offline() received. */
    struct balance late_balance; /* Sum of the balance changes that merge_offline() received. */
    /* Value that each merge_offline() assigns to `late_polls_left`: the number of offline_merged()
     * calls until the merged entries are on disk. */
    uint32_t late_polls;
    /* Number of offline_merged() calls that remain until the merged entries are on disk. */
    uint32_t late_polls_left;
};

/* Returns the simulated store. */
struct hal_storage storage_sim_device(struct storage_sim *sim);
