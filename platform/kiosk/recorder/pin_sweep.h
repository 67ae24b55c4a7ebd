/* pin_sweep.h -- removes the operator menu's PIN from replays that an older version stored.
 *
 * The state hashes in a recording of an older version include the PIN (settings_hash()).
 * Replacing only the initial state would therefore make the hashes wrong. Instead the replay is
 * simulated without a picture and verified (replay_verifier.h). During the simulation the inputs
 * are recorded again, with the PIN withheld and with new state hashes. The new recording is
 * verified too, and replaces the old recording in one transaction.
 *
 * A replay remains unchanged and is counted if a verification fails, or if digits of a PIN are
 * typed in the replay. The caller owns `struct pin_sweep` (8 MiB: static storage) and initializes
 * it to zero. */
#ifndef KINGYO_PLATFORM_KIOSK_RECORDER_PIN_SWEEP_H
#define KINGYO_PLATFORM_KIOSK_RECORDER_PIN_SWEEP_H

#include "platform/kiosk/recorder/replay_verifier.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/store/storage.h"

enum pin_sweep_stage {
    PIN_SWEEP_SEEK = 0, /* Searches for the next stored replay with a PIN. */
    PIN_SWEEP_READ,     /* Parses a recording. */
    PIN_SWEEP_PLAY,     /* Simulates the parsed recording. */
    PIN_SWEEP_DONE,     /* Every stored replay was examined. */
};

struct pin_sweep {
    uint8_t stage;     /* Current step (enum pin_sweep_stage). */
    bool is_check;     /* False while the stored recording is parsed and simulated; true while the
                          new recording is verified. */
    uint32_t round_id; /* Round id of the newest examined replay. 0 means none yet. */
    uint32_t cleaned;  /* Number of replays whose PIN was removed. */
    uint32_t left;     /* Number of replays that still contain a PIN. */
    struct replay_verifier judge;
    struct replay_writer writer;
    struct ledger_entry kept;              /* Ledger entry of the round whose replay is being
                                              examined. */
    size_t size;                           /* Size of `replay` in bytes. */
    uint8_t replay[SESSION_RECORDER_SIZE]; /* Recording that was read from the store. */
    uint8_t made[SESSION_RECORDER_SIZE];   /* New recording without the PIN. */
};

/* Returns the sweep as background work that the store's writer thread runs in short steps. Each
 * step reads one stored replay, parses one second of a replay, or simulates one tick. */
struct storage_chore pin_sweep_chore(struct pin_sweep *sweep);

#endif
