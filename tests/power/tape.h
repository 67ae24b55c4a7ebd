/* tape.h -- records the file operations of a program in one folder: each write, truncation, sync
 * and name change.
 *
 * The test program itself defines the file functions of libc (tape.c), so SQLite and the project's
 * code call these definitions. Each call is recorded and executed, except that a sync is only
 * recorded. Between the operations, the test records marks: notes about which entries were passed
 * to the store, and which entries the store reported as committed. */
#ifndef KINGYO_TESTS_POWER_TAPE_H
#define KINGYO_TESTS_POWER_TAPE_H

#include <stddef.h>
#include <stdint.h>

#include "tests/power/fault.h"

#define TAPE_NAME_SIZE 64u
#define TAPE_NAMES_MAX 64u

enum tape_kind {
    TAPE_CREATE,   /* Operation that creates the empty file `name`. */
    TAPE_WRITE,    /* Operation that writes `size` bytes, stored at `bytes[at]` of the tape, to
                      `file` at `offset`. */
    TAPE_TRUNCATE, /* Operation that truncates or extends `file` to `offset` bytes. */
    TAPE_SYNC,     /* Syncs `file`. */
    /* Sync of `file` that failed. Unsynced data of the file may then be lost for ever (disk.h). */
    TAPE_SYNC_FAILED,
    TAPE_SYNC_FOLDER,  /* Sync of the names in the folder `name`. "" is the recorded folder
                          itself. */
    TAPE_RENAME,       /* Operation that renames `name` to `to`. */
    TAPE_UNLINK,       /* Deletes `name`. */
    TAPE_KEPT,         /* Note of the test (mark): ledger entry `offset` was passed to the
                          store. */
    TAPE_ACKED,        /* Note of the test (mark): the store reported ledger entry `offset` as
                          committed. */
    TAPE_REPLAY_ACKED, /* Note of the test (mark): the store reported the replay of round `offset`
                          as committed. */
    TAPE_EDIT_KEPT,    /* Note of the test (mark): morph graph number `offset` was passed to the
                          store. */
    TAPE_EDIT_ACKED,   /* Note of the test (mark): the store reported morph graph number `offset` as
                          committed. */
    TAPE_TICKET,       /* Note of the test (mark): the dispenser pulse of ticket number `offset`
                          began. */
    TAPE_KIND_COUNT,
};

struct tape_op {
    uint8_t kind;  /* Kind of the operation (enum tape_kind). */
    uint32_t file; /* Number of the file that the operation changes. Files are numbered from 1 in
                      the order of their creation. */
    uint32_t size;
    uint64_t offset;
    size_t at; /* Index of the first written byte in the array `bytes` of struct tape. */
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
    } names[TAPE_NAMES_MAX]; /* Names of the existing files, and the file number that each name
                                refers to. */
};

/* Starts to record the operations in `folder` and its subfolders on `tape`. `tape` must be zeroed
 * or ended. Files that exist already get the first file numbers, in the order of their names in
 * `first`. Only one tape can record at a time. */
void tape_begin(struct tape *tape, const char *folder, const char (*first)[TAPE_NAME_SIZE],
                uint32_t first_count);
/* Records a mark, which is a note of the test between two file operations (enum tape_kind). Does
 * nothing while no tape records. */
void tape_mark(enum tape_kind kind, uint32_t id);
/* Ends the recording. The recorded operations stay on the tape. */
void tape_end(void);
/* Continues to record on a tape that another process began. The files in `folder` must be the
 * result of the operations on the tape. */
void tape_resume(struct tape *tape, const char *folder);
/* Frees all memory of the tape. */
void tape_free(struct tape *tape);

/* Makes each sync take `us` microseconds while a tape records, as on a memory card. The default is
 * 0. */
void tape_sync_us(uint32_t us);

/* Makes each write in the recorded folder fail with `error` (ENOSPC or EROFS) while a tape records.
 * 0 ends the failures. Writes to SQLite's -shm file fail only with ENOSPC, because that file is
 * mapped into memory. */
void tape_fail_writes(int error);

/* Callback for each write to a file outside the recorded folder. The default is null. The callback
 * returns the errno with which the write must fail, or 0. */
extern int (*tape_other_write)(const void *bytes, size_t size);

/* Returns the errno with which a call of this kind must fail now according to the plans in fault.h,
 * or 0. */
int tape_planned_errno(enum fault_call call);

/* If `is_dead` is 1, each later call that would change the recorded folder fails with EIO. The
 * files then stay as after SIGKILL, although the program continues and closes its handles. */
void tape_set_dead(int is_dead);

/* Ends the recording of syncs, as if the card ignored syncs or the store never made one. */
void tape_ignore_syncs(void);

#endif
