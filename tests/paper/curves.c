/* curves.c -- writes tables for plots.gp of measurements of the paper, as `kingyoctl paper` makes
 * them.
 *
 * `curves tear > tear.tsv` writes a table of the time after which the paper tears, for each speed.
 * The columns are grade, wet fraction, speed, and the median, least and greatest time of SPECIMENS
 * specimens. A time above LAST_S means that the paper did not tear.
 *
 * `curves force > force.tsv` writes a table of the force in N at 0.3 m/s, for each tilt of the
 * paper in degrees.
 *
 * `curves holes FOLDER` writes one file FOLDER/hole-SPECIMEN-MOMENT.txt for each specimen and each
 * of MOMENTS moments after the first tear. MOMENT is the index of the moment. Each file is a matrix
 * with one value for each cell of the paper. The value is the stress of the cell (0 .. 255), -1 for
 * a hole, or -9 for a cell beyond the ring. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/play/paper_lab.h"

#define SPECIMENS 9u
#define LAST_S 20.0
#define SPEEDS 40u
#define SPEED_MIN_M_S 0.10
/* Ratio of two successive speeds. The number of speeds is SPEEDS, and they extend from 0.1 m/s to
 * about 1.5 m/s. */
#define SPEED_RATIO 1.0725
#define HOLES 5u
#define MOMENTS 4u

static struct paper_lab lab;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "curves: %s:%d: %s\n", file, line, condition);
    abort();
}

static struct paper_options wet(uint8_t grade)
{
    return (struct paper_options){ .grade = grade,
                                   .wetness = 1.0f,
                                   .wet_fraction = 1.0f,
                                   .tilt_rad = 0.5f * F_PI,
                                   .fish_m = 0.05f,
                                   .tick_count = (uint32_t)(LAST_S * CORE_TICK_HZ) };
}

/* ---- Time to tear --------------------------------------------------------------------------- */

static double time_to_tear_s(const struct paper_options *plan)
{
    paper_lab_open(&lab, plan);
    while (lab.tick < plan->tick_count && lab.tore_tick == 0) {
        paper_lab_tick(&lab);
    }
    return lab.tore_tick > 0 ? paper_lab_tore_s(&lab) : 1e3;
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static void put_speed(struct paper_options plan, double speed_m_s)
{
    double times[SPECIMENS];
    plan.speed_m_s = (float)speed_m_s;
    for (uint32_t seed = 0; seed < SPECIMENS; seed++) {
        plan.seed = seed + 1u;
        times[seed] = time_to_tear_s(&plan);
    }
    qsort(times, SPECIMENS, sizeof times[0], by_size);
    printf("%u\t%.2f\t%.4f\t%.4f\t%.4f\t%.4f\n", plan.grade, (double)plan.wet_fraction, speed_m_s,
           times[SPECIMENS / 2u], times[0], times[SPECIMENS - 1u]);
}

static void put_tear(void)
{
    puts("grade\tfraction\tspeed_m_s\tmedian_s\tleast_s\tgreatest_s");
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        for (uint32_t half = 0; half < 2u; half++) {
            struct paper_options plan = wet(grade);
            plan.wet_fraction = half ? 0.5f : 1.0f;
            double speed_m_s = SPEED_MIN_M_S;
            for (uint32_t i = 0; i < SPEEDS; i++, speed_m_s *= SPEED_RATIO) {
                put_speed(plan, speed_m_s);
            }
            /* gnuplot requires an empty line between two blocks of data. */
            puts("\n");
        }
    }
}

/* ---- Force over tilt ------------------------------------------------------------------------ */

static void put_force(void)
{
    puts("tilt_deg\tforce_n");
    for (uint32_t degrees = 0; degrees <= 90u; degrees++) {
        struct paper_options plan = wet(5);
        plan.tilt_rad = (float)degrees * F_DEG;
        plan.speed_m_s = 0.3f;
        paper_lab_open(&lab, &plan);
        paper_lab_tick(&lab);
        printf("%u\t%.5f\n", degrees, (double)lab.force_n);
    }
}

/* ---- Holes in the sheet --------------------------------------------------------------------- */

static int put_sheet(const char *folder, uint32_t specimen, uint32_t moment)
{
    char path[512];
    const struct sheet *sheet = &lab.poi.sheet;
    snprintf(path, sizeof path, "%s/hole-%u-%u.txt", folder, specimen, moment);
    FILE *file = fopen(path, "w");
    if (!file) {
        perror(path);
        return 74;
    }
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const char *end = cell % SHEET_SIDE == SHEET_SIDE - 1u ? "\n" : " ";
        if (sheet->state[cell] == CELL_OUTSIDE) {
            fprintf(file, "-9%s", end);
        } else {
            fprintf(file, "%d%s", sheet->state[cell] == CELL_HOLE ? -1 : sheet->stress[cell], end);
        }
    }
    return fclose(file) == 0 ? 0 : 74;
}

/* Moves the poi fast until the paper tears, and then slower, as a player does. */
static int put_hole(const char *folder, uint32_t specimen)
{
    /* Ticks after the tear at which the matrices of cells are written. */
    const uint32_t after[MOMENTS] = { 0, 12, 48, 120 };
    const int is_half_wet = specimen == HOLES;
    struct paper_options plan = wet(6);
    plan.wet_fraction = is_half_wet ? 0.5f : 1.0f;
    plan.seed = specimen;
    plan.speed_m_s = is_half_wet ? 0.33f : 0.52f;
    paper_lab_open(&lab, &plan);
    while (lab.tick < plan.tick_count && lab.tore_tick == 0) {
        paper_lab_tick(&lab);
    }
    int status = put_sheet(folder, specimen, 0);
    plan.speed_m_s *= is_half_wet ? 1.0f : 0.55f;
    for (uint32_t moment = 1; moment < MOMENTS && status == 0; moment++) {
        while (lab.tick < lab.tore_tick + after[moment]) {
            paper_lab_tick(&lab);
        }
        status = put_sheet(folder, specimen, moment);
    }
    return status;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "tear") == 0) {
        put_tear();
        return 0;
    }
    if (argc == 2 && strcmp(argv[1], "force") == 0) {
        put_force();
        return 0;
    }
    if (argc == 3 && strcmp(argv[1], "holes") == 0) {
        int status = 0;
        for (uint32_t specimen = 1; specimen <= HOLES && status == 0; specimen++) {
            status = put_hole(argv[2], specimen);
        }
        return status;
    }
    fputs("curves: tear, force, or holes FOLDER\n", stderr);
    return 2;
}
