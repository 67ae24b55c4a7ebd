/* buttons_gpio.c -- runs the GPIO thread, converts the counters of the thread (`reader`) to HAL
 * samples, and converts HAL commands to commands for the thread. */
#include "drivers/gpio/buttons_gpio.h"

#include <signal.h>
#include <string.h>
#include <time.h>

#include "core/base/panic.h"

/* Longest wait in buttons_gpio_stop(): 200 steps of 10 ms, enough for ten pulses of the slowest
 * meters. */
#define STOP_STEPS_MAX 200u
#define STOP_STEP_NS 10000000

/* Button of each input line as a bit of enum input_button, or 0 for the coin lines, which are no
 * buttons. */
static const uint32_t button_of[GPIO_INPUT_COUNT] = {
    [GPIO_START] = INPUT_START, [GPIO_LEFT] = INPUT_LEFT, [GPIO_RIGHT] = INPUT_RIGHT,
    [GPIO_OK] = INPUT_OK,       [GPIO_TEST] = INPUT_TEST, [GPIO_SERVICE] = INPUT_SERVICE,
    [GPIO_TILT] = INPUT_TILT,   [GPIO_COIN] = 0,          [GPIO_COIN2] = 0,
    [GPIO_COIN3] = 0,           [GPIO_DOOR] = INPUT_DOOR,
};

static uint32_t buttons_of(uint32_t roles)
{
    CORE_ASSERT(roles >> GPIO_ROLE_COUNT == 0);
    uint32_t buttons = 0;
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        buttons |= roles & 1u << i ? button_of[i] : 0u;
    }
    return buttons;
}

/* Fills the raw level, the edge count and the fault count of every line. The operator's test page
 * shows these values. */
static void sample_lines(struct gpio_thread *reader, struct button_sample *out)
{
    const uint32_t raw = atomic_load(&reader->raw);
    for (uint32_t role = 0; role < GPIO_INPUT_COUNT; role++) {
        /* The lines of a sample are the buttons, followed by the coin lines. */
        const uint32_t line = gpio_role_is_coin(role) ? INPUT_BUTTON_COUNT + role - GPIO_COIN
                                                      : (uint32_t)__builtin_ctz(button_of[role]);
        CORE_ASSERT(line < HAL_LINE_COUNT);
        out->raw |= raw & 1u << role ? 1u << line : 0u;
        out->line[line] = (struct line_sample){
            .edges = atomic_exchange(&reader->edges[role], 0),
            .faults = atomic_exchange(&reader->line_faults[role], 0),
        };
    }
}

static int buttons_gpio_poll(void *self, struct button_sample *out)
{
    struct gpio_thread *reader = &((struct buttons_gpio *)self)->reader;
    /* `pressed` is read before `held`, because the GPIO thread stores `held` before `pressed`. */
    const uint32_t pressed = atomic_exchange(&reader->pressed, 0);
    const uint32_t missing = atomic_load(&reader->missing);
    *out = (struct button_sample){
        .pressed = buttons_of(pressed),
        .held = buttons_of(atomic_load(&reader->held)),
        .faults = atomic_exchange(&reader->faults, 0),
        .missing = buttons_of(missing),
    };
    sample_lines(reader, out);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        out->coin_count[line] = atomic_exchange(&reader->coins[line], 0);
        out->missing |= missing & 1u << (GPIO_COIN + line) ? HAL_MISSING_COIN << line : 0u;
    }
    return HAL_OK;
}

static const char *buttons_gpio_describe(void *self)
{
    struct buttons_gpio *gpio = self;
    pthread_mutex_lock(&gpio->reader.mutex);
    memcpy(gpio->text, gpio->reader.text, sizeof gpio->text);
    pthread_mutex_unlock(&gpio->reader.mutex);
    return gpio->text;
}

void buttons_gpio_why(struct buttons_gpio *gpio, enum gpio_role role, char out[HAL_TEXT_SIZE])
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    pthread_mutex_lock(&gpio->reader.mutex);
    memcpy(out, gpio->reader.why[role], HAL_TEXT_SIZE);
    pthread_mutex_unlock(&gpio->reader.mutex);
}

static int is_wired(const struct gpio_thread *reader, enum hal_switch which)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    return reader->wires[GPIO_INPUT_COUNT + which].wired;
}

static int buttons_gpio_set(void *self, enum hal_switch which, int active)
{
    struct gpio_thread *reader = &((struct buttons_gpio *)self)->reader;
    const uint32_t bit = 1u << (GPIO_INPUT_COUNT + which);
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

static int buttons_gpio_pulse(void *self, enum hal_switch which, uint32_t count)
{
    struct gpio_thread *reader = &((struct buttons_gpio *)self)->reader;
    if (!is_wired(reader, which)) {
        return HAL_ERR_ABSENT;
    }
    atomic_fetch_add(&reader->pulses[which], count);
    return HAL_OK;
}

/* Returns the pulses that were requested and have not ended. `pulses` is read first, because the
 * GPIO thread adds to `pending` before it subtracts from `pulses`. */
static uint32_t buttons_gpio_pending(void *self, enum hal_switch which)
{
    struct gpio_thread *reader = &((struct buttons_gpio *)self)->reader;
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    const uint32_t asked = atomic_load(&reader->pulses[which]);
    return asked + atomic_load(&reader->pending[which]);
}

/* ---- The thread ----------------------------------------------------------------------------- */

static void *run_gpio_thread(void *context)
{
    struct gpio_thread *reader = context;
    while (!atomic_load(&reader->stop)) {
        gpio_thread_step(reader);
    }
    return NULL;
}

/* Signals that the kernel sends to a thread because of an error in this thread, such as an invalid
 * memory access. */
static const int panics[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

/* Starts the GPIO thread. The signals in `panics` are not blocked in the thread. All other signals
 * are blocked, because the main thread handles them. */
int buttons_gpio_start(struct buttons_gpio *gpio, struct gpio_lines lines,
                       const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock)
{
    CORE_ASSERT(gpio && lines.ops && clock.ops);
    struct gpio_thread *reader = &gpio->reader;
    sigset_t all, before;
    gpio_thread_open(reader, lines, wires, clock);
    sigfillset(&all);
    for (size_t i = 0; i < sizeof panics / sizeof panics[0]; i++) {
        /* A blocked fault signal would end the process without a stack trace. */
        sigdelset(&all, panics[i]);
    }
    pthread_sigmask(SIG_SETMASK, &all, &before);
    reader->runs = pthread_create(&reader->thread, NULL, run_gpio_thread, reader) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (!reader->runs) {
        gpio_thread_close(reader);
        return HAL_ERR_IO;
    }
    return HAL_OK;
}

/* Returns true while requested pulses have not ended. */
static bool has_pulses(struct gpio_thread *reader)
{
    uint32_t asked = 0;
    for (uint32_t i = 0; i < GPIO_OUTPUT_COUNT; i++) {
        asked |= atomic_load(&reader->pulses[i]);
    }
    return asked > 0 || atomic_load(&reader->owed) > 0;
}

void buttons_gpio_stop(struct buttons_gpio *gpio)
{
    struct gpio_thread *reader = &gpio->reader;
    const struct timespec step = { .tv_nsec = STOP_STEP_NS };
    CORE_ASSERT(reader->runs);
    for (uint32_t i = 0; i < STOP_STEPS_MAX && has_pulses(reader); i++) {
        nanosleep(&step, NULL);
    }
    atomic_store(&reader->stop, 1);
    pthread_join(reader->thread, NULL);
    reader->runs = 0;
    gpio_thread_close(reader);
}

/* ---- The devices ---------------------------------------------------------------------------- */

struct hal_buttons buttons_gpio_device(struct buttons_gpio *gpio)
{
    CORE_ASSERT(gpio);
    static const struct hal_buttons_ops ops = {
        .poll = buttons_gpio_poll,
        .describe = buttons_gpio_describe,
    };
    return (struct hal_buttons){ .ops = &ops, .self = gpio };
}

struct hal_switches buttons_gpio_switches(struct buttons_gpio *gpio)
{
    CORE_ASSERT(gpio);
    static const struct hal_switches_ops ops = {
        .set = buttons_gpio_set,
        .pulse = buttons_gpio_pulse,
        .pending = buttons_gpio_pending,
        .describe = buttons_gpio_describe,
    };
    return (struct hal_switches){ .ops = &ops, .self = gpio };
}
