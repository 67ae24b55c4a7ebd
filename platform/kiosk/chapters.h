/* chapters.h -- keeps the chapter that runs (core/game/chapter.h) in memory, and gives the store
 * the replay of each round that is ranked.
 *
 * The caller owns `struct chapters` (6 MiB: static storage) and leaves it zero. A chapter that
 * grows beyond CHAPTERS_SIZE ends its recording: the rounds that follow in it are scores without a
 * replay. One replay at a time goes to the store; while a slow card takes it, a second round that
 * is ranked is a score without one, too. Both are counted. */
#ifndef KINGYO_PLATFORM_KIOSK_CHAPTERS_H
#define KINGYO_PLATFORM_KIOSK_CHAPTERS_H

#include "platform/hal.h"
#include "platform/kiosk/recorder.h"
#include "platform/replay.h"

/* Ten minutes of attract are 0.1 MB; after them a hand of six axes at each tick writes 3.4 KB a
 * second: a quarter of an hour of one player, four minutes of four. */
#define CHAPTERS_SIZE (3u * 1024u * 1024u)

struct chapters {
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    uint32_t seen_id;   /* The newest entry of the ledger that was looked at. */
    uint32_t round_id;  /* Whose replay lies in `replay`; 0: nobody's. */
    uint8_t is_lent;    /* The store has it. */
    size_t replay_size;
    uint32_t missed;    /* Ranked rounds whose replay could not be kept. */
    uint8_t memory[CHAPTERS_SIZE];
    uint8_t replay[CHAPTERS_SIZE];
};

/* Before the first tick of a fresh core. */
void chapters_begin(struct chapters *chapters, const struct core *core);

/* After each tick. */
void chapters_tick(struct chapters *chapters, const struct input *input, const struct core *core,
                   const struct output *output);

/* Once a frame: offers the store a replay whose round is on disk. Returns 1 when the store
 * failed. */
int chapters_offer(struct chapters *chapters, const struct hal_storage *storage);

#endif
