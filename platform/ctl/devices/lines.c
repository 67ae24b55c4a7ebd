/* lines.c -- the command `kingyoctl lines`.
 *
 * The command lists the GPIO lines, shows events on configured lines and tests outputs. */
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "drivers/gpio/gpio_config.h"
#include "platform/ctl/devices/lines.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/clock.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

#define SECONDS_MAX 86400u

/* Seconds for which an output stays on if the option --seconds is absent. The time is long enough
 * to check a lamp. */
#define SET_SECONDS 3u
#define PULSES_MAX 1000u /* Maximum number of pulses in a test of a coin meter. */

static const char name[] = "lines";
static struct gpio_thread gpio;
static volatile sig_atomic_t is_stopped;

/* Arguments of a subcommand of `kingyoctl lines`. */
struct request {
    struct gpio_wire wires[GPIO_ROLE_COUNT];
    enum gpio_role role; /* Role of the last line that the command line configures. */
    uint32_t seconds;    /* Value of the option --seconds. 0 means that the option was not given. */
    const char *word;    /* Last argument: "on", "off" or a number of pulses. Null means that the
                            argument is absent. */
};

/* ---- Command line ---------------------------------------------------------------------------- */

/* Parses one argument: ROLE=LINE, or a value such as "on" or a number of pulses. At most one value
 * is allowed. */
static bool take_word(void *target, const struct option *option, const char *text, char *why)
{
    struct request *request = target;
    char reason[HAL_TEXT_SIZE];
    (void)option;
    if (!strchr(text, '=')) {
        const bool is_first = request->word == NULL;
        request->word = text;
        return is_first;
    }
    if (!gpio_wire_read(text, request->wires, reason) ||
        !gpio_config_agrees(request->wires, reason)) {
        snprintf(why, OPTION_TEXT_MAX, "%s", reason);
        return false;
    }
    request->role = gpio_role_find(text, (size_t)(strchr(text, '=') - text));
    return true;
}

static const struct option options[] = {
    { NULL, "ROLE=LINE", "line and its role, or a value", OPTION_ARGUMENT, .set = take_word },
    { "seconds", "N", "duration", OPTION_WHOLE, .offset = offsetof(struct request, seconds), 1,
      SECONDS_MAX },
};

static const struct option_table table = OPTION_TABLE(options, NULL);

/* ---- Rows of GPIO lines and of their events -------------------------------------------------- */

static const char *or_dash(const char *text)
{
    return text[0] ? text : "-";
}

static void print_line_info(void *context, const struct gpio_line_info *line)
{
    FILE *out = context;
    /* The texts of the line are made printable in a copy, because any program can set the consumer
     * name of a line that it uses. */
    struct gpio_line_info shown = *line;
    printable(shown.device);
    printable(shown.chip);
    printable(shown.name);
    printable(shown.consumer);
    fprintf(out, "%s\t%s\t%u\t%s\t%s\t%s\t%s\n", shown.device, or_dash(shown.chip), line->offset,
            or_dash(shown.name), line->is_output ? "out" : "in", line->active_low ? "low" : "high",
            shown.consumer[0] ? shown.consumer
            : line->used      ? "unknown"
                              : "-");
}

enum exit_code lines_list(struct gpio_lines lines, FILE *out)
{
    fputs("device\tchip\toffset\tname\tdirection\tactive\theld_by\n", out);
    const int count = lines.ops->list(lines.self, print_line_info, out);
    if (print_flush(out) != 0) {
        /* Writing to standard output failed. main() prints the error message. */
        return EXIT_NOT_SO;
    }
    if (count == HAL_ERR_ABSENT) {
        return print_fail(EXIT_NOT_SO,
                          "kingyoctl lines: this machine has no GPIO chip in /dev (%s)",
                          lines.ops->describe(lines.self));
    }
    if (count == 0) {
        return print_fail(EXIT_NOT_SO,
                          "kingyoctl lines: you may open none of the GPIO chips; join the group of "
                          "/dev/gpiochip*");
    }
    return EXIT_OK;
}

static uint64_t lines_show_now_ns(const struct gpio_thread *reader)
{
    return reader->clock.ops->now_ns(reader->clock.self);
}

struct lines_show lines_show_begin(struct gpio_thread *reader)
{
    return (struct lines_show){ reader, lines_show_now_ns(reader), reader->levels, reader->total };
}

/* Prints one row: the seconds since the start of the display, the role of the line, and the
 * event. */
__attribute__((format(printf, 4, 5))) static void
show_row(const struct lines_show *show, FILE *out, const char *role, const char *format, ...)
{
    va_list arguments;
    fprintf(out, "%.3f\t%s\t", (double)(lines_show_now_ns(show->reader) - show->begin_ns) * 1e-9,
            role);
    va_start(arguments, format);
    vfprintf(out, format, arguments);
    va_end(arguments);
    fputc('\n', out);
}

/* Prints the press and the release of a button. A button that was pressed and released between two
 * polls gets two rows. */
static void show_button(const struct lines_show *show, FILE *out, enum gpio_role role,
                        uint32_t pressed)
{
    const uint32_t bit = 1u << role;
    if (pressed & bit) {
        show_row(show, out, gpio_role_name(role), "pressed");
    }
    if (((show->held | pressed) & bit) && !(show->reader->levels & bit)) {
        show_row(show, out, gpio_role_name(role), "released");
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
            show_row(show, out, gpio_role_name(GPIO_COIN + line), "coin %u, its pulse %.1f ms",
                     now->coins[line], (double)reader->coin[line].width_ns * 1e-6);
        }
    }
    const char *coin = gpio_role_name(GPIO_COIN);
    const struct {
        const char *role, *what;
        uint32_t now, before;
    } faults[] = {
        { coin, "pulses too short for a coin", now->too_short, before->too_short },
        { coin, "coins stuck in the slot", now->stuck, before->stuck },
        { coin, "pulses cut off because the line was removed", now->cut, before->cut },
        { coin, "pulses that may be glitches or coins", now->doubtful, before->doubtful },
        { "-", "edges lost", now->lost_edges, before->lost_edges },
        { "-", "chips removed", now->lost_chips, before->lost_chips },
    };
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        if (faults[i].now != faults[i].before) {
            show_row(show, out, faults[i].role, "%s: %u so far", faults[i].what, faults[i].now);
        }
    }
    show->held = reader->levels;
    show->total = reader->total;
}

/* ---- GPIO lines ------------------------------------------------------------------------------ */

/* Opens the configured lines. Returns EXIT_OK, or prints a reason for each line that was not opened
 * and returns EXIT_IO. */
static enum exit_code open_lines(const struct request *request)
{
    gpio_thread_open(&gpio, gpio_lines_device(), request->wires, clock_device());
    for (uint32_t i = 0; i < GPIO_ROLE_COUNT; i++) {
        if (gpio.why[i][0]) {
            print_error("kingyoctl lines: %s: %s", gpio_role_name((enum gpio_role)i), gpio.why[i]);
        }
    }
    if ((uint32_t)__builtin_popcount(gpio.had) != gpio_config_count(gpio.wires)) {
        gpio_thread_close(&gpio);
        return EXIT_IO;
    }
    ctl_stop_at_signals(&is_stopped);
    return EXIT_OK;
}

/* Services the GPIO lines until the monotonic time `until_ns`, until a signal arrives, or until a
 * write to standard output fails. */
static void step_until(uint64_t until_ns, struct lines_show *show)
{
    while (!is_stopped && !ferror(stdout) && ctl_now_ns() < until_ns) {
        gpio_thread_step(&gpio);
        if (show) {
            lines_show_rows(show, stdout);
            fflush(stdout);
        }
    }
}

/* ---- Subcommands ----------------------------------------------------------------------------- */

static enum exit_code run_list(const struct request *request)
{
    if (gpio_config_count(request->wires) > 0 || request->word || request->seconds) {
        return ctl_usage(name, "list takes no arguments");
    }
    return lines_list(gpio_lines_device(), stdout);
}

static enum exit_code run_lines_watch(const struct request *request)
{
    if (gpio_config_count(request->wires) == 0 || request->word) {
        return ctl_usage(name, "watch needs ROLE=LINE, once or more");
    }
    const enum exit_code code = open_lines(request);
    if (code != EXIT_OK) {
        return code;
    }
    const struct hal_switches switches = gpio_thread_switches(&gpio);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0); /* Switches the coin lockout off, if a
                                                              lockout line is configured, so that
                                                              the coin acceptor accepts coins. */
    struct lines_show show = lines_show_begin(&gpio);
    puts("seconds\trole\twhat");
    fflush(stdout);
    step_until(request->seconds ? ctl_now_ns() + request->seconds * NS_PER_S : UINT64_MAX, &show);
    gpio_thread_close(&gpio);
    return EXIT_OK;
}

/* Checks that the request names exactly one output line and has a value. Returns EXIT_OK, or prints
 * one line and returns EXIT_USAGE. */
static enum exit_code check_output(const struct request *request, const char *wanted)
{
    if (gpio_config_count(request->wires) != 1 || !request->word) {
        return ctl_usage(name, "expected ROLE=LINE and %s", wanted);
    }
    return !gpio_role_is_input(request->role)
               ? EXIT_OK
               : ctl_usage(name,
                           "%s is a button: only start-lamp, coin-lockout, ticket and "
                           "coin-counter are switched",
                           gpio_role_name(request->role));
}

/* Returns the output that the command switches. check_output() must have returned EXIT_OK. */
static enum hal_switch output_of(const struct request *request)
{
    CORE_ASSERT(request->role >= GPIO_INPUT_COUNT);
    CORE_ASSERT(request->role < GPIO_ROLE_COUNT);
    return (enum hal_switch)(request->role - GPIO_INPUT_COUNT);
}

static enum exit_code run_set(const struct request *request)
{
    const char wanted[] = "'on' or 'off'";
    enum exit_code code = check_output(request, wanted);
    const bool is_on = code == EXIT_OK && strcmp(request->word, "on") == 0;
    if (code == EXIT_OK && !is_on && strcmp(request->word, "off") != 0) {
        return ctl_usage(name, "expected %s, not '%.40s'", wanted, request->word);
    }
    code = code == EXIT_OK ? open_lines(request) : code;
    if (code == EXIT_OK) {
        const struct hal_switches switches = gpio_thread_switches(&gpio);
        const uint32_t seconds = request->seconds ? request->seconds : SET_SECONDS;
        switches.ops->set(switches.self, output_of(request), is_on);
        step_until(ctl_now_ns() + seconds * NS_PER_S, NULL);
        gpio_thread_close(&gpio);
    }
    return code;
}

static enum exit_code run_pulse(const struct request *request)
{
    uint32_t count = 0;
    enum exit_code code = check_output(request, "a count");
    if (code == EXIT_OK && !number_parse(request->word, 1, PULSES_MAX, &count)) {
        return ctl_usage(name, "pulse needs a count from 1 to %u, not '%.40s'", PULSES_MAX,
                         request->word);
    }
    code = code == EXIT_OK ? open_lines(request) : code;
    if (code != EXIT_OK) {
        return code;
    }
    const struct hal_switches switches = gpio_thread_switches(&gpio);
    const enum hal_switch which = output_of(request);
    switches.ops->set(switches.self, which, 0); /* Switches the output off first, so that the pulses
                                                   start at the idle level. */
    switches.ops->pulse(switches.self, which, count);
    do {
        gpio_thread_step(&gpio);
    } while (!is_stopped && atomic_load(&gpio.owed) > 0);
    const uint32_t owed = atomic_load(&gpio.owed);
    gpio_thread_close(&gpio);
    printf("%u pulses on %s\n", count - owed, gpio_role_name(request->role));
    return owed == 0 ? EXIT_OK : EXIT_NOT_SO;
}

static enum exit_code run_lines_command(int argc, const char *const *argv)
{
    static const struct {
        const char *word;
        enum exit_code (*run)(const struct request *request);
    } subcommands[] = {
        { "list", run_list },
        { "watch", run_lines_watch },
        { "set", run_set },
        { "pulse", run_pulse },
    };
    struct request request = { 0 };
    if (argc == 0) {
        return ctl_usage(name, "expected list, watch, set or pulse; --help explains them");
    }
    for (size_t i = 0; i < sizeof subcommands / sizeof subcommands[0]; i++) {
        if (strcmp(argv[0], subcommands[i].word) == 0) {
            const enum exit_code code = ctl_options(name, &table, 0, &request, argc - 1, argv + 1);
            return code != EXIT_OK ? code : subcommands[i].run(&request);
        }
    }
    return ctl_usage(name, "'%.60s' is none of list, watch, set, pulse", argv[0]);
}

const struct ctl_command ctl_lines = {
    .name = name,
    .summary = "lists GPIO lines, shows their events, and tests lamps and meters",
    .usage =
        "  kingyoctl lines list                       every line of every chip, and its user\n"
        "  kingyoctl lines watch ROLE=LINE... [--seconds N]\n"
        "                                             presses, coins with their widths, faults\n"
        "  kingyoctl lines set ROLE=LINE on|off [--seconds N]\n"
        "                                             for N seconds (3); then releases the line\n"
        "  kingyoctl lines pulse ROLE=LINE COUNT      steps a meter, or requests tickets\n"
        "\n"
        "ROLE: start left right ok test service tilt coin coin2 coin3 door, start-lamp\n"
        "coin-lockout ticket coin-counter. LINE: the name of a line, or CHIP:OFFSET with the\n"
        "chip's label, and after commas: low high up down float as-is debounce=5ms\n"
        "window=15ms-250ms pulse=100ms/100ms. N: 1 to 86400.\n"
        "Exit code 74: a line could not be opened. A line that the kiosk uses belongs to the\n"
        "kiosk: stop the kiosk first.\n",
    .run = run_lines_command,
};
