/* lines_show.h -- what `kingyoctl lines` tells of GPIO lines: which there are, and what they do. */
#ifndef KINGYO_PLATFORM_CTL_LINES_SHOW_H
#define KINGYO_PLATFORM_CTL_LINES_SHOW_H

#include <stdio.h>

#include "drivers/buttons_gpio.h"
#include "platform/kiosk/options.h"

/* A row for each line of each chip, tab-separated, a head first. EXIT_NOT_SO, told on standard
 * error, where there is no chip. */
enum exit_code lines_list(struct gpio_lines lines, FILE *out);

/* One look at lines that are stepped: what changed since the last one. */
struct lines_show {
    struct gpio_reader *reader;
    uint64_t begin_ns;
    uint32_t held;
    struct gpio_total total;
};

struct lines_show lines_show_begin(struct gpio_reader *reader);

/* Prints a row for each press, release, coin and fault since the last call: seconds since the
 * beginning, role, what; tab-separated. */
void lines_show_rows(struct lines_show *show, FILE *out);

#endif
