/* options.c -- the table of the options of `kingyo`, the parsers of their values, and the
 * combination of the sources of settings. */
#include "platform/config/options.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/scene.h"
#include "core/tank/preset.h"
#include "platform/os/number.h"
#include "platform/setting_text.h"

/* ---- Parsers of values --------------------------------------------------------------------- */

static bool add_setting(struct options *options, uint32_t id, int32_t value)
{
    struct options_query_result *source = options->is_file ? &options->file : &options->words;
    CORE_ASSERT(id < SETTING_COUNT);
    source->value[id] = value;
    source->is_set[id] = true;
    return true;
}

/* Parses and stores the value of an option that sets the setting option->id. The values are those
 * of setting_parse(), with these exceptions: --mode accepts "choose" for all game modes, but no
 * list of modes; --grade does not accept "own"; and --fish and --reach do not accept 0. */
static bool set_one(void *target, const struct option *option, const char *value, char *why)
{
    int32_t number;
    const bool is_modes = option->id == SET_MODES;
    (void)why;
    if (is_modes && strcmp(value, "choose") == 0) {
        return add_setting(target, SET_MODES, OPTIONS_MODES_ALL);
    }
    if ((is_modes && strchr(value, ',')) || !setting_parse(option->id, value, &number) ||
        (number == 0 &&
         (option->id == SET_GRADE || option->id == SET_FISH || option->id == SET_REACH))) {
        return false;
    }
    return add_setting(target, option->id, number);
}

static bool set_demo(void *target, const struct option *option, const char *value, char *why)
{
    struct options *options = target;
    (void)option;
    (void)why;
    options->demo = true;
    options->demo_s = OPTIONS_DEMO_S;
    return !value || number_parse(value, OPTIONS_DEMO_S_MIN, OPTIONS_DEMO_S_MAX, &options->demo_s);
}

/* The self-test plays by the bot, without coins. */
static bool set_selftest(void *target, const struct option *option, const char *value, char *why)
{
    struct options *options = target;
    (void)option;
    (void)why;
    options->selftest_s = OPTIONS_SELFTEST_S;
    options->poi = BOARD_POI_BOT;
    add_setting(target, SET_PLAY, PLAY_FREE);
    return !value ||
           number_parse(value, OPTIONS_DEMO_S_MIN, OPTIONS_DEMO_S_MAX, &options->selftest_s);
}

static bool set_window(void *target, const struct option *option, const char *value, char *why)
{
    struct options *options = target;
    char width[16];
    const char *cross = strchr(value, 'x');
    (void)option;
    (void)why;
    if (!cross || cross == value || (size_t)(cross - value) >= sizeof width) {
        return false;
    }
    snprintf(width, sizeof width, "%.*s", (int)(cross - value), value);
    return number_parse(width, HAL_WINDOW_WIDTH_MIN, HAL_WINDOW_SIDE_MAX, &options->width) &&
           number_parse(cross + 1, HAL_WINDOW_HEIGHT_MIN, HAL_WINDOW_SIDE_MAX, &options->height);
}

static bool set_usb(void *target, const struct option *option, const char *value, char *why)
{
    struct options *options = target;
    (void)option;
    (void)why;
    if (strlen(value) >= BOARD_USB_SIZE || options->usb_count == BOARD_USB_MAX ||
        !board_check_usb(value)) {
        return false;
    }
    memcpy(options->usb[options->usb_count++], value, strlen(value) + 1u);
    return true;
}

static bool set_line(void *target, const struct option *option, const char *value, char *why)
{
    struct options *options = target;
    char line[1][BOARD_LINE_SIZE], reason[HAL_TEXT_SIZE];
    const size_t size = strlen(value) + 1u;
    (void)option;
    if (size > BOARD_LINE_SIZE) {
        snprintf(why, OPTION_TEXT_MAX, "longer than %u characters", BOARD_LINE_SIZE - 1u);
        return false;
    }
    memcpy(line[0], value, size);
    if (board_check_lines((const char(*)[BOARD_LINE_SIZE])line, 1, reason)) {
        snprintf(why, OPTION_TEXT_MAX, "%s", reason);
        return false;
    }
    if (options->line_count == BOARD_LINE_MAX) {
        return false;
    }
    memcpy(options->line[options->line_count++], value, size);
    return true;
}

static bool set_seed(void *target, const struct option *option, const char *value, char *why)
{
    struct options *options = target;
    (void)option;
    (void)why;
    options->has_seed = true;
    return number_parse(value, 0, UINT32_MAX, &options->seed);
}

static uint32_t tank_fish_limit(uint8_t tank)
{
    return tank_preset_fish_max(tank_preset(tank), 1.0f);
}

static void print_fish_max(char out[OPTION_TEXT_MAX])
{
    snprintf(out, OPTION_TEXT_MAX / 2u, " %u (festival), %u (thesis) or %u (official)",
             tank_fish_limit(TANK_PRESET_FESTIVAL), tank_fish_limit(TANK_PRESET_THESIS),
             tank_fish_limit(TANK_PRESET_OFFICIAL));
}

static bool set_coins(void *target, const struct option *option, const char *value, char *why)
{
    uint32_t coins;
    (void)option;
    (void)why;
    if (!number_parse(value, 0, (uint32_t)settings_entry(SET_PRICE)->max, &coins)) {
        return false;
    }
    add_setting(target, SET_PLAY, coins == 0 ? PLAY_FREE : PLAY_PAID);
    return coins == 0 || add_setting(target, SET_PRICE, (int32_t)coins);
}

/* Parses NAME=VALUE, where NAME is the name of a setting. */
static bool set_setting(void *target, const struct option *option, const char *text, char *why)
{
    char range[SETTING_RANGE_MAX];
    int32_t value;
    const size_t length = strcspn(text, "=");
    const uint32_t id = text[length] ? setting_find(text, length) : SETTING_COUNT;
    (void)option;
    if (id == SETTING_COUNT) {
        return false;
    }
    if (!setting_parse(id, text + length + 1, &value)) {
        setting_range(id, range);
        snprintf(why, OPTION_TEXT_MAX, "expected %s", range);
        return false;
    }
    return add_setting(target, id, value);
}

/* ---- Table of options ---------------------------------------------------------------------- */

static const char *const poi_names[] = { "auto", "mouse", "touch", "pad", "usb", "bot", NULL };
static const char *const keyboard_names[] = { "auto", "on", "off", NULL };
const char *const options_tank_names[] = { "festival", "thesis", "official", NULL };
const char *const options_mode_names[] = { "festival", "championship", "practice", NULL };
const char *const options_level_names[] = { "master", "normal", "easy", NULL };
_Static_assert(BOARD_POI_BOT == 5 && BOARD_KEYBOARD_OFF == 2 && TANK_PRESET_OFFICIAL == 2 &&
                   MODE_PRACTICE == 2,
               "the lists have the order of their enums");

#define AT(member) .offset = offsetof(struct options, member)
#define SET(function) .kind = OPTION_CUSTOM, .set = (function)

/* clang-format off */
static const struct option table[] = {
    { "demo", "[SECONDS]", "let the bot play off screen and write pictures (20 s)", SET(set_demo),
      .expects = "5 to 600 seconds" },
    { "selftest-board", "[SECONDS]",
      "let the bot play on the screen, then print a report about this board (180 s)",
      SET(set_selftest), .expects = "5 to 600 seconds" },
    { "window", "WxH", "play in a window of this size in pixels; the default is full screen",
      SET(set_window), .expects = "WIDTHxHEIGHT from 320x240 to 8192x8192", .section = "picture" },
    { "detail", "PERCENT",
      "width of the picture without its words, in per cent of the screen's; the default depends on "
      "the graphics hardware", OPTION_WHOLE, AT(detail), .min = 25, .max = 100,
      .section = "picture" },
    { "time", "WHEN", "light of the stall: night with bulbs and lanterns, or day", SET(set_one),
      .id = SET_TIME, .expects = "night or day", .section = "" },
    { "poi", "KIND", "controller of the first player; with bot, the bot plays for all players",
      OPTION_CHOICE, AT(poi), .choices = poi_names, .section = "devices" },
    { "dip", "HOW", "with a mouse or touch screen: hold to dip, or click to dip and to lift",
      SET(set_one), .id = SET_DIP, .expects = "hold or click", .section = "" },
    { "reach", "PERCENT",
      "lower part of the picture in which a mouse or finger reaches the whole tank; the default is "
      "100", SET(set_one), .id = SET_REACH, .expects = "40 to 100", .section = "" },
    { "side", "NAME",
      "side of the bowl of a player who plays alone; with dip, the side of the first dip",
      SET(set_one), .id = SET_SIDE, .expects = "dip, right or left", .section = "" },
    { "text", "SIZE", "size of small texts on the pages for players", SET(set_one), .id = SET_TEXT,
      .expects = "normal, large or largest", .section = "" },
    { "usb", "ID", "USB controller that may be a poi; repeat the option for each controller",
      SET(set_usb), .expects = "VVVV:PPPP or VVVV:PPPP:SERIAL, as lsusb lists it; 8 at most",
      .section = "devices" },
    { "line", "ROLE=LINE",
      "GPIO line and its role, see 'kingyoctl lines'; repeat the option for each line",
      SET(set_line), .expects = "ROLE=LINE[,WORD...]; 32 at most", .section = "devices" },
    { "keyboard", "USE",
      "whether keys act as buttons and coins; auto means on, except in a service",
      OPTION_CHOICE, AT(keyboard), .choices = keyboard_names, .section = "devices" },
    { "mode", "NAME",
      "festival, championship, practice, lab (fish grow), or choose, with which the player chooses "
      "the mode after START",
      SET(set_one), .id = SET_MODES,
      .expects = "festival, championship, practice, lab or choose", .section = "" },
    { "grade", "N",
      "grade of the paper from 4 (strong) to 7 (weak); the default is 6, and 5 in a championship",
      SET(set_one), .id = SET_GRADE, .expects = "4 to 7", .section = "" },
    { "players", "N", "number of bowls at the tank; a bowl without a controller stays empty",
      SET(set_one), .id = SET_PLAYERS, .expects = "1 to 4", .section = "" },
    { "coins", "N", "coins that a round costs; 0, the default, is free play", SET(set_coins),
      .expects = "0 to 20", .section = "" },
    { "tickets", "N", "a ticket for each N fish that a player catches; 0 means no tickets",
      SET(set_one), .id = SET_TICKET_FISH, .expects = "0 to 20", .section = "" },
    { "record", "FILE", "record the session to FILE, which must be a new or empty file",
      OPTION_PATH, AT(record), .section = "files" },
    { "replay", "FILE", "show a recorded session and verify it", OPTION_PATH, AT(replay) },
    { "video", "FILE",
      "write the replay with sound to an MP4 file, through ffmpeg; without ffmpeg, write pictures "
      "and a WAV file to the folder FILE.frames", OPTION_PATH, AT(video) },
    { "shots", "DIR", "folder for pictures (demo: out/demo); otherwise one picture each 5 s",
      OPTION_PATH, AT(shots), .section = "files" },
    { "data", "DIR", "data folder of the kiosk (~/.local/share/kingyo)", OPTION_PATH, AT(data),
      .section = "files" },
    { "set", "KEY=VALUE",
      "setting of kingyo.conf for this session only; repeat the option for each setting",
      SET(set_setting), .expects = "KEY=VALUE; 'kingyoctl config defaults' lists them" },
    { "config", "FILE",
      "configuration file (/etc/kingyo/kingyo.conf), which the command line overrides",
      OPTION_PATH, AT(config) },
    { "lang", "ja|en", "default language, to which a visitor's choice returns", SET(set_one),
      .id = SET_LANGUAGE, .expects = "ja or en", .section = "" },
    { "tank", "NAME",
      "tank of the kiosk; thesis is the tank of 2013, and official that of a championship",
      OPTION_CHOICE, AT(tank), .choices = options_tank_names,
      .expects = "festival, thesis or official",
      .section = "game" },
    { "seed", "N", "seed of all random numbers; equal seeds give equal fish", SET(set_seed),
      .expects = "0 to 4294967295", .section = "game" },
    { "fish", "N", "number of fish, at most", SET(set_one), .id = SET_FISH, .more = print_fish_max,
      .expects = "1 to", .section = "" },
    { "help", NULL, "print this text", OPTION_FLAG, AT(help) },
    { "version", NULL, "print the version", OPTION_FLAG, AT(version) },
};
/* clang-format on */

const struct option_table options_table = OPTION_TABLE(table, NULL);

/* ---- Command line -------------------------------------------------------------------------- */

bool options_wires_clash(const struct options *options, char reason[OPTION_TEXT_MAX])
{
    char why[HAL_TEXT_SIZE];
    CORE_ASSERT(options->line_count <= BOARD_LINE_MAX);
    if (board_check_lines((const char(*)[BOARD_LINE_SIZE])options->line, options->line_count,
                          why) == 0) {
        return false;
    }
    snprintf(reason, OPTION_TEXT_MAX, "%s", why);
    return true;
}

bool options_too_many_fish(const struct options *options, char reason[OPTION_TEXT_MAX])
{
    const struct options_query_result *by = options->is_file ? &options->file : &options->words;
    CORE_ASSERT(options->tank < TANK_PRESET_COUNT);
    const uint32_t most = tank_fish_limit(options->tank);
    if (!by->is_set[SET_FISH] || by->value[SET_FISH] <= (int32_t)most) {
        return false;
    }
    snprintf(reason, OPTION_TEXT_MAX, "%d is too many; the %s tank holds 1 to %u",
             by->value[SET_FISH], tank_preset(options->tank)->name, most);
    return true;
}

int options_check(const struct options *options, char error[OPTIONS_ERROR_MAX])
{
    char reason[OPTION_TEXT_MAX];
    const char *name = options_too_many_fish(options, reason) ? "fish"
                       : options_wires_clash(options, reason) ? "line"
                                                              : NULL;
    if (options->record[0] && options->replay[0]) {
        snprintf(error, OPTIONS_ERROR_MAX, "--record and --replay cannot be combined");
        return -1;
    }
    if (options->video[0] && (!options->replay[0] || options->demo)) {
        snprintf(error, OPTIONS_ERROR_MAX, "--video needs --replay, and no --demo");
        return -1;
    }
    if (name) {
        snprintf(error, OPTIONS_ERROR_MAX, "--%s: %s", name, reason);
        return -1;
    }
    return 0;
}

int options_parse(struct options *options, int argc, const char *const *argv,
                  char error[OPTIONS_ERROR_MAX])
{
    CORE_ASSERT(argc >= 1);
    return option_table_parse(&options_table, 0, options, argc - 1, argv + 1, error)
               ? -1
               : options_check(options, error);
}

void options_print_help(void)
{
    puts("kingyo: a goldfish-scooping kiosk.\n"
         "\n"
         "Mouse: hold the left button to dip the poi, and release it to lift the poi. The wheel\n"
         "tilts the poi, and the right button levels it. Hold F to move the fan over the water;\n"
         "fish gather in its shade while it does not move.\n"
         "Keyboard: Space starts a round, the arrow keys choose a mode, 5 inserts a coin, F2\n"
         "opens the operator's menu, F3 is the service button, L changes the language, F11\n"
         "toggles full screen, and Esc pressed twice quits.\n"
         "Touch screen: one finger moves the poi, a second finger dips it, and three fingers\n"
         "press START.\n"
         "Gamepad: the left stick moves the poi, A or a trigger dips it, and the right stick\n"
         "tilts it.\n"
         "Without a screen the bot plays, or the replay is verified, and pictures are written.\n");
    option_table_print(&options_table, 0);
    puts("\nEach player needs a controller. A bowl without a controller stays empty. With --poi\n"
         "bot, the bot plays for all players. With --poi auto, the first player gets the best\n"
         "connected controller, also if it is connected later: a USB poi, else a gamepad, else\n"
         "mouse or touch screen. No controller changes during a game. A championship uses the\n"
         "official tank: the kiosk changes the tank.\n"
         "\n"
         "--record refuses a file that is not empty. A recording is complete after each second:\n"
         "a killed kiosk loses at most one second, and a power failure loses more.\n"
         "\n"
         "Exit code: 0 success; 1 the display was lost, no picture could be made, or a replay\n"
         "differs; 2 wrong option; 65 invalid recording; 74 a path or standard output that\n"
         "cannot be read or written, finished rounds that could not be saved, or a failure of\n"
         "ffmpeg.");
}

/* ---- Combination of the sources of settings ------------------------------------------------ */

static void apply_source(const struct options_query_result *source, struct settings *settings)
{
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (source->is_set[id]) {
            settings->value[id] = source->value[id];
        }
    }
}

void options_first(const struct options *options, struct settings *settings)
{
    settings_reset(settings);
    apply_source(&options->machine, settings);
    apply_source(&options->file, settings);
}

void options_last(const struct options *options, struct settings *settings)
{
    apply_source(&options->words, settings);
}

bool options_query(const struct options *options, uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    return options->file.is_set[id] || options->words.is_set[id];
}
