/* panic_count.h -- counts panics in a small file in the data folder, and selects the data that the
 * next start leaves out. Pure, except for reading and writing the file.
 *
 * After three panics within ten minutes, or one before the first frame, the next start leaves out a
 * part of the stored data. Settings are left out first, then also replays, then also names, but
 * never the money. Time is counted since power-on because a board may have no clock. Panics before
 * the last power-on are counted in the total. They count for leaving data out only if no frame was
 * shown. */
#ifndef KINGYO_PLATFORM_PANIC_COUNT_H
#define KINGYO_PLATFORM_PANIC_COUNT_H

#include <stdint.h>

#define PANICS_FILE "panics"
/* Size of the file in bytes: less than one sector, so that a power cut cannot tear it. */
#define PANICS_SIZE 80u
#define PANICS_RECENT 3u      /* Number of the newest panics that are stored. */
#define PANICS_WITHIN_S 600u  /* Time window in seconds for PANICS_RECENT panics. */
#define PANICS_OTHER_MAX 100u /* Names that are tried to rename a foreign object. */
#define PANICS_FILES 10u      /* Replays of panics that are stored: panic-0.kgr to panic-9.kgr. */

enum panics_left { LEFT_NOTHING = 0, LEFT_SETTINGS, LEFT_REPLAYS, LEFT_NAMES, LEFT_COUNT };

/* Count of panics. Zero: no panic ever happened. */
struct panics {
    uint32_t total;     /* Panics since the file was created; stops at UINT32_MAX. */
    uint32_t left;      /* enum panics_left of the last start that left data out. */
    uint64_t left_boot; /* Boot of the machine at that start. */
    uint32_t is_early;  /* 1: the newest panic came before the first frame. */
    uint32_t count;     /* Valid entries in `recent`, newest first. */
    uint32_t attempt;   /* enum panics_left of an attempt that began and has not ended; else 0. */
    struct {
        uint64_t boot; /* Boot of the machine. */
        uint32_t up_s; /* Seconds since that boot. */
    } recent[PANICS_RECENT];
};

/* Return the boot of the machine as a number, and the seconds since. panics_up_s() is
 * async-signal-safe. */
uint64_t panics_boot(void);
uint32_t panics_up_s(void);

/* Counts a panic of a program that ran for `run_s` seconds. If the program showed a frame and ran
 * for ten minutes, or on another boot, the last left-out data is no longer suspected. */
void panics_add(struct panics *panics, uint64_t boot, uint32_t up_s, uint32_t run_s, int had_frame);

/* Returns 1 if the next start must leave data out. */
int panics_is_due(const struct panics *panics);

/* Records that this start tries to leave out one part more. Returns that part. */
enum panics_left panics_try(struct panics *panics);

/* Records that the attempt succeeded on this boot, and clears the recent panics. */
void panics_set_left_out(struct panics *panics, uint64_t boot);

/* Clears the attempt and the recent panics, so that the next start leaves nothing out. */
void panics_clear(struct panics *panics);

/* Returns "settings", "settings and replays" and so on; "nothing" for 0 and for values above
 * LEFT_NAMES. */
const char *panics_left_name(uint32_t left);

/* Reads the file in an open folder, without following links and without blocking. Returns 0, also
 * if there is no file, or a negative errno; -EBADMSG if the bytes are invalid. After an error
 * `panics` is zero. An object other than a regular file is renamed to PANICS_FILE ".other-1", "-2"
 * and so on and logged in one line. Then the result is 0 with a zero `panics`, or -ENOTSUP if the
 * renaming failed. */
int panics_read(struct panics *panics, int folder);

/* Writes and syncs the file, mode 0600. Async-signal-safe. Returns 0 or a negative errno; -ENOTSUP
 * if the name belongs to an object other than a regular file. */
int panics_write(const struct panics *panics, int folder);

/* Returns the text for an error of either function. */
const char *panics_error(int error);

#endif
