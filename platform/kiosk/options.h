/* options.h -- what the command line asks of `kingyo`; config_file.h reads the same from a file.
 * Pure. */
#ifndef KINGYO_PLATFORM_KIOSK_OPTIONS_H
#define KINGYO_PLATFORM_KIOSK_OPTIONS_H

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

/* The exit codes of both programs. */
enum exit_code {
    EXIT_OK = 0,
    EXIT_NOT_SO = 1,    /* Checked, and not so; or the display was lost. */
    EXIT_USAGE = 2,
    EXIT_BAD_DATA = 65, /* As sysexits.h: EX_DATAERR ... */
    EXIT_IO = 74,       /* ... and EX_IOERR. */
};

/* Settings that somebody asked for. */
struct asked {
    int32_t value[SETTING_COUNT];
    uint8_t is_set[SETTING_COUNT];
};

struct options {
    uint8_t help, version;
    uint8_t demo;                  /* Play to files, off screen ... */
    uint32_t demo_s;               /* ... for so long. */
    uint32_t width, height;        /* Of the window; 0: full screen. */
    uint8_t poi;                   /* enum board_poi */
    uint8_t has_seed;
    uint32_t seed;
    uint8_t tank;                  /* enum tank_preset_id */
    uint8_t is_file;               /* What is set now comes from the file. */
    struct asked machine;          /* What the machine's locale asks for, ... */
    struct asked file;             /* ... the configuration file, */
    struct asked words;            /* ... and the command line. */
    uint8_t keyboard;              /* enum board_keyboard */
    uint8_t usb_count, line_count;
    char usb[BOARD_USB_MAX][BOARD_USB_SIZE];    /* "VVVV:PPPP" or "VVVV:PPPP:SERIAL" */
    char line[BOARD_LINE_MAX][BOARD_LINE_SIZE]; /* "ROLE=LINE[,WORD...]" */
    char record[OPTIONS_PATH_MAX]; /* Each "" when not asked for. */
    char replay[OPTIONS_PATH_MAX];
    char shots[OPTIONS_PATH_MAX];
    char data[OPTIONS_PATH_MAX];
    char config[OPTIONS_PATH_MAX];
};

/* Sets what `argv` says on top of what `options` holds. 0, or -1 and one line in `error`: also when
 * the tank cannot hold the fish, in whatever order they were named. */
int options_parse(struct options *options, int argc, const char *const *argv,
                  char error[OPTIONS_ERROR_MAX]);

/* What a stall begins with before the operator's menu has its say: each setting at its standard, by
 * the machine's locale, or by the configuration file. */
void options_first(const struct options *options, struct settings *settings);

/* What the command line asks for, over all that `settings` holds. */
void options_last(const struct options *options, struct settings *settings);

/* Whether the file or the command line asks for this setting. */
int options_ask(const struct options *options, uint32_t id);

/* What --help prints. */
void options_print_help(void);

#endif
