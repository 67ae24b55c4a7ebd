/* gpio_thread_lines.c -- requests the lines of the GPIO thread, initializes their states, and
 * reports missing lines. */
#include "drivers/gpio/gpio_thread_lines.h"

#include <stdio.h>
#include <string.h>

#include "drivers/gpio/gpio_config.h"

/* Interval of requests for missing lines, so that a chip that returns is used within a second. */
#define RETRY_NS 1000000000u

uint32_t gpio_thread_begin_bits(void)
{
    uint32_t bits = 0;
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        bits |= gpio_role_begins_active(role) ? gpio_role_bit(role) : 0u;
    }
    return bits;
}

uint32_t gpio_thread_missing_bits(const struct gpio_thread *reader)
{
    uint32_t bits = 0;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        bits |= reader->wires[role].wired ? gpio_role_bit(role) : 0u;
    }
    return bits & ~reader->had;
}

static void begin_input(struct gpio_thread *reader, enum gpio_role role)
{
    const struct gpio_wire *wire = &reader->wires[role];
    const struct gpio_lines *lines = &reader->lines;
    const bool active = lines->ops->level(lines->self, role) == 1;
    const uint64_t now = gpio_thread_now_ns(reader);
    const uint32_t period_us =
        lines->ops->debounces(lines->self, role) == 1 ? 0u : wire->debounce_us;
    reader->inputs[role] = gpio_edge_filter_begin(period_us * 1000ull, active, now);
    if (gpio_role_is_coin(role)) {
        reader->coin[role - GPIO_COIN] = coin_mech_begin(wire->pulse_min_us * 1000ull,
                                                         wire->pulse_max_us * 1000ull, active, now);
    } else if (active) { /* The button was pressed before the line was requested, so no press is
                            reported. */
        reader->levels |= gpio_role_bit(role);
    }
}

/* Counts a coin whose pulse had ended when the line was lost, even if the end was not debounced
 * yet. A pulse that had not ended is counted as cut. */
static void lose_coin(struct gpio_thread *reader, enum gpio_role role)
{
    const struct debounce *debounce = &reader->inputs[role].debounce;
    struct coin_mech *coin = &reader->coin[role - GPIO_COIN];
    if (debounce->stable && !debounce->raw) {
        coin_mech_edge(coin, debounce->since_ns, false);
    }
    coin_mech_lose(coin);
}

static void lose_line(struct gpio_thread *reader, enum gpio_role role)
{
    reader->had &= ~gpio_role_bit(role);
    reader->levels &= ~gpio_role_bit(role);
    if (gpio_role_is_coin(role)) {
        lose_coin(reader, role);
    }
}

void gpio_thread_lose_lines(struct gpio_thread *reader)
{
    const uint32_t before = reader->had;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (before & gpio_role_bit(role) &&
            reader->lines.ops->level(reader->lines.self, role) == HAL_ERR_GONE) {
            lose_line(reader, role);
        }
    }
    if (reader->had != before) {
        reader->total.lost_chips++;
        atomic_fetch_add(&reader->faults, 1);
        atomic_store(&reader->held, reader->levels);
        atomic_store(&reader->missing, gpio_thread_missing_bits(reader));
    }
}

static uint32_t count_bits(uint32_t bits)
{
    return (uint32_t)__builtin_popcount(bits);
}

/* Writes a text such as "; no start, coin (BTN_START: there is no GPIO chip in /dev)". The text
 * lists all missing lines and gives the reason for the first missing line. */
static void say_missing(uint32_t missing, char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE],
                        char out[HAL_TEXT_SIZE])
{
    const char *first = "";
    size_t length = 0;
    out[0] = 0;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (missing & gpio_role_bit(role)) {
            first = length == 0 ? why[role] : first;
            snprintf(out + length, HAL_TEXT_SIZE - length, "%s%s", length ? ", " : "; no ",
                     gpio_role_name(role));
            length = strlen(out);
        }
    }
    const size_t room = HAL_TEXT_SIZE - length;
    if (first[0] && snprintf(out + length, room, " (%s)", first) >= (int)room) {
        out[HAL_TEXT_SIZE - 2u] = ')'; /* Closes the parenthesis of a truncated text. */
    }
}

/* Updates the one-line description of the held and the missing lines. */
static void gpio_thread_lines_describe(struct gpio_thread *reader,
                                       char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    char missing[HAL_TEXT_SIZE];
    say_missing(gpio_thread_missing_bits(reader), why, missing);
    pthread_mutex_lock(&reader->mutex);
    memcpy(reader->why, why, sizeof reader->why);
    snprintf(reader->text, sizeof reader->text, "%.30s: %u of %u lines%.110s",
             reader->lines.ops->describe(reader->lines.self), count_bits(reader->had),
             gpio_config_count(reader->wires), missing);
    pthread_mutex_unlock(&reader->mutex);
}

int gpio_thread_request_lines(struct gpio_thread *reader)
{
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE] = { { 0 } };
    const int result = reader->lines.ops->open(reader->lines.self, reader->wires, why);
    const uint32_t fresh = result > 0 ? (uint32_t)result & ~reader->had : 0u;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (fresh & gpio_role_bit(role) && gpio_role_is_input(role)) {
            begin_input(reader, role);
        }
    }
    reader->had |= fresh;
    reader->lit = (reader->lit & ~fresh) | (fresh & gpio_thread_begin_bits());
    reader->retry_ns = gpio_thread_now_ns(reader) + RETRY_NS;
    atomic_store(&reader->held, reader->levels);
    atomic_store(&reader->missing, gpio_thread_missing_bits(reader));
    gpio_thread_lines_describe(reader, why);
    return result;
}
