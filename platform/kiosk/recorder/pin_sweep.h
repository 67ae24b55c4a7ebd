/* pin_sweep.h -- removes the operator menu's PIN from replays that an older version stored.
 *
 * The sweep examines each stored replay that may contain a PIN
 * (session_recorder_may_contain_pin()). The state hashes of format 7 include the PIN
 * (settings_hash()), so replacing only the initial state would make the hashes wrong. Instead, two
 * cores simulate the replay without a picture. The first core starts with the PIN, and the replay
 * verifier (replay_verifier.h) compares its states with the recording. The second core starts
 * without the PIN (session_recorder_withhold_pin()), gets the same inputs, and is recorded. A third
 * simulation verifies the new recording, which then replaces the old recording in one transaction.
 *
 * The sweep deletes a replay only if the replay may contain a PIN and cannot be cleared of the PIN.
 * A replay may contain a PIN if its format is 7 or older, if its initial state contains a PIN, or
 * if its header is damaged, so that its format is unknown. Such a replay cannot be cleared if the
 * recording is damaged, larger than SESSION_RECORDER_SIZE or too old, if its simulation differs, or
 * if a page for a PIN opens in it, so that its inputs may contain the digits.
 *
 * Any other replay stays unchanged, even if it is damaged: a replay of format 8 or newer whose
 * header is valid and whose initial state is damaged or contains no PIN, and a replay of a newer
 * format than REPLAY_VERSION. The score, the ranking and the ledger never change. A replay whose
 * score does not agree with the ranking is cleared and stays, so that the verifier still reports
 * the disagreement.
 *
 * The caller owns `struct pin_sweep` (9 MiB: static storage) and initializes it to zero. */
#pragma once

#include "platform/kiosk/recorder/replay_verifier.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/store/storage.h"

enum pin_sweep_stage {
    PIN_SWEEP_SEEK = 0, /* Searches for the next stored replay that may contain a PIN. */
    PIN_SWEEP_READ,     /* Parses a recording. */
    PIN_SWEEP_PLAY,     /* Simulates the parsed recording. */
    PIN_SWEEP_DONE,     /* Every stored replay was examined. */
};

struct pin_sweep {
    uint8_t stage; /* Current step (enum pin_sweep_stage). */
    /* False while the stored recording is parsed and simulated; true while the new recording is
     * verified. */
    bool is_check;
    uint32_t round_id; /* Round id of the newest examined replay. 0 means none yet. */
    uint32_t cleaned;  /* Number of replays that were replaced by a recording without a PIN. */
    uint32_t deleted;  /* Number of replays that were deleted. */
    /* Number of replays that stay unexamined, because the database could not be read or written, or
     * the core refused to run. The next start tries again. */
    uint32_t left;
    enum replay_verdict verdict; /* Result of the stored recording's verification. */
    struct replay_verifier verifier;
    /* Second core, which simulates the stored recording without its PIN. The states and the inputs
     * of this core form the new recording. */
    struct core core;
    struct output output;
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    /* Ledger entry of the round whose replay is being examined. */
    struct ledger_entry kept;
    size_t size;                           /* Size of `replay` in bytes. */
    uint8_t replay[SESSION_RECORDER_SIZE]; /* Recording that was read from the store. */
    uint8_t made[SESSION_RECORDER_SIZE];   /* New recording without the PIN. */
};

/* Returns the sweep as background work that the store's writer thread runs in short steps. Each
 * step reads one stored replay, parses one second of a replay, or simulates one tick. */
struct storage_chore pin_sweep_chore(struct pin_sweep *sweep);
