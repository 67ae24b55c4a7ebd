/* system_health.h -- monitors the system health: whether data on the card survive a restart, free
 * disk space, age of the backup, temperature, and quarantined files. A quarantined file is a
 * damaged or foreign file that the store keeps but no longer uses.
 *
 * A separate thread checks every SYSTEM_HEALTH_PERIOD_S seconds, because a card or a sensor may
 * block for a long time and the frame loop must not block. The thread's only output files are the
 * markers of acknowledged quarantined files. */
#pragma once

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <time.h>

#include "core/scene_menu.h"

#define SYSTEM_HEALTH_PERIOD_S 5u
/* File to which the script board/kiosk/check-data writes its result. */
#define SYSTEM_HEALTH_CHECK_PATH "/run/kingyo-data"
/* Tolerance in seconds for file times in the future. A smaller difference may result from daylight
 * saving time. */
#define SYSTEM_HEALTH_CLOCK_SLACK_S 7200
/* Maximum number of quarantined files that are counted. Additional files are ignored. */
#define SYSTEM_HEALTH_QUARANTINE_MAX 64u

/* State of the health monitor. The caller owns the structure, sets `data`, `checked` and `heat`,
 * and clears the other fields. The address of the structure must not change while the monitor's
 * thread runs. */
struct system_health {
    const char *data; /* Folder of the store. Null or "" means that there is no store. */
    /* File with the result of check-data. Null means SYSTEM_HEALTH_CHECK_PATH. */
    const char *checked;
    const char *heat; /* Folder of the thermal zones. Null means /sys/class/thermal. */

    pthread_t thread;
    bool runs;
    int wake_fd; /* Descriptor of eventfd(2) that ends the wait of the health monitor's thread. */
    /* Requests to the health monitor's thread: `ends` to end, `acknowledges` to mark all
     * quarantined files as acknowledged. */
    atomic_bool ends, acknowledges;
    pthread_mutex_t lock; /* Protects `newest`. The frame loop uses trylock only. */
    struct scene_machine newest;

    /* Only the health monitor's thread uses the following fields. */
    int64_t written_s; /* Modification time of the newest store file at the first check. 0 means no
                          file. */
    struct {
        uint64_t inode;
        struct timespec modified;
        /* Identity of the backup file at the last check (inode and modification time). */
    } backup;
    int64_t backup_s; /* Time in seconds on the monotonic clock at which the backup was made. */
    bool has_begun;
};

/* Checks the system once on the calling thread. Sets all fields of `out` except `watch` and
 * `missed`. */
void system_health_sample(struct system_health *machine, struct scene_machine *out);

/* Marks all quarantined files as acknowledged. Returns 0, or the negative errno of the last file
 * that could not be marked. */
int system_health_mark_seen(const struct system_health *machine);

/* Kinds of quarantined files, which the store no longer uses and keeps for the operator. */
enum system_health_quarantine {
    /* Not a quarantined file: a journal, a marker or a file of another program. */
    SYSTEM_HEALTH_QUARANTINE_NONE = 0,
    SYSTEM_HEALTH_QUARANTINE_DAMAGED, /* Damaged database, for example "kingyo.db.damaged-3". */
    /* Marker for a missing database, for example "kingyo.db.missing-3". */
    SYSTEM_HEALTH_QUARANTINE_MISSING,
    /* Copy of the database that was made before a part of its data was deleted, for example
     * "kingyo.db.left-out-3". */
    SYSTEM_HEALTH_QUARANTINE_LEFT,
    /* File that belongs to a ledger other than the store's, for example
     * "kingyo.db.tail.other-3". */
    SYSTEM_HEALTH_QUARANTINE_OTHER,
};

/* Returns the kind of the quarantined file `file`, a name without the folder. */
enum system_health_quarantine system_health_quarantine_of(const char *file);

/* Returns true if the operator has acknowledged the quarantined file `file` in `folder`. */
bool system_health_is_seen(const char *folder, const char *file);

/* Starts the health monitor's thread. If the thread cannot be created, all health values remain
 * unknown. */
void system_health_start(struct system_health *machine);

/* Stops the health monitor's thread and waits until the thread has ended. */
void system_health_stop(struct system_health *machine);

/* Copies the newest result to `out`, except `watch` and `missed`. Leaves `out` unchanged while the
 * health monitor's thread holds the lock. Never blocks. */
void system_health_read(struct system_health *machine, struct scene_machine *out);

/* Requests that the health monitor's thread marks all quarantined files as acknowledged. Never
 * blocks. */
void system_health_acknowledge(struct system_health *machine);
