/* lines_show.h -- the output of `kingyoctl lines`: the list of GPIO lines, and the events on
 * configured lines. */
#ifndef KINGYO_PLATFORM_CTL_DEVICES_LINES_SHOW_H
#define KINGYO_PLATFORM_CTL_DEVICES_LINES_SHOW_H

#include <stdio.h>

#include "drivers/gpio/buttons_gpio.h"
#include "platform/config/options.h"

/* Prints a header and a tab-separated row for each line of each chip. Returns EXIT_OK, or
 * EXIT_NOT_SO after printing an error if there is no chip or the output fails. */
enum exit_code lines_list(struct gpio_lines lines, FILE *out);

/* State of an event display. The counters are compared with those of the last call. */
struct lines_show {
    struct gpio_thread *reader;
    uint64_t begin_ns;
    uint32_t held;
    struct gpio_total total;
};

/* Starts an event display with the current state of `reader` as its base. `reader` must outlive
 * the display. */
struct lines_show lines_show_begin(struct gpio_thread *reader);

/* Prints a row for each press, release, coin and fault since the last call. A row has the seconds
 * since the start, the role and the event, separated by tabs. */
void lines_show_rows(struct lines_show *show, FILE *out);

#endif
