/* tape.h -- records the file operations of a program in one folder: each write, truncation, sync
 * and name change.
 *
 * The test program defines the file functions of libc itself (tape.c), so that SQLite and the
 * project's code call these functions. Each call is executed and recorded, except that syncs are
 * only recorded. Marks between the operations record which entries were passed to the store, and
 * which of them the store reported as committed. */
#ifndef KINGYO_TESTS_POWER_TAPE_H
#define KINGYO_TESTS_POWER_TAPE_H

#include <stddef.h>
#include <stdint.h>

#include "tests/power/fault.h"

#define TAPE_NAME_SIZE 64u
#define TAPE_NAMES_MAX 64u

enum tape_kind {
    TAPE_CREATE,   /* Creates the empty file `name`. */
    TAPE_WRITE,    /* Writes the `size` bytes at `bytes[at]` of the tape to `file` at `offset`. */
    TAPE_TRUNCATE, /* Truncates or extends `file` to `offset` bytes. */
    TAPE_SYNC,     /* Syncs `file`. */
    /* Failed sync of `file`. Unsynced data of the file may be lost for ever (disk.h). */
    TAPE_SYNC_FAILED,
    TAPE_SYNC_FOLDER,  /* Syncs the names in folder `name`; "" is the watched folder itself. */
    TAPE_RENAME,       /* Renames `name` to `to`. */
    TAPE_UNLINK,       /* Deletes `name`. */
    TAPE_KEPT,         /* Mark: ledger entry `offset` was passed to the store. */
    TAPE_ACKED,        /* Mark: ledger entry `offset` was reported as committed. */
    TAPE_REPLAY_ACKED, /* Mark: the replay of round `offset` was reported as committed. */
    TAPE_EDIT_KEPT,    /* Mark: graph number `offset` was passed to the store. */
    TAPE_EDIT_ACKED,   /* Mark: graph number `offset` was reported as committed. */
    TAPE_TICKET,       /* Mark: the dispenser pulse of ticket `offset` began. */
    TAPE_KIND_COUNT,
};

struct tape_op {
    uint8_t kind;  /* Kind of the operation (enum tape_kind). */
    uint32_t file; /* Number of the file. Files are numbered from 1 in the order of creation. */
    uint32_t size;
    uint64_t offset;
    size_t at; /* Position of the written bytes in `bytes` of struct tape. */
    char name[TAPE_NAME_SIZE], to[TAPE_NAME_SIZE];
};

struct tape {
    struct tape_op *ops;
    uint8_t *bytes;
    size_t count, room, used, bytes_room;
    uint32_t files;
    struct {
        char name[TAPE_NAME_SIZE];
        uint32_t file;
    } names[TAPE_NAMES_MAX]; /* Existing names and their file numbers. */
};

/* Starts to record the operations in `folder` and its subfolders on `tape`, which must be zeroed or
 * ended. Existing files get the first numbers, in the order of the names in `first`. Only one tape
 * can run at a time. */
void tape_begin(struct tape *tape, const char *folder, const char (*first)[TAPE_NAME_SIZE],
                uint32_t first_count);
/* Records a mark (a note of the test between two file operations, see enum tape_kind). Does nothing
 * if no tape runs. */
void tape_mark(enum tape_kind kind, uint32_t id);
/* Ends the recording. The tape keeps its operations. */
void tape_end(void);
/* Continues a tape that another process began. The content of `folder` must be the result of the
 * operations on the tape. */
void tape_go_on(struct tape *tape, const char *folder);
/* Frees the memory of the tape. */
void tape_free(struct tape *tape);

/* Makes each sync take `us` microseconds while a tape runs, as on a memory card. The initial value
 * is 0. */
void tape_sync_us(uint32_t us);

/* Makes each write in the watched folder fail with `error` (ENOSPC or EROFS) while a tape runs; 0
 * means no failure. Writes to SQLite's -shm file fail only with ENOSPC, because that file is mapped
 * into memory. */
void tape_refuse(int error);

/* Callback for each write to a file outside the watched folder; initially null. The callback
 * returns 0, or the errno with which the write must fail. */
extern int (*tape_other_write)(const void *bytes, size_t size);

/* Returns the errno with which a call of this kind must fail now (fault.h), or 0. */
int tape_strikes(enum fault_call call);

/* If `is_dead` is 1, each later call that would change the watched folder fails with EIO. The files
 * stay as after SIGKILL, although the program continues and closes its handles. */
void tape_be_dead(int is_dead);

/* Stops the recording of syncs. This simulates a card that ignores syncs, or a store that never
 * syncs. */
void tape_be_deaf(void);

#endif
