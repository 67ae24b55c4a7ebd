/* judge.h -- plays a score's replay again and says whether the score is genuine.
 *
 * It is when every digest and every second's state agree with what was recorded, and the ledger's
 * entry that this play ends with says what the ranking says of that round. The caller owns it (1.3
 * MB: static storage). */
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
};

/* Reads `bytes` wholly, and makes the stall that the replay begins with; they must outlive the
 * judge's work. 0, or -1 when nothing can be played: the verdict is VERDICT_DAMAGED. */
int judge_begin(struct judge *judge, const uint8_t *bytes, size_t size);

/* One tick. 1, or 0 at the end: of the replay, or of its agreement with this play. */
int judge_tick(struct judge *judge);

/* Whether the last round, the score's own, has begun. */
int judge_is_at_round(const struct judge *judge);

/* After the end. Every row that `ranking` has of the round `round_id` must be this play's, and
 * there must be one. */
enum verdict judge_say(const struct judge *judge, const struct ranking *ranking,
                       uint32_t round_id);

#endif
