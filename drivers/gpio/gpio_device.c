/* gpio_device.c -- requests the lines, starts and ends the GPIO thread, reports missing lines, and
 * converts HAL commands to commands for the thread. */
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"
#include "drivers/gpio/gpio_thread.h"
#include "platform/os/thread.h"

/* Maximum number of steps of STOP_STEP_NS that gpio_thread_stop() waits for pulses. The total
 * of two seconds is enough for ten pulses of the slowest meters. */
#define STOP_STEPS_MAX 200u
#define STOP_STEP_NS 10000000
/* Interval of requests for missing lines in ns. With this interval, a chip that returns is used
 * within one second. */
#define RETRY_NS 1000000000u

_Static_assert((int)GPIO_OUTPUT_COUNT == (int)HAL_SWITCH_COUNT, "outputs are the HAL's switches");

/* ---- Requesting and losing lines ------------------------------------------------------------ */

/* Publishes the buttons that are held and the lines that are missing. A line is missing if the role
 * is wired but the GPIO thread does not own the line at present. Returns the missing lines, one bit
 * for each role. */
static uint32_t publish_lines(struct gpio_thread *reader)
{
    uint32_t wired = 0;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        wired |= reader->wires[role].wired ? gpio_role_bit(role) : 0u;
    }
    atomic_store(&reader->held, reader->levels);
    atomic_store(&reader->missing, wired & ~reader->had);
    return wired & ~reader->had;
}

static void begin_input(struct gpio_thread *reader, enum gpio_role role)
{
    const struct gpio_wire *wire = &reader->wires[role];
    const struct gpio_lines *lines = &reader->lines;
    CORE_ASSERT(gpio_role_is_input(role) && wire->wired);
    const bool active = lines->ops->level(lines->self, role) == 1;
    const uint64_t now = hal_now_ns(reader->clock);
    const uint32_t period_us = lines->ops->debounces(lines->self, role) ? 0u : wire->debounce_us;
    reader->inputs[role] = gpio_edge_filter_begin(period_us * 1000ull, active, now);
    if (gpio_role_is_coin(role)) {
        reader->coin[role - GPIO_COIN] = gpio_coin_begin(wire->pulse_min_us * 1000ull,
                                                         wire->pulse_max_us * 1000ull, active, now);
    } else if (active) { /* The button was already pressed when the line was requested. Therefore no
                            press is reported. */
        reader->levels |= gpio_role_bit(role);
    }
}

/* Marks one line as missing. A coin whose pulse had ended when the line was lost is counted, even
 * if the end was not debounced yet. A coin pulse that had not ended is counted as cut. An output
 * pulse that had not ended counts as finished, so that no ticket is dispensed twice. */
static void lose_line(struct gpio_thread *reader, enum gpio_role role)
{
    CORE_ASSERT(reader->had & gpio_role_bit(role));
    reader->had &= ~gpio_role_bit(role);
    reader->levels &= ~gpio_role_bit(role);
    if (gpio_role_is_coin(role)) {
        const struct debounce *debounce = &reader->inputs[role].debounce;
        struct coin_mech *coin = &reader->coin[role - GPIO_COIN];
        if (debounce->stable && !debounce->raw) {
            gpio_coin_edge(coin, debounce->since_ns, false);
        }
        gpio_coin_lose(coin);
    } else if (!gpio_role_is_input(role)) {
        struct pulse_train *train = &reader->trains[role - GPIO_INPUT_COUNT];
        if (train->on) {
            train->on = false;
            train->until_ns = hal_now_ns(reader->clock) + train->off_ns;
        }
    }
}

void gpio_thread_lose(struct gpio_thread *reader)
{
    const uint32_t before = reader->had;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (before & gpio_role_bit(role) &&
            reader->lines.ops->level(reader->lines.self, role) == HAL_ERR_GONE) {
            lose_line(reader, role);
        }
    }
    CORE_ASSERT((reader->had & ~before) == 0);
    if (reader->had != before) {
        reader->total.lost_chips++;
        atomic_fetch_add(&reader->faults, 1);
        publish_lines(reader);
    }
}

/* Writes a text such as "; no start, coin (BTN_START: there is no GPIO chip in /dev)". The text
 * lists all lines of `missing` and gives the reason for the first of these lines. */
static void append_missing(uint32_t missing, char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE],
                           char out[HAL_TEXT_SIZE])
{
    CORE_ASSERT(missing >> GPIO_ROLE_COUNT == 0);
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

void gpio_thread_describe(struct gpio_thread *reader)
{
    char text[HAL_TEXT_SIZE], line[GPIO_WIRE_TEXT_SIZE];
    const uint32_t failing = reader->failing & reader->had, missing = publish_lines(reader);
    pthread_mutex_lock(&reader->mutex);
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        if (failing & gpio_role_bit(role)) {
            gpio_wire_text(&reader->wires[role], line);
            snprintf(reader->why[role], HAL_TEXT_SIZE,
                     "%s does not switch: check the cable and power of its chip", line);
        } else if (reader->had & gpio_role_bit(role)) {
            reader->why[role][0] = '\0';
        }
    }
    append_missing(missing | failing, reader->why, text);
    snprintf(reader->text, sizeof reader->text, "%.30s: %u of %u lines%.110s",
             reader->lines.ops->describe(reader->lines.self),
             (uint32_t)__builtin_popcount(reader->had), gpio_config_count(reader->wires), text);
    pthread_mutex_unlock(&reader->mutex);
}

int gpio_thread_request(struct gpio_thread *reader)
{
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE] = { { 0 } };
    const int result = reader->lines.ops->open(reader->lines.self, reader->wires, why);
    CORE_ASSERT(result < 1 << GPIO_ROLE_COUNT);
    const uint32_t fresh = result > 0 ? (uint32_t)result & ~reader->had : 0u;
    reader->lit &= ~fresh;
    reader->failing &= ~fresh;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (fresh & gpio_role_bit(role) && gpio_role_is_input(role)) {
            begin_input(reader, role);
        } else if (fresh & gpio_role_bit(role) && gpio_role_begins_active(role)) {
            reader->lit |= gpio_role_bit(role);
        }
    }
    reader->had |= fresh;
    reader->retry_ns = hal_now_ns(reader->clock) + RETRY_NS;
    pthread_mutex_lock(&reader->mutex);
    memcpy(reader->why, why, sizeof reader->why);
    pthread_mutex_unlock(&reader->mutex);
    gpio_thread_describe(reader);
    return result;
}

/* ---- Open and close ------------------------------------------------------------------------- */

int gpio_thread_open(struct gpio_thread *reader, struct gpio_lines lines,
                     const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock)
{
    CORE_ASSERT(lines.ops && clock.ops);
    memset(reader, 0, sizeof *reader);
    reader->lines = lines;
    reader->clock = clock;
    pthread_mutex_init(&reader->mutex, NULL);
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        reader->wires[role] = gpio_wire_filled(&wires[role], role);
        if (!gpio_role_is_input(role)) {
            atomic_fetch_or(&reader->wanted,
                            gpio_role_begins_active(role) ? gpio_role_bit(role) : 0u);
            reader->trains[role - GPIO_INPUT_COUNT] = (struct pulse_train){
                .on_ns = reader->wires[role].pulse_on_us * 1000ull,
                .off_ns = reader->wires[role].pulse_off_us * 1000ull,
            };
        }
    }
    const int result = gpio_thread_request(reader);
    atomic_fetch_add(&reader->faults, (uint32_t)__builtin_popcount(atomic_load(&reader->missing)));
    return result;
}

void gpio_thread_close(struct gpio_thread *reader)
{
    const struct gpio_lines *lines = &reader->lines;
    CORE_ASSERT(reader->lines.ops);
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        if (reader->had & gpio_role_bit(role)) {
            lines->ops->set(lines->self, role, gpio_role_begins_active(role));
        }
    }
    lines->ops->close(lines->self);
    reader->had = reader->lit = 0;
    pthread_mutex_destroy(&reader->mutex);
}

static void *run_gpio_thread(void *context)
{
    struct gpio_thread *reader = context;
    while (!atomic_load(&reader->stop)) {
        gpio_thread_step(reader);
    }
    return NULL;
}

int gpio_thread_start(struct gpio_thread *reader, struct gpio_lines lines,
                      const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock)
{
    gpio_thread_open(reader, lines, wires, clock);
    reader->runs = thread_start(&reader->thread, run_gpio_thread, reader) == 0;
    if (!reader->runs) {
        gpio_thread_close(reader);
        return HAL_ERR_IO;
    }
    return HAL_OK;
}

void gpio_thread_stop(struct gpio_thread *reader)
{
    const struct timespec step = { .tv_nsec = STOP_STEP_NS };
    bool has_pulses = true;
    CORE_ASSERT(reader->runs);
    for (uint32_t i = 0; i < STOP_STEPS_MAX && has_pulses; i++) {
        uint32_t requested = 0;
        for (uint32_t output = 0; output < GPIO_OUTPUT_COUNT; output++) {
            requested |= atomic_load(&reader->pulses[output]);
        }
        has_pulses = requested > 0 || atomic_load(&reader->owed) > 0;
        if (has_pulses) {
            nanosleep(&step, NULL);
        }
    }
    atomic_store(&reader->stop, true);
    pthread_join(reader->thread, NULL);
    reader->runs = false;
    gpio_thread_close(reader);
}

/* ---- The devices ---------------------------------------------------------------------------- */

static const char *describe(void *self)
{
    struct gpio_thread *reader = self;
    pthread_mutex_lock(&reader->mutex);
    memcpy(reader->described, reader->text, sizeof reader->described);
    pthread_mutex_unlock(&reader->mutex);
    return reader->described;
}

void gpio_thread_why(struct gpio_thread *reader, enum gpio_role role, char out[HAL_TEXT_SIZE])
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    pthread_mutex_lock(&reader->mutex);
    memcpy(out, reader->why[role], HAL_TEXT_SIZE);
    pthread_mutex_unlock(&reader->mutex);
}

static bool is_wired(const struct gpio_thread *reader, enum hal_switch which)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    return reader->wires[GPIO_INPUT_COUNT + which].wired;
}

static int switch_set(void *self, enum hal_switch which, bool active)
{
    struct gpio_thread *reader = self;
    const uint32_t bit = gpio_role_bit(GPIO_INPUT_COUNT + which);
    if (!is_wired(reader, which)) {
        return HAL_ERR_ABSENT;
    }
    if (active) {
        atomic_fetch_or(&reader->wanted, bit);
    } else {
        atomic_fetch_and(&reader->wanted, ~bit);
    }
    return HAL_OK;
}

static int switch_pulse(void *self, enum hal_switch which, uint32_t count)
{
    struct gpio_thread *reader = self;
    if (!is_wired(reader, which)) {
        return HAL_ERR_ABSENT;
    }
    atomic_fetch_add(&reader->pulses[which], count);
    return HAL_OK;
}

/* Returns the pulses that were requested and have not ended. `pulses` is read first, because the
 * GPIO thread adds to `pending` before it subtracts from `pulses`. */
static uint32_t switch_pending(void *self, enum hal_switch which)
{
    struct gpio_thread *reader = self;
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    const uint32_t requested = atomic_load(&reader->pulses[which]);
    return requested + atomic_load(&reader->pending[which]);
}

struct hal_buttons gpio_thread_buttons(struct gpio_thread *reader)
{
    CORE_ASSERT(reader);
    static const struct hal_buttons_ops ops = {
        .poll = gpio_thread_poll,
        .describe = describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = reader };
}

struct hal_switches gpio_thread_switches(struct gpio_thread *reader)
{
    CORE_ASSERT(reader);
    static const struct hal_switches_ops ops = {
        .set = switch_set,
        .pulse = switch_pulse,
        .pending = switch_pending,
        .describe = describe,
    };
    return (struct hal_switches){ .ops = &ops, .self = reader };
}
