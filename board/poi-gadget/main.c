/* main.c -- `kingyo-poi`, the program that runs on the small computer board of a poi (a paper scoop
 * with sensors). */
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "board/poi-gadget/motor.h"
#include "board/poi-gadget/run.h"
#include "board/poi-gadget/pose_script.h"
#include "board/poi-gadget/sensor_twin.h"
#include "board/poi-gadget/sensors.h"
#include "core/base/panic.h"
#include "drivers/hid/poi_report.h"
#include "platform/config/option_table.h"
#include "platform/os/print.h"

#define CONFIG_DEFAULT "/etc/kingyo-poi/poi.conf"

/* Reports a failed assertion. */
_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    print_error("kingyo-poi: %s:%d: assertion failed: %s", file, line, condition);
    abort();
}

static const char usage[] =
    "kingyo-poi COMMAND [OPTION...]: the program on the board of a poi.\n\n"
    "  run          sends poses to the host, and passes force feedback to motor and light\n"
    "  watch        prints one pose per line, in the format that --script reads\n"
    "  test         checks each part of this poi, and prints advice for each failure\n"
    "  calibrate    asks for the eye of the wires at each mark, and prints lines for the\n"
    "               configuration file\n"
    "  descriptor   writes the HID report descriptor to standard output\n\n";

static const char notes[] =
    "\nExit code: 0 success; 1 a check failed; 2 wrong usage; 65 invalid data; 74 a path that\n"
    "cannot be read or written.\n";

struct arguments {
    struct run_options run;
    const char *config, *root;
    bool simulate, script, hex;
};

#define AT(member) .offset = offsetof(struct arguments, member)

/* Stores the prefix of all paths. Unlike the value of an OPTION_TEXT, the prefix may be empty. */
static bool set_root(void *target, const struct option *option, const char *value,
                     char why[OPTION_TEXT_MAX])
{
    struct arguments *arguments = target;
    (void)option;
    (void)why;
    arguments->root = value;
    return true;
}

static const struct option options[] = {
    { "simulate", NULL, "scoop with simulated sensors, to test a kiosk", OPTION_FLAG,
      AT(simulate) },
    { "script", NULL,
      "read poses from standard input: [+MS] X Y Z PITCH YAW ROLL [KEY...] in mm and degrees, or "
      "'lost'; +MS moves smoothly in MS milliseconds; keys: OK START LEFT RIGHT FAN",
      OPTION_FLAG, AT(script) },
    { "hex", NULL, "write the descriptor as hex text", OPTION_FLAG, AT(hex) },
    { "config", "FILE", "configuration file; the default is " CONFIG_DEFAULT, OPTION_TEXT,
      AT(config) },
    { "device", "FILE", "USB device; - writes the reports to standard output", OPTION_TEXT,
      AT(run.device), .initial = "/dev/hidg0" },
    { "rate", "HZ", "reports per second", OPTION_WHOLE, AT(run.rate_hz), RUN_RATE_MIN_HZ,
      RUN_RATE_MAX_HZ, .initial = "250" },
    { "seconds", "S", "duration; 0 means no limit", OPTION_WHOLE, AT(run.seconds), 0, 86400,
      .initial = "0" },
    { "root", "DIR", "use sys and dev in DIR; '' means those of this machine", OPTION_CUSTOM,
      .set = set_root },
};

static const struct option_table table = { options, sizeof options / sizeof options[0], NULL };

/* ---- Commands ------------------------------------------------------------------------------- */

static enum exit_code play_sensors(const struct poi_config *config,
                                   const struct arguments *arguments, struct force_sink sink)
{
    static struct sensor_source own;
    char why[SENSORS_WHY_SIZE];
    if (!poi_config_is_calibrated(config)) {
        return print_fail(EXIT_NOT_SO,
                          "kingyo-poi: the wires are not calibrated; run 'kingyo-poi calibrate'");
    }
    if (!sensors_open(&own.sensors, config, arguments->root, why)) {
        print_error("kingyo-poi: %s; 'kingyo-poi test' checks all parts", why);
        sensors_close(&own.sensors);
        return EXIT_IO;
    }
    const enum exit_code code = run(&arguments->run, sensors_source(&own, config), sink);
    print_error("kingyo-poi: %u readings of the sensors failed", own.sensors.failed_count);
    sensors_close(&own.sensors);
    return code;
}

/* Runs the main loop with the source of poses that the command line selects: sensors, simulated
 * sensors or a script. */
static enum exit_code stream_poses(struct poi_config *config, const struct arguments *arguments)
{
    static struct pose_script_source script;
    static struct sensor_twin_source twin;
    static struct motor motor;
    struct force_sink sink = { 0 };
    char why[MOTOR_WHY_SIZE];
    if (!arguments->run.prints) {
        if (!motor_open(&motor, config, arguments->root, why)) {
            print_error("kingyo-poi: %s", why); /* A missing motor or light is not fatal. The
                                                   program continues without force feedback. */
        }
        sink = motor_sink(&motor);
    }
    if (arguments->script) {
        const struct pose_source source =
            pose_script_source(&script, STDIN_FILENO, "standard input", arguments->run.rate_hz);
        return run(&arguments->run, source, sink);
    }
    if (!arguments->simulate) {
        return play_sensors(config, arguments, sink);
    }
    if (!poi_config_is_calibrated(config)) {
        sensor_twin_calibrate(config);
    }
    return run(&arguments->run, sensor_twin_source(&twin, config), sink);
}

static enum exit_code write_descriptor(bool as_hex)
{
    for (uint32_t i = 0; i < POI_DESCRIPTOR_SIZE; i++) {
        if (as_hex) {
            printf("%02x%c", poi_descriptor[i], i % 16 == 15 ? '\n' : ' ');
        } else {
            putchar(poi_descriptor[i]);
        }
    }
    fputs(as_hex ? "\n" : "", stdout);
    return EXIT_OK;
}

static enum exit_code run_poi_command(const char *name, struct arguments *arguments)
{
    struct poi_config config;
    if (strcmp(name, "descriptor") == 0) {
        return write_descriptor(arguments->hex);
    }
    if (arguments->simulate && arguments->script) {
        return print_fail(EXIT_USAGE, "kingyo-poi %s: --simulate and --script exclude each other",
                          name);
    }
    if (!arguments->config && !arguments->simulate && !arguments->script) {
        arguments->config = CONFIG_DEFAULT;
    }
    /* If the command line names no configuration file, the default values apply. The default values
     * are sufficient for simulated sensors. */
    poi_config_init(&config);
    if (arguments->config && !poi_config_load(&config, arguments->config)) {
        return access(arguments->config, R_OK) == 0 ? EXIT_BAD_DATA : EXIT_IO;
    }
    if (strcmp(name, "test") == 0) {
        return commands_self_test(&config, arguments->root, arguments->run.device);
    }
    if (strcmp(name, "calibrate") == 0) {
        return commands_calibrate(&config, arguments->root);
    }
    arguments->run.prints = strcmp(name, "watch") == 0;
    return stream_poses(&config, arguments);
}

static enum exit_code run_words(int argc, const char *const *argv)
{
    static const char *const commands[] = { "run", "watch", "test", "calibrate", "descriptor" };
    struct arguments arguments = { .root = "" };
    char error[OPTIONS_ERROR_MAX];
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(usage, stdout);
            option_table_print(&table, UINT32_MAX);
            fputs(notes, stdout);
            return EXIT_OK;
        }
    }
    if (argc < 2) {
        fputs(usage, stderr);
        return EXIT_USAGE;
    }
    size_t known = 0;
    while (known < sizeof commands / sizeof commands[0] && strcmp(commands[known], argv[1]) != 0) {
        known++;
    }
    if (known == sizeof commands / sizeof commands[0]) {
        return print_fail(
            EXIT_USAGE, "kingyo-poi: unknown command '%.100s'; --help lists the commands", argv[1]);
    }
    if (option_table_parse(&table, UINT32_MAX, &arguments, argc - 2, argv + 2, error)) {
        return print_fail(EXIT_USAGE, "kingyo-poi %s: %s", argv[1], error);
    }
    return run_poi_command(argv[1], &arguments);
}

int main(int argc, char **argv)
{
    const int closed = print_open_streams();
    if (closed) {
        return print_fail(EXIT_IO, "kingyo-poi: /dev/null: %s", strerror(-closed));
    }
    const enum exit_code code = run_words(argc, (const char *const *)argv);
    const int lost = print_finish();
    if (lost && (code == EXIT_OK || code == EXIT_NOT_SO)) {
        return print_fail(EXIT_IO, "kingyo-poi: standard output: %s", strerror(-lost));
    }
    return (int)code;
}
