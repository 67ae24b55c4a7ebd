/* bench_open.c -- benchmark of the longest tick: the tick that opens the tank of another game mode.
 *
 * The benchmark opens ROUNDS games with different seeds. In each game it measures the CPU time of
 * two ticks: the tick in which START opens the championship's tank, and the tick that returns to
 * attract mode and opens the festival's tank again. The benchmark prints the medians and maxima:
 * `open_ms open_max_ms back_ms back_max_ms`.
 *
 * A frame with such a tick may be late, because the picture changes completely anyway. The next
 * frame makes up the missing ticks (frame_pacer.h), so no tick is lost.
 *
 * Returns exit status 1 if a tick takes more than one frame. A processor with a quarter of this
 * machine's speed then needs at most four frames. Returns exit status 2 if no other tank was
 * opened. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/phases.h"
#include "platform/cpu.h"

#define ROUNDS 200u
#define BOUND_MS (1e3 / 60.0)

static struct core core;
static struct input input;
static struct output output;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    abort();
}

static double now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static double tick_ms(uint32_t pressed)
{
    const double began_ms = now_ms();
    input.pressed = pressed;
    if (core_tick(&core, &input, &output) != CORE_OK) {
        fputs("bench_open: " CPU_FLOAT_WRONG "\n", stderr);
        exit(70);
    }
    return now_ms() - began_ms;
}

/* Measures one game: the tick in which START opens the championship's tank, and the tick that
 * returns to attract mode and opens the festival's tank again. Returns 0, or -1 if the core or the
 * other tank could not be opened. */
static int measure(uint32_t seed, double *open_ms, double *back_ms)
{
    const struct core_config config = { .seed = seed,
                                        .modes = 1u << MODE_CHAMPIONSHIP,
                                        .lanes = cpu_lanes() };
    if (core_init(&core, &config) != CORE_OK) {
        return -1;
    }
    const uint8_t own = core.world.tank.preset;
    tick_ms(0);
    *open_ms = tick_ms(INPUT_START);
    if (core.world.tank.preset == own) {
        return -1;
    }
    const double began_ms = now_ms();
    attract_begin(&core.game, &core.world, &core.config);
    *back_ms = now_ms() - began_ms + tick_ms(0);
    return core.world.tank.preset == own ? 0 : -1;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(void)
{
    static double open_ms[ROUNDS], back_ms[ROUNDS];
    for (uint32_t i = 0; i < ROUNDS; i++) {
        if (measure(i, &open_ms[i], &back_ms[i])) {
            fprintf(stderr, "bench_open: seed %u: no other tank was opened\n", i);
            return 2;
        }
    }
    qsort(open_ms, ROUNDS, sizeof open_ms[0], compare);
    qsort(back_ms, ROUNDS, sizeof back_ms[0], compare);
    const double most_open_ms = open_ms[ROUNDS - 1u], most_back_ms = back_ms[ROUNDS - 1u];
    printf("%.1f %.1f %.1f %.1f\n", open_ms[ROUNDS / 2u], most_open_ms, back_ms[ROUNDS / 2u],
           most_back_ms);
    return most_open_ms < BOUND_MS && most_back_ms < BOUND_MS ? 0 : 1;
}
