/* lines.h -- prints the output of `kingyoctl lines`, which is either the list of all GPIO
 * lines or the events on the configured lines. */
#pragma once

#include <stdio.h>

#include "drivers/gpio/gpio_thread.h"
#include "platform/config/options.h"

/* Prints a header and a tab-separated row for each line of each GPIO chip. Returns EXIT_OK. If
 * there is no GPIO chip or the output fails, prints an error and returns EXIT_NOT_SO. */
enum exit_code lines_list(struct gpio_lines lines, FILE *out);

/* State of an event display. `held` and `total` are the levels and the counters of `reader` at the
 * last call of lines_show_rows(), which prints the changes since that call. */
struct lines_show {
    struct gpio_thread *reader;
    uint64_t begin_ns;
    uint32_t held;
    struct gpio_total total;
};

/* Starts an event display. Only changes after the current state of `reader` are printed. `reader`
 * must outlive the display. */
struct lines_show lines_show_begin(struct gpio_thread *reader);

/* Prints a row for each press, release, coin and fault since the last call. A row contains the
 * seconds since the start of the display, the role of the line and the event, separated by tabs. */
void lines_show_rows(struct lines_show *show, FILE *out);
