/* gpio_thread.c -- implements the GPIO thread: waits for edges, debounces, counts coins, and drives
 * outputs. */
#include "drivers/gpio/gpio_thread.h"

#include <signal.h>
#include <string.h>
#include <time.h>

#include "drivers/gpio/gpio_config.h"
#include "drivers/gpio/gpio_thread_lines.h"

#define NS_PER_MS 1000000u
/* Interval at which the levels of all input lines are read, in addition to edge events. */
#define WATCH_NS 100000000u
/* Longest wait in gpio_thread_stop(): 200 steps of 10 ms, enough for ten pulses of the slowest
 * meters. */
#define STOP_STEPS_MAX 200u
#define STOP_STEP_NS 10000000

_Static_assert((int)GPIO_OUTPUT_COUNT == (int)HAL_SWITCH_COUNT, "outputs are the HAL's switches");

/* ---- Results -------------------------------------------------------------------------------- */

static void take_turn(struct gpio_thread *reader, enum gpio_role role,
                      struct debounce_edge_time turn)
{
    if (gpio_role_is_coin(role)) {
        coin_mech_edge(&reader->coin[role - GPIO_COIN], turn.time_ns, turn.active);
        return;
    }
    reader->levels =
        turn.active ? reader->levels | gpio_role_bit(role) : reader->levels & ~gpio_role_bit(role);
    /* `held` is stored before `pressed`, so that a thread that sees the press also sees the
     * level. */
    atomic_store(&reader->held, reader->levels);
    if (turn.active) {
        atomic_fetch_or(&reader->pressed, gpio_role_bit(role));
    }
}

static void publish_coins(struct gpio_thread *reader, uint32_t line)
{
    struct coin_mech *coin = &reader->coin[line];
    struct gpio_total *total = &reader->total;
    atomic_fetch_add(&reader->coins[line], coin->coins);
    atomic_fetch_add(&reader->faults, coin_mech_faults(coin));
    atomic_fetch_add(&reader->line_faults[GPIO_COIN + line], coin_mech_faults(coin));
    total->coins[line] += coin->coins;
    total->too_short += coin->too_short;
    total->stuck += coin->stuck;
    total->cut += coin->cut;
    coin->coins = coin->too_short = coin->stuck = coin->cut = 0;
}

/* Adds the counts since the previous call to the atomic counters that the frame loop reads. */
static void publish(struct gpio_thread *reader)
{
    struct gpio_total *total = &reader->total;
    uint32_t lost = 0, doubtful = 0, raw = 0;
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        struct gpio_edge_filter *input = &reader->inputs[i];
        lost += input->lost;
        doubtful += input->doubtful;
        atomic_fetch_add(&reader->line_faults[i], input->lost + input->doubtful);
        raw |= input->debounce.raw && (reader->had & gpio_role_bit(i)) ? gpio_role_bit(i) : 0u;
        input->lost = input->doubtful = 0;
    }
    atomic_store(&reader->raw, raw);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        publish_coins(reader, line);
    }
    atomic_fetch_add(&reader->faults, lost + doubtful);
    total->doubtful += doubtful;
    total->lost_edges += lost;
}

/* ---- One iteration of the thread ------------------------------------------------------------ */

static void earlier(uint64_t *due_ns, uint64_t other_ns)
{
    *due_ns = other_ns < *due_ns ? other_ns : *due_ns;
}

static uint64_t input_due_ns(const struct gpio_thread *reader, enum gpio_role role)
{
    uint64_t due_ns = gpio_edge_filter_due_ns(&reader->inputs[role]);
    if (gpio_role_is_coin(role)) {
        const uint32_t line = role - GPIO_COIN;
        due_ns = due_ns == UINT64_MAX ? coin_mech_due_ns(&reader->coin[line]) : due_ns;
        earlier(&due_ns, reader->coin_look_ns[line]);
    }
    return due_ns;
}

static void take_edges(struct gpio_thread *reader, struct gpio_edge *edges, uint32_t count,
                       uint32_t *touched)
{
    const uint64_t now = gpio_thread_now_ns(reader);
    for (uint32_t i = 0; i < count; i++) {
        const enum gpio_role role = edges[i].role;
        struct debounce_edge_time turn;
        edges[i].taken_ns = now;
        if (gpio_role_is_input(role) && reader->had & gpio_role_bit(role)) {
            *touched |= gpio_role_bit(role);
            atomic_fetch_add(&reader->edges[role], 1u);
            if (gpio_edge_filter_edge(&reader->inputs[role], &edges[i], &turn)) {
                take_turn(reader, role, turn);
            }
        }
    }
}

/* Reads the level of every line that had edges or whose deadline has passed. The level completes
 * the line's last transition. */
static void settle_inputs(struct gpio_thread *reader, uint32_t touched)
{
    const struct gpio_lines *lines = &reader->lines;
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        const uint64_t now = gpio_thread_now_ns(reader);
        if (!(reader->had & gpio_role_bit(role)) ||
            (!(touched & gpio_role_bit(role)) && now < input_due_ns(reader, role))) {
            continue;
        }
        const int level = lines->ops->level(lines->self, role);
        struct debounce_edge_time turn;
        if (gpio_role_is_coin(role)) {
            reader->coin_look_ns[role - GPIO_COIN] = now + GPIO_COIN_POLL_NS;
        }
        if (level == HAL_ERR_GONE) {
            gpio_thread_lose_lines(reader);
        }
        if (level >= 0 && gpio_edge_filter_level(&reader->inputs[role], now, level != 0, &turn)) {
            take_turn(reader, role, turn);
        }
        if (level >= 0 && gpio_role_is_coin(role)) {
            coin_mech_settle(&reader->coin[role - GPIO_COIN],
                             gpio_edge_filter_known_ns(&reader->inputs[role], now));
        }
    }
}

static void drive_output(struct gpio_thread *reader, enum gpio_role role)
{
    const uint32_t bit = gpio_role_bit(role);
    struct pulse_train *train = &reader->trains[role - GPIO_INPUT_COUNT];
    if (!(reader->had & bit)) {
        return; /* Pulses of a missing line are kept until the line is held again. */
    }
    const bool pulses = pulse_train_at(train, gpio_thread_now_ns(reader));
    const bool active = pulses || (atomic_load(&reader->wanted) & bit) != 0;
    if (active == ((reader->lit & bit) != 0)) {
        return;
    }
    const int result = reader->lines.ops->set(reader->lines.self, role, active);
    if (result == HAL_OK) {
        reader->lit ^= bit;
    } else if (result == HAL_ERR_GONE) {
        gpio_thread_lose_lines(reader);
    }
}

/* Drives all outputs. New pulses are added to `pending` and `owed` before they are removed from
 * `pulses`. A thread that reads `pulses` and then `pending` therefore misses no pulse. */
static void drive_outputs(struct gpio_thread *reader)
{
    uint32_t owed = 0, taken[GPIO_OUTPUT_COUNT];
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        struct pulse_train *train = &reader->trains[role - GPIO_INPUT_COUNT];
        taken[role - GPIO_INPUT_COUNT] = atomic_load(&reader->pulses[role - GPIO_INPUT_COUNT]);
        pulse_train_add(train, taken[role - GPIO_INPUT_COUNT]);
        drive_output(reader, role);
        atomic_store(&reader->pending[role - GPIO_INPUT_COUNT], train->left + train->on);
        owed += reader->had & gpio_role_bit(role) ? train->left + train->on : 0u;
    }
    atomic_store(&reader->owed, owed);
    for (uint32_t i = 0; i < GPIO_OUTPUT_COUNT; i++) {
        atomic_fetch_sub(&reader->pulses[i], taken[i]);
    }
}

static uint32_t wait_ms(const struct gpio_thread *reader)
{
    const uint64_t now = gpio_thread_now_ns(reader);
    uint64_t due_ns = now + GPIO_WAIT_MS_MAX * (uint64_t)NS_PER_MS;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (!(reader->had & gpio_role_bit(role))) {
            continue;
        }
        earlier(&due_ns, gpio_role_is_input(role)
                             ? input_due_ns(reader, role)
                             : pulse_train_due_ns(&reader->trains[role - GPIO_INPUT_COUNT]));
    }
    return due_ns <= now ? 1u : (uint32_t)((due_ns - now + NS_PER_MS - 1u) / NS_PER_MS);
}

void gpio_thread_step(struct gpio_thread *reader)
{
    struct gpio_edge edges[GPIO_EDGES_MAX];
    uint32_t touched = 0;
    if (gpio_thread_missing_bits(reader) != 0 && gpio_thread_now_ns(reader) >= reader->retry_ns) {
        gpio_thread_request_lines(reader);
    }
    const int count =
        reader->lines.ops->wait(reader->lines.self, edges, GPIO_EDGES_MAX, wait_ms(reader));
    if (count == HAL_ERR_GONE) {
        gpio_thread_lose_lines(reader);
        publish(reader); /* Publishes the counts before the lines are requested again. */
        gpio_thread_request_lines(reader);
    }
    take_edges(reader, edges, count > 0 ? (uint32_t)count : 0u, &touched);
    if (count < (int)GPIO_EDGES_MAX) { /* If the buffer was full, more edges must be read before the
                                          levels. */
        if (gpio_thread_now_ns(reader) >= reader->watch_ns) {
            reader->watch_ns = gpio_thread_now_ns(reader) + WATCH_NS;
            touched = ~0u;
        }
        settle_inputs(reader, touched);
    }
    drive_outputs(reader);
    publish(reader);
}

/* ---- Start and stop ------------------------------------------------------------------------- */

int gpio_thread_open(struct gpio_thread *reader, struct gpio_lines lines,
                     const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock)
{
    memset(reader, 0, sizeof *reader);
    reader->lines = lines;
    reader->clock = clock;
    atomic_store(&reader->wanted, gpio_thread_begin_bits());
    pthread_mutex_init(&reader->mutex, NULL);
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        reader->wires[role] = gpio_wire_filled(&wires[role], role);
        if (!gpio_role_is_input(role)) {
            reader->trains[role - GPIO_INPUT_COUNT] = (struct pulse_train){
                .on_ns = reader->wires[role].pulse_on_us * 1000ull,
                .off_ns = reader->wires[role].pulse_off_us * 1000ull,
            };
        }
    }
    const int result = gpio_thread_request_lines(reader);
    for (uint32_t bits = gpio_thread_missing_bits(reader); bits != 0; bits &= bits - 1u) {
        atomic_fetch_add(&reader->faults, 1);
    }
    return result;
}

void gpio_thread_close(struct gpio_thread *reader)
{
    const struct gpio_lines *lines = &reader->lines;
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        if (reader->had & gpio_role_bit(role)) {
            lines->ops->set(lines->self, role, gpio_role_begins_active(role));
        }
    }
    lines->ops->close(lines->self);
    reader->had = reader->lit = 0;
    pthread_mutex_destroy(&reader->mutex);
}

static void *gpio_thread_read_lines(void *context)
{
    struct gpio_thread *reader = context;
    while (!atomic_load(&reader->stop)) {
        gpio_thread_step(reader);
    }
    return NULL;
}

/* Signals that the kernel sends to a thread because of its own fault, such as an invalid memory
 * access. */
static const int panics[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };

/* Starts the thread with all signals blocked except `panics`, because the main thread handles all
 * other signals. */
int gpio_thread_start(struct gpio_thread *reader)
{
    sigset_t all, before;
    sigfillset(&all);
    for (size_t i = 0; i < sizeof panics / sizeof panics[0]; i++) {
        /* A blocked fault signal would end the process without a stack trace. */
        sigdelset(&all, panics[i]);
    }
    pthread_sigmask(SIG_SETMASK, &all, &before);
    reader->runs = pthread_create(&reader->thread, NULL, gpio_thread_read_lines, reader) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return reader->runs ? HAL_OK : HAL_ERR_IO;
}

static bool owes(struct gpio_thread *reader)
{
    uint32_t asked = 0;
    for (uint32_t i = 0; i < GPIO_OUTPUT_COUNT; i++) {
        asked |= atomic_load(&reader->pulses[i]);
    }
    return asked > 0 || atomic_load(&reader->owed) > 0;
}

void gpio_thread_stop(struct gpio_thread *reader)
{
    if (reader->runs) {
        const struct timespec step = { .tv_nsec = STOP_STEP_NS };
        for (uint32_t i = 0; i < STOP_STEPS_MAX && owes(reader); i++) {
            nanosleep(&step, NULL);
        }
        atomic_store(&reader->stop, 1);
        pthread_join(reader->thread, NULL);
        reader->runs = 0;
    }
    gpio_thread_close(reader);
}
