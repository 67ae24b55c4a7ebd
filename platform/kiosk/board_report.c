/* board_report.c -- prints the report of `kingyo --selftest-board`; see board_report.h. */
#include "platform/kiosk/board_report.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/printable.h"
#include "core/core.h"
#include "platform/os/file.h"
#include "platform/thermal.h"

#define CPU_FREQUENCY "/sys/devices/system/cpu/cpu0/cpufreq/scaling_cur_freq"
#define GET_THROTTLED "/sys/devices/platform/soc/soc:firmware/get_throttled"
#define TEXT_SIZE 256u
#define LINE_COUNT_MAX 400u /* Number of lines of a file that are searched. */

/* Copies the first line of the file `path` that starts with `key`, without `key` and blanks.
 * `text` becomes "unknown" if there is none. */
static void read_value(const struct board_report *report, const char *path, const char *key,
                       char text[TEXT_SIZE])
{
    char whole[1024], line[TEXT_SIZE];
    snprintf(text, TEXT_SIZE, "unknown");
    snprintf(whole, sizeof whole, "%s%s", report->root, path);
    FILE *file = file_open(whole, FILE_KERNEL_SIZE_MAX);
    if (!file) {
        return;
    }
    for (uint32_t i = 0; i < LINE_COUNT_MAX; i++) {
        if (file_read_line(file, line, sizeof line) == FILE_LINE_END) {
            break;
        }
        const size_t length = strlen(key);
        if (strncmp(line, key, length) == 0 && line[length]) {
            snprintf(text, TEXT_SIZE, "%s", line + length + strspn(line + length, " \t:"));
            printable(text);
            break;
        }
    }
    fclose(file);
}

static void print_value(const struct board_report *report, FILE *out, const char *name,
                        const char *path, const char *key)
{
    char text[TEXT_SIZE];
    read_value(report, path, key, text);
    fprintf(out, "%-16s %s\n", name, text);
}

static double ms_of(const struct frame_timing *timing, double share)
{
    return (double)frame_timing_quantile_ns(timing, share) * 1e-6;
}

static void print_heat(const struct board_report *report, FILE *out)
{
    if (report->margin_end_mdeg == THERMAL_UNKNOWN_MDEG) {
        fprintf(out, "%-16s unknown\n", "heat");
        return;
    }
    fprintf(out, "%-16s %.1f K below the limit at the start, %.1f K at the end\n", "heat",
            report->margin_begin_mdeg * 1e-3, report->margin_end_mdeg * 1e-3);
}

/* A picture that is shown for more than 1.5 periods of a 60 Hz screen is late. */
static void print_frames(const struct board_report *report, FILE *out)
{
    const struct frame_timing *frame = report->frame_time;
    const double late_ms = ms_of(frame, 0.99), median_ms = ms_of(frame, 0.5);
    const bool holds = report->frames > 0 && median_ms < 17.5 && late_ms < 25.0;
    fprintf(out, "%-16s %llu in %u s; median %.1f ms, 99 of 100 within %.1f ms\n", "frames",
            (unsigned long long)report->frames, report->seconds, median_ms, late_ms);
    fprintf(out, "%-16s median %.1f ms, 99 of 100 within %.1f ms\n", "work",
            ms_of(report->work_time, 0.5), ms_of(report->work_time, 0.99));
    fprintf(out, "%-16s %llu ticks dropped, %u device faults\n", "lost",
            (unsigned long long)report->dropped_ticks, report->faults);
    fprintf(out, "%-16s %s\n", "60 a second", holds ? "yes" : "NO");
}

void board_report_print(const struct board_report *report, FILE *out)
{
    fprintf(out, "---- Kingyo %s, self-test of a board: please send these lines ----\n",
            KINGYO_VERSION);
    print_value(report, out, "board", "/proc/device-tree/model", "");
    print_value(report, out, "kernel", "/proc/version", "");
    print_value(report, out, "memory", "/proc/meminfo", "MemTotal");
    print_value(report, out, "memory free", "/proc/meminfo", "MemAvailable");
    print_value(report, out, "processor kHz", CPU_FREQUENCY, "");
    print_value(report, out, "throttled", GET_THROTTLED, "");
    print_value(report, out, "data partition", "/run/kingyo-data", "");
    print_value(report, out, "watchdog", "/sys/class/watchdog/watchdog0/identity", "");
    print_heat(report, out);
    fprintf(out, "%-16s %s\n", "drawn by", report->display);
    fprintf(out, "%-16s %u fish, %u players\n", "tank", report->fish, report->players);
    fprintf(out, "%-16s %.1f s after power on\n", "first picture",
            (double)report->first_picture_ms * 1e-3);
    print_frames(report, out);
    fprintf(out, "---- end ----\n");
}
