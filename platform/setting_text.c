/* setting_text.c -- the names of choices, modes and times of day, and the help text of each
 * setting. */
#include "platform/setting_text.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

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

static const struct words play = { 3, { "free", "paid", "event" } };
static const struct words language = { 2, { "ja", "en" } };
static const struct words rotation = { 4, { "0", "90", "180", "270" } };
/* Values 1 to 3 have no name because they are not valid. Value 0 is the paper grade of the game
 * mode. */
static const struct words grade = { 8, { "own", "", "", "", "4", "5", "6", "7" } };
static const struct words on = { 2, { "off", "on" } };

_Static_assert(PLAY_KIND_COUNT == 3 && LANGUAGE_COUNT == 2, "each has its word");
_Static_assert(CHOICE_COUNT <= 8, "so many words there may be");

static struct words mode_setting_words(void)
{
    struct words words = { .count = CHOICE_COUNT, .word = { [CHOICE_LAB] = "lab" } };
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        words.word[mode] = rules_of(mode)->name;
    }
    return words;
}

static struct words words_of(uint32_t id)
{
    assert(id < SETTING_COUNT);
    switch (id) {
    case SET_PLAY:
        return play;
    case SET_LANGUAGE:
        return language;
    case SET_ROTATION:
        return rotation;
    case SET_GRADE:
        return grade;
    case SET_MODES:
        return mode_setting_words();
    default:
        return on;
    }
}

/* Returns the index of the matching word, or -1 if no word matches. */
static int32_t find_word(const struct words *words, const char *text, size_t length)
{
    assert(words->count <= 8);
    for (uint32_t i = 0; i < words->count; i++) {
        if (length > 0 && strlen(words->word[i]) == length &&
            memcmp(words->word[i], text, length) == 0) {
            return (int32_t)i;
        }
    }
    return -1;
}

/* ---- Parsing ------------------------------------------------------------------------------- */

static int parse_number(const struct setting *setting, const char *text, int32_t *out)
{
    uint32_t number;
    if (!number_parse(text, (uint32_t)setting->min, (uint32_t)setting->max, &number)) {
        return 0;
    }
    *out = (int32_t)number;
    return 1;
}

static int parse_bits(const struct words *words, const char *text, int32_t *out)
{
    int32_t bits = 0;
    for (;;) {
        text += strspn(text, " \t");
        const size_t length = strcspn(text, ", \t");
        const int32_t bit = find_word(words, text, length);
        if (bit < 0) {
            return 0;
        }
        bits |= 1 << bit;
        text += length + strspn(text + length, " \t");
        if (*text == '\0') {
            *out = bits;
            return 1;
        }
        if (*text++ != ',') {
            return 0;
        }
    }
}

static int parse_minute(const char *text, int32_t *out)
{
    char hour[3] = "";
    uint32_t hours, minutes;
    const char *colon = strchr(text, ':');
    if (!colon || colon - text > 2 || strlen(colon + 1) != 2) {
        return 0;
    }
    memcpy(hour, text, (size_t)(colon - text));
    if (!number_parse(hour, 0, 23, &hours) || !number_parse(colon + 1, 0, 59, &minutes)) {
        return 0;
    }
    *out = (int32_t)hours * MINUTES_PER_HOUR + (int32_t)minutes;
    return 1;
}

static int parse_kind(uint32_t id, const char *text, int32_t *out)
{
    const struct setting *setting = settings_entry(id);
    const struct words words = words_of(id);
    switch (setting->kind) {
    case KIND_CHOICE:
        *out = find_word(&words, text, strlen(text));
        return *out >= 0;
    case KIND_BITS:
        return parse_bits(&words, text, out);
    case KIND_MINUTE:
        return parse_minute(text, out);
    default:
        return parse_number(setting, text, out);
    }
}

int setting_parse(uint32_t id, const char *text, int32_t *out)
{
    int32_t value = 0;
    assert(setting_section(settings_entry(id)->group)); /* A setting in a file is never negative. */
    if (!parse_kind(id, text, &value) || !settings_allows(id, value)) {
        return 0;
    }
    *out = value;
    return 1;
}

/* ---- Printing ------------------------------------------------------------------------------ */

__attribute__((format(printf, 3, 4))) static void setting_text_put(char *out, size_t size,
                                                                   const char *format, ...)
{
    assert(strlen(out) < size);
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
    assert(settings_allows(id, value));
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
    [SET_PLAY] = "Who pays: free play, paid play, or an event, which is free and sends coins back.",
    [SET_PRICE] = "Units that a round costs in paid play. A unit is what the smallest coin is "
                  "worth.",
    [SET_COIN_1] = "Units that a pulse of the first coin line is worth.",
    [SET_COIN_2] = "The same of the second.",
    [SET_COIN_3] = "The same of the third.",
    [SET_BONUS_UNITS] = "Who inserts so many units in a row gets credits for nothing; 0: nobody.",
    [SET_BONUS_CREDITS] = "How many credits that are.",
    [SET_CREDIT_MAX] = "Credits that may wait; from there on coins are sent back.",
    [SET_CREDIT_EXPIRY_MIN] = "Minutes after which credits that nobody plays lapse; 0: never.",
    [SET_TICKET_FISH] = "A ticket for so many fish that a player catches; 0: no tickets.",
    [SET_MODES] = "What START offers to choose from.",
    [SET_GRADE] = "The paper, from 4, strong, to 7, weak; own: the mode's.",
    [SET_ROUND_S] = "Seconds of a round, 10 at least; 0: the mode's own time.",
    [SET_FISH] = "How many fish swim; 0: as many as the tank is made for. At most as many as it "
                 "holds.",
    [SET_PLAYERS] = "Bowls at the tank; who has no controller leaves one empty.",
    [SET_LANGUAGE] = "Language of the stall. When nothing says it, the machine's locale does.",
    [SET_NAMES] = "Whether whoever is ranked is asked for a name.",
    [SET_VOLUME] = "Per cent of full volume.",
    [SET_ATTRACT_SOUND] = "While nobody plays, every so many-th show is heard; 0: none.",
    [SET_ROTATION] = "Degrees by which the screen is turned, clockwise.",
    [SET_OVERSCAN_X] = "Thousandths of the picture's width that the screen hides at each side.",
    [SET_OVERSCAN_Y] = "The same of its height.",
    [SET_BRIGHTNESS] = "Per cent of the picture's full brightness.",
    [SET_DIM] = "Per cent of that while nobody has played for a while.",
    [SET_DIM_AFTER_MIN] = "Minutes without a player after which the picture is dimmed; 0: never.",
    [SET_NIGHT_FROM_MIN] = "From this time of day on the picture is dark; needs a clock that is "
                           "right.",
    [SET_NIGHT_TO_MIN] = "Until this time of day; the same as night-from: never.",
    [SET_PIN] = "Four digits that open the operator's menu; 0: it opens without.",
};

const char *setting_section(uint32_t group)
{
    assert(group < SETTING_GROUP_COUNT);
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
    assert(id < SETTING_COUNT);
    return help[id] ? help[id] : "";
}
