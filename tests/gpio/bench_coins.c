/* bench_coins.c -- checks that the GPIO driver counts a million simulated coins correctly, in spite
 * of contact bounce, electrical sparks and frames of random length.
 *
 * Usage: bench_coins [COINS] [TSV]. Each of the two kernel interfaces gets half of the coins.
 *
 * Returns exit status 1 if a coin was lost, was counted twice, or was counted before its pulse
 * ended. The exit status is also 1 if too few faults were reported: each jam (long pulse) and nine
 * of ten knocks (short pulses) must be reported as a fault. A few knocks may be missed, because a
 * knock looks like a spark if the kernel reads the line late. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "core/base/panic.h"
#include "tests/gpio/coin_rain.h"

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "bench_coins: %s:%d: %s\n", file, line, condition);
    abort();
}

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static int report(const char *name, const struct rain_result *result, double took_s, FILE *tsv)
{
    const long difference = (long)result->counted - (long)result->coins;
    printf("%s: %u coins, %u counted (%ld lost, %ld doubled), %u counted too early, %u too late\n",
           name, result->coins, result->counted, difference < 0 ? -difference : 0,
           difference > 0 ? difference : 0, result->early, result->late);
    printf(
        "  %u knocks and %u jams, %u pairs of sparks; %u faults reported, %u of them of sparks\n",
        result->knocks, result->jams, result->sparks, result->faults, result->doubtful);
    printf("  %llu edges, %u dropped by the queue, %u read late\n",
           (unsigned long long)result->edges, result->dropped, result->blinks);
    printf("  %.1f days of the slot in %.1f s; %u looks, frames up to %.2f s, stalls up to %.0f "
           "ms\n",
           (double)result->time_ns * 1e-9 / 86400.0, took_s, result->looks,
           (double)result->longest_frame_ns * 1e-9, (double)result->longest_stall_ns * 1e-6);
    if (tsv) {
        fprintf(tsv, "%s\t%u\t%u\t%u\t%u\t%u\t%u\t%u\t%u\n", name, result->coins, result->counted,
                result->knocks, result->jams, result->sparks, result->faults, result->doubtful,
                result->dropped);
    }
    return difference == 0 && result->early == 0 && result->late == 0 &&
           result->faults - result->doubtful >=
               result->jams + result->knocks - result->knocks / 10u;
}

int main(int argc, char **argv)
{
    const unsigned long coins = argc > 1 ? strtoul(argv[1], NULL, 10) : 1000000ul;
    FILE *tsv = argc > 2 ? fopen(argv[2], "w") : NULL;
    int holds = 1;
    if (coins < 2 || coins > UINT32_MAX) {
        fputs("bench_coins: COINS is a number from 2 on\n", stderr);
        return 2;
    }
    if (tsv) {
        fputs("interface\tcoins\tcounted\tknocks\tjams\tspark_pairs\tfaults\tdoubtful\t"
              "dropped_edges\n",
              tsv);
    }
    for (uint8_t second = 0; second < 2; second++) {
        const struct rain_config config = {
            .coins = (uint32_t)(coins / 2u),
            .seed = 20050601u + second,
            .is_second = second,
        };
        const double begin_s = now_s();
        const struct rain_result result = coin_rain(&config);
        holds &= report(second ? "libgpiod 2.x" : "libgpiod 1.6", &result, now_s() - begin_s, tsv);
    }
    if (tsv) {
        fclose(tsv);
    }
    puts(holds ? "coins: none lost, none doubled" : "coins: NOT all of them right");
    return holds ? 0 : 1;
}
