/* storage_sim.h -- a store in memory that can be busy, fail, and take its time to be durable. */
#ifndef KINGYO_DRIVERS_STORAGE_SIM_H
#define KINGYO_DRIVERS_STORAGE_SIM_H

#include "core/memory.h"
#include "platform/hal.h"

struct storage_sim {
    struct ledger_entry entry;  /* As last accepted, */
    struct round_record record; /* and the last round's, ... */
    struct ledger_entry round;  /* ... and its entry. */
    struct edit_record edit;    /* As last accepted. */
    uint32_t accepted_count;
    uint32_t refused_count;
    uint32_t write_refused_count; /* What its thread could not write. */
    uint32_t busy_left;         /* This many saves are answered HAL_ERR_BUSY first. */
    int edit_failed;            /* The last edit did. */
    uint32_t fail_left;         /* Then this many HAL_ERR_IO. */
    uint32_t delay_polls;       /* Calls of saved_id until an accepted record is on disk. */
    uint32_t polls_since;
    uint8_t *replay;            /* The caller's room for one replay; null: none is kept. */
    size_t replay_room;
    uint32_t replay_id;         /* Of the round whose replay lies there; 0: none. */
    size_t replay_size;
    uint32_t replay_polls_left; /* Calls of replay_kept_id, or replay_fetched, until it is done. */
    uint32_t replay_asked_id;   /* As fetch_replay() was last asked for. */
    struct memory memory;       /* What earlier evenings left. */
    int wants_restart;          /* 1: it came late, and is not empty. */
    struct audits late;         /* What was handed over to that one adds to its books, ... */
    struct purse late_purse;    /* ... and to its purse. */
    uint32_t late_polls;        /* Calls of handed_over() until it is on disk, ... */
    uint32_t late_polls_left;   /* ... and those that are left. */
};

struct hal_storage storage_sim_device(struct storage_sim *sim);

#endif
