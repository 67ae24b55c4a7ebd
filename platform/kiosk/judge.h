/* judge.h -- plays a score's replay again and says whether the score is genuine.
 *
 * It is when every digest and every second's state agree with what was recorded, and the entry
 * that this play ends with says what the ranking says of that round and what the ledger has on
 * disk of it: boot, ticks, the tank's seed, mode, grade, who played, and each player's catch,
 * papers and fouls. So it proves that these inputs make that very score in this program, in a tank
 * of that seed, for so many ticks. It does not prove whose hand it was, nor how many fish the
 * stall had (no entry says it: `kingyoctl scores verify` tells the replay's), nor that nobody
 * who can write the disk changed entry, ranking and replay together: there is no secret in it. An
 * entry that is so old that the ledger dropped it is not asked; one that is not as it was written
 * disproves. The caller owns it (1.3 MB: static storage). */
#ifndef KINGYO_PLATFORM_KIOSK_JUDGE_H
#define KINGYO_PLATFORM_KIOSK_JUDGE_H

#include <stddef.h>
#include <stdint.h>

#include "platform/kiosk/replayer.h"

enum verdict {
    VERDICT_GENUINE = 0,
    VERDICT_OTHER,   /* This program makes another play of it: replayer.difference, or the play
                        gives another score than the ranking's. */
    VERDICT_DAMAGED, /* Its bytes are no recording: replayer.reader.problem. */
    VERDICT_UNCHECKED, /* The core refused to run here with CORE_ERR_FLOAT. */
    VERDICT_COUNT,
};

struct judge {
    struct replayer replayer;
    struct core core;
    struct input input;
    struct output output;
    struct replay_totals said;  /* Of the whole replay, by itself. */
    uint32_t round_tick;        /* Its last round begins in the second from here. */
    struct ledger_entry round;  /* The newest that this play wrote; id 0: none yet. */
    uint32_t seen_id;
    uint8_t is_damaged;
    uint8_t is_refused;         /* The core returned CORE_ERR_FLOAT. */
    uint8_t is_read;            /* All of it was, and nothing is damaged. */
    const uint8_t *bytes;
    size_t size;
};

/* Sets the calling thread's floating-point control and opens a replay; its bytes must outlive the
 * judge's work. 0, or -1 when nothing can be played: the verdict is VERDICT_DAMAGED. */
int judge_open(struct judge *judge, const uint8_t *bytes, size_t size);

/* Reads on in what is open, a second of play at most: what is decoded in one go is a frame's. 1:
 * there is more; 0: it is wholly read, and the stall that it begins with is made; -1 as above. */
int judge_read(struct judge *judge);

/* All of that at once, for who has no frames to keep. 0 or -1. */
int judge_begin(struct judge *judge, const uint8_t *bytes, size_t size);

/* One tick. 1, or 0 at the end: of the replay, of its agreement with this play, or because the core
 * refused the tick. */
int judge_tick(struct judge *judge);

/* Whether the last round, the score's own, has begun. */
int judge_is_at_round(const struct judge *judge);

/* After the end. Every row that `ranking` has of the round `round_id` must be this play's, there
 * must be one, and the ledger's entry of the round must be the play's, where the ledger still has
 * it: `kept`, with id 0 where it has not. */
enum verdict judge_say(const struct judge *judge, const struct ranking *ranking, uint32_t round_id,
                       const struct ledger_entry *kept);

#endif
