/* options.h -- what the command line and the configuration file ask of `kingyo`. Pure but for the
 * file. */
#ifndef KINGYO_PLATFORM_KIOSK_OPTIONS_H
#define KINGYO_PLATFORM_KIOSK_OPTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "core/core.h"
#include "platform/board.h"

#define OPTIONS_PATH_MAX 1024u
#define OPTIONS_ERROR_MAX 256u
#define OPTIONS_WARNINGS_MAX 20u /* Of one file; the others are only counted. */
#define OPTIONS_DEMO_S 20u
#define OPTIONS_DEMO_S_MIN 5u
#define OPTIONS_DEMO_S_MAX 600u
#define OPTIONS_MODES_ALL ((1u << CHOICE_COUNT) - 1u)

/* The exit codes of both programs. */
enum exit_code {
    EXIT_OK = 0,
    EXIT_NOT_SO = 1,    /* Checked, and not so; or the display was lost. */
    EXIT_USAGE = 2,
    EXIT_BAD_DATA = 65, /* As sysexits.h: EX_DATAERR ... */
    EXIT_IO = 74,       /* ... and EX_IOERR. */
};

struct options {
    uint8_t help, version;
    uint8_t demo;                  /* Play to files, off screen ... */
    uint32_t demo_s;               /* ... for so long. */
    uint32_t width, height;        /* Of the window; 0: full screen. */
    uint8_t poi;                   /* enum board_poi */
    uint8_t has_language, language; /* enum language */
    uint8_t has_seed;
    uint32_t seed;
    uint8_t tank;                  /* enum tank_preset_id */
    uint32_t fish_count;           /* 0: the tank's own. */
    uint8_t modes;                 /* As core_config's; 0: nobody said. */
    uint8_t grade;                 /* As core_config's. */
    uint8_t players;               /* As core_config's. */
    uint8_t coins, tickets;        /* As core_config's credit_coins and ticket_fish. */
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

/* Reads "key = value" lines: the keys are the options' names, '#' at the
 * beginning of a line or after white space begins a comment. A line that
 * cannot be used is told through `warn` (may be null) and skipped: a typing mistake must not
 * keep a stall closed; nor must more fish than the tank holds. 0, or a negative errno when the
 * file cannot be read. */
int options_read_config(struct options *options, const char *path,
                        void (*warn)(const char *line));

/* Writes what they ask of the stall into `core`: tank, fish, language, modes (`modes` where nobody
 * said), paper and players. The rest of it stays. */
void options_stall(const struct options *options, uint8_t modes, struct core_config *core);

/* How many bowls there will be, 1 .. POI_MAX. */
uint32_t options_players(const struct options *options);

/* What --help prints. */
void options_print_help(void);

#endif
