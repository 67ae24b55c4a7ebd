/* storage.h -- the store: one SQLite file with the ledger (platform/store/sqlite/ledger_file.h),
 * written by its own thread.
 *
 * The frame loop never blocks on the card. keep() copies an entry into one of STORAGE_QUEUE_MAX
 * slots and returns. The thread writes and syncs all queued entries in one transaction, and
 * saved_id() then returns the newest id. After a failed sync an entry is acknowledged only when its
 * bytes were written again and synced (platform/store/sqlite/ledger_log.c), both in the database
 * and in the ledger mirror.
 *
 * A card that is slow, full, busy, read-only or absent is retried once a second while the queue
 * fills. A file that must be read completely to detect a change is retried less often
 * (storage_card.c). When the queue is full, keep() returns HAL_ERR_BUSY and the entries wait in the
 * output of the core. A card that is full at the start is read, and written as soon as it has free
 * space. Each failed attempt is counted. close() tries once more and returns the number of entries
 * that are lost.
 *
 * The file is copied to a backup beside it at the start, each hour and after each
 * STORAGE_BACKUP_ENTRIES entries. The backup is validated before it replaces the previous backup.
 * Entries since then are stored twice, in the database and in the ledger mirror
 * (platform/store/sqlite/ledger_mirror.h).
 *
 * A damaged file is renamed (quarantined), never repaired in place and never deleted. The backup
 * replaces it, with all later entries that the damaged file or the mirror still contains. A missing
 * file is replaced in the same way, and an empty marker file records the loss. If the card has no
 * space for the replacement, all files stay unchanged and are only read.
 *
 * A file or folder that is removed, renamed, replaced or mounted over while it is open is detected
 * within a second (storage_moved.c). No entry is acknowledged until the file is back.
 *
 * Edits from the growth lab become text files in the same folder. They are stored even if the
 * database cannot be opened. */
#ifndef KINGYO_PLATFORM_STORE_STORAGE_H
#define KINGYO_PLATFORM_STORE_STORAGE_H

#include <pthread.h>
#include <semaphore.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/persistent_state.h"
#include "platform/hal.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/sqlite/ledger_recovery.h"

#define STORAGE_FILE "kingyo.db"
#define STORAGE_BACKUP_SUFFIX ".backup"
#define STORAGE_MIRROR_SUFFIX ".tail"
/* Finished replacement of a damaged file, until it is renamed. */
#define STORAGE_NEW_SUFFIX ".new"
/* Backup of a database that the operator replaced by a copy. */
#define STORAGE_BEFORE_SUFFIX ".before-restore"
/* Followed by a number: the database that the operator replaced by a copy. */
#define STORAGE_REPLACED_SUFFIX ".before-"
/* Followed by a number: a quarantined damaged file. */
#define STORAGE_QUARANTINE_SUFFIX ".damaged-"
/* Followed by a number: an empty marker for a missing file. */
#define STORAGE_MISSING_SUFFIX ".missing-"
/* After the name of a backup or mirror of a foreign ledger; then a number. */
#define STORAGE_OTHER_SUFFIX ".other-"
/* Followed by a number: a copy made by ledger_leave_out(). */
#define STORAGE_LEFT_SUFFIX ".left-out-"
/* After such a name: the operator has acknowledged the event. */
#define STORAGE_SEEN_SUFFIX ".seen"
/* A card that blocks one write for this long is reported as unhealthy. The worst internal pause
 * of good cards is one second. */
#define STORAGE_STUCK_MS 3000
/* Interval between two complete reads of an unusable file. The interval doubles from the first
 * value up to the second. */
#define STORAGE_RETRY_MS 1000
#define STORAGE_RETRY_MS_MAX 60000
/* Growth of the free space in bytes that triggers an early retry on a full card. The margin is
 * needed because other programs write to the card, too. */
#define STORAGE_ROOM_MORE (256u * 1024u)
#define STORAGE_BACKUP_S 3600 /* Longest interval between two backups. */
/* Entries after which a backup is made earlier. */
#define STORAGE_BACKUP_ENTRIES (LEDGER_MIRROR_SLOTS / 2u)
#define STORAGE_PATH_SIZE 512u
/* Twice the number of entries that the core can have unwritten, so that a slot is always free while
 * the card responds. */
#define STORAGE_QUEUE_MAX (2u * LEDGER_RING)
/* Enough because the menu allows far less than four saved edits a second. */
#define STORAGE_EDITS_MAX 4u
#define STORAGE_REPLAY_MS 10000 /* Time after which a replay that the card rejects is given up. */
/* Limit in bytes for all memory of SQLite. The highest measured use was 4.2 MiB, with 100,000
 * entries, a backup and a replay of maximum length (SESSION_RECORDER_SIZE) for each ranked round.
 */
#define STORAGE_HEAP_MAX (8 * 1024 * 1024)

#define STORAGE_RANKS (MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

/* Request to write or read a replay. The frame loop sets the other fields first and then `state`;
 * the thread resets `state` at the end. */
enum storage_replay_state { STORAGE_REPLAY_IDLE = 0, STORAGE_REPLAY_WAITS };
struct storage_replay {
    uint32_t round_id;
    const uint8_t *bytes; /* Bytes to write, borrowed until the request ends. */
    uint8_t *room;        /* Buffer for the bytes that are read, borrowed until the request ends. */
    size_t size;
    struct ledger_entry *round; /* Receives the ledger entry of the round that is read. */
    atomic_int state;           /* enum storage_replay_state */
};

#define OFFLINE_CREDITS_MAX 16u /* One entry for each coin line and each other credit kind. */

#define STORAGE_PLACES 3u /* The database file, its log (-wal) and the log's index (-shm). */

/* Identity of a file when it was first seen. Zero: the file did not exist yet. */
struct storage_place {
    uint64_t device, inode;
};

/* State of the offline credits: credits of a kiosk that started without a store, for a database
 * that appears later. */
enum offline_credits_state {
    OFFLINE_CREDITS_NONE = 0,
    OFFLINE_CREDITS_NEW,
    OFFLINE_CREDITS_PENDING
};
struct offline_credits {
    struct ledger_entry entries[OFFLINE_CREDITS_MAX];
    uint32_t count;
    uint32_t boot; /* Boot number of the entries in that database; 0: none assigned yet. */
    struct balance_change step; /* Change of the balance in that database. */
    atomic_int state;           /* enum offline_credits_state; NEW is handled at once. */
};

/* Background work on the open file, without a deadline. The thread calls `step` for at most
 * STORAGE_CHORE_MS in a row, while no entry waits and the last write succeeded. One call takes at
 * most a few milliseconds. `step` returns SQLITE_OK, SQLITE_DONE when no work is left, or the code
 * of a failed write; the next call then continues with another part. Null: no work. */
struct storage_chore {
    int (*step)(void *self, struct ledger_file *file);
    void *self;
};
#define STORAGE_CHORE_MS 10
#define STORAGE_CHORE_WAIT_MS 40 /* Interval between two runs of background work. */

/* State of the store. The caller owns the structure, sets the first four fields and clears the
 * rest. The address must not change while the store is open. */
struct storage {
    const char *dir; /* Folder of the file; must outlive the store. Null: nothing is stored. */
    struct ledger_file_options how; /* Zero: defaults. With a custom vfs there is no backup. */
    uint8_t by_hand; /* 1: no thread is started; the caller calls storage_work() instead. */
    struct storage_chore chore;

    struct ledger_file file;     /* Used only by the thread while the thread runs. */
    struct ledger_content start; /* Content of the file at open(). */
    char path[STORAGE_PATH_SIZE];
    char text[HAL_TEXT_SIZE];

    pthread_t thread;
    sem_t wake;
    bool running; /* 1 between open() and close(). */
    bool has_thread;
    bool closes; /* 1 while close() runs: no new backup is started. */
    atomic_bool stop;
    atomic_bool has_file; /* The database was opened at least once, so that entries are accepted. */
    bool has_to_rebuild;  /* The file is damaged or missing and has not been replaced yet. */
    atomic_uint aside;    /* Number of the quarantined file; 0: none. */
    atomic_uint strange;  /* Index + 1 in storage_suffixes of a file that was renamed because it was
                             no regular file; 0: none. */
    bool was_missing;     /* 1: the replaced file was missing; 0: it was damaged. */
    uint32_t from_backup; /* Newest entry id in the backup that replaced a file. */
    struct ledger_recovered salvaged; /* Newer entries recovered from the damaged file and the
                                         mirror. */
    atomic_int error;      /* SQLite code of the last failed write; 0: the last write succeeded. */
    atomic_int edit_error; /* errno of the last failed edit; 0: the last write of an edit
                              succeeded. */
    atomic_uint refused;   /* Failed writes, including retries. */
    atomic_llong busy_since_ms; /* Start of the current write on the monotonic clock; 0: no write
                                   runs. */

    /* Queue of entries with one producer (the frame loop) and one consumer (the thread). Both
     * indexes only increase. */
    struct ledger_entry queue[STORAGE_QUEUE_MAX];
    atomic_uint pushed, written;
    /* Queue of edits from the growth lab. Each edit becomes a text file (graph_file.h). */
    struct graph_edit_record edits[STORAGE_EDITS_MAX];
    atomic_uint edits_pushed, edits_written;
    uint32_t accepted_edit_id;
    atomic_uint stored_edit_id;

    int hold;             /* Handle of the locked folder + 1, which excludes other kiosk processes;
                             0: not locked. */
    uint32_t accepted_id; /* Newest id that keep() accepted, so that a repeated call stores the
                             entry once. */
    atomic_uint saved_id;
    atomic_bool is_unproven; /* 1: the log that was read may not be on disk. Then saved_id() returns
                                0 and the store is reported as unhealthy. */
    uint32_t saved_boot, saved_tick; /* Boot and tick of the entry `saved_id`. Used by the thread
                                        only. */
    uint64_t sight;       /* Hash of the file attributes at the last attempt to open. Used by the
                             thread only. */
    uint64_t room;        /* Free bytes on the card at the last attempt to open. Used by the
                             thread only. */
    int64_t look_due_ms;  /* Time of the next attempt, monotonic; 0: at once. Used by the thread
                             only. */
    int64_t look_wait_ms; /* Interval to the next attempt. Used by the thread only. */
    struct storage_place places[STORAGE_PLACES]; /* Used by the thread only. */
    bool moved;  /* The open file is no longer at its path. Used by the thread only. */
    bool prunes; /* Entries, rounds or replays may exceed their limits, and must be deleted
                    (ledger_file_prune()). Used by the thread only. */
    struct ledger_mirror tail;   /* Ledger mirror: a second copy of the newest entries. Used by
                                    the thread only. */
    uint32_t tail_from;          /* First entry id that the mirror lacks; 0: none. Used by the
                                    thread only. */
    atomic_int tail_error;       /* errno of the last mirror write; 0: the write succeeded. */
    struct ledger_backup backup; /* Backup in progress. Used by the thread only. */
    uint32_t backup_id;          /* Newest entry id when the last backup started. */
    int64_t backup_due_s;        /* Time of the next backup on the monotonic clock. */

    struct offline_credits late;
    struct storage_replay put, get;
    int64_t put_since_ms; /* Time of the first rejection of the replay; 0: none. */
    atomic_uint put_id;   /* Round id of the newest replay that was written or given up. */
    atomic_int got;       /* Return value of replay_fetched(). */
    atomic_uint sealed[STORAGE_RANKS]; /* Ranked rounds whose replay is on disk; 0: none. */
};

/* Returns the device of `storage`, which must outlive the device. open() may block on the disk
 * once, before the first frame. close() may block for about four seconds if another program locks
 * the file. */
struct hal_storage storage_device(struct storage *storage);

/* Does all pending work of the thread on the caller's thread. Call only if `by_hand` is set. */
void storage_work(struct storage *storage);

#endif
