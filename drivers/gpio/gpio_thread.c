/* gpio_thread.c -- implements the GPIO thread's work: requests lines, waits for edges, debounces,
 * counts coins, drives outputs, and reports missing lines. */
#include "drivers/gpio/gpio_thread.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"

#define NS_PER_MS 1000000u
/* Interval at which the levels of all input lines are read, in addition to edge events. */
#define WATCH_NS 100000000u
/* Interval of requests for missing lines, so that a chip that returns is used within a second. */
#define RETRY_NS 1000000000u

_Static_assert((int)GPIO_OUTPUT_COUNT == (int)HAL_SWITCH_COUNT, "outputs are the HAL's switches");

static uint64_t gpio_clock_now_ns(const struct gpio_thread *reader)
{
    CORE_ASSERT(reader->clock.ops);
    return reader->clock.ops->now_ns(reader->clock.self);
}

static uint32_t role_bit(enum gpio_role role)
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    return 1u << role;
}

/* ---- Requesting and losing lines ------------------------------------------------------------ */

/* Returns the outputs that start active, one bit for each role. */
static uint32_t begin_bits(void)
{
    uint32_t bits = 0;
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        bits |= gpio_role_begins_active(role) ? role_bit(role) : 0u;
    }
    return bits;
}

/* Returns the missing lines, one bit for each role. A line is missing if the role is wired but the
 * GPIO thread does not own the line at present. */
static uint32_t missing_bits(const struct gpio_thread *reader)
{
    uint32_t bits = 0;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        bits |= reader->wires[role].wired ? role_bit(role) : 0u;
    }
    return bits & ~reader->had;
}

static void begin_input(struct gpio_thread *reader, enum gpio_role role)
{
    const struct gpio_wire *wire = &reader->wires[role];
    const struct gpio_lines *lines = &reader->lines;
    CORE_ASSERT(gpio_role_is_input(role) && wire->wired);
    const bool active = lines->ops->level(lines->self, role) == 1;
    const uint64_t now = gpio_clock_now_ns(reader);
    const uint32_t period_us =
        lines->ops->debounces(lines->self, role) == 1 ? 0u : wire->debounce_us;
    reader->inputs[role] = gpio_edge_filter_begin(period_us * 1000ull, active, now);
    if (gpio_role_is_coin(role)) {
        reader->coin[role - GPIO_COIN] = gpio_coin_begin(wire->pulse_min_us * 1000ull,
                                                         wire->pulse_max_us * 1000ull, active, now);
    } else if (active) { /* The button was already pressed when the line was requested. Therefore no
                            press is reported. */
        reader->levels |= role_bit(role);
    }
}

/* Marks one line as missing. A coin whose pulse had ended when the line was lost is counted, even
 * if the end was not debounced yet. A pulse that had not ended is counted as cut. */
static void lose_line(struct gpio_thread *reader, enum gpio_role role)
{
    CORE_ASSERT(reader->had & role_bit(role));
    reader->had &= ~role_bit(role);
    reader->levels &= ~role_bit(role);
    if (gpio_role_is_coin(role)) {
        const struct debounce *debounce = &reader->inputs[role].debounce;
        struct coin_mech *coin = &reader->coin[role - GPIO_COIN];
        if (debounce->stable && !debounce->raw) {
            gpio_coin_edge(coin, debounce->since_ns, false);
        }
        gpio_coin_lose(coin);
    }
}

/* Marks the lines of removed chips as missing. Counts one fault if at least one line is newly
 * missing. */
static void lose_lines(struct gpio_thread *reader)
{
    const uint32_t before = reader->had;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (before & role_bit(role) &&
            reader->lines.ops->level(reader->lines.self, role) == HAL_ERR_GONE) {
            lose_line(reader, role);
        }
    }
    CORE_ASSERT((reader->had & ~before) == 0);
    if (reader->had != before) {
        reader->total.lost_chips++;
        atomic_fetch_add(&reader->faults, 1);
        atomic_store(&reader->held, reader->levels);
        atomic_store(&reader->missing, missing_bits(reader));
    }
}

/* Writes a text such as "; no start, coin (BTN_START: there is no GPIO chip in /dev)". The text
 * lists all missing lines and gives the reason for the first missing line. */
static void say_missing(uint32_t missing, char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE],
                        char out[HAL_TEXT_SIZE])
{
    CORE_ASSERT(missing >> GPIO_ROLE_COUNT == 0);
    const char *first = "";
    size_t length = 0;
    out[0] = 0;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (missing & role_bit(role)) {
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

/* Requests the missing lines. Returns the result of gpio_lines_ops.open. */
static int request_lines(struct gpio_thread *reader)
{
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE] = { { 0 } };
    const int result = reader->lines.ops->open(reader->lines.self, reader->wires, why);
    CORE_ASSERT(result < 1 << GPIO_ROLE_COUNT);
    const uint32_t fresh = result > 0 ? (uint32_t)result & ~reader->had : 0u;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (fresh & role_bit(role) && gpio_role_is_input(role)) {
            begin_input(reader, role);
        }
    }
    reader->had |= fresh;
    reader->lit = (reader->lit & ~fresh) | (fresh & begin_bits());
    reader->retry_ns = gpio_clock_now_ns(reader) + RETRY_NS;
    atomic_store(&reader->held, reader->levels);
    atomic_store(&reader->missing, missing_bits(reader));
    char missing[HAL_TEXT_SIZE];
    say_missing(missing_bits(reader), why, missing);
    pthread_mutex_lock(&reader->mutex);
    memcpy(reader->why, why, sizeof reader->why);
    snprintf(reader->text, sizeof reader->text, "%.30s: %u of %u lines%.110s",
             reader->lines.ops->describe(reader->lines.self),
             (uint32_t)__builtin_popcount(reader->had), gpio_config_count(reader->wires), missing);
    pthread_mutex_unlock(&reader->mutex);
    return result;
}

/* ---- Results -------------------------------------------------------------------------------- */

static void take_turn(struct gpio_thread *reader, enum gpio_role role,
                      struct debounce_edge_time turn)
{
    CORE_ASSERT(gpio_role_is_input(role) && reader->had & role_bit(role));
    if (gpio_role_is_coin(role)) {
        gpio_coin_edge(&reader->coin[role - GPIO_COIN], turn.time_ns, turn.active);
        return;
    }
    reader->levels =
        turn.active ? reader->levels | role_bit(role) : reader->levels & ~role_bit(role);
    /* `held` is stored before `pressed`, so that a thread that sees the press also sees the
     * level. */
    atomic_store(&reader->held, reader->levels);
    if (turn.active) {
        atomic_fetch_or(&reader->pressed, role_bit(role));
    }
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
        raw |= input->debounce.raw && (reader->had & role_bit(i)) ? role_bit(i) : 0u;
        input->lost = input->doubtful = 0;
    }
    atomic_store(&reader->raw, raw);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        struct coin_mech *coin = &reader->coin[line];
        atomic_fetch_add(&reader->coins[line], coin->coins);
        atomic_fetch_add(&reader->faults, gpio_coin_faults(coin));
        atomic_fetch_add(&reader->line_faults[GPIO_COIN + line], gpio_coin_faults(coin));
        total->coins[line] += coin->coins;
        total->too_short += coin->too_short;
        total->stuck += coin->stuck;
        total->cut += coin->cut;
        coin->coins = coin->too_short = coin->stuck = coin->cut = 0;
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
    CORE_ASSERT(gpio_role_is_input(role));
    uint64_t due_ns = gpio_edge_filter_due_ns(&reader->inputs[role]);
    if (gpio_role_is_coin(role)) {
        const uint32_t line = role - GPIO_COIN;
        due_ns = due_ns == UINT64_MAX ? gpio_coin_due_ns(&reader->coin[line]) : due_ns;
        earlier(&due_ns, reader->coin_look_ns[line]);
    }
    return due_ns;
}

/* Processes edges of the lines. Returns the lines that had edges, one bit for each role. */
static uint32_t take_edges(struct gpio_thread *reader, struct gpio_edge *edges, uint32_t count)
{
    const uint64_t now = gpio_clock_now_ns(reader);
    uint32_t touched = 0;
    CORE_ASSERT(count <= GPIO_EDGES_MAX);
    for (uint32_t i = 0; i < count; i++) {
        const enum gpio_role role = edges[i].role;
        struct debounce_edge_time turn;
        edges[i].taken_ns = now;
        if (gpio_role_is_input(role) && reader->had & role_bit(role)) {
            touched |= role_bit(role);
            atomic_fetch_add(&reader->edges[role], 1u);
            if (gpio_edge_filter_edge(&reader->inputs[role], &edges[i], &turn)) {
                take_turn(reader, role, turn);
            }
        }
    }
    return touched;
}

/* Reads the level of every line that had edges or whose deadline has passed. The level completes
 * the line's last transition. */
static void settle_inputs(struct gpio_thread *reader, uint32_t touched)
{
    const struct gpio_lines *lines = &reader->lines;
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        const uint64_t now = gpio_clock_now_ns(reader);
        if (!(reader->had & role_bit(role)) ||
            (!(touched & role_bit(role)) && now < input_due_ns(reader, role))) {
            continue;
        }
        const int level = lines->ops->level(lines->self, role);
        struct debounce_edge_time turn;
        if (gpio_role_is_coin(role)) {
            reader->coin_look_ns[role - GPIO_COIN] = now + GPIO_COIN_POLL_NS;
        }
        if (level == HAL_ERR_GONE) {
            lose_lines(reader);
        }
        if (level >= 0 && gpio_edge_filter_level(&reader->inputs[role], now, level != 0, &turn)) {
            take_turn(reader, role, turn);
        }
        if (level >= 0 && gpio_role_is_coin(role)) {
            gpio_coin_settle(&reader->coin[role - GPIO_COIN],
                             gpio_edge_filter_known_ns(&reader->inputs[role], now));
        }
    }
}

static void drive_output(struct gpio_thread *reader, enum gpio_role role)
{
    CORE_ASSERT(role >= GPIO_INPUT_COUNT && role < GPIO_ROLE_COUNT);
    const uint32_t bit = role_bit(role);
    struct pulse_train *train = &reader->trains[role - GPIO_INPUT_COUNT];
    if (!(reader->had & bit)) {
        return; /* Pulses of a missing line are kept until the line is held again. */
    }
    const bool pulses = gpio_pulses_at(train, gpio_clock_now_ns(reader));
    const bool active = pulses || (atomic_load(&reader->wanted) & bit) != 0;
    if (active == ((reader->lit & bit) != 0)) {
        return;
    }
    const int result = reader->lines.ops->set(reader->lines.self, role, active);
    if (result == HAL_OK) {
        reader->lit ^= bit;
    } else if (result == HAL_ERR_GONE) {
        lose_lines(reader);
    }
}

/* Drives all outputs. New pulses are added to `pending` and `owed` before they are removed from
 * `pulses`. A thread that reads `pulses` and then `pending` therefore misses no pulse. */
static void drive_outputs(struct gpio_thread *reader)
{
    uint32_t owed = 0, taken[GPIO_OUTPUT_COUNT];
    for (uint32_t i = 0; i < GPIO_OUTPUT_COUNT; i++) {
        const enum gpio_role role = GPIO_INPUT_COUNT + i;
        struct pulse_train *train = &reader->trains[i];
        taken[i] = atomic_load(&reader->pulses[i]);
        gpio_pulses_add(train, taken[i]);
        drive_output(reader, role);
        atomic_store(&reader->pending[i], train->left + train->on);
        owed += reader->had & role_bit(role) ? train->left + train->on : 0u;
    }
    atomic_store(&reader->owed, owed);
    for (uint32_t i = 0; i < GPIO_OUTPUT_COUNT; i++) {
        atomic_fetch_sub(&reader->pulses[i], taken[i]);
    }
}

static uint32_t wait_ms(const struct gpio_thread *reader)
{
    const uint64_t now = gpio_clock_now_ns(reader);
    uint64_t due_ns = now + GPIO_WAIT_MS_MAX * (uint64_t)NS_PER_MS;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (!(reader->had & role_bit(role))) {
            continue;
        }
        earlier(&due_ns, gpio_role_is_input(role)
                             ? input_due_ns(reader, role)
                             : gpio_pulses_due_ns(&reader->trains[role - GPIO_INPUT_COUNT]));
    }
    return due_ns <= now ? 1u : (uint32_t)((due_ns - now + NS_PER_MS - 1u) / NS_PER_MS);
}

void gpio_thread_step(struct gpio_thread *reader)
{
    struct gpio_edge edges[GPIO_EDGES_MAX];
    CORE_ASSERT((reader->levels & ~reader->had) == 0);
    if (missing_bits(reader) != 0 && gpio_clock_now_ns(reader) >= reader->retry_ns) {
        request_lines(reader);
    }
    const int count =
        reader->lines.ops->wait(reader->lines.self, edges, GPIO_EDGES_MAX, wait_ms(reader));
    if (count == HAL_ERR_GONE) {
        lose_lines(reader);
        publish(reader); /* Publishes the counts before the lines are requested again. */
        request_lines(reader);
    }
    uint32_t touched = take_edges(reader, edges, count > 0 ? (uint32_t)count : 0u);
    if (count < (int)GPIO_EDGES_MAX) { /* If the buffer was full, more edges must be read before the
                                          levels. */
        if (gpio_clock_now_ns(reader) >= reader->watch_ns) {
            reader->watch_ns = gpio_clock_now_ns(reader) + WATCH_NS;
            touched = ~0u;
        }
        settle_inputs(reader, touched);
    }
    drive_outputs(reader);
    publish(reader);
}

/* ---- Open and close ------------------------------------------------------------------------- */

int gpio_thread_open(struct gpio_thread *reader, struct gpio_lines lines,
                     const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock)
{
    CORE_ASSERT(lines.ops && clock.ops);
    memset(reader, 0, sizeof *reader);
    reader->lines = lines;
    reader->clock = clock;
    atomic_store(&reader->wanted, begin_bits());
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
    const int result = request_lines(reader);
    atomic_fetch_add(&reader->faults, (uint32_t)__builtin_popcount(missing_bits(reader)));
    return result;
}

void gpio_thread_close(struct gpio_thread *reader)
{
    const struct gpio_lines *lines = &reader->lines;
    CORE_ASSERT(reader->lines.ops);
    for (enum gpio_role role = GPIO_INPUT_COUNT; role < GPIO_ROLE_COUNT; role++) {
        if (reader->had & role_bit(role)) {
            lines->ops->set(lines->self, role, gpio_role_begins_active(role));
        }
    }
    lines->ops->close(lines->self);
    reader->had = reader->lit = 0;
    pthread_mutex_destroy(&reader->mutex);
}
