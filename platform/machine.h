/* machine.h -- how the machine below the stall is: whether its card keeps what is written, how much
 * room there is, how old the backup is, how hot it runs, what was set aside.
 *
 * A thread of its own looks every few seconds, since a card or a sensor may take long to answer,
 * which no frame waits for. It writes nothing but the marks of what the operator acknowledged. */
#ifndef KINGYO_PLATFORM_MACHINE_H
#define KINGYO_PLATFORM_MACHINE_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/scene_machine.h"

#define MACHINE_LOOK_S 5u
#define MACHINE_CHECKED "/run/kingyo-data" /* Where board/kiosk/check-data says what it found. */
#define MACHINE_CLOCK_SLACK_S 7200  /* A file of the future by less than this is summer time. */
#define MACHINE_ASIDE_MAX 64u       /* Of a folder with more the rest is not counted. */

/* The caller owns it, sets the first three, and leaves the rest zero. It stays at its address while
 * it runs. */
struct machine {
    const char *data;    /* The store's folder; null or "": there is none. */
    const char *checked; /* Null: MACHINE_CHECKED. */
    const char *heat;    /* Null: /sys/class/thermal. */

    pthread_t thread;
    bool runs;
    pthread_mutex_t lock; /* Of what stands below. The frame loop only tries it. */
    pthread_cond_t bell;
    bool ends, acknowledges;
    struct scene_machine newest;

    /* The looker's own. */
    int64_t written_s;   /* When the newest file was written as it first looked; 0: none was. */
    struct { uint64_t inode; int64_t mtime_s; long mtime_ns; } backup; /* That it saw last. */
    int64_t backup_s;    /* When that was made, on the monotonic clock. */
    bool has_begun;
};

/* Looks once, on the caller's own thread: all but `watch` and `missed`, which it leaves alone. */
void machine_look(struct machine *machine, struct scene_machine *out);

/* Marks what was set aside so far as acknowledged; 0, or a negative errno of the last that could
 * not be. */
int machine_mark_seen(const struct machine *machine);

/* What the store has set aside, and an operator should know of. */
enum machine_aside {
    MACHINE_ASIDE_NOT = 0, /* Something else: a journal of one, a mark, somebody's file. */
    MACHINE_ASIDE_DAMAGED, /* "kingyo.db.damaged-3": a database, */
    MACHINE_ASIDE_MISSING, /* "kingyo.db.missing-3": the note that there was none, */
    MACHINE_ASIDE_LEFT,    /* "kingyo.db.left-out-3": a copy from before a part was left out, */
    MACHINE_ASIDE_OTHER,   /* "kingyo.db.tail.other-3": what was of another list. */
};
enum machine_aside machine_aside_of(const char *file);

/* Whether it was acknowledged. */
bool machine_is_seen(const char *folder, const char *file);

/* Begins to look. Where no thread is to be had nothing is known. */
void machine_start(struct machine *machine);
void machine_stop(struct machine *machine);

/* The newest look, in all but `watch` and `missed`. While one is being copied, `out` stays as it
 * is. Never waits. */
void machine_read(struct machine *machine, struct scene_machine *out);

/* The operator has seen what was set aside: the thread marks it. Never waits; false: not taken,
 * ask again. */
bool machine_acknowledge(struct machine *machine);

#endif
