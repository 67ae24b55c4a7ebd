/* bench_poi.c -- benchmark of one tick of the paper with five fish, of the whole poi, and of the
 * bowls.
 *
 * Usage: bench_poi [TSV]. The table is also written to the file TSV, with one figure in each row.
 *
 * Measures the CPU time of this thread for each tick, including the time to read the clock. Returns
 * exit status 1 if the median of the paper with five fish exceeds GOAL_US in its slowest state. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/catch.h"
#include "core/poi/paper/strain.h"
#include "core/tank/preset.h"
#include "tests/unit/support/open_tank.h"

#define SAMPLES 40000u
#define GOAL_US 60.0
#define FISH 5u
#define SEEDS 32u

static const struct sheet_wetting in_air = { 0.0f, 0.0f, -1.0f };
static double samples[SAMPLES];
static FILE *tsv;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "bench_poi: %s:%d: %s\n", file, line, condition);
    abort();
}

static double now_us(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec * 1e6 + (double)now.tv_nsec * 1e-3;
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* Prints one row: the median, the 99th percentile and the maximum of `count` times in `samples`.
 * Returns the median. */
static double report(const char *what, uint32_t count)
{
    if (count == 0) {
        printf("  %-58s nothing to measure\n", what);
        return 0.0;
    }
    qsort(samples, count, sizeof samples[0], by_size);
    const double median = samples[count / 2u], p99 = samples[count - 1u - count / 100u];
    printf("  %-58s %7.2f %7.2f %7.2f   %u\n", what, median, p99, samples[count - 1u], count);
    if (tsv) {
        fprintf(tsv, "%s\t%.3f\t%.3f\t%u\n", what, median, p99, count);
    }
    return median;
}

/* ---- The sheet ------------------------------------------------------------------------------ */

struct state {
    const char *what;
    float pressure_pa;
    /* Forces of the tail slap and of the body of each fish on the paper, in N. If `body_n` is 0, no
     * fish is on the paper. */
    float slap_n, body_n;
    uint8_t half_wet;
    /* 1 if only those ticks are measured in which a cell tears, otherwise 0. */
    uint8_t only_tearing;
};

static void lay(const struct state *state, uint32_t seed, struct sheet *sheet)
{
    sheet_init(sheet, 5, POI_RADIUS_M, seed);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const int is_dry = state->half_wet && cell % SHEET_SIDE >= SHEET_SIDE / 2u;
        sheet->wetness[cell] = is_dry ? 0.0f : 1.0f;
    }
    sheet->touched = 1;
    sheet->soaked = !state->half_wet;
}

/* Fills `loads` with the loads of FISH fish that lie side by side. Each fish has a body load and a
 * tail load. Returns the number of loads, which is 0 if no fish lies on the paper. */
static uint32_t load(const struct state *state, struct sheet_load loads[2u * FISH])
{
    if (state->body_n == 0.0f) {
        return 0;
    }
    for (uint32_t i = 0; i < FISH; i++) {
        const float x_m = 0.014f * ((float)i - 2.0f), z_m = i % 2u ? 0.012f : -0.012f;
        loads[i] = (struct sheet_load){ x_m, z_m, 0.003f, -state->slap_n };
        loads[FISH + i] = (struct sheet_load){ x_m, 0.0f, 0.020f, -state->body_n };
    }
    return 2u * FISH;
}

/* Measures the ticks of one state of the paper. When most of the paper is torn, the measurement
 * continues with a new sheet. */
static double measure(const struct state *state)
{
    static struct sheet sheet;
    struct sheet_load loads[2u * FISH];
    const uint32_t load_count = load(state, loads);
    uint32_t count = 0, seed = 0, idle = 0;
    lay(state, seed, &sheet);
    for (uint32_t tick = 0; tick < 8u * SAMPLES && count < SAMPLES; tick++) {
        const double start = now_us();
        const struct sheet_events events =
            sheet_tick(&sheet, state->pressure_pa, in_air, loads, load_count);
        samples[count] = now_us() - start;
        count += !state->only_tearing || events.cells_torn > 0;
        idle = events.cells_torn > 0 ? 0 : idle + 1u;
        if (sheet_left(&sheet) < 0.3f || (state->only_tearing && idle > 60u)) {
            lay(state, ++seed % SEEDS, &sheet);
            idle = 0;
        }
    }
    return report(state->what, count);
}

/* ---- The poi -------------------------------------------------------------------------------- */

static struct tank tank;
static struct poi poi;

/* Measures the ticks of a poi with five fish that is held above the water of the festival's tank.
 * The fish slap the paper as in the game. The measurement ends when a fish has left the paper, or
 * after 30 s. */
static double measure_poi(void)
{
    struct bowl bowl;
    const vec3 place = v3(0.0f, 0.08f, 0.0f);
    const struct stall stall = { &tank, &bowl, 1, false };
    open_tank(&tank, TANK_PRESET_FESTIVAL, 300, 1);
    bowl_init(&bowl, v3(0.30f, 0.02f, 0.15f));
    poi_init(&poi, 5, place, 1);
    poi.link = POI_SOURCE_LIVE;
    for (uint32_t i = 0; i < FISH; i++) {
        struct fish *fish = &tank.fish[i];
        fish_grow(fish, 0.04f, tank_behavior_params(&tank));
        fish->position_m = v3(0.010f * ((float)i - 2.0f), place.y + 0.006f, 0.0f);
        fish->velocity_m_s = v3(0.0f, 0.0f, 0.0f);
        fish->angles = (struct angles){ 0 };
    }
    const struct poi_grip grip = { .target.position_m = place, .has_wrist = 1 };
    uint32_t count = 0;
    for (uint32_t tick = 0; count < 30u * CORE_TICK_HZ; tick++) {
        struct output output = { 0 };
        struct catch_result caught[POI_MAX] = { 0 };
        const double start = now_us();
        poi_tick(&poi, &grip, &tank, &bowl);
        const struct obstacle ring = poi_obstacle(&poi);
        poi_apply_reaction(&poi, &ring);
        catch_tick(&poi, 0, &stall, tick, &output, caught);
        samples[count++] = now_us() - start;
        if (poi.carried_count < FISH) {
            break;
        }
    }
    return report("poi and catch: ring, paper, 5 real fish of 4 cm, 300 in tank", count);
}

/* ---- Carried fish and fish in bowls --------------------------------------------------------- */

/* Measures catch_tick() in the championship's tank with 1,000 fish. The poi does not move.
 * `carried_fish` is the number of fish on its paper at the start. */
static void measure_catch(uint32_t carried_fish, const char *what)
{
    struct bowl bowl;
    const struct stall stall = { &tank, &bowl, 1, false };
    struct catch_result caught[POI_MAX] = { 0 };
    open_tank(&tank, TANK_PRESET_OFFICIAL, 1000, 1);
    bowl_init(&bowl, tank_preset(TANK_PRESET_OFFICIAL)->bowl_m[0]);
    poi_init(&poi, 5, v3(0.0f, 0.08f, 0.0f), 1);
    for (uint32_t i = 0; i < carried_fish; i++) {
        const float x_m = 0.014f * ((float)(i % 4u) - 1.5f);
        const float z_m = 0.014f * ((float)(i / 4u) - 1.5f);
        tank.fish[i].gait = GAIT_HELD;
        poi.carried_fish[poi.carried_count++] = (struct carried_fish){
            .fish = (uint16_t)i, .side = 1, .x_m = x_m, .z_m = z_m, .lie = 1.0f, .rest_s = 1e3f
        };
    }
    for (uint32_t tick = 0; tick < 30u * CORE_TICK_HZ; tick++) {
        struct output output = { 0 };
        const double start = now_us();
        catch_tick(&poi, 0, &stall, tick, &output, caught);
        samples[tick] = now_us() - start;
    }
    report(what, 30u * CORE_TICK_HZ);
}

static void measure_bowls(uint32_t fish_count, const char *what)
{
    static struct bowl bowls[POI_MAX];
    const struct stall stall = { &tank, bowls, POI_MAX, false };
    const uint8_t live[POI_MAX] = { 1, 1, 1, 1 };
    static struct poi pois[POI_MAX];
    open_tank(&tank, TANK_PRESET_OFFICIAL, 1000, 1);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        bowl_init(&bowls[i], tank_preset(TANK_PRESET_OFFICIAL)->bowl_m[i]);
        poi_init(&pois[i], 5, v3_add(bowls[i].position_m, v3(0.0f, 0.05f, 0.0f)), i);
    }
    for (uint32_t i = 0; i < POI_MAX * fish_count; i++) {
        const vec3 off_m = v3(0.04f * f_sin((float)i), 0.0f, 0.04f * f_cos(2.0f * (float)i));
        tank.fish[i].position_m = v3_add(bowls[i % POI_MAX].position_m, off_m);
        bowl_take(&bowls[i % POI_MAX], i % POI_MAX, &tank, &tank.fish[i], v3(0.0f, 0.0f, 0.0f));
    }
    for (uint32_t tick = 0; tick < 30u * CORE_TICK_HZ; tick++) {
        const double start = now_us();
        bowl_buoyancy_tick(&stall, pois, live, POI_MAX);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            bowl_fish_tick(&bowls[i], i, &tank);
        }
        samples[tick] = now_us() - start;
    }
    report(what, 30u * CORE_TICK_HZ);
}

int main(int argc, char **argv)
{
    /* clang-format off */
    static const struct state states[] = {
        { .what = "calm: a slow glide, soaked, no fish", .pressure_pa = 2.0f },
        { .what = "5 fish lie on it, soaked", .pressure_pa = -29.0f, .body_n = 0.014f },
        { .what = "5 fish slap at once, soaked", .pressure_pa = -29.0f, .body_n = 0.014f,
          .slap_n = 0.04f },
        { .what = "the same, half wet", .pressure_pa = -29.0f, .body_n = 0.014f, .slap_n = 0.04f,
          .half_wet = 1 },
        { .what = "worst: 5 slap with 0.15 N at once, and it tears", .pressure_pa = -100.0f,
          .body_n = 0.028f, .slap_n = 0.15f, .only_tearing = 1 },
        { .what = "worst, half wet", .pressure_pa = -150.0f, .body_n = 0.028f, .slap_n = 0.15f,
          .half_wet = 1, .only_tearing = 1 },
    };
    /* clang-format on */
    double worst_us = 0.0;
    tsv = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (argc == 2 && !tsv) {
        fprintf(stderr, "bench_poi: cannot write %s\n", argv[1]);
        return 74;
    }
    if (tsv) {
        fputs("what\tmedian_us\tp99_us\tticks\n", tsv);
    }
    printf("Microseconds a tick (No. 5; the core's budget for a tick is 8,333)\n"
           "  %-58s %7s %7s %7s   %s\n",
           "", "median", "p99", "most", "ticks");
    for (uint32_t i = 0; i < sizeof states / sizeof states[0]; i++) {
        const double median_us = measure(&states[i]);
        worst_us = median_us > worst_us ? median_us : worst_us;
    }
    measure_poi();
    measure_catch(0, "catch: a poi over 1,000 fish");
    measure_catch(POI_CARRIED_MAX, "catch: the same, 16 fish on it");
    measure_bowls(0, "four empty bowls, four pois");
    measure_bowls(40, "four bowls with 40 fish of 4 cm in each");
    measure_bowls(107, "four bowls with 107, the record, in each");
    printf("Sizes: a sheet %zu bytes, a poi %zu; on the stack of a tick %zu more. No allocation.\n",
           sizeof(struct sheet), sizeof(struct poi), sizeof(struct strain));
    printf("The sheet's worst median, %.1f us, is %s the goal of %.0f.\n", worst_us,
           worst_us < GOAL_US ? "within" : "OVER", GOAL_US);
    if (tsv && fclose(tsv) != 0) {
        return 74;
    }
    return worst_us < GOAL_US ? 0 : 1;
}
