/* table.c -- the 2013 thesis' table 4.2, measured here: updates a second for eight fish counts,
 * near fish found by the grid and each against each.
 *
 * Usage: table FILE.csv. Ten seconds a tank, as the thesis; an update is one tick and one picture,
 * drawn by the kiosk's own renderer at 1280x720 without a screen. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "platform/cpu.h"
#include "tests/thesis/easel.h"

#define SECONDS 10u
#define DRAWINGS 12u

/* Section 4.4; -1: it could not be measured. */
static const struct {
    uint32_t fish;
    double grid, all;
} thesis[] = {
    { 50, 362.0, 70.3 }, { 100, 175.0, 9.7 }, { 150, 91.0, 2.7 }, { 200, 60.4, 1.9 },
    { 250, 40.3, 0.5 },  { 300, 26.5, 0.3 },  { 400, 11.8, -1.0 }, { 600, 4.0, -1.0 },
};

static struct tank_lab lab;
static struct tank_plan plan;

static double now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

/* Runs the tank; the mean tick in ms. The lab stays open. */
static double run_ms(uint32_t fish, const char *pairs)
{
    char count[16];
    const char *const argv[] = { "--fish", count, "--pairs", pairs };
    double sum_ns = 0.0;
    snprintf(count, sizeof count, "%u", fish);
    if (tank_plan_read(&plan, 4, argv) != EXIT_OK || tank_lab_open(&lab, &plan) != EXIT_OK) {
        exit(1);
    }
    while (lab.tick < SECONDS * CORE_TICK_HZ) {
        tank_lab_tick(&lab);
        sum_ns += (double)lab.tick_ns[lab.tick - 1u];
    }
    return 1e-6 * sum_ns / (double)lab.tick;
}

/* The quickest of some: others may work on the same machine. */
static double draw_ms(void)
{
    double best_ms = INFINITY;
    for (uint32_t i = 0; i < DRAWINGS; i++) {
        const double begin_ms = now_ms();
        easel_draw(&lab);
        best_ms = fmin(best_ms, now_ms() - begin_ms);
    }
    return best_ms;
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

int main(int argc, char **argv)
{
    FILE *file = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!file || easel_open(1) != 0) {
        fputs("table: cannot begin\n", stderr);
        return 1;
    }
    name_machine(file);
    fputs("fish,thesis_grid_fps,thesis_all_fps,tick_us_grid,tick_us_all,draw_ms,grid_fps,all_fps,"
          "grid_fps_undrawn,all_fps_undrawn\n", file);
    for (size_t i = 0; i < sizeof thesis / sizeof thesis[0]; i++) {
        const double all_ms = run_ms(thesis[i].fish, "all");
        tank_lab_close(&lab);
        const double grid_ms = run_ms(thesis[i].fish, "grid");
        const double picture_ms = draw_ms();
        tank_lab_close(&lab);
        fprintf(file, "%u,%.1f,", thesis[i].fish, thesis[i].grid);
        fprintf(file, thesis[i].all < 0.0 ? "," : "%.1f,", thesis[i].all);
        fprintf(file, "%.1f,%.1f,%.2f,%.1f,%.1f,%.0f,%.0f\n", 1e3 * grid_ms, 1e3 * all_ms,
                picture_ms, 1e3 / (grid_ms + picture_ms), 1e3 / (all_ms + picture_ms),
                1e3 / grid_ms, 1e3 / all_ms);
        printf("  table 4.2: %3u fish: the thesis %5.1f updates a second, here %5.1f; without "
               "drawing %.0f, each against each %.0f\n", thesis[i].fish, thesis[i].grid,
               1e3 / (grid_ms + picture_ms), 1e3 / grid_ms, 1e3 / all_ms);
        fflush(stdout);
    }
    easel_close();
    return fclose(file) == 0 ? 0 : 1;
}
