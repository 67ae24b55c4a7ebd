/* gpio_config.c -- parses wiring texts and fills in default times. */
#include "drivers/gpio/gpio_config.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"

/* Default debounce time of a coin line. Coin switches bounce for 1 to 3 ms. */
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

/* Name of each role, and the role's default debounce time in us. */
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
    /* The debounce time is short, because a tilt pendulum touches its ring for only a few
     * milliseconds. */
    [GPIO_TILT] = { "tilt", 2000 },
    [GPIO_COIN] = { "coin", COIN_DEBOUNCE_US },
    [GPIO_COIN2] = { "coin2", COIN_DEBOUNCE_US },
    [GPIO_COIN3] = { "coin3", COIN_DEBOUNCE_US },
    /* The debounce time is long, because a door switch bounces for longer than a button. */
    [GPIO_DOOR] = { "door", 50000 },
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

/* ---- Words of a wiring text ------------------------------------------------------------------ */

/* Size of the buffer for a copy of a wiring text. All options of a role together are shorter. */
#define TEXT_SIZE 256u

/* Returns true and moves `*word` behind `prefix` if `*word` starts with `prefix`, otherwise returns
 * false. */
static bool strip(const char **word, const char *prefix)
{
    const size_t length = strlen(prefix);
    if (strncmp(*word, prefix, length) != 0) {
        return false;
    }
    *word += length;
    return true;
}

/* Parses the digits at the start of `word` into `out`. Returns the text after the digits, or null
 * if there are no digits or if the value exceeds `max`. */
static const char *parse_number(const char *word, uint32_t max, uint32_t *out)
{
    char *end = NULL;
    const unsigned long long value = strtoull(word, &end, 10);
    CORE_ASSERT(max < UINT32_MAX);
    if (!isdigit((unsigned char)word[0]) || value > max) {
        return NULL;
    }
    *out = (uint32_t)value;
    return end;
}

/* Parses a time that ends at the character `end`. Returns the text after `end`, or a pointer to the
 * terminating zero if `end` is 0. Returns null unless the time is 1 us to GPIO_TIME_US_MAX. */
static const char *parse_time(const char *word, char end, uint32_t *out_us)
{
    static const struct {
        const char *unit;
        uint32_t us;
    } units[] = { { "us", 1 }, { "ms", 1000 }, { "s", 1000000 } };
    uint32_t number = 0;
    const char *unit = word ? parse_number(word, GPIO_TIME_US_MAX, &number) : NULL;
    for (size_t i = 0; unit && i < sizeof units / sizeof units[0]; i++) {
        const size_t length = strlen(units[i].unit);
        if (strncmp(unit, units[i].unit, length) == 0 && unit[length] == end) {
            *out_us = number * units[i].us;
            return number >= 1 && number <= GPIO_TIME_US_MAX / units[i].us
                       ? unit + length + (end != '\0')
                       : NULL;
        }
    }
    return NULL;
}

/* ---- Parsing of one wire -------------------------------------------------------------------- */

/* Parses a line: CHIP:OFFSET if only digits follow the last colon, otherwise the name of a line.
 * Returns false if the text is empty or too long. */
static bool parse_line(char *word, struct gpio_wire *wire)
{
    CORE_ASSERT(wire->offset == 0);
    char *colon = strrchr(word, ':'), *name = wire->name;
    const char *end = colon ? parse_number(colon + 1, UINT16_MAX, &wire->offset) : NULL;
    if (end && !*end) {
        *colon = '\0';
        name = wire->chip;
    } else {
        wire->offset = 0;
    }
    const size_t length = strlen(word);
    if (length == 0 || length >= GPIO_TEXT_SIZE) {
        return false;
    }
    memcpy(name, word, length + 1u);
    return true;
}

static bool parse_level_or_bias(const char *word, struct gpio_wire *wire, bool *has_bias)
{
    static const char *const biases[] = {
        [GPIO_BIAS_AS_IS] = "as-is",
        [GPIO_BIAS_UP] = "up",
        [GPIO_BIAS_DOWN] = "down",
        [GPIO_BIAS_OFF] = "float",
    };
    if (strcmp(word, "low") == 0 || strcmp(word, "high") == 0) {
        wire->active_low = strcmp(word, "low") == 0;
        return true;
    }
    for (uint32_t i = 0; i < sizeof biases / sizeof biases[0]; i++) {
        if (strcmp(word, biases[i]) == 0) {
            wire->bias = (uint8_t)i;
            *has_bias = true;
            return true;
        }
    }
    return false;
}

/* Parses one of the options debounce=, window= and pulse=. Returns false if the time is invalid or
 * the role does not have the option. */
static bool parse_timing(const char *word, enum gpio_role role, struct gpio_wire *wire)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    if (strip(&word, "debounce=")) {
        return gpio_role_is_input(role) && parse_time(word, '\0', &wire->debounce_us);
    }
    if (strip(&word, "window=")) {
        word = parse_time(word, '-', &wire->pulse_min_us);
        return gpio_role_is_coin(role) && parse_time(word, '\0', &wire->pulse_max_us) &&
               wire->pulse_min_us < wire->pulse_max_us;
    }
    if (!strip(&word, "pulse=") || gpio_role_is_input(role)) {
        return false;
    }
    word = parse_time(word, '/', &wire->pulse_on_us);
    return parse_time(word, '\0', &wire->pulse_off_us) != NULL;
}

/* Writes the reason why the word is invalid to `why`. Returns false. */
static bool reject_word(const char *word, enum gpio_role role, char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    const char *name = roles[role].name, *at = word;
    if (gpio_role_is_coin(role) && strip(&word, "window=")) {
        return gpio_config_error(why,
                                 "%s: '%.30s': a window is a shortest pulse and a longer one, "
                                 "of 1us to 10s: window=15ms-250ms",
                                 name, at);
    }
    if (gpio_role_is_input(role) && strip(&word, "debounce=")) {
        return gpio_config_error(why, "%s: '%.30s': a time of 1us to 10s is wanted: debounce=5ms",
                                 name, at);
    }
    return gpio_config_error(why, "%s: '%.30s' is none of low high up down float as-is%s", name, at,
                             gpio_role_is_coin(role)    ? " debounce=3ms window=15ms-250ms"
                             : gpio_role_is_input(role) ? " debounce=5ms"
                                                        : " pulse=100ms/100ms");
}

bool gpio_wire_read(const char *text, struct gpio_wire wires[GPIO_ROLE_COUNT],
                    char why[HAL_TEXT_SIZE])
{
    char buffer[TEXT_SIZE], *rest = buffer;
    CORE_ASSERT(text && why);
    if (!strchr(text, '=')) {
        return gpio_config_error(why, "ROLE=LINE is wanted, as in start=BTN_START");
    }
    if (strlen(text) >= sizeof buffer) {
        return gpio_config_error(why, "the text is longer than %u characters", TEXT_SIZE - 1u);
    }
    memcpy(buffer, text, strlen(text) + 1u);
    const char *name = strsep(&rest, "=");
    const enum gpio_role role = gpio_role_find(name, strlen(name));
    if (role == GPIO_ROLE_COUNT) {
        return gpio_config_error(
            why,
            "'%.20s' is not a role; expected start left right ok test service tilt coin coin2 "
            "coin3 door start-lamp coin-lockout ticket coin-counter",
            name);
    }
    const bool rests = gpio_role_is_input(role) || gpio_role_begins_active(role);
    struct gpio_wire wire = { .wired = true, .active_low = rests };
    bool has_bias = !rests;
    if (!parse_line(strsep(&rest, ","), &wire)) {
        return gpio_config_error(why,
                                 "%s: a line's name or CHIP:OFFSET is wanted, of 1 to %u letters",
                                 roles[role].name, GPIO_TEXT_SIZE - 1u);
    }
    while (rest && *rest) {
        const char *word = strsep(&rest, ",");
        if (!parse_level_or_bias(word, &wire, &has_bias) && !parse_timing(word, role, &wire)) {
            return reject_word(word, role, why);
        }
    }
    /* With the default bias, a button whose wire is disconnected reads as released, and a coin lock
     * whose wire is disconnected stays locked. */
    if (!has_bias) {
        const bool is_up = gpio_role_is_input(role) == wire.active_low;
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
        count += wires[i].wired;
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
