/* board_report.h -- prints the report of `kingyo --selftest-board`: what the board is, what drew
 * the picture, and whether the picture had 60 frames a second. A person who owns a board sends the
 * report, because the project's own tests run in emulators only. */
#pragma once

#include <stdint.h>
#include <stdio.h>

#include "platform/kiosk/frame_pacer.h"

struct board_report {
    /* Prefix of all paths: "" for this machine, or a test folder with the same layout. */
    const char *root;
    const char *display; /* Description of the display by its driver. */
    uint32_t seconds;    /* Duration of the run. */
    uint32_t fish, players;
    /* Time of the first picture since power on, in milliseconds. */
    uint64_t first_picture_ms;
    uint64_t frames, dropped_ticks;
    uint32_t faults;                       /* Number of device faults that the kiosk survived. */
    const struct frame_timing *frame_time; /* Time from one picture to the next. */
    const struct frame_timing *work_time;  /* Time from the first device poll to the buffer swap. */
    /* Temperature margin (thermal_read()) before and after the run. */
    int32_t margin_begin_mdeg, margin_end_mdeg;
};

/* Writes the report to `out`, about 15 lines. The value of a missing file is "unknown". */
void board_report_print(const struct board_report *report, FILE *out);
