/* machine.h -- system health: whether the card stores data, its free space, the age of the backup,
 * the temperature and the quarantined files.
 *
 * A separate thread checks every few seconds, because a card or a sensor may block for long and the
 * frame loop must not. The thread writes only the markers of acknowledged files. */
#ifndef KINGYO_PLATFORM_MACHINE_H
#define KINGYO_PLATFORM_MACHINE_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/scene_machine.h"

#define MACHINE_LOOK_S 5u
#define MACHINE_CHECKED "/run/kingyo-data" /* File in which board/kiosk/check-data writes its
                                              result. */
#define MACHINE_CLOCK_SLACK_S 7200  /* A file time less than this in the future is explained by
                                       daylight saving time. */
#define MACHINE_ASIDE_MAX 64u       /* Files that are counted; further files are ignored. */

/* State of the monitor. The caller owns the structure, sets the first three fields and clears the
 * rest. The address must not change while the thread runs. */
struct machine {
    const char *data;    /* Folder of the store; null or "": none. */
    const char *checked; /* Null: MACHINE_CHECKED. */
    const char *heat;    /* Null: /sys/class/thermal. */

    pthread_t thread;
    bool runs;
    pthread_mutex_t lock; /* Protects the fields below it. The frame loop only tries to lock it. */
    pthread_cond_t bell;
    bool ends, acknowledges;
    struct scene_machine newest;

    /* Fields of the thread only. */
    int64_t written_s;   /* Time of the newest file at the first check; 0: none. */
    struct { uint64_t inode; int64_t mtime_s; long mtime_ns; } backup; /* Identity of the backup
                                                                          seen last. */
    int64_t backup_s;    /* Time when that backup was made, on the monotonic clock. */
    bool has_begun;
};

/* Checks once on the caller's thread. Fills all of `out` except `watch` and `missed`. */
void machine_look(struct machine *machine, struct scene_machine *out);

/* Marks all quarantined files as acknowledged. Returns 0, or the negative errno of the last file
 * that could not be marked. */
int machine_mark_seen(const struct machine *machine);

/* Kinds of quarantined files of the store. */
enum machine_aside {
    MACHINE_ASIDE_NOT = 0, /* Another file: a journal, a marker, a foreign file. */
    MACHINE_ASIDE_DAMAGED, /* "kingyo.db.damaged-3": a database. */
    MACHINE_ASIDE_MISSING, /* "kingyo.db.missing-3": the marker for a missing database. */
    MACHINE_ASIDE_LEFT,    /* "kingyo.db.left-out-3": the database before a part was deleted. */
    MACHINE_ASIDE_OTHER,   /* "kingyo.db.tail.other-3": a file of a foreign ledger. */
};

/* Returns the kind of a file, given its name without the folder. */
enum machine_aside machine_aside_of(const char *file);

/* Returns true if the file was acknowledged. */
bool machine_is_seen(const char *folder, const char *file);

/* Starts the thread. If no thread can be created, all values remain unknown. */
void machine_start(struct machine *machine);

/* Stops the thread and waits for its end. */
void machine_stop(struct machine *machine);

/* Copies the newest result, except `watch` and `missed`. Leaves `out` unchanged while the thread
 * holds the lock. Never blocks. */
void machine_read(struct machine *machine, struct scene_machine *out);

/* Requests that the thread marks the quarantined files as acknowledged. Never blocks. Returns false
 * if the request was not accepted; the caller retries. */
bool machine_acknowledge(struct machine *machine);

#endif
