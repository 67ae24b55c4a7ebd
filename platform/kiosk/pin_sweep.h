/* pin_sweep.h -- removes the menu's PIN from replays that an older Kingyo kept.
 *
 * The state hashes of such a recording (`rules_7`, core/core.h) count the PIN, so that its start
 * cannot just be replaced. Instead the replay is played again without a picture and verified
 * (judge.h). During the play the same inputs are recorded with the PIN withheld and with the hashes
 * of that state. The new recording is then verified as well, and replaces the old one in one
 * transaction. A replay that fails either check, or in which digits of a PIN are typed, stays as it
 * is and is counted. The caller owns `struct pin_sweep` (8 MiB: static storage) and leaves it
 * zero. */
#ifndef KINGYO_PLATFORM_KIOSK_PIN_SWEEP_H
#define KINGYO_PLATFORM_KIOSK_PIN_SWEEP_H

#include "platform/kiosk/chapters.h"
#include "platform/kiosk/judge.h"
#include "platform/storage.h"

enum pin_sweep_stage {
    PIN_SWEEP_SEEK = 0, /* Looks for the next kept replay. */
    PIN_SWEEP_READ,     /* Parses a recording. */
    PIN_SWEEP_PLAY,     /* Plays that recording. */
    PIN_SWEEP_DONE,     /* Every kept replay was looked at. */
};

struct pin_sweep {
    uint8_t stage;      /* enum pin_sweep_stage */
    uint8_t is_check;   /* 1: the recording that is read and played is the new one. */
    uint32_t round_id;  /* Round whose replay was looked at last; 0: none yet. */
    uint32_t cleaned;   /* Replays that were replaced. */
    uint32_t left;      /* Replays that still hold a PIN. */
    struct judge judge;
    struct replay_writer writer;
    struct ledger_entry kept;   /* Entry of the round, as the ledger has it. */
    size_t size;                /* Bytes of `replay`. */
    uint8_t replay[CHAPTERS_SIZE]; /* The recording as it was kept. */
    uint8_t made[CHAPTERS_SIZE];   /* The new recording. */
};

/* The work for struct storage: each call reads one kept replay, parses a second of one, or plays
 * one tick, on the calling thread. */
struct storage_chore pin_sweep_chore(struct pin_sweep *sweep);

#endif
