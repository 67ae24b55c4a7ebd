/* pin_sweep.h -- removes the menu's PIN from replays that an older version stored.
 *
 * The state hashes of such a recording (`rules_7`, core/core.h) include the PIN, so that replacing
 * its start is not enough. Instead the replay is played again without a picture and verified
 * (replay_verifier.h). During the play the same inputs are recorded with the PIN withheld and with
 * the hashes of that state. The new recording is verified as well, and replaces the old one in one
 * transaction. A replay that fails either check, or in which digits of a PIN are typed, stays
 * unchanged and is counted. The caller owns `struct pin_sweep` (8 MiB: static storage) and clears
 * it. */
#ifndef KINGYO_PLATFORM_KIOSK_PIN_SWEEP_H
#define KINGYO_PLATFORM_KIOSK_PIN_SWEEP_H

#include "platform/kiosk/replay_verifier.h"
#include "platform/kiosk/session_recorder.h"
#include "platform/store/storage.h"

enum pin_sweep_stage {
    PIN_SWEEP_SEEK = 0, /* Finds the next stored replay. */
    PIN_SWEEP_READ,     /* Parses a recording. */
    PIN_SWEEP_PLAY,     /* Plays that recording. */
    PIN_SWEEP_DONE,     /* Every stored replay was examined. */
};

struct pin_sweep {
    uint8_t stage;     /* enum pin_sweep_stage */
    uint8_t is_check;  /* 1: the new recording is being read and played. */
    uint32_t round_id; /* Round of the replay examined last; 0: none yet. */
    uint32_t cleaned;  /* Replays that were replaced. */
    uint32_t left;     /* Replays that still contain a PIN. */
    struct replay_verifier judge;
    struct replay_writer writer;
    struct ledger_entry kept;              /* Entry of the round in the ledger. */
    size_t size;                           /* Size of `replay` in bytes. */
    uint8_t replay[SESSION_RECORDER_SIZE]; /* The stored recording. */
    uint8_t made[SESSION_RECORDER_SIZE];   /* The new recording. */
};

/* Returns the background work for struct storage. Each step reads one stored replay, parses a
 * second of one, or plays one tick, on the calling thread. */
struct storage_chore pin_sweep_chore(struct pin_sweep *sweep);

#endif
