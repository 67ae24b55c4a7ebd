/* bench_tank.c -- what a tick of the tank costs: one row a fish count, median and p99 of one
 * thread.
 *
 * Usage: bench_tank [TICKS]. Fish swim ten seconds first, so that the start's order is gone. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "core/base/panic.h"
#include "core/tank/tank.h"

#define TICKS_MAX 20000u
#define WARM_TICKS (10u * CORE_TICK_HZ)

static struct tank tank;
static double tick_us[TICKS_MAX];

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "bench_tank: %s:%d: %s\n", file, line, condition);
    abort();
}

static double now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e6 + (double)now.tv_nsec * 1e-3;
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static void bench(uint32_t fish_count, uint32_t ticks)
{
    tank_init(&tank, TANK_PRESET_FESTIVAL, fish_count, 1);
    for (uint32_t tick = 0; tick < WARM_TICKS + ticks; tick++) {
        const double start_us = now_us();
        tank_tick(&tank, tick, NULL, 0);
        if (tick >= WARM_TICKS) {
            tick_us[tick - WARM_TICKS] = now_us() - start_us;
        }
    }
    qsort(tick_us, ticks, sizeof tick_us[0], by_size);
    const double median_us = tick_us[ticks / 2u], p99_us = tick_us[ticks * 99u / 100u];
    printf("%6u fish  best %8.1f us  median %8.1f us  p99 %8.1f us  %7.1f ns a fish and tick\n",
           fish_count, tick_us[0], median_us, p99_us, 1000.0 * median_us / fish_count);
}

int main(int argc, char **argv)
{
    const long asked = argc > 1 ? strtol(argv[1], NULL, 10) : 2400;
    if (asked < 100 || asked > (long)TICKS_MAX) {
        fprintf(stderr, "bench_tank: TICKS must be 100 .. %u\n", TICKS_MAX);
        return 2;
    }
    static const uint32_t counts[] = { 50, 100, 300, 600 };
    for (uint32_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        bench(counts[i], (uint32_t)asked);
    }
    return 0;
}
