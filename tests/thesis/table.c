/* table.c -- measures table 4.2 of the 2013 thesis: the updates per second for eight numbers of
 * fish, if neighbours are found by a grid and if all pairs are tested.
 *
 * Usage: table FILE.csv
 *
 * Each tank first runs for ten seconds, as in the thesis. A measured update is one tick and one
 * frame, which the kiosk's renderer draws at 1280x720 off screen. The two methods are measured
 * alternately, so that other load on the machine affects both equally. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "platform/cpu.h"
#include "tests/thesis/easel.h"

#define SECONDS 10u
/* Number of measured updates of each tank. The number is odd, so that one of the measured times is
 * the median. */
#define FRAMES 15u

/* Updates per second from section 4.4 of the thesis; -1 means that the thesis gives no value. */
static const struct {
    uint32_t fish;
    double grid, all;
} thesis[] = {
    { 50, 362.0, 70.3 }, { 100, 175.0, 9.7 }, { 150, 91.0, 2.7 },  { 200, 60.4, 1.9 },
    { 250, 40.3, 0.5 },  { 300, 26.5, 0.3 },  { 400, 11.8, -1.0 }, { 600, 4.0, -1.0 },
};

/* Methods of the search for neighbouring fish. */
enum search { GRID, ALL, SEARCH_COUNT };

static const char *const search_words[SEARCH_COUNT] = { "grid", "all" };

/* One tank for each search method. The seeds are equal, so that the fish of both tanks swim
 * alike. */
static struct tank_lab tanks[SEARCH_COUNT];
static struct tank_options plans[SEARCH_COUNT];

static double now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

/* Runs the tank for ten seconds and returns the mean duration of a tick in ms. The lab stays open
 * for draw_both_ms(). */
static double run_ms(uint32_t fish, enum search search)
{
    struct tank_lab *lab = &tanks[search];
    char count[16];
    const char *const argv[] = { "--fish", count, "--pairs", search_words[search] };
    double sum_ns = 0.0;
    snprintf(count, sizeof count, "%u", fish);
    if (tank_options_read(&plans[search], 4, argv) != EXIT_OK) {
        exit(1);
    }
    /* Adds one tick for each frame that draw_both_ms() measures. */
    plans[search].tick_count = SECONDS * CORE_TICK_HZ + FRAMES;
    if (tank_lab_open(lab, &plans[search]) != EXIT_OK) {
        exit(1);
    }
    while (lab->tick < SECONDS * CORE_TICK_HZ) {
        tank_lab_tick(lab);
        sum_ns += (double)lab->tick_ns[lab->tick - 1u];
    }
    return 1e-6 * sum_ns / (double)lab->tick;
}

/* Returns the duration of one tick and one frame in ms. The time for the statistics of the lab is
 * not included. */
static double frame_ms(enum search search)
{
    struct tank_lab *lab = &tanks[search];
    tank_lab_tick(lab);
    const double begin_ms = now_ms();
    easel_draw(lab);
    return now_ms() - begin_ms + 1e-6 * (double)lab->tick_ns[lab->tick - 1u];
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* Computes the median duration of an update for each search method, in ms. */
static void draw_both_ms(double median_ms[SEARCH_COUNT])
{
    static double frames[SEARCH_COUNT][FRAMES];
    for (uint32_t i = 0; i < FRAMES; i++) {
        for (uint32_t turn = 0; turn < SEARCH_COUNT; turn++) {
            const enum search search = (i + turn) % SEARCH_COUNT;
            frames[search][i] = frame_ms(search);
        }
    }
    for (uint32_t search = 0; search < SEARCH_COUNT; search++) {
        qsort(frames[search], FRAMES, sizeof frames[search][0], by_size);
        median_ms[search] = frames[search][FRAMES / 2u];
    }
}

static void name_machine(FILE *file)
{
    char line[256], *model = NULL;
    FILE *cpu = fopen("/proc/cpuinfo", "r");
    while (cpu && !model && fgets(line, sizeof line, cpu)) {
        model = strncmp(line, "model name", 10) == 0 ? strchr(line, ':') : NULL;
    }
    fprintf(file, "# %.*s; one thread, %u lanes; pictures by %s, %ux%u\n",
            model ? (int)strcspn(model + 2, "\n") : 15, model ? model + 2 : "unknown machine",
            cpu_lanes(), easel_describe(), EASEL_WIDTH, EASEL_HEIGHT);
    if (cpu) {
        fclose(cpu);
    }
}

static void write_row(FILE *file, size_t row)
{
    double tick_ms[SEARCH_COUNT], update_ms[SEARCH_COUNT];
    for (enum search search = GRID; search < SEARCH_COUNT; search++) {
        tick_ms[search] = run_ms(thesis[row].fish, search);
    }
    draw_both_ms(update_ms);
    for (enum search search = GRID; search < SEARCH_COUNT; search++) {
        tank_lab_close(&tanks[search]);
    }
    fprintf(file, "%u,%.1f,", thesis[row].fish, thesis[row].grid);
    fprintf(file, thesis[row].all < 0.0 ? "," : "%.1f,", thesis[row].all);
    fprintf(file, "%.1f,%.1f,%.2f,%.2f,%.2f,%.2f,%.0f,%.0f\n", 1e3 * tick_ms[GRID],
            1e3 * tick_ms[ALL], update_ms[GRID], update_ms[ALL], 1e3 / update_ms[GRID],
            1e3 / update_ms[ALL], 1e3 / tick_ms[GRID], 1e3 / tick_ms[ALL]);
    printf("  table 4.2: %3u fish: the thesis %5.1f updates a second, here %5.2f, each against "
           "each %5.2f; without drawing %.0f and %.0f\n",
           thesis[row].fish, thesis[row].grid, 1e3 / update_ms[GRID], 1e3 / update_ms[ALL],
           1e3 / tick_ms[GRID], 1e3 / tick_ms[ALL]);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    FILE *file = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!file || easel_open(1) != 0) {
        fputs("table: cannot begin\n", stderr);
        return 1;
    }
    name_machine(file);
    fputs("fish,thesis_grid_fps,thesis_all_fps,tick_us_grid,tick_us_all,update_ms_grid,"
          "update_ms_all,grid_fps,all_fps,grid_fps_undrawn,all_fps_undrawn\n",
          file);
    for (size_t i = 0; i < sizeof thesis / sizeof thesis[0]; i++) {
        write_row(file, i);
    }
    easel_close();
    return fclose(file) == 0 ? 0 : 1;
}
