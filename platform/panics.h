/* panics.h -- the count of panics, in a small file of its own in the data folder, and what the next
 * start leaves out because of them. Pure, but for reading and writing the file.
 *
 * Three panics within ten minutes, or one before the first frame, make the next start leave out a
 * part of what the store remembers: first settings, then replays too, then names too. Never the
 * money. Time is counted since the machine was switched on, because a board may have no clock;
 * panics from before that are counted, and start no such thing unless no frame was shown. */
#ifndef KINGYO_PLATFORM_PANICS_H
#define KINGYO_PLATFORM_PANICS_H

#include <stdint.h>

#define PANICS_FILE "panics"
#define PANICS_SIZE 80u        /* Bytes of the file: one sector, so that no power cut tears it. */
#define PANICS_RECENT 3u       /* Number of newest panics that are kept. */
#define PANICS_WITHIN_S 600u   /* Time window in seconds for PANICS_RECENT panics. */
#define PANICS_OTHER_MAX 100u  /* Names tried for something that is set aside. */
#define PANICS_FILES 10u       /* Replays of panics that are kept: panic-0.kgr to panic-9.kgr. */

enum panics_left { LEFT_NOTHING = 0, LEFT_SETTINGS, LEFT_REPLAYS, LEFT_NAMES, LEFT_COUNT };

/* Zero: none ever happened. */
struct panics {
    uint32_t total;     /* Since the file was made; stops at UINT32_MAX. */
    uint32_t left;      /* enum panics_left of the last start that left something out. */
    uint64_t left_boot; /* The machine's start of that. */
    uint32_t is_early;  /* 1: the newest came before the first frame. */
    uint32_t count;     /* Of `recent` that are set, the newest first. */
    uint32_t attempt;   /* enum panics_left of a leave-out that has begun and not ended; else 0. */
    struct {
        uint64_t boot;  /* The machine's start. */
        uint32_t up_s;  /* Seconds since that. */
    } recent[PANICS_RECENT];
};

/* The machine's start as a number, and the seconds since. The latter is async-signal-safe. */
uint64_t panics_boot(void);
uint32_t panics_up_s(void);

/* Counts a panic of a program that ran for `run_s` seconds. A program that ran for ten minutes, or
 * on another start of the machine, has outlived what the last start left out. */
void panics_add(struct panics *panics, uint64_t boot, uint32_t up_s, uint32_t run_s, int had_frame);

/* Returns whether the next start leaves something out. */
int panics_is_due(const struct panics *panics);

/* Notes that this start tries to leave out one part more, and returns which. */
enum panics_left panics_try(struct panics *panics);

/* Notes that the attempt succeeded on this start of the machine, and clears the recent panics. */
void panics_leave(struct panics *panics, uint64_t boot);

/* Clears the attempt and the recent panics, so that the next start leaves nothing out. */
void panics_forget(struct panics *panics);

/* "settings", "settings and replays" and so on; "nothing" for 0 and beyond LEFT_NAMES. */
const char *panics_left_name(uint32_t left);

/* Reads the file in an open folder; follows no link and never blocks. Returns 0, also if there is
 * none, or a negative errno; -EBADMSG: its bytes are not a count. `panics` is zero then. If
 * something other than a regular file has that name, it is renamed to PANICS_FILE ".other-1", "-2"
 * and so on, one line is logged, and the result is 0 with a `panics` of zero. -ENOTSUP: it cannot
 * be renamed. */
int panics_read(struct panics *panics, int folder);

/* Writes and syncs it, mode 0600. Async-signal-safe. Returns 0 or a negative errno, -ENOTSUP if
 * something other than a regular file has that name. */
int panics_write(const struct panics *panics, int folder);

/* Returns words for an error of either. */
const char *panics_error(int error);

#endif
