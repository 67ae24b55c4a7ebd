/* lines_show.c -- prints GPIO lines and their events as rows. */
#include "platform/ctl/devices/lines_show.h"

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "drivers/gpio/gpio_config.h"
#include "platform/os/print.h"

static const char *or_dash(const char *text)
{
    return text[0] ? text : "-";
}

static void tell_line(void *context, const struct gpio_line_info *line)
{
    FILE *out = context;
    struct gpio_line_info shown = *line; /* Copy of the line's description, in which all texts are
                                            made printable. The consumer of a line chooses its own
                                            name, so the name may contain any character. */
    printable(shown.device);
    printable(shown.chip);
    printable(shown.name);
    printable(shown.consumer);
    fprintf(out, "%s\t%s\t%u\t%s\t%s\t%s\t%s\n", shown.device, or_dash(shown.chip), line->offset,
            or_dash(shown.name), line->is_output ? "out" : "in", line->active_low ? "low" : "high",
            shown.consumer[0] ? shown.consumer
            : line->used      ? "somebody"
                              : "-");
}

enum exit_code lines_list(struct gpio_lines lines, FILE *out)
{
    fputs("device\tchip\toffset\tname\tdirection\tactive\theld_by\n", out);
    const int count = lines.ops->list(lines.self, tell_line, out);
    if (print_flush(out) != 0) {
        return EXIT_NOT_SO; /* A write to standard output failed. main() prints the error
                               message. */
    }
    if (count == HAL_ERR_ABSENT) {
        print_error("kingyoctl lines: no GPIO chip in /dev (%s)", lines.ops->describe(lines.self));
        return EXIT_NOT_SO;
    }
    if (count == 0) {
        print_error("kingyoctl lines: there are chips, but none that may be opened; a user in the "
                    "group of /dev/gpiochip* may");
        return EXIT_NOT_SO;
    }
    return EXIT_OK;
}

static uint64_t lines_show_now_ns(const struct gpio_thread *reader)
{
    return reader->clock.ops->now_ns(reader->clock.self);
}

struct lines_show lines_show_begin(struct gpio_thread *reader)
{
    return (struct lines_show){
        .reader = reader,
        .begin_ns = lines_show_now_ns(reader),
        .held = reader->levels,
        .total = reader->total,
    };
}

static void begin_row(const struct lines_show *show, FILE *out, const char *role)
{
    fprintf(out, "%.3f\t%s\t", (double)(lines_show_now_ns(show->reader) - show->begin_ns) * 1e-9,
            role);
}

/* Prints the press and the release of a button. A button that was pressed and released between two
 * polls gets two rows. */
static void show_button(const struct lines_show *show, FILE *out, enum gpio_role role,
                        uint32_t pressed)
{
    const uint32_t bit = 1u << role;
    const uint32_t held = show->reader->levels;
    if (pressed & bit) {
        begin_row(show, out, gpio_role_name(role));
        fputs("pressed\n", out);
    }
    if (((show->held | pressed) & bit) && !(held & bit)) {
        begin_row(show, out, gpio_role_name(role));
        fputs("released\n", out);
    }
}

static void show_count(const struct lines_show *show, FILE *out, const char *what, uint32_t before,
                       uint32_t now)
{
    if (now != before) {
        begin_row(show, out, gpio_role_name(GPIO_COIN));
        fprintf(out, "%s: %u so far\n", what, now);
    }
}

void lines_show_rows(struct lines_show *show, FILE *out)
{
    CORE_ASSERT(show->reader && out);
    struct gpio_thread *reader = show->reader;
    const uint32_t pressed = atomic_exchange(&reader->pressed, 0);
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        show_button(show, out, role, pressed);
    }
    const struct gpio_total *now = &reader->total, *before = &show->total;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        if (now->coins[line] != before->coins[line]) {
            begin_row(show, out, gpio_role_name(GPIO_COIN + line));
            fprintf(out, "coin %u, its pulse %.1f ms\n", now->coins[line],
                    (double)reader->coin[line].width_ns * 1e-6);
        }
    }
    show_count(show, out, "too short for a coin", before->too_short, now->too_short);
    show_count(show, out, "a coin sticks", before->stuck, now->stuck);
    show_count(show, out, "its line went in mid-pulse", before->cut, now->cut);
    show_count(show, out, "two sparks, or a coin that nobody saw", before->doubtful, now->doubtful);
    if (reader->total.lost_edges != show->total.lost_edges) {
        begin_row(show, out, "-");
        fprintf(out, "edges lost: %u so far\n", reader->total.lost_edges);
    }
    if (reader->total.lost_chips != show->total.lost_chips) {
        begin_row(show, out, "-");
        fputs("a chip went away; it is looked for\n", out);
    }
    show->held = reader->levels;
    show->total = reader->total;
}
