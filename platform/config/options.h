/* options.h -- defines the options of `kingyo`: their table, the structure that receives their
 * values, and the settings that they select. config_file.h reads the same options from a file. Pure
 * functions, except for options_print_help(). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/core.h"
#include "core/settings.h"
#include "platform/board.h"
#include "platform/config/option_table.h"
#include "platform/os/exit_code.h"

#define OPTIONS_DEMO_S 20u
#define OPTIONS_DEMO_S_MIN 5u
#define OPTIONS_DEMO_S_MAX 600u
#define OPTIONS_SELFTEST_S 180u /* Default length of the self-test of a board in seconds. */
#define OPTIONS_MODES_ALL ((1 << CHOICE_COUNT) - 1)

/* Settings from one source, for example the command line. If the source sets the setting `id`,
 * is_set[id] is true and value[id] is the value. */
struct options_query_result {
    int32_t value[SETTING_COUNT];
    bool is_set[SETTING_COUNT];
};

struct options {
    bool help, version;
    /* True if the demonstration runs without a window and writes pictures. */
    bool demo;
    uint32_t demo_s; /* Length of the demonstration in seconds. */
    /* Length of the self-test of a board in seconds. 0 means no self-test. */
    uint32_t selftest_s;
    uint32_t width, height; /* Window size in pixels. 0 means full screen. */
    /* Width of the picture without its words, in per cent of the screen's width. 0 means that the
     * renderer chooses the width for the graphics hardware. */
    uint32_t detail;
    uint8_t poi; /* Kind of controller that moves the poi (enum board_poi). */
    bool has_seed;
    uint32_t seed;
    uint8_t tank; /* Tank preset of the game (enum tank_preset_id). */
    /* True while values from the configuration file are parsed. False while the command line is
     * parsed. */
    bool is_file;
    /* Settings that follow from the machine's locale, for example the language. */
    struct options_query_result machine;
    struct options_query_result file;  /* Settings from the configuration file. */
    struct options_query_result words; /* Settings from the command line. */
    uint8_t keyboard;                  /* Keyboard mode (enum board_keyboard). */
    uint8_t usb_count, line_count;
    /* USB controllers, each "VVVV:PPPP" or "VVVV:PPPP:SERIAL". */
    char usb[BOARD_USB_MAX][BOARD_USB_SIZE];
    char line[BOARD_LINE_MAX][BOARD_LINE_SIZE]; /* GPIO line options, each "ROLE=LINE[,WORD...]". */
    /* Path of the recording to write. In all path fields of the structure, "" means that the path
     * is not set. */
    char record[OPTIONS_PATH_MAX];
    char replay[OPTIONS_PATH_MAX];
    char video[OPTIONS_PATH_MAX];
    char shots[OPTIONS_PATH_MAX];
    char data[OPTIONS_PATH_MAX];
    char config[OPTIONS_PATH_MAX];
};

/* Checks rules that concern several options. Returns 0. If a rule is violated, writes one line to
 * `error` and returns -1. */
int options_check(const struct options *options, char error[OPTIONS_ERROR_MAX]);

/* Names of the tank presets (enum tank_preset_id) and of the game modes (enum game_mode). Each list
 * ends with null. */
extern const char *const options_tank_names[];
extern const char *const options_mode_names[];
/* Names of the levels in the order of enum level, followed by null. */
extern const char *const options_level_names[];

/* Table of the options of `kingyo`. The values of the options are stored in a struct options. */
extern const struct option_table options_table;

/* Parses `argv` into `options`, starting with argv[1]. Options that `argv` does not contain keep
 * their values. The order of the options has no effect. Returns 0. Returns -1 and writes one line
 * to `error` if an option is invalid, or if the tank cannot hold the number of fish. */
int options_parse(struct options *options, int argc, const char *const *argv,
                  char error[OPTIONS_ERROR_MAX]);

/* Returns true and writes the reason to `reason` if two GPIO line options use the same GPIO
 * line. Otherwise returns false. */
bool options_wires_clash(const struct options *options, char reason[OPTION_TEXT_MAX]);

/* Returns true if the tank cannot hold the configured number of fish, and writes the reason to
 * `reason`. Otherwise returns false. Checks the configuration file if options->is_file is true,
 * otherwise the command line. */
bool options_too_many_fish(const struct options *options, char reason[OPTION_TEXT_MAX]);

/* Sets the initial settings, which the operator's menu may change later. Each setting gets its
 * value from the configuration file if the file has one, otherwise from the machine's locale,
 * otherwise the default. */
void options_first(const struct options *options, struct settings *settings);

/* Overrides the values in `settings` with the settings that the command line sets. */
void options_last(const struct options *options, struct settings *settings);

/* Returns true if the configuration file or the command line sets the setting `id`. */
bool options_query(const struct options *options, uint32_t id);

/* Prints the text of --help. */
void options_print_help(void);
