/* option_table.c -- the table with the name, value, help text and parser of each option. */
#include "platform/config/option_table.h"

#include <stdio.h>
#include <string.h>

#include "core/game/rules.h"
#include "core/scene.h"
#include "core/tank/tank.h"
#include "platform/board.h"
#include "platform/os/number.h"
#include "platform/setting_text.h"

/* ---- Parsers of values --------------------------------------------------------------------- */

static struct options_query_result *asked(struct options *options)
{
    return options->is_file ? &options->file : &options->words;
}

static int option_table_add(struct options *options, uint32_t id, int32_t value)
{
    asked(options)->value[id] = value;
    asked(options)->is_set[id] = 1;
    return 1;
}

/* Parses the value of the setting `id` as setting_parse() does and stores the value. */
static int ask_text(struct options *options, uint32_t id, const char *text)
{
    int32_t value;
    return setting_parse(id, text, &value) && option_table_add(options, id, value);
}

static int ask_number(struct options *options, uint32_t id, const char *text, uint32_t least,
                      uint32_t most)
{
    uint32_t number;
    return number_parse(text, least, most, &number) &&
           option_table_add(options, id, (int32_t)number);
}

static int copy_path(char out[OPTIONS_PATH_MAX], const char *text)
{
    const size_t length = strlen(text);
    if (length == 0 || length >= OPTIONS_PATH_MAX) {
        return 0;
    }
    memcpy(out, text, length + 1);
    return 1;
}

static int set_demo(struct options *options, const char *value)
{
    options->demo = 1;
    options->demo_s = OPTIONS_DEMO_S;
    return !value || number_parse(value, OPTIONS_DEMO_S_MIN, OPTIONS_DEMO_S_MAX, &options->demo_s);
}

static int set_window(struct options *options, const char *value)
{
    char width[16];
    const char *cross = strchr(value, 'x');
    if (!cross || cross == value || (size_t)(cross - value) >= sizeof width) {
        return 0;
    }
    snprintf(width, sizeof width, "%.*s", (int)(cross - value), value);
    return number_parse(width, HAL_WINDOW_WIDTH_MIN, HAL_WINDOW_SIDE_MAX, &options->width) &&
           number_parse(cross + 1, HAL_WINDOW_HEIGHT_MIN, HAL_WINDOW_SIDE_MAX, &options->height);
}

static int find_name(const char *const *names, uint8_t count, const char *value, uint8_t *out)
{
    for (uint8_t i = 0; i < count; i++) {
        if (strcmp(names[i], value) == 0) {
            *out = i;
            return 1;
        }
    }
    return 0;
}

static int set_poi(struct options *options, const char *value)
{
    static const char *const names[] = { "auto", "mouse", "touch", "pad", "usb", "bot" };
    return find_name(names, sizeof names / sizeof names[0], value, &options->poi);
}

static int set_keyboard(struct options *options, const char *value)
{
    static const char *const names[] = { "auto", "on", "off" };
    return find_name(names, sizeof names / sizeof names[0], value, &options->keyboard);
}

static int set_usb(struct options *options, const char *value)
{
    if (strlen(value) >= BOARD_USB_SIZE || options->usb_count == BOARD_USB_MAX ||
        !board_check_usb(value)) {
        return 0;
    }
    memcpy(options->usb[options->usb_count++], value, strlen(value) + 1u);
    return 1;
}

/* Parses `value` as one GPIO line option. */
static int option_table_read_wire(const char *value, char line[1][BOARD_LINE_SIZE],
                                  char why[HAL_TEXT_SIZE])
{
    if (strlen(value) >= BOARD_LINE_SIZE) {
        snprintf(why, HAL_TEXT_SIZE, "longer than %u characters", BOARD_LINE_SIZE - 1u);
        return -1;
    }
    memcpy(line[0], value, strlen(value) + 1u);
    return board_check_lines((const char(*)[BOARD_LINE_SIZE])line, 1, why);
}

static int set_line(struct options *options, const char *value)
{
    char why[HAL_TEXT_SIZE];
    char(*line)[BOARD_LINE_SIZE] = &options->line[options->line_count];
    if (options->line_count == BOARD_LINE_MAX || option_table_read_wire(value, line, why)) {
        return 0;
    }
    options->line_count++;
    return 1;
}

static int set_seed(struct options *options, const char *value)
{
    options->has_seed = 1;
    return number_parse(value, 0, UINT32_MAX, &options->seed);
}

static int set_tank(struct options *options, const char *value)
{
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        if (strcmp(tank_preset(id)->name, value) == 0) {
            options->tank = id;
            return 1;
        }
    }
    return 0;
}

static uint32_t fish_max(uint8_t tank)
{
    return tank_preset_fish_max(tank_preset(tank), 1.0f);
}

static int set_language(struct options *options, const char *value)
{
    return ask_text(options, SET_LANGUAGE, value);
}

/* Sets the number of fish. option_too_many_fish() checks the tank's maximum later, when the tank is
 * known. */
static int set_fish(struct options *options, const char *value)
{
    return ask_number(options, SET_FISH, value, 1, TANK_FISH_MAX);
}

/* Sets the game modes that a player can choose: one mode, the growth lab, or all modes. */
static int set_mode(struct options *options, const char *value)
{
    if (strcmp(value, "choose") == 0) {
        return option_table_add(options, SET_MODES, OPTIONS_MODES_ALL);
    }
    return !strchr(value, ',') && ask_text(options, SET_MODES, value);
}

static int set_grade(struct options *options, const char *value)
{
    return strcmp(value, "own") != 0 && ask_text(options, SET_GRADE, value);
}

static int set_players(struct options *options, const char *value)
{
    return ask_text(options, SET_PLAYERS, value);
}

static int set_coins(struct options *options, const char *value)
{
    uint32_t coins;
    if (!number_parse(value, 0, (uint32_t)settings_entry(SET_PRICE)->max, &coins)) {
        return 0;
    }
    return coins == 0 ? option_table_add(options, SET_PLAY, PLAY_FREE)
                      : option_table_add(options, SET_PLAY, PLAY_PAID) &&
                            option_table_add(options, SET_PRICE, (int32_t)coins);
}

static int set_tickets(struct options *options, const char *value)
{
    return ask_text(options, SET_TICKET_FISH, value);
}

/* Splits NAME=VALUE. Returns the id of the setting NAME and sets `value`. Returns SETTING_COUNT if
 * there is no such setting. */
static uint32_t split_setting(const char *text, const char **value)
{
    const size_t length = strcspn(text, "=");
    *value = text[length] ? text + length + 1 : NULL;
    return *value ? setting_find(text, length) : SETTING_COUNT;
}

static int set_setting(struct options *options, const char *text)
{
    const char *value;
    const uint32_t id = split_setting(text, &value);
    return id < SETTING_COUNT && ask_text(options, id, value);
}

static int set_record(struct options *options, const char *value)
{
    return copy_path(options->record, value);
}

static int set_replay(struct options *options, const char *value)
{
    return copy_path(options->replay, value);
}

static int set_shots(struct options *options, const char *value)
{
    return copy_path(options->shots, value);
}

static int set_data(struct options *options, const char *value)
{
    return copy_path(options->data, value);
}

static int set_config(struct options *options, const char *value)
{
    return copy_path(options->config, value);
}

static int set_help(struct options *options, const char *value)
{
    (void)value;
    options->help = 1;
    return 1;
}

static int set_version(struct options *options, const char *value)
{
    (void)value;
    options->version = 1;
    return 1;
}

/* ---- Table of options ---------------------------------------------------------------------- */

static const struct option table[] = {
    { "demo", "[SECONDS]", "let the bot play off screen and write pictures (20 s)",
      "5 to 600 seconds", set_demo, NULL },
    { "window", "WxH", "play in a window of that size; else full screen",
      "WIDTHxHEIGHT from 320x240 to 8192x8192", set_window, "picture" },
    { "poi", "KIND", "who holds the poi: auto, usb, pad, mouse, touch; or bot, who holds all",
      "auto, usb, pad, mouse, touch or bot", set_poi, "devices" },
    { "usb", "ID", "a USB controller that may be a poi; again for each",
      "VVVV:PPPP or VVVV:PPPP:SERIAL, as lsusb lists it; 8 at most", set_usb, "devices" },
    { "line", "ROLE=LINE", "a GPIO line and its role; 'kingyoctl lines' has more; again for each",
      "ROLE=LINE[,WORD...]; 32 at most", set_line, "devices" },
    { "keyboard", "USE", "whether keys are buttons and coins: on, off; auto: not as a service",
      "auto, on or off", set_keyboard, "devices" },
    { "mode", "NAME", "festival, championship, practice, lab (fish grow), or choose: START asks",
      "festival, championship, practice, lab or choose", set_mode, "" },
    { "grade", "N", "paper from 4, strong, to 7, weak (6; a championship has 5)", "4 to 7",
      set_grade, "" },
    { "players", "N", "bowls at the tank; who has no controller leaves one empty", "1 to 4",
      set_players, "" },
    { "coins", "N", "coins that a round costs; 0, as it is else: free play", "0 to 20", set_coins,
      "" },
    { "tickets", "N", "a ticket for each N fish that a player catches; 0: none", "0 to 20",
      set_tickets, "" },
    { "record", "FILE", "write the play to FILE, a new one, to be shown again", "a path",
      set_record, "files" },
    { "replay", "FILE", "show a recorded play and check it", "a path", set_replay, NULL },
    { "shots", "DIR", "where pictures go (demo: out/demo; else one each 5 s)", "a path", set_shots,
      "files" },
    { "data", "DIR", "where all is kept (~/.local/share/kingyo)", "a path", set_data, "files" },
    { "set", "KEY=VALUE", "a setting of kingyo.conf, for this run alone; again for each",
      "KEY=VALUE; 'kingyoctl config defaults' lists them", set_setting, NULL },
    { "config", "FILE", "settings, devices (/etc/kingyo/kingyo.conf); options here win", "a path",
      set_config, NULL },
    { "lang", "ja|en", "language of the stall", "ja or en", set_language, "" },
    { "tank", "NAME", "festival (the stall), thesis (2013) or official (championship)",
      "festival, thesis or official", set_tank, "game" },
    { "seed", "N", "of everything random; equal seeds swim alike", "0 to 4294967295", set_seed,
      "game" },
    { "fish", "N", "how many fish; the tanks hold", "1 to", set_fish, "" },
    { "help", NULL, "this text", NULL, set_help, NULL },
    { "version", NULL, "the version", NULL, set_version, NULL },
};

const struct option *option_find(const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        if (strlen(table[i].name) == length && memcmp(table[i].name, name, length) == 0) {
            return &table[i];
        }
    }
    return NULL;
}

const char *option_text(const struct option *option, const char *text, char out[OPTION_TEXT_MAX])
{
    if (option->set != set_fish) {
        return text;
    }
    snprintf(out, OPTION_TEXT_MAX, "%s %u (festival), %u (thesis) or %u (official)", text,
             fish_max(TANK_PRESET_FESTIVAL), fish_max(TANK_PRESET_THESIS),
             fish_max(TANK_PRESET_OFFICIAL));
    return out;
}

/* Writes the valid range to `out` if `text` is NAME=VALUE with an invalid value. Returns `out`, or
 * null if the value is valid or the setting is unknown. */
static const char *object_to_setting(const char *text, char out[OPTION_TEXT_MAX])
{
    const char *value;
    char range[SETTING_RANGE_MAX];
    int32_t read;
    const uint32_t id = split_setting(text, &value);
    if (id == SETTING_COUNT || setting_parse(id, value, &read)) {
        return NULL;
    }
    setting_range(id, range);
    snprintf(out, OPTION_TEXT_MAX, "expected %s", range);
    return out;
}

const char *option_objects(const struct option *option, const char *value,
                           char out[OPTION_TEXT_MAX])
{
    char line[1][BOARD_LINE_SIZE];
    char why[HAL_TEXT_SIZE];
    if (option->set == set_setting) {
        return object_to_setting(value, out);
    }
    if (option->set != set_line || option_table_read_wire(value, line, why) == 0) {
        return NULL;
    }
    snprintf(out, OPTION_TEXT_MAX, "%s", why);
    return out;
}

int option_wires_clash(const struct options *options, char says[OPTION_TEXT_MAX])
{
    char why[HAL_TEXT_SIZE];
    if (board_check_lines((const char(*)[BOARD_LINE_SIZE])options->line, options->line_count,
                          why) == 0) {
        return 0;
    }
    snprintf(says, OPTION_TEXT_MAX, "%s", why);
    return 1;
}

int option_too_many_fish(const struct options *options, char says[OPTION_TEXT_MAX])
{
    const struct options_query_result *by = options->is_file ? &options->file : &options->words;
    const uint32_t most = fish_max(options->tank);
    if (!by->is_set[SET_FISH] || by->value[SET_FISH] <= (int32_t)most) {
        return 0;
    }
    snprintf(says, OPTION_TEXT_MAX, "%d is too many; the %s tank holds 1 to %u",
             by->value[SET_FISH], tank_preset(options->tank)->name, most);
    return 1;
}

const struct option *option_at(uint32_t index)
{
    return index < sizeof table / sizeof table[0] ? &table[index] : NULL;
}
