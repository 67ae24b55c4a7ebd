/* tape.h -- writes down what a program does to one folder: each write, cut, sync, new name.
 *
 * The test program defines libc's own file functions (tape.c), so that SQLite's default file system
 * layer and our code both go through them; they do what was asked, and note it. Syncs are only
 * noted. Between them lie marks: what the frame loop handed over, and what it was told is safe. */
#ifndef KINGYO_TESTS_POWER_TAPE_H
#define KINGYO_TESTS_POWER_TAPE_H

#include <stddef.h>
#include <stdint.h>

#include "tests/power/fault.h"

#define TAPE_NAME_SIZE 64u
#define TAPE_NAMES_MAX 64u

enum tape_kind {
    TAPE_CREATE,      /* `name` is a new, empty file. */
    TAPE_WRITE,       /* `size` bytes from `at` into `file` at `offset`. */
    TAPE_TRUNCATE,    /* `file` is `offset` bytes long. */
    TAPE_SYNC,        /* Of `file`. */
    TAPE_SYNC_FAILED, /* Of `file`, too: its dirty pages count as clean now (disk.h). */
    TAPE_SYNC_FOLDER, /* The names in folder `name`; "" is the watched folder itself. */
    TAPE_RENAME,      /* `name` is called `to`. */
    TAPE_UNLINK,      /* `name` goes. */
    TAPE_KEPT,        /* The ledger's entry `offset` was handed over. */
    TAPE_ACKED,       /* The frame loop was told that it is safe. */
    TAPE_REPLAY_ACKED, /* The same of the replay of round `offset`. */
    TAPE_EDIT_KEPT,   /* Graph number `offset` was handed over ... */
    TAPE_EDIT_ACKED,  /* ... and reported as safe. */
    TAPE_TICKET,      /* The pulse of ticket `offset` began at the dispenser. */
    TAPE_KIND_COUNT,
};

struct tape_op {
    uint8_t kind;    /* enum tape_kind */
    uint32_t file;   /* From 1, in the order of their making. */
    uint32_t size;
    uint64_t offset;
    size_t at;       /* In the tape's bytes. */
    char name[TAPE_NAME_SIZE], to[TAPE_NAME_SIZE];
};

struct tape {
    struct tape_op *ops;
    uint8_t *bytes;
    size_t count, room, used, bytes_room;
    uint32_t files;
    struct { char name[TAPE_NAME_SIZE]; uint32_t file; } names[TAPE_NAMES_MAX]; /* As they are. */
};

/* From now on what happens in `folder` and in folders within is noted on `tape`, which is zero or
 * was ended. Files that are there already are numbered first, in the order of `first`. One tape at
 * a time. */
void tape_begin(struct tape *tape, const char *folder, const char (*first)[TAPE_NAME_SIZE],
                uint32_t first_count);
/* Where no tape runs, nothing is noted. */
void tape_mark(enum tape_kind kind, uint32_t id);
void tape_end(void);
/* Goes on with a tape that another process began: what lies in `folder` is as the tape says. */
void tape_go_on(struct tape *tape, const char *folder);
void tape_free(struct tape *tape);

/* While a tape runs, each sync takes so long: a card. 0 at first. */
void tape_sync_us(uint32_t us);

/* While a tape runs, each write of the watched folder fails so (ENOSPC, EROFS); 0: none. A log's
 * index lies in memory: only ENOSPC concerns it. */
void tape_refuse(int error);

/* Called with each write to a file that is not in the watched folder; null at first. Returns 0, or
 * the errno with which the write fails. */
extern int (*tape_other_write)(const void *bytes, size_t size);

/* The errno with which a call has to fail now (fault.h), or 0. */
int tape_strikes(enum fault_call call);

/* While dead, a program changes nothing in the watched folder any more: each call that would fails
 * with EIO. The files stay as SIGKILL would leave them, though the program closes its handles. */
void tape_be_dead(int is_dead);

/* From now on syncs are not noted: a card that lies, or a store that never asks. */
void tape_be_deaf(void);

#endif
