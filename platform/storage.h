/* storage.h -- the store: one SQLite file of the ledger (store/ledger_file.h), written by a thread
 * of its own. Graphs from the growth lab go to texts beside it; they are kept, too, where that file
 * cannot be.
 *
 * A frame never waits for a card: keep() puts an entry into one of STORAGE_QUEUE_MAX slots and
 * comes back, the thread writes and syncs all that wait in one transaction, and saved_id() then
 * names the newest. After a failed sync an entry is acknowledged only when its bytes were written
 * again and synced (store/ledger_log.c), in the database and in the tail. A card that is slow,
 * full, busy, read-only or away is tried again each second while the slots fill (one whose file has
 * to be read from end to end to see that nothing changed, less often: storage_card.c); when they
 * are full, keep() says HAL_ERR_BUSY and the core's entries wait in its output. A card that is full
 * at the start is read all the same, and written when it has room. Each try that fails is counted.
 * close() tries once more and says how many entries are lost for good.
 *
 * At the start, each hour and each STORAGE_BACKUP_ENTRIES entries the file is copied to a backup
 * beside it, which is checked before it takes the place of the last; entries since then are kept
 * twice (store/ledger_tail.h). A damaged file is set aside under a new name, never repaired in
 * place and never deleted; the backup takes its place, with all entries beyond it that the damaged
 * file or the tail still has. So it does where the file is gone, and a note says so. Where the card
 * has no room for that, all is left as it is and only read.
 *
 * A file or folder that is removed, renamed, replaced or mounted over while it is open is detected
 * within a second (storage_moved.c). Nothing is acknowledged until it is back. */
#ifndef KINGYO_PLATFORM_STORAGE_H
#define KINGYO_PLATFORM_STORAGE_H

#include <pthread.h>
#include <semaphore.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/memory.h"
#include "platform/hal.h"
#include "platform/store/ledger_backup.h"
#include "platform/store/ledger_salvage.h"

#define STORAGE_FILE "kingyo.db"
#define STORAGE_BACKUP_SUFFIX ".backup"
#define STORAGE_TAIL_SUFFIX ".tail"
#define STORAGE_NEW_SUFFIX ".new"       /* What takes a damaged file's place, until it does. */
#define STORAGE_BEFORE_SUFFIX ".before-restore" /* The backup of what a copy was put in place of. */
#define STORAGE_REPLACED_SUFFIX ".before-" /* And a number: what a copy was put in place of. */
#define STORAGE_ASIDE_SUFFIX ".damaged-" /* And a number. */
#define STORAGE_MISSING_SUFFIX ".missing-" /* And a number: an empty note that it was not there. */
#define STORAGE_OTHER_SUFFIX ".other-"  /* Behind a backup or tail of another list; and a number. */
#define STORAGE_LEFT_SUFFIX ".left-out-" /* And a number: a copy made by ledger_leave_out(). */
#define STORAGE_SEEN_SUFFIX ".seen"     /* Behind that: the operator has acknowledged it. */
#define STORAGE_STUCK_MS 3000 /* A card that writes for so long is not well: the best ones' worst
                                 pause to tidy up is a second. */
/* From one look through a file that is of no use to the next: it doubles from the first to the
 * second. */
#define STORAGE_LOOK_MS 1000
#define STORAGE_LOOK_MS_MAX 60000
/* Bytes by which a full card's room has to grow to be worth a look before its time: others write
 * there, too. */
#define STORAGE_ROOM_MORE (256u * 1024u)
#define STORAGE_BACKUP_S 3600 /* From one backup to the next, ... */
#define STORAGE_BACKUP_ENTRIES (LEDGER_TAIL_SLOTS / 2u) /* ... or sooner, after so many entries. */
#define STORAGE_PATH_SIZE 512u
/* What the core may have unwritten, twice: it never waits for a slot where a card answers. */
#define STORAGE_QUEUE_MAX (2u * LEDGER_RING)
#define STORAGE_EDITS_MAX 4u /* Nobody edits and saves another graph each quarter of a second. */
#define STORAGE_REPLAY_MS 10000 /* So long may a card that refuses a replay hold its bytes. */
/* All the memory that SQLite may ever have, in bytes. The most that it needed was 4.2 MiB: 100,000
 * entries, a backup, and a replay as long as they can be (CHAPTERS_SIZE) of each ranked round. */
#define STORAGE_HEAP_MAX (8 * 1024 * 1024)

#define STORAGE_RANKS (MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

/* A replay on its way to the card or from it: the frame loop sets the rest, then `state`; the
 * thread sets it back. */
enum storage_replay_state { STORAGE_REPLAY_IDLE = 0, STORAGE_REPLAY_WAITS };
struct storage_replay {
    uint32_t round_id;
    const uint8_t *bytes;  /* Lent while it waits: to be written, ... */
    uint8_t *room;         /* ... or to be filled. */
    size_t size;
    struct ledger_entry *round; /* The round's, to be filled. */
    atomic_int state;      /* enum storage_replay_state */
};

#define STORAGE_LATE_MAX 16u /* A coin's line each, and what became of them. */

#define STORAGE_PLACES 3u /* The file, its log, and the log's index. */

/* Where a file was first seen. Zero: it was not there yet. */
struct storage_place {
    uint64_t device, inode;
};

/* What a stall that began without a store was given: for a file that comes late. */
enum storage_late_state { STORAGE_LATE_NONE = 0, STORAGE_LATE_NEW, STORAGE_LATE_WAITS };
struct storage_late {
    struct ledger_entry entries[STORAGE_LATE_MAX];
    uint32_t count;
    uint32_t boot;       /* Under which that file has them; 0: it has none yet. */
    struct purse_step step; /* What its purse changes by. */
    atomic_int state;    /* enum storage_late_state: NEW is looked at at once. */
};

/* Work on the open file that is not urgent. The thread calls `step` for at most STORAGE_CHORE_MS in
 * a row, while no entry waits and the last write went well. `step` does a piece of at most a few
 * milliseconds and returns SQLITE_OK, SQLITE_DONE if nothing is left, or the result of a write that
 * failed, after which it goes on with another piece. Null: there is none. */
struct storage_chore {
    int (*step)(void *self, struct ledger_file *file);
    void *self;
};
#define STORAGE_CHORE_MS 10
#define STORAGE_CHORE_WAIT_MS 40 /* From one such row of steps to the next. */

/* The caller owns it, sets the first four and leaves the rest zero. It stays at its address while
 * open. */
struct storage {
    const char *dir;      /* Where the file lives; must outlive this. Null: nothing is kept. */
    struct ledger_file_how how; /* Zero: as usual. With a vfs there is no backup. */
    uint8_t by_hand;      /* 1: no thread; storage_work() does what it would do. */
    struct storage_chore chore;

    struct ledger_file file; /* The thread's alone once it runs. */
    struct ledger_content start; /* As the file said at open(). */
    char path[STORAGE_PATH_SIZE];
    char text[HAL_TEXT_SIZE];

    pthread_t thread;
    sem_t wake;
    bool running;         /* open() was called, and close() was not. */
    bool has_thread;
    bool closes;          /* No backup is begun any more. */
    atomic_bool stop;
    atomic_bool has_file; /* The database was opened: entries are taken. */
    bool has_to_rebuild;  /* The file is damaged or gone, and nothing took its place yet. */
    atomic_uint aside;    /* The number of a file that was replaced; 0: none was. */
    atomic_uint strange;  /* What was set aside since it was no regular file: the index among
                             storage_suffixes + 1; 0: nothing. */
    bool was_missing;     /* Then: it was not damaged but gone; */
    uint32_t from_backup; /* the newest entry of the backup, ... */
    struct ledger_salvaged salvaged; /* ... and what came later and was found. */
    atomic_int error;     /* SQLite's last refusal to write; 0: the last write went well. */
    atomic_int edit_error; /* errno of the last graph that was refused; 0: the last went well. */
    atomic_uint refused;  /* Writes that failed, retries among them. */
    atomic_llong busy_since_ms; /* Of the write that is under way, monotonic; 0: none is. */

    /* One writer (the frame loop) and one reader (the thread): indexes only grow. */
    struct ledger_entry queue[STORAGE_QUEUE_MAX];
    atomic_uint pushed, written;
    /* Graphs from the growth lab, in a queue of their own: each becomes a text (edit_file.h). */
    struct edit_record edits[STORAGE_EDITS_MAX];
    atomic_uint edits_pushed, edits_written;
    uint32_t accepted_edit_id;
    atomic_uint kept_edit_id;

    int hold;             /* The folder's handle + 1, which keeps other stalls out; 0: none. */
    uint32_t accepted_id; /* Newest id that keep() took, so that asking twice keeps one. */
    atomic_uint saved_id;
    atomic_bool is_unproven; /* The log that was read may not be on disk: nothing counts as saved,
                                and the store is not well. */
    uint32_t saved_boot, saved_tick; /* Of that entry; the thread's. */
    uint64_t sight;          /* What was seen from outside at the last look; the thread's, ... */
    uint64_t room;           /* ... as the bytes that were free, ... */
    int64_t look_due_ms;     /* ... as when the next is due, 0: at once, ... */
    int64_t look_wait_ms;    /* ... and how long it waits. */
    struct storage_place places[STORAGE_PLACES]; /* The thread's. */
    bool moved;              /* The open file is not at its path any more; the thread's. */
    bool prunes;                     /* Something may have fallen out; the thread's. */
    struct ledger_tail tail;         /* The newest entries once more; the thread's, ... */
    uint32_t tail_from;              /* ... as the first of them that it lacks; 0: none. */
    atomic_int tail_error;           /* errno of its last write; 0: that went well. */
    struct ledger_backup backup;     /* Under way; the thread's. */
    uint32_t backup_id;              /* The newest entry when it began. */
    int64_t backup_due_s;            /* On the monotonic clock. */

    struct storage_late late;
    struct storage_replay put, get;
    int64_t put_since_ms; /* When it was first refused; 0: it was not. */
    atomic_uint put_id;   /* The newest replay that was written, or given up. */
    atomic_int got;       /* As replay_fetched(). */
    atomic_uint sealed[STORAGE_RANKS]; /* Ranked rounds whose replay is on disk; 0: none. */
};

/* open() may wait for the disk, once, before the first frame; close() for about four seconds, when
 * another program holds the file. */
struct hal_storage storage_device(struct storage *storage);

/* All that the thread has to do now, on the caller's own; only where `by_hand` is set. */
void storage_work(struct storage *storage);

#endif
