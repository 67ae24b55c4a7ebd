/* bench_tank.c -- benchmark of the time of a tank's tick per fish, from 50 to 100,000 fish, with
 * the share of each stage of the tick.
 *
 * bench_tank [TSV] prints the tables and also writes them to the file TSV, with one figure in each
 * row.
 *
 * bench_tank FISH TICKS prints the mean CPU time of TICKS ticks, for use under valgrind.
 *
 * bench_tank dragged measures only the cost of a poi that moves in the water.
 *
 * This program is built for up to 131,072 fish (bench.mk). As a reference, each run also measures
 * the search for pairs of close fish alone, in the same poses. The SIMD widths alternate on one
 * tank, which is possible because all widths give the same bits. The core has no clock, so the
 * linker option --wrap replaces the calls between modules by functions that measure the stages. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "core/poi/poi.h"
#include "core/tank/behavior/swim.h"
#include "core/tank/tank.h"
#include "platform/cpu.h"
#include "platform/huge_pages.h"

#define SAMPLES_MAX 4000u
#define SAMPLES_MIN 8u
#define MEASURE_NS 0.9e9 /* Measuring time in ns for each number of fish. */
#define WARM_NS 0.4e9
/* Longest warm-up before a measurement, in ticks (five seconds). After this time the fish have left
 * the regular grid in which they start. */
#define WARM_TICKS 600u
/* Number of ticks between two readings of the clock. The broad phase makes one full update in this
 * time, so each block has the same work. */
#define BLOCK BROAD_PHASE_UPDATE_TICKS
/* Number of fish in a tank of the floor area that the thesis used, so that the density equals that
 * of the thesis. */
#define THESIS_FISH 600.0f

static struct tank *store;
#define tank (*store)
static struct narrow_phase pairs;
static struct narrow_phase_pair found[NARROW_PHASE_BATCH + SIMD_LANES_MAX];
static float no_reach[TANK_FISH_MAX];
static double samples[3][SAMPLES_MAX];
static FILE *tsv;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "bench_tank: %s:%d: %s\n", file, line, condition);
    abort();
}

static double clock_ns(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec * 1e9 + (double)now.tv_nsec;
}

static double now_ns(void)
{
    return clock_ns(CLOCK_MONOTONIC);
}

/* Returns the CPU time of this thread in ns. The time of other processes is not included, but they
 * can displace data from the caches. */
static double work_ns(void)
{
    return clock_ns(CLOCK_THREAD_CPUTIME_ID);
}

static void row(const char *what, const char *name, uint32_t fish, uint32_t lanes, double value)
{
    if (tsv) {
        fprintf(tsv, "%s\t%s\t%u\t%u\t%.6g\n", what, name, fish, lanes, value);
    }
}

/* ---- Time of the stages of a tick ------------------------------------------------------------ */

enum stage { BEHAVIOR, MOVE, SYNC, GRID, PAIRS, UPDATE, SOLVE, SETTLE, AIR, STAGE_COUNT };
static const char *const stage_name[STAGE_COUNT] = {
    [BEHAVIOR] = "behavior", [MOVE] = "move",     [SYNC] = "sync",
    [GRID] = "grid",         [PAIRS] = "pairs",   [UPDATE] = "update",
    [SOLVE] = "solve",       [SETTLE] = "settle", [AIR] = "air",
};
static double spent_ns[STAGE_COUNT], since_ns;
static enum stage stage_now;
static int is_timed;

/* Counts the time from now on for `stage`. Returns the stage that was counted before. */
static enum stage enter(enum stage stage)
{
    const enum stage before = stage_now;
    if (is_timed) {
        const double now = now_ns();
        spent_ns[before] += now - since_ns;
        since_ns = now;
        stage_now = stage;
    }
    return before;
}

#define WRAP(owner, name, parameters, arguments)                                                   \
    void __real_##name parameters;                                                                 \
    void __wrap_##name parameters;                                                                 \
    void __wrap_##name parameters                                                                  \
    {                                                                                              \
        const enum stage before = enter(owner);                                                    \
        __real_##name arguments;                                                                   \
        enter(before);                                                                             \
    }
#define WRAP_INT(owner, name, parameters, arguments)                                               \
    int __real_##name parameters;                                                                  \
    int __wrap_##name parameters;                                                                  \
    int __wrap_##name parameters                                                                   \
    {                                                                                              \
        const enum stage before = enter(owner);                                                    \
        const int result = __real_##name arguments;                                                \
        enter(before);                                                                             \
        return result;                                                                             \
    }

/* Functions of the core whose time is measured: each call is wrapped, and its time is added to the
 * stage of the tick in the first column. The list in bench.mk must have the same names. */
WRAP(MOVE, swim_move_all, (const struct shoal *shoal, uint32_t lanes), (shoal, lanes))
WRAP(SYNC, broad_phase_mark,
     (struct broad_phase * broad_phase, const struct fish *fish, uint32_t count),
     (broad_phase, fish, count))
WRAP(SYNC, broad_phase_sync, (struct broad_phase * broad_phase, struct fish *fish),
     (broad_phase, fish))
WRAP_INT(SYNC, broad_phase_is_stale, (const struct broad_phase *broad_phase), (broad_phase))
WRAP(SYNC, broad_phase_select_contacts, (struct broad_phase * broad_phase), (broad_phase))
WRAP(UPDATE, broad_phase_update,
     (struct broad_phase * broad_phase, const struct fish *fish, struct broad_phase_search how,
      const struct perception *around),
     (broad_phase, fish, how, around))
WRAP(GRID, narrow_phase_begin, (struct narrow_phase * search, const struct narrow_phase_query *of),
     (search, of))
WRAP_INT(PAIRS, narrow_phase_next,
         (struct narrow_phase * search, const struct narrow_phase_query *of,
          struct narrow_phase_pair *to, uint32_t *count),
         (search, of, to, count))
WRAP(SOLVE, contact_solver_project,
     (struct contact_solver * solver, struct broad_phase *broad_phase,
      const struct solver_context *place),
     (solver, broad_phase, place))
WRAP(SOLVE, contact_solver_finish,
     (struct contact_solver * solver, struct broad_phase *broad_phase,
      const struct solver_context *place),
     (solver, broad_phase, place))
WRAP(SETTLE, swim_settle_all, (const struct shoal *shoal, uint32_t lanes), (shoal, lanes))
WRAP(AIR, oxygen_tick,
     (struct oxygen * oxygen, const struct fish *fish, uint32_t fish_count, vec3 size_m,
      uint32_t tick),
     (oxygen, fish, fish_count, size_m, tick))

/* ---- Measuring ------------------------------------------------------------------------------ */

static uint32_t tick;

static void open_preset(uint8_t preset, uint32_t fish, float area_scale, uint8_t search)
{
    struct tank_config config = tank_config_of(preset);
    config.fish_count = fish;
    config.area_scale = area_scale;
    config.search = search;
    config.lanes = (uint8_t)cpu_lanes();
    if (!tank_open(&tank, &config)) {
        fprintf(stderr, "bench_tank: no tank holds %u fish\n", fish);
        exit(1);
    }
    tick = 0;
}

static void open_tank(uint32_t fish, float area_scale, uint8_t search)
{
    open_preset(TANK_PRESET_THESIS, fish, area_scale, search);
}

/* A poi is dragged around the tank on an oval, at half the depth of the water. The ring is tilted
 * and its paper is whole. */
static float drag_m_s; /* Speed of the dragged poi in m/s. 0 means no poi. */
static struct obstacle disc;
static uint8_t paper[OBSTACLE_PAPER_SIDE * OBSTACLE_PAPER_SIDE];

static vec3 hand_m(void)
{
    const float x = 0.35f * tank.size_m.x, z = 0.30f * tank.size_m.z;
    const float angle_rad = 2.0f * drag_m_s / (x + z) * CORE_TICK_S * (float)tick;
    return v3(x * cosf(angle_rad), -0.5f * tank.size_m.y, z * sinf(angle_rad));
}

static void take_disc(float speed_m_s)
{
    drag_m_s = speed_m_s;
    memset(paper, OBSTACLE_PAPER_HOLDS, sizeof paper);
    const struct angles slant = { 0.0f, 35.0f * F_DEG, 0.0f };
    const struct basis axes = vec_basis_from_angles(slant);
    disc = (struct obstacle){
        .kind = OBSTACLE_DISC,
        .centre_m = hand_m(),
        .radius_m = POI_OUTER_RADIUS_M,
        .normal = axes.up,
        .axes = axes,
        .axes_before = axes,
        .paper = paper,
        .paper_radius_m = POI_RADIUS_M,
    };
}

/* Moves the disc (the ring with its paper) toward its target on the oval. Fish may block the disc.
 * A disc that was blocked then moves at up to 1.5 times its normal speed until it has caught up. */
static void pull_disc(void)
{
    const vec3 way_m = v3_sub(hand_m(), disc.centre_m);
    disc.step_m = v3_limit(way_m, 1.5f * drag_m_s * CORE_TICK_S);
    disc.centre_m = v3_add(disc.centre_m, disc.step_m);
    disc.velocity_m_s = v3_scale(disc.step_m, (float)CORE_TICK_HZ);
    disc.reaction = 0;
}

static void tick_tank(void)
{
    if (drag_m_s > 0.0f) {
        pull_disc();
    }
    tank_tick(&tank, tick++, &disc, drag_m_s > 0.0f);
}

static void warm_up(double limit_ns)
{
    const double start = now_ns();
    while (tick % BLOCK != 0 || (tick < WARM_TICKS && now_ns() - start < limit_ns)) {
        tick_tank();
    }
}

/* Runs BLOCK ticks. Returns the time in ns per fish and tick. */
static double block_ns(uint32_t lanes)
{
    tank.lanes = (uint8_t)lanes;
    const double start = work_ns();
    for (uint32_t i = 0; i < BLOCK; i++) {
        tick_tank();
    }
    return (work_ns() - start) / (double)(BLOCK * tank.fish_count);
}

/* Searches for pairs of close fish in the current poses. Returns the time in ns per fish. */
static double bare_ns(uint32_t lanes, uint32_t *found_count)
{
    const struct narrow_phase_query of = {
        .body = tank.broad_phase.body,
        .flags = tank.broad_phase.flags,
        .reach_m = no_reach,
        .count = tank.fish_count,
        .which = BODY_SWIMMING,
        .lanes = (uint8_t)lanes,
        .width_m = tank.size_m.x,
        .breadth_m = tank.size_m.z,
    };
    const double start = work_ns();
    *found_count = 0;
    narrow_phase_begin(&pairs, &of);
    for (uint32_t some; narrow_phase_next(&pairs, &of, found, &some);) {
        *found_count += some;
    }
    return (work_ns() - start) / (double)tank.fish_count;
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static double median(double *values, uint32_t count)
{
    qsort(values, count, sizeof values[0], by_size);
    return values[count / 2u];
}

struct figures {
    /* Time per fish in ns of a tick (tick_ns) and of the search for pairs alone (bare_ns). Element
     * 0 is the time with 4 SIMD lanes, element 1 with 8. */
    double tick_ns[2], bare_ns[2];
    double found; /* Number of pairs found per fish. */
};

static struct figures measure(uint32_t fish)
{
    static double bare[2][SAMPLES_MAX];
    struct figures figures = { 0 };
    uint32_t count = 0, pair_count = 0;
    open_tank(fish, (float)fish / THESIS_FISH, PAIR_SEARCH_GRID);
    warm_up(WARM_NS);
    const double start = now_ns();
    const uint32_t widths = cpu_lanes() == 8u ? 2u : 1u;
    while (count < SAMPLES_MAX && (count < SAMPLES_MIN || now_ns() - start < MEASURE_NS)) {
        for (uint32_t w = 0; w < widths; w++) {
            const uint32_t lanes = 4u << w;
            /* Runs each measured function once without measurement. Otherwise its data would not be
             * in the cache, because the other functions displace them. */
            (void)block_ns(lanes);
            samples[w][count] = block_ns(lanes);
            (void)bare_ns(lanes, &pair_count);
            bare[w][count] = bare_ns(lanes, &pair_count);
        }
        count++;
    }
    for (uint32_t w = 0; w < widths; w++) {
        figures.tick_ns[w] = median(samples[w], count);
        figures.bare_ns[w] = median(bare[w], count);
        row("tick_ns", "kingyo", fish, 4u << w, figures.tick_ns[w]);
        row("bare_search_ns", "kingyo", fish, 4u << w, figures.bare_ns[w]);
    }
    figures.found = (double)pair_count / (double)fish;
    return figures;
}

/* ---- Tables --------------------------------------------------------------------------------- */

static const uint32_t counts[] = { 50,  100,  150,  200,  250,   300,   400,
                                   600, 1000, 2000, 6000, 20000, 60000, 100000 };
#define COUNTS (sizeof counts / sizeof counts[0])
static struct figures all[COUNTS];

static void print_cpu(void)
{
    char line[256], name[200] = "an unnamed processor";
    FILE *info = fopen("/proc/cpuinfo", "r");
    while (info && fgets(line, sizeof line, info)) {
        if (sscanf(line, "model name : %199[^\n]", name) == 1) {
            break;
        }
    }
    if (info) {
        fclose(info);
    }
    printf("One thread on %s, %u lanes at most.\n", name, cpu_lanes());
}

static void print_growth(void)
{
    puts("\nA fish and tick at the thesis' density (600 on 136 x 65 cm), and a bare search for "
         "pairs on the same poses");
    puts("    fish   8 lanes: tick   bare  ratio   4 lanes: tick   bare  ratio   pairs a fish");
    for (uint32_t c = 0; c < COUNTS; c++) {
        all[c] = measure(counts[c]);
        const struct figures *f = &all[c];
        printf("  %6u   %10.1f ns %6.1f %6.2f   %10.1f ns %6.1f %6.2f   %8.2f\n", counts[c],
               f->tick_ns[1], f->bare_ns[1], f->tick_ns[1] / fmax(f->bare_ns[1], 1e-9),
               f->tick_ns[0], f->bare_ns[0], f->tick_ns[0] / f->bare_ns[0], f->found);
        fflush(stdout);
    }
}

/* Returns the exponent with which the time grows with the number of fish: the slope of log(time)
 * over log(number), fitted for 600 fish and more. */
static double exponent(uint32_t width)
{
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (uint32_t c = 0; c < COUNTS; c++) {
        if (counts[c] >= 600u && all[c].tick_ns[width] > 0.0) {
            const double log_n = log((double)counts[c]);
            const double log_t = log((double)counts[c] * all[c].tick_ns[width]);
            n += 1.0;
            x += log_n;
            y += log_t;
            xx += log_n * log_n;
            xy += log_n * log_t;
        }
    }
    return n > 1.0 ? (n * xy - x * y) / (n * xx - x * x) : 0.0;
}

static void print_exponents(void)
{
    printf("\nA tick grows as the number of fish to the power of %.3f (4 lanes: %.3f), 600 to "
           "100,000.\n",
           exponent(1), exponent(0));
    row("exponent", "kingyo", 100000, 8, exponent(1));
    row("exponent", "kingyo", 100000, 4, exponent(0));
}

static double stage_ns[SAMPLES_MAX][STAGE_COUNT]; /* Time of each stage in each block, in ns. */
static double whole_ns[SAMPLES_MAX];

static uint32_t time_stages(void)
{
    uint32_t count = 0;
    const double start = now_ns();
    while (count < SAMPLES_MAX && (count < SAMPLES_MIN || now_ns() - start < MEASURE_NS)) {
        memset(spent_ns, 0, sizeof spent_ns);
        is_timed = 1;
        stage_now = BEHAVIOR;
        since_ns = now_ns();
        (void)block_ns(cpu_lanes());
        enter(BEHAVIOR);
        is_timed = 0;
        memcpy(stage_ns[count], spent_ns, sizeof spent_ns);
        whole_ns[count] = 0.0;
        for (uint32_t s = 0; s < STAGE_COUNT; s++) {
            whole_ns[count] += spent_ns[s];
        }
        count++;
    }
    return count;
}

/* Prints the mean time of each stage in ns per fish and tick. Uses only blocks of ticks that took
 * no longer than the median, because other processes interrupted the slower blocks. */
static void print_shares(uint32_t fish)
{
    static double sorted[SAMPLES_MAX];
    double sum[STAGE_COUNT] = { 0 }, sum_whole = 0.0, kept = 0.0;
    open_tank(fish, (float)fish / THESIS_FISH, PAIR_SEARCH_GRID);
    warm_up(WARM_NS);
    const uint32_t count = time_stages();
    memcpy(sorted, whole_ns, sizeof sorted);
    const double most = median(sorted, count);
    for (uint32_t c = 0; c < count; c++) {
        for (uint32_t s = 0; s < STAGE_COUNT && whole_ns[c] <= most; s++) {
            sum[s] += stage_ns[c][s];
        }
        kept += whole_ns[c] <= most;
    }
    printf("  %6u", fish);
    for (uint32_t s = 0; s < STAGE_COUNT; s++) {
        const double ns = sum[s] / (kept * (double)fish * (double)BLOCK);
        sum_whole += ns;
        printf("  %8.1f", ns);
        row("stage_ns", stage_name[s], fish, cpu_lanes(), ns);
    }
    printf("   %6.1f\n", sum_whole);
    fflush(stdout);
}

static void print_stages(void)
{
    printf(
        "\nTime of the stages in ns per fish and tick, with %u lanes. The broad phase is updated\n"
        "every fourth tick; its time (grid, pairs, update) is divided among the four ticks. The\n"
        "time of reading the clock is included.\n"
        "    fish",
        cpu_lanes());
    for (uint32_t s = 0; s < STAGE_COUNT; s++) {
        printf("  %8s", stage_name[s]);
    }
    puts("    whole");
    print_shares(600);
    print_shares(6000);
    print_shares(60000);
}

/* Configurations of a kiosk that are measured with a dragged poi. */
static const struct {
    const char *name;
    uint8_t preset;
    uint32_t fish;
} tanks[] = {
    { "festival", TANK_PRESET_FESTIVAL, 300 },
    { "thesis", TANK_PRESET_THESIS, 600 },
    { "official", TANK_PRESET_OFFICIAL, 1000 },
};
static const float drags_m_s[] = { 0.0f, 0.2f, 0.4f, 1.0f };
#define DRAGS (sizeof drags_m_s / sizeof drags_m_s[0])

/* Returns the mean time in ns per fish and tick. The mean is used instead of the median, because
 * the cost of a poi varies between ticks. */
static double dragged_ns(uint32_t tank_index, float speed_m_s)
{
    double sum_ns = 0.0;
    uint32_t count = 0;
    open_preset(tanks[tank_index].preset, tanks[tank_index].fish, 1.0f, PAIR_SEARCH_GRID);
    take_disc(speed_m_s);
    warm_up(WARM_NS);
    const double start = now_ns();
    while (count < SAMPLES_MIN || now_ns() - start < 2.0 * MEASURE_NS) {
        sum_ns += block_ns(cpu_lanes());
        count++;
    }
    return sum_ns / (double)count;
}

static void print_dragged(void)
{
    puts("\nWith a poi dragged through, ns a fish and tick (means; in braces of the calm tick's)");
    printf("  %-8s   fish      calm", "");
    for (uint32_t d = 1; d < DRAGS; d++) {
        printf("      at %.1f m/s", (double)drags_m_s[d]);
    }
    for (uint32_t s = 0; s < sizeof tanks / sizeof tanks[0]; s++) {
        const double calm_ns = dragged_ns(s, 0.0f);
        printf("\n  %-8s %6u  %8.1f", tanks[s].name, tanks[s].fish, calm_ns);
        row("calm_ns", tanks[s].name, tanks[s].fish, cpu_lanes(), calm_ns);
        for (uint32_t d = 1; d < DRAGS; d++) {
            const double ns = dragged_ns(s, drags_m_s[d]);
            char what[32];
            snprintf(what, sizeof what, "dragged_%.1f_m_s_ns", (double)drags_m_s[d]);
            printf("  %8.1f (%3.1f)", ns, ns / calm_ns);
            row(what, tanks[s].name, tanks[s].fish, cpu_lanes(), ns);
        }
        fflush(stdout);
    }
    puts("");
    take_disc(0.0f);
}

/* Returns how many ticks per second the tank runs without drawing. */
static double ticks_per_s(uint32_t fish, uint8_t search)
{
    uint32_t count = 0;
    open_tank(fish, 1.0f, search);
    warm_up(0.3 * WARM_NS);
    const double start = now_ns();
    while (count < SAMPLES_MAX && (count < SAMPLES_MIN || now_ns() - start < 0.2 * MEASURE_NS)) {
        samples[0][count++] = block_ns(cpu_lanes());
    }
    return 1e9 / (median(samples[0], count) * (double)fish);
}

/* Frames per second in table 4.2 of the 2013 thesis, including drawing; 0 means that the thesis
 * gives no value. */
static const struct {
    uint32_t fish;
    double grid, all;
} table_4_2[] = {
    { 50, 362.0, 70.3 }, { 100, 175.0, 9.7 }, { 150, 91.0, 2.7 }, { 200, 60.4, 1.9 },
    { 250, 40.3, 0.5 },  { 300, 26.5, 0.3 },  { 400, 11.8, 0.0 }, { 600, 4.0, 0.0 },
};

static void print_table_4_2(void)
{
    puts("\nThe thesis' table 4.2, in its tank: steps a second with the grid and with each against "
         "each.\nTheirs are frames with the picture drawn, on an Intel Core i7-2637M of 1.7 GHz "
         "under Windows 7;\nours are ticks without a picture (make thesis-figures has them with "
         "one).");
    puts("    fish   thesis: grid    all   kingyo: grid          all");
    for (uint32_t t = 0; t < sizeof table_4_2 / sizeof table_4_2[0]; t++) {
        const uint32_t fish = table_4_2[t].fish;
        const double grid = ticks_per_s(fish, PAIR_SEARCH_GRID),
                     each = ticks_per_s(fish, PAIR_SEARCH_ALL);
        printf("  %6u   %12.1f %6.1f   %12.0f %12.0f\n", fish, table_4_2[t].grid, table_4_2[t].all,
               grid, each);
        row("ticks_per_s", "grid", fish, cpu_lanes(), grid);
        row("ticks_per_s", "all_pairs", fish, cpu_lanes(), each);
        fflush(stdout);
    }
}

/* Times of other programs in ns, measured on a similar machine with one thread at the fish density
 * of the thesis. Each of these programs does only a part of the work: it either finds contacts or
 * steers. */
static const struct {
    const char *name;
    double ns[3];
} peers[] = {
    { "ODE, sweep and prune", { 1314, 1988, 3667 } },
    { "OpenSteer", { 1340, 1829, 4128 } },
    { "RVO2", { 1624, 2045, 4653 } },
    { "Bullet", { 2020, 3901, 5377 } },
    { "Jolt", { 4249, 5587, 8343 } },
};

static const struct figures *figures_of(uint32_t fish)
{
    uint32_t c = 0;
    while (counts[c] != fish) {
        c++;
    }
    return &all[c];
}

static void print_peers(void)
{
    const uint32_t fish[3] = { 600, 6000, 60000 };
    const uint32_t width = cpu_lanes() == 8u ? 1u : 0u;
    puts("\nBeside others, ns a fish and step (theirs measured before, on a machine of this kind: "
         "finding\ncontacts or steering alone; ours is the whole tick)");
    puts("                              600     6,000    60,000");
    printf("  %-22s", "kingyo");
    for (uint32_t f = 0; f < 3u; f++) {
        printf("  %8.0f", figures_of(fish[f])->tick_ns[width]);
    }
    for (uint32_t p = 0; p < sizeof peers / sizeof peers[0]; p++) {
        printf("\n  %-22s", peers[p].name);
        for (uint32_t f = 0; f < 3u; f++) {
            printf("  %8.0f", peers[p].ns[f]);
            row("peer_ns", peers[p].name, fish[f], 0, peers[p].ns[f]);
        }
    }
    puts("");
}

static void open_store(void)
{
    store = huge_pages_alloc(sizeof *store);
    if (!store) {
        fprintf(stderr, "bench_tank: no memory for %zu bytes\n", sizeof *store);
        exit(1);
    }
}

int main(int argc, char **argv)
{
    open_store();
    if (argc == 3) {
        open_tank((uint32_t)strtoul(argv[1], NULL, 10), strtof(argv[1], NULL) / THESIS_FISH,
                  PAIR_SEARCH_GRID);
        const uint32_t end = (uint32_t)strtoul(argv[2], NULL, 10);
        const double start = work_ns();
        while (tick < end) {
            tank_tick(&tank, tick++, NULL, 0);
        }
        printf("%.1f ns a fish and tick\n",
               (work_ns() - start) / (double)end / (double)tank.fish_count);
        return 0;
    }
    if (argc == 2 && strcmp(argv[1], "dragged") == 0) {
        print_dragged();
        return 0;
    }
    tsv = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (argc == 2 && !tsv) {
        fprintf(stderr, "bench_tank: cannot write %s\n", argv[1]);
        return 74;
    }
    if (tsv) {
        fputs("what\tname\tfish\tlanes\tvalue\n", tsv);
    }
    print_cpu();
    print_growth();
    print_exponents();
    print_stages();
    print_dragged();
    print_table_4_2();
    print_peers();
    return tsv && fclose(tsv) != 0 ? 74 : 0;
}
