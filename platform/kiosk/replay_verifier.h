/* replay_verifier.h -- replays a score and verifies that it is genuine.
 *
 * A score is genuine if every digest and every second's state equal the recorded ones. In addition,
 * the game's final entry must equal the ranking's rows and the ledger's entry of the round. The
 * entry contains boot, ticks, the tank's seed, mode, grade, players, and each player's catch,
 * papers and fouls. This proves that these inputs make exactly this score in this program, in a
 * tank of that seed, for that many ticks.
 *
 * The result does not prove who played, nor how many fish the tank had. No entry contains the
 * number of fish; `kingyoctl scores verify` prints the replay's number. An attacker who can write
 * the disk can change entry, ranking and replay together, because no secret is involved. An entry
 * that the ledger has dropped is not compared. An entry with a wrong checksum disproves the score.
 * The caller owns the verifier (1.3 MB: static storage). */
#ifndef KINGYO_PLATFORM_KIOSK_REPLAY_VERIFIER_H
#define KINGYO_PLATFORM_KIOSK_REPLAY_VERIFIER_H

#include <stddef.h>
#include <stdint.h>

#include "platform/kiosk/replayer.h"

enum replay_verdict {
    REPLAY_VERDICT_GENUINE = 0,
    REPLAY_VERDICT_OTHER,     /* The game differs from the recording (replayer.difference), or
                                 gives a score other than the ranking's. */
    REPLAY_VERDICT_DAMAGED,   /* The bytes are no valid recording: replayer.reader.problem. */
    REPLAY_VERDICT_UNCHECKED, /* Not verified, because the core returned CORE_ERR_FLOAT. */
    REPLAY_VERDICT_COUNT,
};

struct replay_verifier {
    struct replayer replayer;
    struct core core;
    struct input input;
    struct output output;
    struct replay_totals said; /* Totals that the replay itself states. */
    uint32_t round_tick;       /* First tick of the recorded second in which the last round
                                  begins. */
    struct ledger_entry round; /* Newest round entry of this game; id 0: none yet. */
    uint32_t seen_id;
    uint8_t is_damaged;
    uint8_t is_refused; /* 1: the core returned CORE_ERR_FLOAT. */
    uint8_t is_read;    /* 1: the whole replay was parsed and is valid. */
    const uint8_t *bytes;
    size_t size;
};

/* Sets the calling thread's floating-point control and opens a replay. The bytes must outlive the
 * verification. Returns 0, or -1 if nothing can be played; the result is then
 * REPLAY_VERDICT_DAMAGED. */
int replay_verifier_open(struct replay_verifier *verifier, const uint8_t *bytes, size_t size);

/* Parses at most one second of the open replay, so that the work fits into a frame. Returns 1 if
 * more is left, 0 if the replay is parsed and its initial state was created, or -1 as
 * replay_verifier_open(). */
int replay_verifier_read(struct replay_verifier *verifier);

/* Opens and parses a replay completely. Returns 0 or -1. */
int replay_verifier_begin(struct replay_verifier *verifier, const uint8_t *bytes, size_t size);

/* Runs one tick. Returns 1, or 0 at the end: of the replay, at the first difference, or because the
 * core rejected the tick. */
int replay_verifier_tick(struct replay_verifier *verifier);

/* Returns 1 if the last round, which is the score's, has begun. */
int replay_verifier_is_at_round(const struct replay_verifier *verifier);

/* Returns the result. Call after the end. Every row of `ranking` with the round `round_id` must
 * equal this game, and there must be at least one. If the ledger still has the round, its entry
 * `kept` must equal the game's entry; otherwise the id of `kept` is 0. */
enum replay_verdict replay_verifier_result(const struct replay_verifier *verifier,
                                           const struct ranking *ranking, uint32_t round_id,
                                           const struct ledger_entry *kept);

#endif
