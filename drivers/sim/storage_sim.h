/* storage_sim.h -- a simulated store in memory that can be busy, fail, and delay durability. */
#ifndef KINGYO_DRIVERS_SIM_STORAGE_SIM_H
#define KINGYO_DRIVERS_SIM_STORAGE_SIM_H

#include "core/persistent_state.h"
#include "platform/hal.h"

struct storage_sim {
    struct ledger_entry entry;     /* Entry that was accepted last. */
    struct round_record record;    /* Record of the last round. */
    struct ledger_entry round;     /* Entry of the last round. */
    struct graph_edit_record edit; /* Edit that was accepted last. */
    uint32_t accepted_count;
    uint32_t refused_count;
    /* Result of refused_count(): entries that the writer could not write. */
    uint32_t write_refused_count;
    uint32_t busy_left;   /* Number of saves that return HAL_ERR_BUSY first. */
    int edit_failed;      /* 1 if the last edit failed. */
    uint32_t fail_left;   /* Number of saves after those that return HAL_ERR_IO. */
    uint32_t delay_polls; /* Calls of saved_id() until an accepted entry is on disk. */
    uint32_t polls_since;
    uint8_t *replay; /* Buffer of the caller for one replay; null: replays are not stored. */
    size_t replay_room;
    uint32_t replay_id; /* Id of the round whose replay is stored; 0: none. */
    size_t replay_size;
    /* Calls of replay_kept_id() or replay_fetched() until the replay is done. */
    uint32_t replay_polls_left;
    uint32_t replay_asked_id;       /* Id in the last call of fetch_replay(). */
    struct persistent_state memory; /* State at the start, from earlier runs. */
    int wants_restart;              /* 1: the store appeared late and is not empty. */
    struct audits late;             /* Sums of the entries passed to hand_over(). */
    struct balance late_purse;      /* Balance change passed to hand_over(). */
    uint32_t late_polls;            /* Calls of handed_over() until the data are on disk. */
    uint32_t late_polls_left;       /* Remaining calls of handed_over() until then. */
};

struct hal_storage storage_sim_device(struct storage_sim *sim);

#endif
