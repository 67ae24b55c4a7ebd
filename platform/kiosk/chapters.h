/* chapters.h -- keeps the chapter that runs (core/game/chapter.h) in memory, gives the store the
 * replay of each round that is ranked, and writes the chapter to a file in a panic.
 *
 * A chapter's recording begins with the configuration that makes its first state, so that memory
 * always holds a snapshot and every input since. The caller owns `struct chapters` (20 MiB: static
 * storage) and leaves it zero. The rounds of a chapter that has grown beyond CHAPTERS_SIZE are
 * scores without a replay. A chapter that grows beyond CHAPTERS_MEMORY ends its recording: a panic
 * then writes the chapter up to there. One replay at a time goes to the store; while a slow card
 * takes it, a second round that is ranked is a score without one, too, and so is a round of a
 * chapter in which digits of the PIN were typed. All are counted. */
#ifndef KINGYO_PLATFORM_KIOSK_CHAPTERS_H
#define KINGYO_PLATFORM_KIOSK_CHAPTERS_H

#include <stdatomic.h>

#include "platform/hal.h"
#include "platform/kiosk/recorder.h"
#include "platform/replay.h"

/* Ten minutes of attract are 0.1 MB; after them a hand of six axes at each tick writes 3.4 KB a
 * second: a quarter of an hour of one player, four minutes of four. */
#define CHAPTERS_SIZE (3u * 1024u * 1024u)

/* Ten minutes in which every field of every input changes at each tick are 16 MiB. Four hands of
 * six axes write 13 KB a second: twenty minutes, which is a chapter of attract and the longest
 * round with its pauses. Pages that no chapter has reached take no memory. */
#define CHAPTERS_MEMORY (17u * 1024u * 1024u)
#define CHAPTERS_SECOND_MAX                                                                        \
    (REPLAY_CHUNK_HEAD_SIZE + REPLAY_PAYLOAD_MAX + REPLAY_SUM_SIZE)
_Static_assert(REPLAY_HEADER_MAX + 600u * CHAPTERS_SECOND_MAX + REPLAY_END_SIZE <= CHAPTERS_MEMORY,
               "ten minutes of any input fit");

struct chapters {
    struct core_config start; /* The start of the chapter with its PIN withheld (core/pin.h), which
                                 replaces the true start in each replay that the store keeps. */
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    uint32_t seen_id;   /* The newest entry of the ledger that was looked at. */
    uint32_t round_id;  /* Whose replay lies in `replay`; 0: nobody's. */
    uint8_t is_lent;    /* The store has it. */
    uint8_t is_sealed;  /* Its checksums are renewed. */
    struct replay_seal seal;
    uint8_t has_pin;    /* Digits of a PIN were typed in this chapter: no replay of it is kept. */
    size_t replay_size;
    uint32_t missed;    /* Ranked rounds whose replay could not be kept. */
    struct input begun;     /* Input of the running tick; valid while is_in_tick is 1. */
    atomic_uchar is_in_tick; /* 1 while core_tick() runs. */
    atomic_uchar is_busy;   /* From chapters_before() to the end of chapters_tick(). */
    atomic_uchar is_frozen; /* A panic reads it: the thread that ticks stops where it would change
                               anything. */
    uint8_t memory[CHAPTERS_MEMORY];
    uint8_t replay[CHAPTERS_SIZE];
};

/* Before the first tick of a fresh core. */
void chapters_begin(struct chapters *chapters, const struct core *core);

/* Before each tick, with its input. */
void chapters_before(struct chapters *chapters, const struct input *input);

/* After each tick. */
void chapters_tick(struct chapters *chapters, const struct input *input, const struct core *core,
                   const struct output *output);

/* Bytes of a replay whose checksums one frame renews, which takes 0.2 ms. CHAPTERS_SIZE bytes take
 * 4 ms and are spread over 24 frames. */
#define CHAPTERS_SEAL_SIZE (128u * 1024u)

/* Once a frame: renews checksums of the replay that waits, CHAPTERS_SEAL_SIZE at a time, and then
 * offers it to the store when its round is on disk. Returns 1 when the store failed. */
int chapters_offer(struct chapters *chapters, const struct hal_storage *storage);

/* ---- The PIN in a recording ------------------------------------------------------------------ */

/* Withholds the PIN (core/pin.h) in the start of a recording without a change of the play: each
 * pair of setting and told value stays equal or different, because the core writes an entry if they
 * differ. `told`: the told value of a running core, or null. */
void chapters_withhold_pin(struct core_config *config, int32_t *told);

/* Returns whether the start of a recording holds a PIN. */
int chapters_start_has_pin(const struct core_config *config);

/* Returns whether digits of a PIN are typed right now: the inputs of that recording hold them. */
int chapters_types_pin(const struct core *core);

/* ---- In a panic: async-signal-safe ---------------------------------------------------------- */

/* Stops further changes. `is_own`: the caller is the thread that ticks; another waits for the end
 * of a tick that runs, CHAPTERS_FREEZE_MS at most. Returns 1, or 0 if a change was interrupted. */
#define CHAPTERS_FREEZE_MS 200
int chapters_freeze(struct chapters *chapters, int is_own);

/* Returns whether there is a chapter to write. */
int chapters_has_begun(const struct chapters *chapters);

/* Writes the chapter after chapters_freeze(), which returned `is_sound`. A tick that was
 * interrupted is written with its input and REPLAY_HASH_NONE. Returns 0 or a negative errno. */
int chapters_dump(struct chapters *chapters, const struct core *core, int is_sound, int fd);

#endif
