/* system_health.h -- system health: whether the card stores data, its free space, the age of the
 * backup, the temperature and the quarantined files.
 *
 * A separate thread checks every few seconds, because a card or a sensor may block for long and the
 * frame loop must not. The thread writes only the markers of acknowledged files. */
#ifndef KINGYO_PLATFORM_SYSTEM_HEALTH_H
#define KINGYO_PLATFORM_SYSTEM_HEALTH_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/scene_machine.h"

#define SYSTEM_HEALTH_PERIOD_S 5u
/* File in which board/kiosk/check-data writes its result. */
#define SYSTEM_HEALTH_CHECK_PATH "/run/kingyo-data"
/* A file time less than this in the future is explained by daylight saving time. */
#define SYSTEM_HEALTH_CLOCK_SLACK_S 7200
#define SYSTEM_HEALTH_QUARANTINE_MAX 64u /* Files that are counted; further files are ignored. */

/* State of the monitor. The caller owns the structure, sets the first three fields and clears the
 * rest. The address must not change while the thread runs. */
struct system_health {
    const char *data;    /* Folder of the store; null or "": none. */
    const char *checked; /* Null: SYSTEM_HEALTH_CHECK_PATH. */
    const char *heat;    /* Null: /sys/class/thermal. */

    pthread_t thread;
    bool runs;
    pthread_mutex_t lock; /* Protects the fields below it. The frame loop only tries to lock it. */
    pthread_cond_t bell;
    bool ends, acknowledges;
    struct scene_machine newest;

    /* Fields of the thread only. */
    int64_t written_s; /* Time of the newest file at the first check; 0: none. */
    struct {
        uint64_t inode;
        int64_t mtime_s;
        long mtime_ns;
    } backup;         /* Identity of the backup seen last. */
    int64_t backup_s; /* Time when that backup was made, on the monotonic clock. */
    bool has_begun;
};

/* Checks once on the caller's thread. Fills all of `out` except `watch` and `missed`. */
void system_health_sample(struct system_health *machine, struct scene_machine *out);

/* Marks all quarantined files as acknowledged. Returns 0, or the negative errno of the last file
 * that could not be marked. */
int system_health_mark_seen(const struct system_health *machine);

/* Kinds of quarantined files of the store. */
enum system_health_quarantine {
    SYSTEM_HEALTH_QUARANTINE_NONE = 0, /* Another file: a journal, a marker, a foreign file. */
    SYSTEM_HEALTH_QUARANTINE_DAMAGED,  /* "kingyo.db.damaged-3": a database. */
    SYSTEM_HEALTH_QUARANTINE_MISSING,  /* "kingyo.db.missing-3": the marker for a missing
                                          database. */
    SYSTEM_HEALTH_QUARANTINE_LEFT,     /* "kingyo.db.left-out-3": the database before a part was
                                          deleted. */
    SYSTEM_HEALTH_QUARANTINE_OTHER,    /* "kingyo.db.tail.other-3": a file of a foreign ledger. */
};

/* Returns the kind of a file, given its name without the folder. */
enum system_health_quarantine system_health_quarantine_of(const char *file);

/* Returns true if the file was acknowledged. */
bool system_health_is_seen(const char *folder, const char *file);

/* Starts the thread. If no thread can be created, all values remain unknown. */
void system_health_start(struct system_health *machine);

/* Stops the thread and waits for its end. */
void system_health_stop(struct system_health *machine);

/* Copies the newest result, except `watch` and `missed`. Leaves `out` unchanged while the thread
 * holds the lock. Never blocks. */
void system_health_read(struct system_health *machine, struct scene_machine *out);

/* Requests that the thread marks the quarantined files as acknowledged. Never blocks. Returns false
 * if the request was not accepted; the caller retries. */
bool system_health_acknowledge(struct system_health *machine);

#endif
