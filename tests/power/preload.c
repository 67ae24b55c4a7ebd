/* preload.c -- a library that is loaded into a real kiosk before libc (LD_PRELOAD).
 *
 * The library makes file calls fail, records the operations in the data folder, inserts coins, and
 * kills the kiosk with SIGKILL. KINGYO_FAULT_DIR is the data folder, and KINGYO_FAULT_TAPE is the
 * file for the recorded operations (kiosk_tape.h). KINGYO_FAULT_SEED is the seed of the faults, the
 * coins and the time of the SIGKILL. If KINGYO_FAULT_SYNCS is set, every sync fails permanently
 * instead. The library reads the kiosk's status file to record which data are committed. */
#include <SDL2/SDL.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/base/rng.h"
#include "tests/power/kiosk_tape.h"

#define PLANS 3u
/* Number of rename() calls that a kiosk makes in its first seconds. All of them belong to its
 * backup of the database. */
#define RENAMES 2u
#define STATUS_MAX 65536u

static struct kiosk_tape *map;
static uint64_t seed;
static uint32_t draws;
static atomic_int runs; /* 1 from the time at which the kiosk first writes a status file. */

static uint32_t draw(uint32_t below)
{
    return rng_u32((struct rng_key){ (uint32_t)seed, draws++, 99u, RNG_TEST }) % below;
}

/* ---- Reading the status file of the kiosk --------------------------------------------------- */

/* Reads the text that the kiosk writes to its status file. This file is outside the data folder.
 * Returns the errno with which the write must fail, or 0. */
static int read_status(const void *bytes, size_t size)
{
    static const char saved[] = "\"saved_id\": ", refused[] = "\"store\": {\"well\": false";
    const char *at = memmem(bytes, size, saved, sizeof saved - 1u);
    const int error = at ? tape_planned_errno(FAULT_WRITE) : 0;
    if (at && size < STATUS_MAX && !error) {
        tape_mark(TAPE_ACKED, (uint32_t)strtoul(at + sizeof saved - 1u, NULL, 10));
        map->refusals += memmem(bytes, size, refused, sizeof refused - 1u) != NULL;
        atomic_store(&runs, 1);
    }
    return error;
}

/* ---- Inserting coins and ending the kiosk --------------------------------------------------- */

static void wait_ms(uint32_t ms)
{
    nanosleep(&(struct timespec){ .tv_sec = ms / 1000u, .tv_nsec = ms % 1000u * 1000000L }, NULL);
}

static void press(int (*push)(SDL_Event *), SDL_Keycode code)
{
    SDL_Event event = { .type = SDL_KEYDOWN };
    event.key.keysym.sym = code;
    push(&event);
    wait_ms(60);
    event.type = SDL_KEYUP;
    push(&event);
}

static void *play(void *unused)
{
    int (*push)(SDL_Event *);
    *(void **)&push = dlsym(RTLD_DEFAULT, "SDL_PushEvent");
    while (push && !atomic_load(&runs)) {
        wait_ms(20);
    }
    const uint32_t keys = 8u + draw(16);
    for (uint32_t i = 0; push && i < keys; i++) {
        press(push, SDLK_5);
        map->coins++;
        if (draw(6) == 0) {
            press(push, SDLK_SPACE);
        }
        wait_ms(60u + draw(300));
    }
    wait_ms(draw(2000));
    kill(getpid(), SIGKILL);
    return unused;
}

/* ---- Starting the library ------------------------------------------------------------------- */

static void plan(void)
{
    struct fault_plan plans[PLANS];
    for (uint32_t i = 0; i < PLANS; i++) {
        plans[i] = fault_draw(seed, i);
        plans[i].first %= plans[i].calls == 1u << FAULT_RENAME ? RENAMES : UINT32_MAX;
    }
    if (getenv("KINGYO_FAULT_SYNCS")) {
        plans[0] = (struct fault_plan){ 1u << FAULT_FSYNC | 1u << FAULT_FDATASYNC, 0,
                                        FAULT_FOR_EVER, EIO };
    }
    fault_begin(plans, getenv("KINGYO_FAULT_SYNCS") ? 1u : PLANS);
}

__attribute__((constructor)) static void begin(void)
{
    const char *folder = getenv("KINGYO_FAULT_DIR"), *tape = getenv("KINGYO_FAULT_TAPE");
    const char *number = getenv("KINGYO_FAULT_SEED");
    pthread_t thread;
    map = folder && tape && number ? kiosk_tape_map(tape) : NULL;
    if (!map) {
        static const char why[] = "preload: KINGYO_FAULT_DIR, _TAPE and _SEED are needed\n";
        (void)!write(2, why, sizeof why - 1u);
        abort();
    }
    unsetenv("LD_PRELOAD");
    seed = strtoull(number, NULL, 10);
    fault_failed = map->failed;
    tape_other_write = read_status;
    if (map->tape.count > 0) {
        tape_resume(&map->tape, folder);
    } else {
        tape_begin(&map->tape, folder, NULL, 0);
    }
    plan();
    if (pthread_create(&thread, NULL, play, NULL) != 0) {
        abort();
    }
    pthread_detach(thread);
}
