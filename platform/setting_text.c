/* setting_text.c -- the names of choices, modes and times of day, and the help text of each
 * setting. */
#include "platform/setting_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/game/rules.h"
#include "platform/os/number.h"

#define MINUTES_PER_HOUR 60

/* ---- Names of values ----------------------------------------------------------------------- */

/* Names for the values of a KIND_CHOICE setting or the bits of a KIND_BITS setting, lowest
 * first. */
struct words {
    uint32_t count;
    const char *word[8];
};

_Static_assert(PLAY_KIND_COUNT == 3 && LANGUAGE_COUNT == 2, "each has its word");
_Static_assert(CHOICE_COUNT <= 8, "so many words there may be");

static struct words words_of(uint32_t id)
{
    static const struct words names[SETTING_COUNT] = {
        [SET_PLAY] = { 3, { "free", "paid", "event" } },
        [SET_LANGUAGE] = { 2, { "ja", "en" } },
        [SET_LEVEL] = { LEVEL_CHOICE_COUNT, { "normal", "easy", "master" } },
        [SET_DIP] = { 2, { "hold", "click" } },
        [SET_SIDE] = { BOWL_SIDE_COUNT, { "dip", "right", "left" } },
        [SET_TEXT] = { 3, { "normal", "large", "largest" } },
        [SET_MUSIC] = { SETTING_SOUND_STEPS, { "100", "75", "50", "25", "silent" } },
        [SET_EFFECTS] = { SETTING_SOUND_STEPS, { "100", "75", "50", "25", "silent" } },
        [SET_QUIET_VOLUME] = { QUIET_VOLUME_COUNT, { "50", "30", "15", "silent" } },
        [SET_TIME] = { 2, { "night", "day" } },
        [SET_CAMERA] = { 2, { "follow", "rest" } },
        [SET_BOWL] = { 2, { "colour", "white" } },
        [SET_ROTATION] = { 4, { "0", "90", "180", "270" } },
        /* The value is the paper grade of the poi (the paper scoop). Value 0 means the game mode's
         * own grade. Values 1 to 3 have no name because they are not valid. */
        [SET_GRADE] = { 8, { "own", "", "", "", "4", "5", "6", "7" } },
    };
    struct words words = { .count = CHOICE_COUNT, .word = { [CHOICE_LAB] = "lab" } };
    CORE_ASSERT(id < SETTING_COUNT);
    if (id != SET_MODES) {
        return names[id].count > 0 ? names[id] : (struct words){ 2, { "off", "on" } };
    }
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        words.word[mode] = rules_of((uint8_t)mode)->name;
    }
    return words;
}

/* Returns the index of the matching word, or -1 if no word matches. */
static int32_t find_word(const struct words *words, const char *text, size_t length)
{
    CORE_ASSERT(words->count <= 8);
    for (uint32_t i = 0; i < words->count; i++) {
        if (length > 0 && strlen(words->word[i]) == length &&
            memcmp(words->word[i], text, length) == 0) {
            return (int32_t)i;
        }
    }
    return -1;
}

/* ---- Parsing ------------------------------------------------------------------------------- */

/* Parses words separated by commas. Returns the bits of the words, or -1 if a word is unknown or no
 * word follows a comma. */
static int32_t parse_bits(const struct words *words, const char *text)
{
    int32_t bits = 0;
    for (;; text++) {
        text += strspn(text, " \t");
        const size_t length = strcspn(text, ", \t");
        const int32_t bit = find_word(words, text, length);
        text += length + strspn(text + length, " \t");
        if (bit < 0 || (*text != ',' && *text != '\0')) {
            return -1;
        }
        bits |= 1 << bit;
        if (*text == '\0') {
            return bits;
        }
    }
}

/* Parses a time of day HH:MM. Returns the minutes after midnight, or -1 if the time is invalid. */
static int32_t parse_minute(const char *text)
{
    char hour[3] = "";
    uint32_t hours, minutes;
    const char *colon = strchr(text, ':');
    if (!colon || colon - text > 2 || strlen(colon + 1) != 2) {
        return -1;
    }
    memcpy(hour, text, (size_t)(colon - text));
    if (!number_parse(hour, 0, 23, &hours) || !number_parse(colon + 1, 0, 59, &minutes)) {
        return -1;
    }
    return (int32_t)hours * MINUTES_PER_HOUR + (int32_t)minutes;
}

bool setting_parse(uint32_t id, const char *text, int32_t *out)
{
    const struct setting *setting = settings_entry(id);
    const struct words words = words_of(id);
    uint32_t number;
    int32_t value = -1; /* -1 means that the text is invalid, because no valid setting in a file is
                         * negative. */
    CORE_ASSERT(setting_section(setting->group));
    if (setting->kind == KIND_CHOICE) {
        value = find_word(&words, text, strlen(text));
    } else if (setting->kind == KIND_BITS) {
        value = parse_bits(&words, text);
    } else if (setting->kind == KIND_MINUTE) {
        value = parse_minute(text);
    } else if (number_parse(text, (uint32_t)setting->min, (uint32_t)setting->max, &number)) {
        value = (int32_t)number;
    }
    if (value < 0 || !settings_allows(id, value)) {
        return false;
    }
    *out = value;
    return true;
}

/* ---- Printing ------------------------------------------------------------------------------ */

__attribute__((format(printf, 3, 4))) static void setting_text_put(char *out, size_t size,
                                                                   const char *format, ...)
{
    CORE_ASSERT(strlen(out) < size);
    const size_t length = strlen(out);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(out + length, size - length, format, arguments);
    va_end(arguments);
}

void setting_print(uint32_t id, int32_t value, char out[SETTING_TEXT_MAX])
{
    const struct words words = words_of(id);
    out[0] = '\0';
    CORE_ASSERT(settings_allows(id, value));
    switch (settings_entry(id)->kind) {
    case KIND_CHOICE:
        setting_text_put(out, SETTING_TEXT_MAX, "%s", words.word[value]);
        break;
    case KIND_BITS:
        for (uint32_t bit = 0; bit < words.count; bit++) {
            if ((uint32_t)value >> bit & 1u) {
                setting_text_put(out, SETTING_TEXT_MAX, "%s%s", out[0] ? ", " : "",
                                 words.word[bit]);
            }
        }
        break;
    case KIND_MINUTE:
        setting_text_put(out, SETTING_TEXT_MAX, "%02d:%02d", value / MINUTES_PER_HOUR,
                         value % MINUTES_PER_HOUR);
        break;
    default:
        setting_text_put(out, SETTING_TEXT_MAX, "%d", value);
    }
}

/* Writes the words as a list: "free, paid or event", where `last` joins the last two words. */
static void list_words(const struct words *words, const char *last, char *out)
{
    for (uint32_t i = 0; i < words->count; i++) {
        if (words->word[i][0]) {
            const char *gap = !out[0] ? "" : i + 1 == words->count ? last : ", ";
            setting_text_put(out, SETTING_RANGE_MAX, "%s%s", gap, words->word[i]);
        }
    }
}

void setting_range(uint32_t id, char out[SETTING_RANGE_MAX])
{
    const struct setting *setting = settings_entry(id);
    const struct words words = words_of(id);
    out[0] = '\0';
    switch (setting->kind) {
    case KIND_CHOICE:
        list_words(&words, " or ", out);
        break;
    case KIND_BITS:
        list_words(&words, " and ", out);
        setting_text_put(out, SETTING_RANGE_MAX, ", one or more, with commas between them");
        break;
    case KIND_MINUTE:
        setting_text_put(out, SETTING_RANGE_MAX, "00:00 to 23:45 in steps of %d minutes",
                         setting->step);
        break;
    default:
        setting_text_put(out, SETTING_RANGE_MAX, "%d to %d", setting->min, setting->max);
        if (setting->step > 1) {
            setting_text_put(out, SETTING_RANGE_MAX, " in steps of %d", setting->step);
        }
    }
}

/* ---- Sections and help texts --------------------------------------------------------------- */

static const char *const sections[SETTING_GROUP_COUNT] = {
    [GROUP_MONEY] = "money",     [GROUP_GAME] = "game",         [GROUP_SOUND] = "sound",
    [GROUP_PICTURE] = "picture", [GROUP_OPERATOR] = "operator",
};

static const char *const help[SETTING_COUNT] = {
    [SET_PLAY] = "Payment: free play, paid play, or an event, which is free and returns all coins.",
    [SET_PRICE] = ("Units that a round costs in paid play. One unit is the value of the smallest "
                   "coin."),
    [SET_COIN_1] = "Units that a pulse of the first coin line is worth.",
    [SET_COIN_2] = "Units that a pulse of the second coin line is worth.",
    [SET_COIN_3] = "Units that a pulse of the third coin line is worth.",
    [SET_BONUS_UNITS] =
        ("Units that a player must insert before a round to get the bonus credits. 0 "
         "means no bonus."),
    [SET_BONUS_CREDITS] = "Number of bonus credits.",
    [SET_CREDIT_MAX] = "Maximum number of unused credits. Coins beyond the maximum are returned.",
    [SET_CREDIT_EXPIRY_MIN] = "Minutes after which unused credits are deleted. 0 means never.",
    [SET_TICKET_FISH] = ("Number of caught fish for which a player gets a ticket. 0 means no "
                         "tickets."),
    [SET_MODES] = "Game modes that a player can choose after START.",
    [SET_GRADE] =
        ("Grade of the paper, from 4 (strong) to 7 (weak). own means the grade of the game "
         "mode."),
    [SET_ROUND_S] = ("Length of a round in seconds, at least 10. 0 means the length of the game "
                     "mode."),
    [SET_FISH] =
        ("Number of fish, at most the number that the tank can hold. 0 means the default of "
         "the tank."),
    [SET_PLAYERS] = "Number of bowls at the tank. A bowl without a controller stays empty.",
    [SET_LANGUAGE] =
        ("Default language, to which a visitor's choice returns. Without this setting it is the "
         "language of the machine's locale."),
    [SET_NAMES] = "Whether a player who is ranked can enter a name.",
    [SET_VOLUME] = "Volume of all sounds in per cent of the full volume. 0 means silent.",
    [SET_ATTRACT_SOUND] =
        ("Every n-th loop of the demonstration has sound, where n is the value. 0 "
         "means no sound."),
    [SET_ROTATION] = "Clockwise rotation of the screen in degrees.",
    [SET_OVERSCAN_X] = "Thousandths of the picture's width that the screen hides at each side.",
    [SET_OVERSCAN_Y] =
        ("Thousandths of the picture's height that the screen hides at the top and at "
         "the bottom."),
    [SET_BRIGHTNESS] = "Brightness in per cent of the picture's full brightness.",
    [SET_DIM] = "Per cent of the brightness to which the picture is dimmed without players.",
    [SET_DIM_AFTER_MIN] = ("Minutes without a player after which the picture is dimmed. 0 means "
                           "never."),
    [SET_NIGHT_FROM_MIN] = ("Time of day at which the picture becomes dark. The machine needs a "
                            "correct clock."),
    [SET_NIGHT_TO_MIN] = ("Time of day until which the picture stays dark. The time of night-from "
                          "means never."),
    [SET_LEVEL] =
        ("Level that players have until they choose another one: easy for children and "
         "beginners, or master, which is as hard as a real stall. A championship is always "
         "played at master."),
    [SET_DIP] =
        ("With a mouse or a touch screen: hold the button to dip the poi, or click once to dip it "
         "and once to lift it."),
    [SET_REACH] =
        ("Lower part of the picture, from 40 per cent, in which a mouse or a finger reaches the "
         "whole tank. 0 means the whole picture."),
    [SET_SIDE] =
        ("Side of the bowl of a player who plays alone. With dip, the bowl is on the side where "
         "the visitor dips to end the demonstration, and otherwise on the right."),
    [SET_TEXT] = "Size of small texts on the pages for players.",
    [SET_MUSIC] =
        ("Volume of the music and of the sounds around the stall, in per cent of volume, or "
         "silent."),
    [SET_EFFECTS] =
        ("Volume of the sounds of the game, in per cent of volume, or silent. They include "
         "coins, calls and results."),
    [SET_QUIET_VOLUME] =
        ("Volume of all sounds in the quiet hours, in per cent of volume, or silent. The "
         "operator's menu keeps its volume."),
    [SET_QUIET_FROM_MIN] = ("Time of day at which the quiet hours begin. The machine needs a "
                            "correct clock."),
    [SET_QUIET_TO_MIN] = ("Time of day at which the quiet hours end. The time of quiet-from means "
                          "that there are none."),
    [SET_TIME] = "Light of the stall: night with bulbs and lanterns, or day.",
    [SET_CAMERA] =
        ("Camera in a round with one player: follow comes closer to the poi by up to 15 per cent, "
         "rest does not move."),
    [SET_BOWL] = "Bowls of the players: with a band in the player's colour, or classic white.",
    [SET_PIN] = "Four digits that open the operator's menu. 0 means that the menu needs no PIN.",
};

const char *setting_section(uint32_t group)
{
    CORE_ASSERT(group < SETTING_GROUP_COUNT);
    return sections[group];
}

uint32_t setting_find(const char *name, size_t length)
{
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const struct setting *setting = settings_entry(id);
        if (sections[setting->group] && strlen(setting->name) == length &&
            memcmp(setting->name, name, length) == 0) {
            return id;
        }
    }
    return SETTING_COUNT;
}

const char *setting_help(uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    return help[id] ? help[id] : "";
}
