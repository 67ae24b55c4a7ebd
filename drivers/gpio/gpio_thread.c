/* gpio_thread.c -- implements the GPIO thread's work from the edges of the lines to the samples of
 * the frame loop: debounces, counts coins, and drives outputs. gpio_device.c requests the lines. */
#include "drivers/gpio/gpio_thread.h"

#include "core/base/panic.h"
#include "drivers/gpio/gpio_config.h"
#include "platform/os/log.h"

/* Interval at which the levels of all input lines are read, in addition to edge events. */
#define WATCH_NS 100000000u
/* If the line of an output does not switch, the change of level is tried again after this time. */
#define SET_RETRY_NS 20000000u

/* ---- Results, which the frame loop reads ---------------------------------------------------- */

static void take_turn(struct gpio_thread *reader, enum gpio_role role,
                      struct debounce_edge_time turn)
{
    CORE_ASSERT(gpio_role_is_input(role) && reader->had & gpio_role_bit(role));
    if (gpio_role_is_coin(role)) {
        gpio_coin_edge(&reader->coin[role - GPIO_COIN], turn.time_ns, turn.active);
        return;
    }
    reader->levels =
        turn.active ? reader->levels | gpio_role_bit(role) : reader->levels & ~gpio_role_bit(role);
    /* `held` is stored before `pressed`, so that a thread that reads the press also reads the
     * level. */
    atomic_store(&reader->held, reader->levels);
    if (turn.active) {
        atomic_fetch_or(&reader->pressed, gpio_role_bit(role));
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
        raw |= input->debounce.raw && (reader->had & gpio_role_bit(i)) ? gpio_role_bit(i) : 0u;
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

int gpio_thread_poll(void *self, struct button_sample *out)
{
    struct gpio_thread *reader = self;
    /* `pressed` is read before `held`, because the GPIO thread stores `held` before `pressed`. */
    const uint32_t pressed = atomic_exchange(&reader->pressed, 0);
    const uint32_t missing = atomic_load(&reader->missing);
    const uint32_t raw = atomic_load(&reader->raw);
    *out = (struct button_sample){
        .pressed = buttons_of(pressed),
        .held = buttons_of(atomic_load(&reader->held)),
        .faults = atomic_exchange(&reader->faults, 0),
        .missing = buttons_of(missing),
    };
    /* The raw level, the edge count and the fault count of every line are for the operator's test
     * page. The lines of a sample are the buttons, followed by the coin lines. */
    for (uint32_t role = 0; role < GPIO_INPUT_COUNT; role++) {
        const uint32_t line = gpio_role_is_coin(role) ? INPUT_BUTTON_COUNT + role - GPIO_COIN
                                                      : (uint32_t)__builtin_ctz(button_of[role]);
        CORE_ASSERT(line < HAL_LINE_COUNT);
        out->raw |= raw & gpio_role_bit(role) ? 1u << line : 0u;
        out->line[line] = (struct line_sample){
            .edges = atomic_exchange(&reader->edges[role], 0),
            .faults = atomic_exchange(&reader->line_faults[role], 0),
        };
    }
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        out->coin_count[line] = atomic_exchange(&reader->coins[line], 0);
        out->missing |= missing & gpio_role_bit(GPIO_COIN + line) ? HAL_MISSING_COIN << line : 0u;
    }
    return HAL_OK;
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
        earlier(&due_ns, reader->coin_poll_ns[line]);
    }
    return due_ns;
}

/* Processes edges of the lines. Returns the lines that had edges, one bit for each role. */
static uint32_t take_edges(struct gpio_thread *reader, struct gpio_edge *edges, uint32_t count)
{
    const uint64_t now = hal_now_ns(reader->clock);
    uint32_t touched = 0;
    CORE_ASSERT(count <= GPIO_EDGES_MAX);
    for (uint32_t i = 0; i < count; i++) {
        const enum gpio_role role = edges[i].role;
        struct debounce_edge_time turn;
        edges[i].taken_ns = now;
        if (gpio_role_is_input(role) && reader->had & gpio_role_bit(role)) {
            touched |= gpio_role_bit(role);
            atomic_fetch_add(&reader->edges[role], 1u);
            if (gpio_edge_filter_edge(&reader->inputs[role], &edges[i], &turn)) {
                take_turn(reader, role, turn);
            }
        }
    }
    return touched;
}

/* Reads the level of every line that had edges or whose deadline has passed. A level that was
 * stable for the debounce period becomes a transition of the line. */
static void settle_inputs(struct gpio_thread *reader, uint32_t touched)
{
    const struct gpio_lines *lines = &reader->lines;
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        const uint64_t now = hal_now_ns(reader->clock);
        if (!(reader->had & gpio_role_bit(role)) ||
            (!(touched & gpio_role_bit(role)) && now < input_due_ns(reader, role))) {
            continue;
        }
        const int level = lines->ops->level(lines->self, role);
        struct debounce_edge_time turn;
        if (gpio_role_is_coin(role)) {
            reader->coin_poll_ns[role - GPIO_COIN] = now + GPIO_COIN_POLL_NS;
        }
        if (level == HAL_ERR_GONE) {
            gpio_thread_lose(reader);
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

/* Sets the level of an output. Returns true if the line switched. A line that does not switch
 * counts as one fault, however often it fails before it switches again. The log and describe() name
 * such a line. */
static bool switch_line(struct gpio_thread *reader, enum gpio_role role, bool active)
{
    const uint32_t bit = gpio_role_bit(role);
    const int result = reader->lines.ops->set(reader->lines.self, role, active);
    if (result == HAL_OK) {
        reader->lit ^= bit;
        if (reader->failing & bit) {
            reader->failing &= ~bit;
            gpio_thread_describe(reader);
        }
        return true;
    }
    if (result == HAL_ERR_GONE) {
        gpio_thread_lose(reader);
    } else if (!(reader->failing & bit)) {
        reader->failing |= bit;
        atomic_fetch_add(&reader->faults, 1);
        gpio_thread_describe(reader);
        log_print(LOG_LEVEL_ERROR, "line %s: %s", gpio_role_name(role), reader->why[role]);
    }
    return false;
}

/* Sets the current level of an output. A pulse begins or ends only when the line has switched. If
 * the line does not switch, the pulse is kept, and the change of level is tried again after
 * SET_RETRY_NS. */
static void drive_output(struct gpio_thread *reader, enum gpio_role role)
{
    CORE_ASSERT(role >= GPIO_INPUT_COUNT && role < GPIO_ROLE_COUNT);
    const uint32_t bit = gpio_role_bit(role);
    struct pulse_train *train = &reader->trains[role - GPIO_INPUT_COUNT];
    if (!(reader->had & bit)) {
        return; /* Pulses of a missing line are kept until the line is held again. */
    }
    struct pulse_train next = *train;
    const uint64_t now_ns = hal_now_ns(reader->clock);
    const bool active = gpio_pulses_at(&next, now_ns) || (atomic_load(&reader->wanted) & bit) != 0;
    if (active == ((reader->lit & bit) != 0) || switch_line(reader, role, active)) {
        *train = next;
    } else if (reader->had & bit) {
        train->until_ns = now_ns + SET_RETRY_NS;
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
        owed += reader->had & gpio_role_bit(role) ? train->left + train->on : 0u;
    }
    atomic_store(&reader->owed, owed);
    for (uint32_t i = 0; i < GPIO_OUTPUT_COUNT; i++) {
        atomic_fetch_sub(&reader->pulses[i], taken[i]);
    }
}

static uint32_t wait_ms(const struct gpio_thread *reader)
{
    const uint64_t now = hal_now_ns(reader->clock);
    uint64_t due_ns = now + GPIO_WAIT_MS_MAX * (uint64_t)NS_PER_MS;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (!(reader->had & gpio_role_bit(role))) {
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
    if (atomic_load(&reader->missing) != 0 && hal_now_ns(reader->clock) >= reader->retry_ns) {
        gpio_thread_request(reader);
    }
    const int count =
        reader->lines.ops->wait(reader->lines.self, edges, GPIO_EDGES_MAX, wait_ms(reader));
    if (count == HAL_ERR_GONE) {
        gpio_thread_lose(reader);
        publish(reader); /* Publishes the counts before the lines are requested again. */
        gpio_thread_request(reader);
    }
    uint32_t touched = take_edges(reader, edges, count > 0 ? (uint32_t)count : 0u);
    if (count < (int)GPIO_EDGES_MAX) { /* If the buffer was full, more edges must be read before the
                                          levels. */
        if (hal_now_ns(reader->clock) >= reader->watch_ns) {
            reader->watch_ns = hal_now_ns(reader->clock) + WATCH_NS;
            touched = ~0u;
        }
        settle_inputs(reader, touched);
    }
    drive_outputs(reader);
    publish(reader);
}
