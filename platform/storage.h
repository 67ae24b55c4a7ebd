/* storage.h -- the store of finished rounds: one SQLite file, written by its own thread.
 * Graphs from the growth lab go to texts beside it; they are kept, too, where that file cannot be.
 *
 * A frame never waits for a card: save() puts a record into one of STORAGE_QUEUE_MAX slots and
 * comes back, the thread writes and syncs it, and saved_id() then names it. A card that is slow,
 * full or busy is tried again each second while the slots fill; when they are full, save() says
 * HAL_ERR_BUSY and the core's record waits in its output. Each try that fails is counted.
 * close() tries once more and says how many rounds are lost for good. A damaged file is set
 * aside under a new name, never repaired in place and never deleted, and a fresh one begins. */
#ifndef KINGYO_PLATFORM_STORAGE_H
#define KINGYO_PLATFORM_STORAGE_H

#include <pthread.h>
#include <semaphore.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/memory.h"
#include "platform/hal.h"
#include "platform/score_file.h"

#define STORAGE_FILE "kingyo.db"
#define STORAGE_PATH_SIZE 512u
/* A round takes 10 s at least: 16 of them are minutes of a card that does not answer. */
#define STORAGE_QUEUE_MAX 16u
#define STORAGE_EDITS_MAX 4u /* Nobody edits and saves another graph each quarter of a second. */
/* All the memory that SQLite may ever have, in bytes; it needs about 0.3 MiB of it. */
#define STORAGE_HEAP_MAX (8 * 1024 * 1024)

/* The caller owns it, sets `dir` and leaves the rest zero. It stays at its address while open. */
struct storage {
    const char *dir;      /* Where the file lives; must outlive this. Null: nothing is kept. */

    struct score_file file; /* The thread's alone once it runs. */
    uint32_t best_today[MODE_COUNT]; /* As the file said at open(); bots do not count. */
    char path[STORAGE_PATH_SIZE];
    char set_aside[STORAGE_PATH_SIZE + 32]; /* Where a damaged file went; empty: none was. */
    char text[HAL_TEXT_SIZE];

    pthread_t thread;
    sem_t wake;
    bool running;         /* The thread. */
    bool has_file;        /* The database is open: rounds are taken. */
    atomic_bool stop;
    atomic_int error;     /* SQLite's last refusal to write; 0: the last write went well. */
    atomic_int edit_error; /* errno of the last graph that was refused; 0: the last went well. */
    atomic_uint refused;  /* Writes that failed, retries among them. */

    /* One writer (the frame loop) and one reader (the thread): indexes only grow. */
    struct storage_slot {
        struct round_record record;
        int64_t ended_s;  /* Unix time when save() took it. */
    } queue[STORAGE_QUEUE_MAX];
    atomic_uint pushed, written;
    /* Graphs from the growth lab, in a queue of their own: each becomes a text (edit_file.h). */
    struct edit_record edits[STORAGE_EDITS_MAX];
    atomic_uint edits_pushed, edits_written;
    uint32_t accepted_edit_id;
    atomic_uint kept_edit_id;

    uint32_t accepted_id; /* Newest id that save() took, so that asking twice keeps one. */
    atomic_uint saved_id;
};

/* open() may wait for the disk, once, before the first frame; close() for about four seconds, when
 * another program holds the file. */
struct hal_storage storage_device(struct storage *storage);

#endif
