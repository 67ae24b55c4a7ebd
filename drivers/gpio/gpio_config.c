/* gpio_config.c -- parses wiring texts and fills in default times. */
#include "drivers/gpio/gpio_config.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

/* Default debounce time of a coin line; coin switches bounce for 1 to 3 ms. */
#define COIN_DEBOUNCE_US 3000u
/* Default shortest coin pulse: the shortest common pulse of 25 ms, minus 20 %, minus 5 ms of
 * bounce. */
#define COIN_MIN_US 15000u
/* Default longest coin pulse: the longest common pulse of 200 ms, plus 20 %, rounded up. */
#define COIN_MAX_US 250000u
/* Default length of an output pulse. Electromechanical meters count five to ten steps per
 * second. */
#define PULSE_ON_US 100000u
#define PULSE_OFF_US 100000u

/* Name and default debounce time of each role. */
static const struct {
    const char *name;
    uint32_t debounce_us;
} roles[GPIO_ROLE_COUNT] = {
    [GPIO_START] = { "start", 5000 }, /* Microswitches bounce for 1 to 5 ms. The debounce time is
                                         shorter than a frame of 16 ms. */
    [GPIO_LEFT] = { "left", 5000 },
    [GPIO_RIGHT] = { "right", 5000 },
    [GPIO_OK] = { "ok", 5000 },
    /* TEST and SERVICE are rarely used, so a slow response is better than an accidental press. */
    [GPIO_TEST] = { "test", 20000 },
    [GPIO_SERVICE] = { "service", 20000 },
    [GPIO_TILT] = { "tilt", 2000 }, /* A tilt pendulum touches its ring for only a few
                                       milliseconds. */
    [GPIO_COIN] = { "coin", COIN_DEBOUNCE_US },
    [GPIO_COIN2] = { "coin2", COIN_DEBOUNCE_US },
    [GPIO_COIN3] = { "coin3", COIN_DEBOUNCE_US },
    [GPIO_DOOR] = { "door", 50000 }, /* A door switch bounces for longer than a button. */
    [GPIO_START_LAMP] = { "start-lamp", 0 },
    [GPIO_COIN_LOCKOUT] = { "coin-lockout", 0 },
    [GPIO_TICKET] = { "ticket", 0 },
    [GPIO_COIN_COUNTER] = { "coin-counter", 0 },
};

__attribute__((format(printf, 2, 3))) static bool gpio_config_error(char why[HAL_TEXT_SIZE],
                                                                    const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, HAL_TEXT_SIZE, format, arguments);
    va_end(arguments);
    return false;
}

const char *gpio_role_name(enum gpio_role role)
{
    return role < GPIO_ROLE_COUNT ? roles[role].name : "";
}

enum gpio_role gpio_role_find(const char *name, size_t length)
{
    CORE_ASSERT(name || length == 0);
    enum gpio_role role = 0;
    for (; role < GPIO_ROLE_COUNT; role++) {
        const char *own = roles[role].name;
        size_t i = 0;
        while (i < length && own[i] &&
               (name[i] == '_' ? '-' : tolower((unsigned char)name[i])) == own[i]) {
            i++;
        }
        if (i == length && !own[i]) {
            break;
        }
    }
    return role;
}

/* ---- Tokens of a wiring text ---------------------------------------------------------------- */

/* A part of the wiring text. The caller owns the bytes, which are not terminated by 0. */
struct token {
    const char *at;
    size_t length;
};

/* Returns true if `word` equals `text`. */
static bool token_is(struct token word, const char *text)
{
    CORE_ASSERT(text);
    return word.length == strlen(text) && memcmp(word.at, text, word.length) == 0;
}

/* Returns true and removes `prefix` from `word` if `word` starts with `prefix`, otherwise returns
 * false. */
static bool token_strip(struct token *word, const char *prefix)
{
    const size_t length = strlen(prefix);
    if (word->length < length || memcmp(word->at, prefix, length) != 0) {
        return false;
    }
    *word = (struct token){ word->at + length, word->length - length };
    return true;
}

/* Splits `rest` at the first `mark`. Returns the part before the mark and keeps the part after the
 * mark in `rest`. If there is no mark, returns all of `rest`. */
static struct token token_split(struct token *rest, char mark)
{
    const char *at = rest->length ? memchr(rest->at, mark, rest->length) : NULL;
    const size_t length = at ? (size_t)(at - rest->at) : rest->length;
    const size_t taken = at ? length + 1u : length;
    const struct token first = { rest->at, length };
    CORE_ASSERT(taken <= rest->length);
    *rest = (struct token){ rest->at + taken, rest->length - taken };
    return first;
}

/* Parses leading digits into `out` and removes them from `word`. Returns false if there are no
 * digits or if the value exceeds `max`. */
static bool parse_number(struct token *word, uint32_t max, uint32_t *out)
{
    uint64_t value = 0;
    size_t i = 0;
    while (i < word->length && isdigit((unsigned char)word->at[i])) {
        value = value * 10u + (uint64_t)(word->at[i] - '0');
        if (value > max) {
            return false;
        }
        i++;
    }
    CORE_ASSERT(i <= word->length && value <= max);
    *word = (struct token){ word->at + i, word->length - i };
    *out = (uint32_t)value;
    return i > 0;
}

/* Parses a single time. Returns false unless the time is 1 us to GPIO_TIME_US_MAX. */
static bool parse_time(struct token word, uint32_t *out_us)
{
    static const struct {
        const char *unit;
        uint32_t us;
    } units[] = { { "us", 1 }, { "ms", 1000 }, { "s", 1000000 } };
    uint32_t number;
    if (!parse_number(&word, GPIO_TIME_US_MAX, &number)) {
        return false;
    }
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (token_is(word, units[i].unit)) {
            *out_us = number * units[i].us;
            return number >= 1 && number <= GPIO_TIME_US_MAX / units[i].us;
        }
    }
    return false;
}

/* Parses two times that are separated by `mark`. Returns false unless each time is 1 us to
 * GPIO_TIME_US_MAX. */
static bool parse_times(struct token word, char mark, uint32_t *first_us, uint32_t *second_us)
{
    CORE_ASSERT(first_us && second_us);
    const struct token first = token_split(&word, mark);
    return parse_time(first, first_us) && parse_time(word, second_us);
}

/* ---- Parsing of one wire -------------------------------------------------------------------- */

static bool copies_name(struct token word, char out[GPIO_TEXT_SIZE])
{
    if (word.length == 0 || word.length >= GPIO_TEXT_SIZE) {
        return false;
    }
    memcpy(out, word.at, word.length);
    out[word.length] = '\0';
    return true;
}

/* Parses LINE: CHIP:OFFSET if only digits follow the last colon, otherwise a line name. Returns
 * false if the text is empty or too long. */
static bool reads_line(struct token word, struct gpio_wire *wire)
{
    CORE_ASSERT(wire->offset == 0);
    const char *colon = word.length ? memrchr(word.at, ':', word.length) : NULL;
    if (colon) {
        const size_t length = (size_t)(colon - word.at);
        struct token digits = { colon + 1, word.length - length - 1u };
        if (parse_number(&digits, UINT16_MAX, &wire->offset) && digits.length == 0) {
            return copies_name((struct token){ word.at, length }, wire->chip);
        }
        wire->offset = 0;
    }
    return copies_name(word, wire->name);
}

static bool reads_level_or_bias(struct token word, struct gpio_wire *wire, bool *has_bias)
{
    static const char *const biases[] = {
        [GPIO_BIAS_AS_IS] = "as-is",
        [GPIO_BIAS_UP] = "up",
        [GPIO_BIAS_DOWN] = "down",
        [GPIO_BIAS_OFF] = "float",
    };
    if (token_is(word, "low") || token_is(word, "high")) {
        wire->active_low = token_is(word, "low");
        return true;
    }
    for (uint8_t i = 0; i < sizeof biases / sizeof biases[0]; i++) {
        if (token_is(word, biases[i])) {
            wire->bias = i;
            *has_bias = true;
            return true;
        }
    }
    return false;
}

/* Parses debounce=, window= or pulse=. Returns false if the time is invalid or the word does not
 * suit the role. */
static bool reads_timing(struct token word, enum gpio_role role, struct gpio_wire *wire)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    if (token_strip(&word, "debounce=")) {
        return gpio_role_is_input(role) && parse_time(word, &wire->debounce_us);
    }
    if (token_strip(&word, "window=")) {
        return gpio_role_is_coin(role) &&
               parse_times(word, '-', &wire->pulse_min_us, &wire->pulse_max_us) &&
               wire->pulse_min_us < wire->pulse_max_us;
    }
    return token_strip(&word, "pulse=") && !gpio_role_is_input(role) &&
           parse_times(word, '/', &wire->pulse_on_us, &wire->pulse_off_us);
}

/* Writes the reason why the word is invalid to `why`. Returns false. */
static bool refuse_word(struct token word, enum gpio_role role, char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    const char *name = roles[role].name, *at = word.at;
    const int length = (int)(word.length < 30 ? word.length : 30);
    if (gpio_role_is_coin(role) && token_strip(&word, "window=")) {
        return gpio_config_error(why,
                                 "%s: '%.*s': a window is a shortest pulse and a longer one, "
                                 "of 1us to 10s: window=15ms-250ms",
                                 name, length, at);
    }
    if (gpio_role_is_input(role) && token_strip(&word, "debounce=")) {
        return gpio_config_error(why, "%s: '%.*s': a time of 1us to 10s is wanted: debounce=5ms",
                                 name, length, at);
    }
    return gpio_config_error(why, "%s: '%.*s' is none of low high up down float as-is%s", name,
                             length, at,
                             gpio_role_is_coin(role)    ? " debounce=3ms window=15ms-250ms"
                             : gpio_role_is_input(role) ? " debounce=5ms"
                                                        : " pulse=100ms/100ms");
}

bool gpio_wire_read(const char *text, struct gpio_wire wires[GPIO_ROLE_COUNT],
                    char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(text && why);
    struct token rest = { text, strlen(text) };
    if (!memchr(text, '=', rest.length)) {
        return gpio_config_error(why, "ROLE=LINE is wanted, as in start=BTN_START");
    }
    const struct token name = token_split(&rest, '=');
    const enum gpio_role role = gpio_role_find(name.at, name.length);
    if (role == GPIO_ROLE_COUNT) {
        return gpio_config_error(
            why,
            "'%.*s' is no role: start left right ok test service tilt coin coin2 "
            "coin3 door start-lamp coin-lockout ticket coin-counter",
            (int)(name.length < 20 ? name.length : 20), name.at);
    }
    const bool rests = gpio_role_is_input(role) || gpio_role_begins_active(role);
    struct gpio_wire wire = { .wired = 1, .active_low = rests };
    bool has_bias = !rests;
    const struct token line = token_split(&rest, ',');
    if (!reads_line(line, &wire)) {
        return gpio_config_error(why,
                                 "%s: a line's name or CHIP:OFFSET is wanted, of 1 to %u letters",
                                 roles[role].name, GPIO_TEXT_SIZE - 1u);
    }
    while (rest.length > 0) {
        const struct token word = token_split(&rest, ',');
        if (!reads_level_or_bias(word, &wire, &has_bias) && !reads_timing(word, role, &wire)) {
            return refuse_word(word, role, why);
        }
    }
    if (!has_bias) { /* The default bias sets a button whose wire is disconnected to "released", and
                        a disconnected coin lock to "locked". */
        const bool is_up = gpio_role_is_input(role) == (wire.active_low != 0);
        wire.bias = is_up ? GPIO_BIAS_UP : GPIO_BIAS_DOWN;
    }
    CORE_ASSERT(wire.bias <= GPIO_BIAS_OFF && (wire.name[0] || wire.chip[0]));
    wires[role] = gpio_wire_filled(&wire, role);
    return true;
}

/* ---- Defaults, texts and checks of wires ---------------------------------------------------- */

static void set_default(uint32_t *value, uint32_t own)
{
    *value = *value ? *value : own;
}

struct gpio_wire gpio_wire_filled(const struct gpio_wire *wire, enum gpio_role role)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    struct gpio_wire filled = *wire;
    set_default(&filled.debounce_us, roles[role].debounce_us);
    if (gpio_role_is_coin(role)) {
        set_default(&filled.pulse_min_us, COIN_MIN_US);
        set_default(&filled.pulse_max_us, COIN_MAX_US);
    } else if (!gpio_role_is_input(role)) {
        set_default(&filled.pulse_on_us, PULSE_ON_US);
        set_default(&filled.pulse_off_us, PULSE_OFF_US);
    }
    return filled;
}

uint32_t gpio_config_count(const struct gpio_wire wires[GPIO_ROLE_COUNT])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < GPIO_ROLE_COUNT; i++) {
        count += wires[i].wired != 0;
    }
    return count;
}

void gpio_wire_text(const struct gpio_wire *wire, char out[GPIO_WIRE_TEXT_SIZE])
{
    CORE_ASSERT(wire->wired);
    if (wire->name[0]) {
        snprintf(out, GPIO_WIRE_TEXT_SIZE, "%s", wire->name);
    } else {
        snprintf(out, GPIO_WIRE_TEXT_SIZE, "%s:%u", wire->chip, wire->offset);
    }
}

bool gpio_config_agrees(const struct gpio_wire wires[GPIO_ROLE_COUNT], char why[HAL_TEXT_SIZE])
{
    for (enum gpio_role a = 0; a < GPIO_ROLE_COUNT; a++) {
        for (enum gpio_role b = a + 1; b < GPIO_ROLE_COUNT; b++) {
            if (wires[a].wired && wires[b].wired && strcmp(wires[a].name, wires[b].name) == 0 &&
                strcmp(wires[a].chip, wires[b].chip) == 0 && wires[a].offset == wires[b].offset) {
                char line[GPIO_WIRE_TEXT_SIZE];
                gpio_wire_text(&wires[a], line);
                return gpio_config_error(why, "%s and %s are both on %s: one line, one role",
                                         gpio_role_name(a), gpio_role_name(b), line);
            }
        }
    }
    return true;
}
