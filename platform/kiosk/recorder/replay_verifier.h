/* replay_verifier.h -- replays a score and verifies that the score is genuine.
 *
 * The verifier simulates the recorded inputs. A score is genuine if every digest and the state hash
 * of every second equal the recorded values. In addition, the ledger entry that the simulation
 * creates for the round must agree with the ranking's rows and with the stored ledger entry. The
 * compared data are the boot number, the ticks, the tank's seed, the mode, the paper grade, the
 * players, and each player's catch, papers and fouls. The verification proves that the inputs give
 * exactly this score in this program, in a tank with this seed, for this number of ticks.
 *
 * The verification does not prove who played. An older ledger entry does not contain the number of
 * fish in the tank; `kingyoctl scores verify` prints the number in the replay. An attacker who can
 * write to the disk can change ledger, ranking and replay together, because no secret key is used.
 * If the ledger no longer contains the round, only the ranking is compared. If the stored entry has
 * a wrong checksum, the score is not genuine. The caller owns the verifier (1.3 MB: static
 * storage). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/kiosk/recorder/replayer.h"

enum replay_verdict {
    REPLAY_VERDICT_GENUINE = 0,
    /* The simulation differs from the recording (replayer.difference), or the simulated score
     * differs from the score in the ranking. */
    REPLAY_VERDICT_OTHER,
    /* The bytes are not a valid recording; see replayer.reader.problem. */
    REPLAY_VERDICT_DAMAGED,
    /* The score was not verified because the core returned CORE_ERR_FLOAT. */
    REPLAY_VERDICT_UNCHECKED,
    REPLAY_VERDICT_COUNT,
};

struct replay_verifier {
    struct replayer replayer;
    struct core core;
    struct input input;
    struct output output;
    struct replay_totals recorded; /* Totals that are stored in the replay. */
    /* First tick of a recorded second, counted from 1. The last round starts in this second. */
    uint32_t round_tick;
    /* Newest round entry of the simulated game. The id is 0 before the first round. */
    struct ledger_entry round;
    uint32_t seen_id;
    bool is_damaged;
    bool is_refused; /* True if the core returned CORE_ERR_FLOAT. */
    bool is_read;    /* True if the whole replay was parsed and is valid. */
    const uint8_t *bytes;
    size_t size;
};

/* Opens a replay and sets the calling thread's floating-point control register. `bytes` must
 * outlive the verification. Returns 0, or -1 if the header is invalid. The result of the
 * verification is then REPLAY_VERDICT_DAMAGED. */
int replay_verifier_open(struct replay_verifier *verifier, const uint8_t *bytes, size_t size);

/* Parses at most one second of the open replay, so that the work fits into a frame. Returns 1 if
 * seconds remain. Returns 0 if the replay is completely parsed and the core is initialized. Returns
 * -1 if the replay is invalid. */
int replay_verifier_read(struct replay_verifier *verifier);

/* Opens and parses a replay completely. Returns 0, or -1 if the replay is invalid. */
int replay_verifier_begin(struct replay_verifier *verifier, const uint8_t *bytes, size_t size);

/* Simulates one tick. Returns false at the end of the replay, at the first difference, or if the
 * core rejected the tick; otherwise returns true. */
bool replay_verifier_tick(struct replay_verifier *verifier);

/* Returns true if the simulation has reached the recorded second in which the last round starts.
 * The verified score is the score of the last round. */
bool replay_verifier_is_at_round(const struct replay_verifier *verifier);

/* Returns the result of the verification. Call after replay_verifier_tick() has returned false. At
 * least one row of `ranking` must have the id `round_id`, and every row with this id must equal the
 * simulated round. `kept` is the round's ledger entry and must equal the entry of the simulation.
 * An id of 0 in `kept` means that the ledger no longer has the entry. */
enum replay_verdict replay_verifier_result(const struct replay_verifier *verifier,
                                           const struct ranking *ranking, uint32_t round_id,
                                           const struct ledger_entry *kept);
