/* options.h -- parses the command line of `kingyo`; config_file.h reads the same options from a
 * file. Pure. */
#ifndef KINGYO_PLATFORM_CONFIG_OPTIONS_H
#define KINGYO_PLATFORM_CONFIG_OPTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "core/core.h"
#include "core/settings.h"
#include "platform/board.h"

#define OPTIONS_PATH_MAX 1024u
#define OPTIONS_ERROR_MAX 256u
#define OPTIONS_DEMO_S 20u
#define OPTIONS_DEMO_S_MIN 5u
#define OPTIONS_DEMO_S_MAX 600u
#define OPTIONS_MODES_ALL ((1 << CHOICE_COUNT) - 1)

/* Exit codes of `kingyo` and `kingyoctl`. */
enum exit_code {
    EXIT_OK = 0,
    EXIT_NOT_SO = 1, /* The check failed, or the display was lost. */
    EXIT_USAGE = 2,
    EXIT_BAD_DATA = 65, /* EX_DATAERR of sysexits.h. */
    EXIT_IO = 74,       /* EX_IOERR of sysexits.h. */
};

/* Settings that one source sets explicitly. */
struct options_query_result {
    int32_t value[SETTING_COUNT];
    uint8_t is_set[SETTING_COUNT];
};

struct options {
    uint8_t help, version;
    uint8_t demo;           /* 1: play off screen and write pictures. */
    uint32_t demo_s;        /* Length of the demonstration in seconds. */
    uint32_t width, height; /* Window size in pixels; 0: full screen. */
    uint8_t poi;            /* enum board_poi */
    uint8_t has_seed;
    uint32_t seed;
    uint8_t tank;                        /* enum tank_preset_id */
    uint8_t is_file;                     /* 1: the current values come from the file. */
    struct options_query_result machine; /* Settings from the machine's locale. */
    struct options_query_result file;    /* Settings from the configuration file. */
    struct options_query_result words;   /* Settings from the command line. */
    uint8_t keyboard;                    /* enum board_keyboard */
    uint8_t usb_count, line_count;
    char usb[BOARD_USB_MAX][BOARD_USB_SIZE];    /* "VVVV:PPPP" or "VVVV:PPPP:SERIAL" */
    char line[BOARD_LINE_MAX][BOARD_LINE_SIZE]; /* "ROLE=LINE[,WORD...]" */
    char record[OPTIONS_PATH_MAX]; /* File to record; "" if not set, as in the fields below. */
    char replay[OPTIONS_PATH_MAX];
    char shots[OPTIONS_PATH_MAX];
    char data[OPTIONS_PATH_MAX];
    char config[OPTIONS_PATH_MAX];
};

/* Parses `argv` into `options`, whose other values stay. Returns 0, or -1 with one line in `error`;
 * also if the tank cannot hold the fish, independent of the order of the options. */
int options_parse(struct options *options, int argc, const char *const *argv,
                  char error[OPTIONS_ERROR_MAX]);

/* Sets the initial settings before the operator's menu changes them: each one is the default, or
 * comes from the machine's locale or the configuration file. */
void options_first(const struct options *options, struct settings *settings);

/* Sets the settings of the command line, which override all others. */
void options_last(const struct options *options, struct settings *settings);

/* Returns 1 if the file or the command line sets this setting. */
int options_query(const struct options *options, uint32_t id);

/* Prints the text of --help. */
void options_print_help(void);

#endif
