/* main.c -- `kingyo-poi`: what runs on the small board that is a poi. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "board/poi-gadget/run.h"
#include "board/poi-gadget/scoop.h"
#include "board/poi-gadget/script_source.h"
#include "drivers/poi_descriptor.h"

static const char usage[] =
    "kingyo-poi COMMAND [OPTION...]: the program of a poi's own board.\n\n"
    "  run          poses to the host, at each beat; what the hand feels to the motor\n"
    "  watch        prints the poses, a line each, as --script reads them\n"
    "  descriptor   writes the HID report descriptor to standard output; --hex as text\n\n"
    "  --simulate          scoops without sensors, for who tests a kiosk\n"
    "  --script            poses from standard input: [+MS] X Y Z PITCH YAW ROLL [KEY...]\n"
    "                      in mm and degrees, or 'lost'; +MS glides; keys OK START LEFT RIGHT FAN\n"
    "  --device FILE       /dev/hidg0; - writes the reports to standard output\n"
    "  --rate HZ           of the reports, 50 .. 1000; 250\n"
    "  --seconds S         ends then; 0: never\n\n"
    "Exit code: 0 fine; 1 checked, and not so; 2 wrong usage; 65 bad data; 74 a path that\n"
    "cannot be read or written.\n";

struct arguments {
    struct run_options run;
    uint8_t simulate, script, hex;
};

static int read_count(const char *word, uint32_t least, uint32_t most, uint32_t *out)
{
    char *end;
    errno = 0;
    const unsigned long value = strtoul(word, &end, 10);
    if (errno || end == word || *end != '\0' || value < least || value > most || *word == '-') {
        return 0;
    }
    *out = (uint32_t)value;
    return 1;
}

/* One option and its value: how many words it took, or 0 where it is none. */
static int read_option(struct arguments *out, const char *name, const char *value)
{
    uint32_t seconds;
    if (strcmp(name, "--simulate") == 0) {
        return out->simulate = 1;
    }
    if (strcmp(name, "--script") == 0) {
        return out->script = 1;
    }
    if (strcmp(name, "--hex") == 0) {
        return out->hex = 1;
    }
    if (strcmp(name, "--device") == 0 && value) {
        out->run.device = value;
        return 2;
    }
    if (strcmp(name, "--rate") == 0 && value) {
        return read_count(value, RUN_RATE_MIN_HZ, RUN_RATE_MAX_HZ, &out->run.rate_hz) ? 2 : 0;
    }
    if (strcmp(name, "--seconds") == 0 && value && read_count(value, 0, 86400, &seconds)) {
        out->run.seconds = (float)seconds;
        return 2;
    }
    return 0;
}

static enum exit_code descriptor(const struct arguments *arguments)
{
    for (uint32_t i = 0; i < POI_DESCRIPTOR_SIZE && arguments->hex; i++) {
        printf("%02x%c", poi_descriptor[i], i % 16 == 15 ? '\n' : ' ');
    }
    if (arguments->hex) {
        putchar('\n');
    } else {
        fwrite(poi_descriptor, 1, sizeof poi_descriptor, stdout);
    }
    if (fflush(stdout) != 0) {
        perror("kingyo-poi: standard output");
        return EXIT_IO;
    }
    return EXIT_OK;
}

static enum pose_result simulate_step(void *self, float seconds, struct poi_report *out)
{
    scoop_step(self, seconds, out);
    return POSE_NEW;
}

static enum exit_code play(const struct arguments *arguments, int prints)
{
    static struct script_source script;
    static struct scoop scoop;
    struct pose_source source = { .step = simulate_step, .self = &scoop };
    if (arguments->script) {
        source = script_source(&script, STDIN_FILENO, "standard input");
    }
    return prints ? watch(&arguments->run, source)
                  : run(&arguments->run, source, (struct feel_sink){ 0 });
}

static enum exit_code wrong(const char *what, const char *word)
{
    fprintf(stderr, "kingyo-poi: %s '%.100s'; --help lists what there is\n", what, word);
    return EXIT_USAGE;
}

int main(int argc, char **argv)
{
    struct arguments arguments = { .run = { .device = "/dev/hidg0", .rate_hz = 250 } };
    const char *command = argc > 1 ? argv[1] : "--help";
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            command = argv[i];
        }
    }
    if (strcmp(command, "--help") == 0) {
        fputs(usage, argc > 1 ? stdout : stderr);
        return argc > 1 ? EXIT_OK : EXIT_USAGE;
    }
    for (int i = 2, taken; i < argc; i += taken) {
        taken = read_option(&arguments, argv[i], i + 1 < argc ? argv[i + 1] : NULL);
        if (taken == 0) {
            return (int)wrong("not an option, or not its value:", argv[i]);
        }
    }
    if (strcmp(command, "descriptor") == 0) {
        return (int)descriptor(&arguments);
    }
    const int runs = strcmp(command, "run") == 0, prints = strcmp(command, "watch") == 0;
    if (!runs && !prints) {
        return (int)wrong("unknown command", command);
    }
    if (arguments.simulate == arguments.script) {
        return (int)wrong("give one of --simulate and --script to", command);
    }
    return (int)play(&arguments, prints);
}
