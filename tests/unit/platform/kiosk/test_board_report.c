/* test_board_report.c -- the report of a board's self-test: values from files, unknown values, and
 * the verdict about the frame rate. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "platform/kiosk/board_report.h"
#include "platform/thermal.h"

static struct frame_timing frame_time, work_time;
static char root[] = "/tmp/kingyo-board-XXXXXX";

static void write_file(const char *folder, const char *name, const char *text, size_t size)
{
    char command[256], path[256];
    snprintf(command, sizeof command, "mkdir -p '%s%s'", root, folder);
    assert_int_equal(system(command), 0);
    snprintf(path, sizeof path, "%s%s/%s", root, folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, size, file), size);
    fclose(file);
}

/* Prints the report of a run whose frames took `frame_ms`, and returns the text. */
static const char *report_of(uint32_t frame_ms, int32_t margin_end_mdeg)
{
    static char text[4096];
    frame_time = (struct frame_timing){ 0 };
    for (uint32_t i = 0; i < 1000; i++) {
        frame_timing_add(&frame_time, frame_ms * 1000000ull + 700000ull);
    }
    const struct board_report report = {
        .root = root,
        .display = "V3D 4.2, 1280x720",
        .seconds = 180,
        .fish = 300,
        .players = 4,
        .first_picture_ms = 14250,
        .frames = 1000,
        .dropped_ticks = 3,
        .faults = 1,
        .frame_time = &frame_time,
        .work_time = &work_time,
        .margin_begin_mdeg = 30500,
        .margin_end_mdeg = margin_end_mdeg,
    };
    memset(text, 0, sizeof text);
    FILE *out = fmemopen(text, sizeof text - 1, "w");
    assert_non_null(out);
    board_report_print(&report, out);
    fclose(out);
    return text;
}

static void assert_has(const char *text, const char *line)
{
    if (!strstr(text, line)) {
        fail_msg("no '%s' in:\n%s", line, text);
    }
}

static void reads_values_of_the_board(void **state)
{
    (void)state;
    static const char model[] = "Raspberry Pi 4 Model B Rev 1.5";
    write_file("/proc/device-tree", "model", model, sizeof model);
    write_file("/proc", "meminfo", "MemTotal:  3884472 kB\nMemAvailable: 3000000 kB\n", 51);
    write_file("/run", "kingyo-data", "kept: /dev/mmcblk0p4, ext4; start 7\n", 36);
    const char *text = report_of(16, 12000);
    assert_has(text, "board            Raspberry Pi 4 Model B Rev 1.5\n");
    assert_has(text, "memory           3884472 kB\n");
    assert_has(text, "memory free      3000000 kB\n");
    assert_has(text, "data partition   kept: /dev/mmcblk0p4, ext4; start 7\n");
    assert_has(text, "heat             30.5 K below the limit at the start, 12.0 K at the end\n");
    assert_has(text, "drawn by         V3D 4.2, 1280x720\n");
    assert_has(text, "tank             300 fish, 4 players\n");
    assert_has(text, "first picture    14.2 s after power on\n");
    assert_has(text, "lost             3 ticks dropped, 1 device faults\n");
    assert_has(text, "60 a second      yes\n");
}

static void reports_unknown_values(void **state)
{
    (void)state;
    const char *text = report_of(16, THERMAL_UNKNOWN_MDEG);
    assert_has(text, "watchdog         unknown\n");
    assert_has(text, "throttled        unknown\n");
    assert_has(text, "heat             unknown\n");
}

static void refuses_thirty_frames_a_second(void **state)
{
    (void)state;
    assert_has(report_of(33, 12000), "60 a second      NO\n");
}

static int make_root(void **state)
{
    (void)state;
    return mkdtemp(root) ? 0 : -1;
}

static int remove_root(void **state)
{
    char command[64];
    (void)state;
    snprintf(command, sizeof command, "rm -r '%s'", root);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_values_of_the_board),
        cmocka_unit_test(reports_unknown_values),
        cmocka_unit_test(refuses_thirty_frames_a_second),
    };
    return cmocka_run_group_tests(tests, make_root, remove_root);
}
