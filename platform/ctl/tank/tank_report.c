/* tank_report.c -- writes the trace, and computes and prints the results of a tank simulation. */
#include "platform/ctl/tank/tank_report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/json.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

#define DEG (180.0 / 3.14159265358979323846)
#define ROW_MAX 512u
#define BAR_WIDTH 40
/* Maximum number of characters in a chart. A chart of a longer simulation omits seconds at regular
 * intervals. */
#define SPARKS_MAX 60u

static const char *const gait_names[GAIT_COUNT] = {
    [GAIT_REST] = "rest",     [GAIT_SWIM] = "swim",       [GAIT_BURST] = "burst",
    [GAIT_ESCAPE] = "escape", [GAIT_SURFACE] = "surface", [GAIT_HELD] = "held",
    [GAIT_BOWL] = "held",
};
static const char *const avoiding_names[] = { "none", "yaw", "pitch" };

static enum exit_code tank_trace_print_error(const struct tank_trace *trace, int error)
{
    return print_fail(EXIT_IO, "kingyoctl tank: --trace: %s: %s", trace->path, strerror(error));
}

enum exit_code tank_trace_open(struct tank_trace *trace, const char *path)
{
    trace->path = path;
    const int error = file_atomic_open(&trace->out, path);
    if (error) {
        return tank_trace_print_error(trace, -error);
    }
    trace->file = trace->out.file;
    fputs("tick,fish,x_cm,y_cm,z_cm,yaw_deg,pitch_deg,roll_deg,length_cm,height_cm,width_cm,"
          "speed_cm_s,tail_hz,gait,stamina,avoiding\n",
          trace->file);
    return EXIT_OK;
}

void tank_trace_add(struct tank_trace *trace, const struct tank *tank, uint32_t tick)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        CORE_ASSERT(fish->gait < GAIT_COUNT && fish->avoiding < 3);
        const struct {
            double value;
            uint32_t decimals;
        } figures[] = {
            { (double)tick, 0 },
            { (double)i, 0 },
            { 100.0 * (double)fish->position_m.x, 4 },
            { 100.0 * (double)fish->position_m.y, 4 },
            { 100.0 * (double)fish->position_m.z, 4 },
            { DEG * (double)fish->angles.yaw_rad, 4 },
            { DEG * (double)fish->angles.pitch_rad, 4 },
            { DEG * (double)fish->angles.roll_rad, 4 },
            { 100.0 * (double)fish->length_m, 4 },
            { 100.0 * (double)fish->height_m, 4 },
            { 100.0 * (double)fish->width_m, 4 },
            { 100.0 * (double)v3_length(fish->velocity_m_s), 4 },
            { (double)fish->tail_beat_hz, 3 },
        };
        char row[ROW_MAX];
        uint32_t length = 0;
        for (uint32_t k = 0; k < sizeof figures / sizeof figures[0]; k++) {
            length += number_print_fixed(row + length, figures[k].value, figures[k].decimals);
            row[length++] = ',';
        }
        fwrite(row, 1, length, trace->file);
        length = number_print_fixed(row, 100.0 * (double)fish->stamina, 3);
        fprintf(trace->file, "%s,%.*s,%s\n", gait_names[fish->gait], (int)length, row,
                avoiding_names[fish->avoiding]);
    }
}

enum exit_code tank_trace_close(struct tank_trace *trace)
{
    const int error = file_atomic_close(&trace->out);
    trace->file = NULL;
    return error ? tank_trace_print_error(trace, -error) : EXIT_OK;
}

/* ---- Statistics ------------------------------------------------------------------------------ */

static int by_size(const void *left, const void *right)
{
    const float a = *(const float *)left, b = *(const float *)right;
    return (a > b) - (a < b);
}

struct tank_figures tank_figures_of(struct tank_lab *lab)
{
    const struct lab_sums *sums = &lab->sums;
    double sum_ns = 0.0;
    CORE_ASSERT(lab->timed_count > 0 && sums->fish_ticks > 0);
    for (uint32_t i = 0; i < lab->timed_count; i++) {
        sum_ns += (double)lab->tick_ns[i];
    }
    const double fish_ticks = (double)sums->fish_ticks;
    const double swim_ticks = sums->swim_ticks > 0 ? (double)sums->swim_ticks : 1.0;
    struct tank_figures figures = {
        .ns_per_fish_tick = sum_ns / (double)lab->timed_count / (double)lab->tank.fish_count,
        .speed_mean_cm_s = 100.0 * sums->speed_m_s / swim_ticks,
        .speed_max_cm_s = 100.0 * sums->speed_max_m_s,
        .stamina_mean = 100.0 * sums->stamina / fish_ticks,
    };
    for (uint32_t gait = 0; gait < GAIT_COUNT; gait++) {
        figures.share[gait] = (double)sums->gait_ticks[gait] / fish_ticks;
        figures.other_share += gait > GAIT_BURST ? figures.share[gait] : 0.0;
    }
    figures.surfacing_share = figures.share[GAIT_SURFACE];
    const uint32_t count = lab->timed_count;
    qsort(lab->tick_ns, count, sizeof lab->tick_ns[0], by_size);
    figures.tick_ms_median = 1e-6 * (double)lab->tick_ns[count / 2u];
    figures.tick_ms_p99 = 1e-6 * (double)lab->tick_ns[(uint32_t)(count * 99ull / 100u)];
    return figures;
}

/* ---- Output as JSON -------------------------------------------------------------------------- */

static void put_counts(struct json *json, const char *key, const uint32_t *counts, uint32_t count)
{
    json_open(json, key, '[');
    for (uint32_t i = 0; i < count; i++) {
        json_value(json, NULL, "%u", counts[i]);
    }
    json_close(json, ']');
}

void tank_report_json(const struct tank_lab *lab, const struct tank_figures *figures)
{
    const struct tank_meetings *meetings = &lab->meetings;
    const uint32_t seconds = tank_lab_seconds(lab->plan);
    struct json json = { .file = stdout };
    json_print(&json,
               "{preset: %s, fish: %u, seconds: %.3f, seed: %u, ticks: %u, observe_every: %u,"
               " state_hash: %016llx,",
               tank_preset(lab->tank.preset)->name, lab->tank.fish_count, lab->plan->seconds,
               lab->tank.seed, lab->tick, lab->observe_every,
               (unsigned long long)tank_lab_hash(lab));
    json_print(&json,
               "ns_per_fish_tick: %.1f, tick_ms_median: %.6f, tick_ms_p99: %.6f,"
               " body_overlaps: %llu, deepest_overlap_mm: %.4f,",
               figures->ns_per_fish_tick, figures->tick_ms_median, figures->tick_ms_p99,
               (unsigned long long)lab->overlaps.pairs, lab->overlaps.deepest_mm);
    json_print(&json,
               "encounters: {head_on: %llu, side: %llu, rear_end: %llu, by_yaw: %llu,"
               " by_pitch: %llu},",
               (unsigned long long)meetings->head_on, (unsigned long long)meetings->side,
               (unsigned long long)meetings->rear_end, (unsigned long long)meetings->by_yaw,
               (unsigned long long)meetings->by_pitch);
    json_print(&json,
               "gait_share: {burst: %.6f, swim: %.6f, rest: %.6f, other: %.6f},"
               " speed_cm_s: {mean: %.4f, max: %.4f}, stamina_mean: %.4f, surfacing_share: %.6f,"
               " oxygen_mg_l: {start: %.4f, end: %.4f},",
               figures->share[GAIT_BURST], figures->share[GAIT_SWIM], figures->share[GAIT_REST],
               figures->other_share, figures->speed_mean_cm_s, figures->speed_max_cm_s,
               figures->stamina_mean, figures->surfacing_share, (double)lab->oxygen_start_mg_l,
               (double)lab->tank.oxygen.dissolved_mg_l);
    put_counts(&json, "shade_count", lab->shade_count, seconds);
    put_counts(&json, "surfacing_count", lab->surfacing_count, seconds);
    json_close(&json, '}');
    json_end(&json);
}

/* ---- Output as text -------------------------------------------------------------------------- */

static void tank_report_print_bar(const char *label, double share)
{
    const int full = (int)(share * BAR_WIDTH + 0.5);
    printf("  %-8s %5.1f %% ", label, 100.0 * share);
    for (int i = 0; i < full; i++) {
        fputs("█", stdout);
    }
    putchar('\n');
}

/* Prints a chart of `counts`, in which the height of each character shows the count of one second.
 * If there are more than SPARKS_MAX seconds, some seconds are omitted at regular intervals. */
static void sparks(const char *label, const uint32_t *counts, uint32_t count)
{
    static const char *const heights[] = { "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█" };
    const uint32_t stride = (count + SPARKS_MAX - 1u) / SPARKS_MAX;
    uint32_t most = 1;
    for (uint32_t i = 0; i < count; i++) {
        most = counts[i] > most ? counts[i] : most;
    }
    printf("%-12s ", label);
    for (uint32_t i = 0; i < count; i += stride) {
        fputs(heights[counts[i] * 7u / most], stdout);
    }
    printf("  %u at the start, %u at the end, %u at most\n", counts[0], counts[count - 1u],
           most == 1 && counts[count - 1u] == 0 && counts[0] == 0 ? 0 : most);
}

void tank_report_text(const struct tank_lab *lab, const struct tank_figures *figures)
{
    const uint32_t seconds = tank_lab_seconds(lab->plan);
    const struct tank_meetings *meetings = &lab->meetings;
    const vec3 size_m = lab->tank.size_m;
    printf("%s: %u fish in %.1f x %.1f cm, %.1f cm of water; seed %u, %.1f s, %u ticks\n",
           tank_preset(lab->tank.preset)->name, lab->tank.fish_count, 100.0 * (double)size_m.x,
           100.0 * (double)size_m.z, 100.0 * (double)size_m.y, lab->tank.seed, lab->plan->seconds,
           lab->tick);
    printf("state hash   %016llx\n", (unsigned long long)tank_lab_hash(lab));
    printf("cost         %.0f ns a fish and tick; a tick %.3f ms median, %.3f ms p99\n",
           figures->ns_per_fish_tick, figures->tick_ms_median, figures->tick_ms_p99);
    printf("overlaps     %llu pair-ticks deeper than %.1f mm; deepest %.3f mm\n",
           (unsigned long long)lab->overlaps.pairs, OVERLAP_DEEP_MM, lab->overlaps.deepest_mm);
    printf("encounters   %llu head-on, %llu from the side, %llu from behind; %llu turns, "
           "%llu climbs or dives\n",
           (unsigned long long)meetings->head_on, (unsigned long long)meetings->side,
           (unsigned long long)meetings->rear_end, (unsigned long long)meetings->by_yaw,
           (unsigned long long)meetings->by_pitch);
    printf("speed        %.2f cm/s mean, %.2f cm/s most\n", figures->speed_mean_cm_s,
           figures->speed_max_cm_s);
    printf("stamina      %.1f of 100\n", figures->stamina_mean);
    printf("oxygen       %.2f mg/L at the start, %.2f mg/L at the end\n",
           (double)lab->oxygen_start_mg_l, (double)lab->tank.oxygen.dissolved_mg_l);
    puts("gaits");
    tank_report_print_bar("burst", figures->share[GAIT_BURST]);
    tank_report_print_bar("swim", figures->share[GAIT_SWIM]);
    tank_report_print_bar("rest", figures->share[GAIT_REST]);
    tank_report_print_bar("other", figures->other_share);
    if (lab->plan->shade_count > 0) {
        sparks("in the shade", lab->shade_count, seconds);
    }
    sparks("surfacing", lab->surfacing_count, seconds);
}
