/* lines.c -- the command `kingyoctl lines`.
 *
 * The command lists the GPIO lines, shows events on configured lines and tests outputs. */
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"
#include "platform/ctl/devices/lines_show.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/os/clock.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

#define SECONDS_MAX 86400u

/* Seconds for which an output stays on if the option --seconds is absent. The time is long enough
 * to check a lamp. */
#define SET_SECONDS 3u
#define PULSES_MAX 1000u /* Maximum number of pulses in a test of a coin meter. */
#define NS_PER_S 1000000000ull

static const char name[] = "lines";
static struct buttons_gpio gpio;
static volatile sig_atomic_t is_stopped;

/* Arguments of a subcommand of `kingyoctl lines`. */
struct request {
    struct gpio_wire wires[GPIO_ROLE_COUNT];
    enum gpio_role role; /* Role of the last line that the command line configures. */
    uint32_t seconds;    /* Duration in seconds. 0 means that --seconds was not given. */
    const char *word;    /* Last argument: "on", "off" or a number of pulses. Null means that the
                            argument is absent. */
};

/* ---- Command line ---------------------------------------------------------------------------- */

/* Parses ROLE=LINE, or the one word that is not a line. */
static int take_word(void *target, const struct option *option, const char *text, char *why)
{
    struct request *request = target;
    char reason[HAL_TEXT_SIZE];
    (void)option;
    if (!strchr(text, '=')) {
        const int is_first = request->word == NULL;
        request->word = text;
        return is_first;
    }
    if (!gpio_wire_read(text, request->wires, reason) ||
        !gpio_config_agrees(request->wires, reason)) {
        snprintf(why, OPTION_TEXT_MAX, "%s", reason);
        return 0;
    }
    request->role = gpio_role_find(text, (size_t)(strchr(text, '=') - text));
    return 1;
}

static const struct option options[] = {
    { NULL, "ROLE=LINE", "line and its role, or a value", OPTION_ARGUMENT, .set = take_word },
    { "seconds", "N", "duration", OPTION_WHOLE, .offset = offsetof(struct request, seconds), 1,
      SECONDS_MAX },
};

static const struct option_table table = { options, sizeof options / sizeof options[0], NULL };

/* ---- GPIO lines ------------------------------------------------------------------------------ */

/* Opens the configured lines. Returns EXIT_OK, or prints a reason for each line that was not opened
 * and returns EXIT_IO. */
static enum exit_code open_lines(const struct request *request)
{
    gpio_thread_open(&gpio.reader, gpio_lines_device(), request->wires, clock_device());
    for (uint32_t i = 0; i < GPIO_ROLE_COUNT; i++) {
        if (gpio.reader.why[i][0]) {
            print_error("kingyoctl lines: %s: %s", gpio_role_name((enum gpio_role)i),
                        gpio.reader.why[i]);
        }
    }
    if ((uint32_t)__builtin_popcount(gpio.reader.had) != gpio_config_count(gpio.reader.wires)) {
        gpio_thread_close(&gpio.reader);
        return EXIT_IO;
    }
    ctl_stop_at_signals(&is_stopped);
    return EXIT_OK;
}

static uint64_t lines_now_ns(void)
{
    const struct hal_clock clock = clock_device();
    return clock.ops->now_ns(clock.self);
}

/* Services the GPIO lines until the monotonic time `until_ns`, until a signal arrives, or until a
 * write to standard output fails. */
static void step_until(uint64_t until_ns, struct lines_show *show)
{
    while (!is_stopped && !ferror(stdout) && lines_now_ns() < until_ns) {
        gpio_thread_step(&gpio.reader);
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
    const struct hal_switches switches = buttons_gpio_switches(&gpio);
    switches.ops->set(switches.self, HAL_COIN_LOCKOUT, 0); /* Switches the coin lockout off, if a
                                                              lockout line is configured, so that
                                                              the coin acceptor accepts coins. */
    struct lines_show show = lines_show_begin(&gpio.reader);
    puts("seconds\trole\twhat");
    fflush(stdout);
    step_until(request->seconds ? lines_now_ns() + request->seconds * NS_PER_S : UINT64_MAX, &show);
    gpio_thread_close(&gpio.reader);
    return EXIT_OK;
}

/* Checks that the request names exactly one output line and has a value. Returns EXIT_OK, or prints
 * one line and returns EXIT_USAGE. */
static enum exit_code open_output(const struct request *request, const char *wanted)
{
    if (gpio_config_count(request->wires) != 1 || !request->word) {
        return ctl_usage(name, "expected ROLE=LINE and %s", wanted);
    }
    if (gpio_role_is_input(request->role)) {
        return ctl_usage(name,
                         "%s is a button: only start-lamp, coin-lockout, ticket and "
                         "coin-counter are switched",
                         gpio_role_name(request->role));
    }
    return EXIT_OK;
}

static enum exit_code run_set(const struct request *request)
{
    const char wanted[] = "'on' or 'off'";
    enum exit_code code = open_output(request, wanted);
    if (code != EXIT_OK) {
        return code;
    }
    const int is_on = strcmp(request->word, "on") == 0;
    if (!is_on && strcmp(request->word, "off") != 0) {
        return ctl_usage(name, "expected %s, not '%.40s'", wanted, request->word);
    }
    code = open_lines(request);
    if (code != EXIT_OK) {
        return code;
    }
    const struct hal_switches switches = buttons_gpio_switches(&gpio);
    switches.ops->set(switches.self, (enum hal_switch)(request->role - GPIO_INPUT_COUNT), is_on);
    const uint32_t seconds = request->seconds ? request->seconds : SET_SECONDS;
    step_until(lines_now_ns() + seconds * NS_PER_S, NULL);
    gpio_thread_close(&gpio.reader);
    return EXIT_OK;
}

static enum exit_code run_pulse(const struct request *request)
{
    uint32_t count = 0;
    enum exit_code code = open_output(request, "a count");
    if (code != EXIT_OK) {
        return code;
    }
    if (!number_parse(request->word, 1, PULSES_MAX, &count)) {
        return ctl_usage(name, "pulse needs a count from 1 to %u, not '%.40s'", PULSES_MAX,
                         request->word);
    }
    code = open_lines(request);
    if (code != EXIT_OK) {
        return code;
    }
    CORE_ASSERT(!gpio_role_is_input(request->role));
    const struct hal_switches switches = buttons_gpio_switches(&gpio);
    const enum hal_switch which = (enum hal_switch)(request->role - GPIO_INPUT_COUNT);
    switches.ops->set(switches.self, which, 0); /* Switches the output off first, so that the pulses
                                                   start at the idle level. */
    switches.ops->pulse(switches.self, which, count);
    do {
        gpio_thread_step(&gpio.reader);
    } while (!is_stopped && atomic_load(&gpio.reader.owed) > 0);
    const uint32_t owed = atomic_load(&gpio.reader.owed);
    gpio_thread_close(&gpio.reader);
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
