/* panics.h -- counts panics in a small file in the data folder, and selects the stored data that
 * the next program start leaves out (deletes after making a copy).
 *
 * A panic is a failed assertion or a fatal signal. After three panics within ten minutes, or after
 * one panic before the first frame, the next start leaves out a part of the stored data. The part
 * grows with each attempt: first settings, then also replays, then also names. The ledger (the list
 * of money events) is never left out.
 *
 * Times are seconds since power-on because a board may have no clock. The total also counts panics
 * from before the last power-on. However, such a panic causes data to be left out only if it came
 * before the first frame.
 *
 * The module has no side effects except that it reads and writes the file. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#define PANICS_FILE "panics"
/* Size of the file in bytes. The file is smaller than one disk sector, so that a power cut cannot
 * leave a partly written file. */
#define PANICS_SIZE 80u
#define PANICS_RECENT 3u /* Number of the newest panics that the file stores. */
/* Period in seconds. After PANICS_RECENT panics within this period, the next program start leaves
 * out stored data. */
#define PANICS_WITHIN_S 600u
/* Maximum number of names ".other-1", ".other-2" and so on that are tried when an object that is
 * not a regular file is renamed. */
#define PANICS_OTHER_MAX 100u
/* Maximum number of stored replay files with the inputs before a panic: panic-0.kgr to
 * panic-9.kgr. */
#define PANICS_FILES 10u

enum panics_left { LEFT_NOTHING = 0, LEFT_SETTINGS, LEFT_REPLAYS, LEFT_NAMES, LEFT_COUNT };

/* Count of panics. A structure of zeros means that there was no panic. */
struct panics {
    uint32_t total;     /* Panics since the file was created. The count stops at UINT32_MAX. */
    uint32_t left;      /* Part of the stored data that was left out last (enum panics_left). */
    uint64_t left_boot; /* Id (panics_boot()) of the boot in which `left` was set. */
    bool is_early;      /* True if the newest panic came before the first frame. */
    uint32_t count;     /* Number of valid entries in `recent`, which has the newest panic first. */
    /* Part of the stored data that the current program start is leaving out (enum panics_left). 0
     * means that this start leaves out nothing, or has finished. */
    uint32_t attempt;
    struct {
        uint64_t boot; /* Id (panics_boot()) of the boot in which the panic occurred. */
        uint32_t up_s; /* Seconds between the boot and the panic. */
    } recent[PANICS_RECENT];
};

/* panics_boot() returns a number that identifies the current boot of the machine. panics_up_s()
 * returns the seconds since that boot and is async-signal-safe. */
uint64_t panics_boot(void);
uint32_t panics_up_s(void);

/* Counts a panic of a program that ran for `run_s` seconds. `boot` and `up_s` are the values of
 * panics_boot() and panics_up_s(). `had_frame` is true if the program showed a frame. Clears
 * panics.left if the program showed a frame and either ran for ten minutes or ran in another boot
 * than panics.left_boot. */
void panics_add(struct panics *panics, uint64_t boot, uint32_t up_s, uint32_t run_s,
                bool had_frame);

/* Returns true if the counted panics require that the next program start leaves out a part of the
 * stored data. */
bool panics_is_due(const struct panics *panics);

/* Sets panics.attempt to the part of the stored data that the current program start must leave out,
 * which is one step more than panics.left. Returns panics.attempt. */
enum panics_left panics_try(struct panics *panics);

/* Records that the stored data of panics.attempt were left out in the boot `boot`: copies
 * panics.attempt to panics.left, and clears panics.attempt and the recent panics. */
void panics_set_left_out(struct panics *panics, uint64_t boot);

/* Clears panics.attempt and the recent panics, so that the next program start leaves out no
 * data. */
void panics_clear(struct panics *panics);

/* Returns the name of an enum panics_left, for example "settings and replays". Returns "nothing"
 * for LEFT_NOTHING and for invalid values. */
const char *panics_left_name(uint32_t left);

/* Reads the file in the open folder `folder`, without following links and without blocking. Returns
 * 0 if the file was read or does not exist. Returns -EBADMSG if the bytes are invalid, or another
 * negative errno. After an error `panics` is zero. If the name PANICS_FILE belongs to an object
 * other than a regular file, the object is renamed to PANICS_FILE ".other-1", ".other-2" and so on,
 * one line is logged, and the result is 0 with a zero `panics`. If the object cannot be renamed,
 * the result is -ENOTSUP. */
int panics_read(struct panics *panics, int folder);

/* Writes the file with mode 0600 and syncs it to disk. Async-signal-safe. Returns 0 or a negative
 * errno. Returns -ENOTSUP if the name PANICS_FILE belongs to an object other than a regular
 * file. */
int panics_write(const struct panics *panics, int folder);

/* Returns the text for an error of panics_read() or panics_write(). */
const char *panics_error(int error);
