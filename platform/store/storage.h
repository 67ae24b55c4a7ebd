/* storage.h -- the store: an SQLite database with the ledger (platform/store/sqlite/ledger_file.h).
 * The ledger is the append-only list of money events and rounds. A separate thread writes the
 * database.
 *
 * The frame loop never blocks on the memory card that contains the database's folder. append()
 * copies an entry into a queue of STORAGE_QUEUE_MAX entries and returns. The store's thread writes
 * and syncs all queued entries in one transaction. Afterwards committed_id() returns the id of the
 * newest entry. After a failed sync, an entry counts as saved only when its bytes were written
 * again and synced, in the database (platform/store/sqlite/ledger_file.c) and in the ledger mirror.
 * The ledger mirror is a second copy of the newest entries.
 *
 * If the card is slow, full, busy, read-only or absent, the write is retried once per second while
 * the queue fills. An unusable database file is read completely at each attempt to open it, so the
 * attempts become rarer, down to one per minute (storage_card.c). When the queue is full, append()
 * returns HAL_ERR_BUSY, and the core keeps the entries in its output. If the card is full at
 * program start, the store only reads the database until the card has free space. Each failed write
 * is counted. close() tries once more and returns the number of lost entries.
 *
 * The database is copied to a backup file in the same folder: at program start, every hour, and
 * after STORAGE_BACKUP_ENTRIES entries. The backup is validated before it replaces the previous
 * backup. Entries that are newer than the backup are stored twice, in the database and in the
 * ledger mirror (platform/store/sqlite/ledger_recovery.h).
 *
 * A damaged database is renamed (quarantined). The store never repairs a damaged database in place
 * and never deletes it. The replacement consists of the backup and of all later entries that can be
 * read from the damaged database or the ledger mirror. A missing database is replaced in the same
 * way, and an empty marker file records the loss. If the card has no space for the replacement, all
 * files stay unchanged and are only read.
 *
 * The open database or its folder may be removed, renamed, replaced or mounted over. The store
 * detects each of these events within one second (storage_card.c). Afterwards no entry counts as
 * saved until the file is back.
 *
 * Edits of the growth lab become text files in the same folder. Edits are stored even if the
 * database cannot be opened. */
#pragma once

#include <pthread.h>
#include <semaphore.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/persistent_state.h"
#include "platform/hal.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/sqlite/ledger_recovery.h"

#define STORAGE_BACKUP_SUFFIX ".backup"
#define STORAGE_MIRROR_SUFFIX ".tail"
/* Suffix of the complete replacement of a damaged or missing database, until the replacement is
 * renamed to STORAGE_FILE. */
#define STORAGE_NEW_SUFFIX ".new"
/* Suffix of an old backup that is kept when the operator restores a copy of the database. The old
 * backup belongs to the replaced database. */
#define STORAGE_BEFORE_SUFFIX ".before-restore"
/* Suffix of the replaced database, which is kept when the operator restores a copy. A number
 * follows the suffix. */
#define STORAGE_REPLACED_SUFFIX ".before-"
/* Suffix of a damaged database that is kept but no longer used (quarantined). A number follows the
 * suffix. */
#define STORAGE_QUARANTINE_SUFFIX ".damaged-"
/* Suffix of the empty marker file that records that the database was missing. A number follows the
 * suffix. */
#define STORAGE_MISSING_SUFFIX ".missing-"
/* Suffix of a quarantined backup or ledger mirror that belongs to a foreign ledger. A number
 * follows the suffix. */
#define STORAGE_OTHER_SUFFIX ".other-"
/* Suffix of the empty marker file that records that the operator has acknowledged a quarantined
 * file. The suffix follows the full name of the quarantined file. */
#define STORAGE_SEEN_SUFFIX ".seen"
/* Time in milliseconds after which a blocked write makes the store unhealthy. Good memory cards
 * pause for at most one second. */
#define STORAGE_STUCK_MS 3000
/* STORAGE_RETRY_MS is the shortest and STORAGE_RETRY_MS_MAX the longest interval in milliseconds
 * between two attempts to open an unusable file, which is read completely each time. The interval
 * doubles after each attempt. */
#define STORAGE_RETRY_MS 1000
#define STORAGE_RETRY_MS_MAX 60000
/* Increase of the free space in bytes after which the store writes to a full memory card again
 * before the retry interval ends. A smaller increase is ignored because other programs also write
 * to the card. */
#define STORAGE_ROOM_MORE (256u * 1024u)
#define STORAGE_BACKUP_S 3600 /* Maximum interval between two backups in seconds. */
/* Number of new entries after which a backup is made, even if less than STORAGE_BACKUP_S has
 * passed. */
#define STORAGE_BACKUP_ENTRIES (LEDGER_MIRROR_SLOTS / 2u)
/* Capacity of the queue of ledger entries: twice the number of unwritten entries that the core can
 * hold. While the memory card responds, the queue is therefore never full. */
#define STORAGE_QUEUE_MAX (2u * LEDGER_RING)
/* Capacity of the queue of growth-lab edits. The operator's menu permits far fewer than four edits
 * per second. */
#define STORAGE_EDITS_MAX 4u
/* Time in milliseconds after which the store stops trying to write a replay that the memory card
 * rejects. */
#define STORAGE_REPLAY_MS 10000
/* Maximum memory of SQLite in bytes. The highest measured use was 4.2 MiB, with 100,000 entries, a
 * backup, and a replay of maximum length (SESSION_RECORDER_SIZE) for each ranked round. */
#define STORAGE_HEAP_MAX (8 * 1024 * 1024)

/* States of a request to write or read a replay. The frame loop first sets all other fields of the
 * request, and then sets `state` to STORAGE_REPLAY_WAITS. The store's thread sets `state` to
 * STORAGE_REPLAY_IDLE when the request is complete. */
enum storage_replay_state { STORAGE_REPLAY_IDLE = 0, STORAGE_REPLAY_WAITS };
struct storage_replay {
    uint32_t round_id;
    /* Bytes to write. The caller must not change the bytes until the request is complete. */
    const uint8_t *bytes;
    /* Buffer that receives the bytes of the replay. The buffer must stay valid until the request is
     * complete. */
    uint8_t *room;
    size_t size;
    struct ledger_entry *round; /* Destination for the ledger entry of the round. */
    atomic_int state;           /* State of the request (enum storage_replay_state). */
};

/* Maximum number of entries in one transfer: one for each coin line and each kind of credit. */
#define OFFLINE_CREDITS_MAX 16u

/* Number of monitored files: the database, its write-ahead log (-wal) and the index of the log
 * (-shm). */
#define STORAGE_PLACES 3u

/* Device and inode of a monitored file, taken when the store first found the file at its path. A
 * structure of zeros means that the file has not existed yet. */
struct storage_place {
    uint64_t device, inode;
};

/* States of a transfer of offline credits. Offline credits are coins and credits that the kiosk
 * received before a database was available. */
enum offline_credits_state {
    OFFLINE_CREDITS_NONE = 0,
    OFFLINE_CREDITS_NEW,
    OFFLINE_CREDITS_PENDING
};
struct offline_credits {
    struct ledger_entry entries[OFFLINE_CREDITS_MAX];
    uint32_t count;
    /* Boot number that the transferred entries get in the database. 0 means not yet assigned. */
    uint32_t boot;
    struct balance_change step; /* Change that the transfer makes to the database's balance. */
    /* State of the transfer (enum offline_credits_state). The store's thread handles
     * OFFLINE_CREDITS_NEW immediately. */
    atomic_int state;
};

/* Background work on the open database that has no deadline. The store's thread calls `step`
 * repeatedly, for at most STORAGE_CHORE_MS milliseconds in one period. The thread calls `step` only
 * while no entry waits and the last write succeeded. One call takes at most a few milliseconds.
 * `step` returns SQLITE_OK if work is left, SQLITE_DONE if no work is left, or the code of a failed
 * write. After a failed write, the next call of `step` must continue with another part of the work.
 * A null `step` means no work. */
struct storage_chore {
    int (*step)(void *self, struct ledger_file *file);
    void *self;
};
#define STORAGE_CHORE_MS 10
/* Interval between two periods of background work, in milliseconds. */
#define STORAGE_CHORE_WAIT_MS 40

/* State of the store. The caller owns the structure, sets `dir`, `how`, `without_thread` and
 * `chore`, and clears the other fields. The address of the structure must not change while the
 * store is open. */
struct storage {
    /* Folder of the database. Must outlive the store. Null means that nothing is stored. */
    const char *dir;
    /* Options for opening the database. A structure of zeros means the defaults. With a custom vfs
     * no backup is made. */
    struct ledger_file_options how;
    /* True if no thread is started and the caller calls storage_work() instead. */
    bool without_thread;
    struct storage_chore chore;

    /* Open database. While the store's thread runs, only the store's thread uses the database. */
    struct ledger_file file;
    struct ledger_content start; /* Content of the database when open() read it. */
    char path[STORAGE_PATH_SIZE];
    char text[HAL_TEXT_SIZE];

    pthread_t thread;
    sem_t wake;
    bool running; /* True from open() to close(). */
    bool has_thread;
    bool closes; /* True while close() runs, so that no new backup is started. */
    atomic_bool stop;
    /* True if the database was opened at least once. Entries are accepted only then. */
    atomic_bool has_file;
    /* True if the database is damaged or missing and has not been replaced yet. */
    bool has_to_rebuild;
    /* Number at the end of the quarantined database's file name. 0 means that no database was
     * quarantined. */
    atomic_uint quarantined;
    /* Identifies the FIFO, device, link or folder that was renamed last because it had the name of
     * a database file. The value is 1 plus the index of the name's suffix in storage_suffixes. 0
     * means that no object was renamed. */
    atomic_uint strange;
    bool was_missing;     /* True if the replaced database was missing; false if it was damaged. */
    uint32_t from_backup; /* Newest entry id in the backup from which the replacement was made. */
    /* Entries newer than the backup that were recovered from the damaged database and the ledger
     * mirror. */
    struct ledger_recovered salvaged;
    /* SQLite code of the last write. 0 means that the write succeeded. */
    atomic_int error;
    /* errno of the last write of an edit. 0 means that the write succeeded. */
    atomic_int edit_error;
    atomic_uint refused; /* Number of failed writes, including retries. */
    /* Start time of the current write on the monotonic clock. 0 means that no write is in
     * progress. */
    atomic_llong busy_since_ms;

    /* Queue of ledger entries with one producer (the frame loop) and one consumer (the store's
     * thread). `pushed` and `written` only increase. */
    struct ledger_entry queue[STORAGE_QUEUE_MAX];
    atomic_uint pushed, written;
    /* Queue of graph edits of the growth lab, in which growth curves of the fish are edited. Each
     * edit becomes a text file (graph_file.h). */
    struct graph_edit_record edits[STORAGE_EDITS_MAX];
    atomic_uint edits_pushed, edits_written;
    uint32_t accepted_edit_id;
    atomic_uint stored_edit_id;

    /* Descriptor of the locked folder plus 1. The lock excludes other kiosk processes. 0 means not
     * locked. */
    int hold;
    /* Newest entry id that append() has accepted. append() ignores an entry whose id is not
     * newer. */
    uint32_t accepted_id;
    atomic_uint saved_id;
    /* True if the store has read the write-ahead log, but the log may not be on disk.
     * committed_id() then returns 0 and the store counts as unhealthy. */
    atomic_bool is_unproven;
    /* Boot number and tick of the entry `saved_id`. Used by the store's thread only. */
    uint32_t saved_boot, saved_tick;
    /* Hash of the database file's attributes at the last attempt to open the database. Used by the
     * store's thread only. */
    uint64_t sight;
    /* Free bytes on the memory card at the last attempt to open the database. Used by the store's
     * thread only. */
    uint64_t room;
    /* Time of the next attempt to open the database, on the monotonic clock. 0 means immediately.
     * Used by the store's thread only. */
    int64_t retry_due_ms;
    /* Current interval between two attempts to open the database. Used by the store's thread
     * only. */
    int64_t retry_wait_ms;
    /* Identities of the database, its log and the log's index. Used by the store's thread only. */
    struct storage_place places[STORAGE_PLACES];
    /* True if the open database is no longer at its path. Used by the store's thread only. */
    bool moved;
    /* True if entries, rounds or replays may exceed their limits. ledger_file_prune() must then
     * delete the excess. Used by the store's thread only. */
    bool prunes;
    /* Ledger mirror, the second copy of the newest entries. Used by the store's thread only. */
    struct ledger_mirror tail;
    /* First entry id that the ledger mirror lacks. 0 means that the mirror is complete. Used by the
     * store's thread only. */
    uint32_t tail_from;
    /* errno of the last write to the ledger mirror. 0 means that the write succeeded. */
    atomic_int tail_error;
    /* State of the backup that is in progress. Used by the store's thread only. */
    struct ledger_backup backup;
    uint32_t backup_id;   /* Newest entry id when the last backup was started. */
    int64_t backup_due_s; /* Time of the next backup on the monotonic clock. */

    struct offline_credits late;
    struct storage_replay put, get;
    /* Time when the memory card first rejected the requested replay. 0 means that the card has not
     * rejected the replay. */
    int64_t put_since_ms;
    /* Round id of the newest replay that was written, or that was abandoned because the memory card
     * rejected it. */
    atomic_uint put_id;
    /* Result of the last read of a replay. fetched() returns this result when the request is
     * complete. */
    atomic_int got;
    /* Round id of each ranking row whose replay is on disk. 0 means that the row has no replay on
     * disk. */
    atomic_uint sealed[LEDGER_RANKS];
};

/* Returns the HAL device that uses `storage`. `storage` must outlive the returned device. open()
 * may block on the disk once, before the first frame. close() may block for about four seconds if
 * another program locks the database. */
struct hal_storage storage_device(struct storage *storage);

/* Does all pending work of the store's thread on the calling thread. The caller must have set
 * `without_thread`. */
void storage_work(struct storage *storage);
