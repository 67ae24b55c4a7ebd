/* main.c -- `kingyo-poi`, the program that runs on the small computer board of a poi (a paper scoop
 * with sensors). */
#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "board/poi-gadget/commands.h"
#include "board/poi-gadget/motor.h"
#include "board/poi-gadget/run.h"
#include "board/poi-gadget/pose_script.h"
#include "board/poi-gadget/sensor_twin.h"
#include "board/poi-gadget/sensors.h"
#include "drivers/hid/poi_report.h"
#include "platform/os/print.h"

static const char usage[] =
    "kingyo-poi COMMAND [OPTION...]: the program of a poi's own board.\n\n"
    "  run          poses to the host, at each beat; what the hand feels to motor and light\n"
    "  watch        prints the poses, a line each, as --script reads them\n"
    "  test         looks at each part of this poi, and says what to do\n"
    "  calibrate    asks for the wires' eye at each mark, prints lines for the config\n"
    "  descriptor   writes the HID report descriptor to standard output; --hex as text\n\n"
    "  --simulate          scoops without sensors, for who tests a kiosk\n"
    "  --script            poses from standard input: [+MS] X Y Z PITCH YAW ROLL [KEY...]\n"
    "                      in mm and degrees, or 'lost'; +MS glides; keys OK START LEFT RIGHT FAN\n"
    "  --config FILE       /etc/kingyo-poi/poi.conf\n"
    "  --device FILE       /dev/hidg0; - writes the reports to standard output\n"
    "  --rate HZ           of the reports, 50 .. 1000; 250\n"
    "  --seconds S         ends then; 0: never\n"
    "  --root DIR          looks for sys and dev there\n\n"
    "Exit code: 0 fine; 1 checked, and not so; 2 wrong usage; 65 bad data; 74 a path that\n"
    "cannot be read or written.\n";

struct arguments {
    struct run_options run;
    const char *config, *root;
    uint8_t simulate, script, hex;
};

static int read_count(const char *word, uint32_t least, uint32_t most, uint32_t *out)
{
    char *end;
    assert(least <= most);
    errno = 0;
    const unsigned long value = strtoul(word, &end, 10);
    if (errno || end == word || *end != '\0' || value < least || value > most || *word == '-') {
        return 0;
    }
    *out = (uint32_t)value;
    return 1;
}

/* ---- Command line ---------------------------------------------------------------------------- */

/* Parses one option and its value. Returns the number of command-line words that were parsed, or 0
 * if the option is invalid. */
static int read_option(struct arguments *out, const char *name, const char *value)
{
    /* Exactly one of `flag`, `path` and `count` is set. */
    const struct option {
        const char *name;
        uint8_t *flag;
        const char **path;
        uint32_t *count, least, most;
    } options[] = {
        { "--simulate", .flag = &out->simulate },
        { "--script", .flag = &out->script },
        { "--hex", .flag = &out->hex },
        { "--config", .path = &out->config },
        { "--device", .path = &out->run.device },
        { "--root", .path = &out->root },
        { "--rate", .count = &out->run.rate_hz, .least = RUN_RATE_MIN_HZ, .most = RUN_RATE_MAX_HZ },
        { "--seconds", .count = &out->run.seconds, .least = 0, .most = 86400 },
    };
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        const struct option *option = &options[i];
        if (strcmp(option->name, name) != 0) {
            continue;
        }
        if (option->flag) {
            *option->flag = 1;
            return 1;
        }
        if (value && option->path) {
            *option->path = value;
            return 2;
        }
        return value && read_count(value, option->least, option->most, option->count) ? 2 : 0;
    }
    return 0;
}

static enum exit_code report_usage_error(const char *what, const char *word)
{
    print_error("kingyo-poi: %s '%.100s'; --help lists what there is", what, word);
    return EXIT_USAGE;
}

/* ---- Commands ------------------------------------------------------------------------------- */

static enum exit_code play_sensors(const struct poi_config *config,
                                   const struct arguments *arguments, struct feel_sink sink,
                                   int prints)
{
    static struct sensor_source own;
    char why[SENSORS_WHY_SIZE];
    if (!poi_config_is_calibrated(config)) {
        print_error("kingyo-poi: the wires are not calibrated: kingyo-poi calibrate");
        return EXIT_NOT_SO;
    }
    if (!sensors_open(&own.sensors, config, arguments->root, why)) {
        print_error("kingyo-poi: %s; kingyo-poi test says more", why);
        sensors_close(&own.sensors);
        return EXIT_IO;
    }
    const struct pose_source source = sensors_source(&own, config);
    const enum exit_code code =
        prints ? run_watch(&arguments->run, source) : run(&arguments->run, source, sink);
    print_error("kingyo-poi: %u readings missed", own.sensors.failed_count);
    sensors_close(&own.sensors);
    return code;
}

/* Runs the program with the selected source of poses. If `prints` is 1, prints the poses as text.
 * Otherwise sends the poses to the host. */
static enum exit_code stream_poses(struct poi_config *config, const struct arguments *arguments,
                                   int prints)
{
    static struct pose_script_source script;
    static struct sensor_twin_source twin;
    static struct motor motor;
    struct feel_sink sink = { 0 };
    struct pose_source source;
    char why[MOTOR_WHY_SIZE];
    if (!prints) {
        if (!motor_open(&motor, config, arguments->root, why)) {
            print_error("kingyo-poi: %s", why); /* A missing motor or light is not fatal. The
                                                   program continues without force feedback. */
        }
        sink = motor_sink(&motor);
    }
    if (!arguments->script && !arguments->simulate) {
        return play_sensors(config, arguments, sink, prints);
    }
    if (arguments->script) {
        source =
            pose_script_source(&script, STDIN_FILENO, "standard input", arguments->run.rate_hz);
    } else {
        if (!poi_config_is_calibrated(config)) {
            sensor_twin_calibrate(config);
        }
        source = sensor_twin_source(&twin, config);
    }
    return prints ? run_watch(&arguments->run, source) : run(&arguments->run, source, sink);
}

static enum exit_code run_poi_command(const char *name, struct arguments *arguments)
{
    struct poi_config config;
    const int prints = strcmp(name, "watch") == 0;
    if (strcmp(name, "descriptor") == 0) {
        for (uint32_t i = 0; i < POI_DESCRIPTOR_SIZE && arguments->hex; i++) {
            printf("%02x%c", poi_descriptor[i], i % 16 == 15 ? '\n' : ' ');
        }
        if (arguments->hex) {
            putchar('\n');
        } else {
            fwrite(poi_descriptor, 1, sizeof poi_descriptor, stdout);
        }
        return EXIT_OK;
    }
    if (arguments->simulate && arguments->script) {
        return report_usage_error("--simulate and --script exclude each other in", name);
    }
    if (!arguments->config && !arguments->simulate && !arguments->script) {
        arguments->config = "/etc/kingyo-poi/poi.conf";
    }
    /* If no file is named, the defaults apply, which are sufficient for simulated sensors. */
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
    return stream_poses(&config, arguments, prints);
}

static enum exit_code run_words(int argc, char **argv)
{
    struct arguments arguments = { .run = { .device = "/dev/hidg0", .rate_hz = 250 }, .root = "" };
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(usage, stdout);
            return EXIT_OK;
        }
    }
    if (argc < 2) {
        fputs(usage, stderr);
        return EXIT_USAGE;
    }
    static const char *const commands[] = { "run", "watch", "test", "calibrate", "descriptor" };
    size_t known = 0;
    while (known < sizeof commands / sizeof commands[0] && strcmp(commands[known], argv[1]) != 0) {
        known++;
    }
    if (known == sizeof commands / sizeof commands[0]) {
        return report_usage_error("unknown command", argv[1]);
    }
    for (int i = 2, taken; i < argc; i += taken) {
        taken = read_option(&arguments, argv[i], i + 1 < argc ? argv[i + 1] : NULL);
        if (taken == 0) {
            return report_usage_error("not an option, or not its value:", argv[i]);
        }
    }
    return run_poi_command(argv[1], &arguments);
}

int main(int argc, char **argv)
{
    const int closed = print_open_streams();
    if (closed) {
        print_error("kingyo-poi: /dev/null: %s", strerror(-closed));
        return EXIT_IO;
    }
    const enum exit_code code = run_words(argc, argv);
    const int lost = print_finish();
    if (lost && (code == EXIT_OK || code == EXIT_NOT_SO)) {
        print_error("kingyo-poi: standard output: %s", strerror(-lost));
        return EXIT_IO;
    }
    return (int)code;
}
