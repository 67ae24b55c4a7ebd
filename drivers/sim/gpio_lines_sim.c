/* gpio_lines_sim.c -- models the wires, the kernel's delayed interrupt thread, the queues of edges,
 * the GPIO backend and its clock. */
#include "drivers/sim/gpio_lines_sim.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

#define NEVER UINT64_MAX

/* ---- Model of the kernel --------------------------------------------------------------------- */

/* Returns a random delay from late_min_ns to late_max_ns by the xorshift32 generator. */
static uint64_t lateness_ns(struct gpio_lines_sim *sim)
{
    sim->seed ^= sim->seed << 13;
    sim->seed ^= sim->seed >> 17;
    sim->seed ^= sim->seed << 5;
    CORE_ASSERT(sim->late_min_ns <= sim->late_max_ns);
    const uint64_t range_ns = sim->late_max_ns - sim->late_min_ns + 1u;
    return sim->late_min_ns + sim->seed % range_ns;
}

static void queue_edge(struct gpio_lines_sim *sim, struct gpio_sim_line *line)
{
    CORE_ASSERT(sim->queue_size <= GPIO_SIM_QUEUE_MAX && line->count <= sim->queue_size);
    line->number++;
    if (line->count == sim->queue_size) {
        sim->dropped++;
        if (!sim->is_numbered) {
            return;
        }
        /* The second version of the kernel's GPIO interface drops the oldest edge when the queue is
         * full, to make room for the new edge. */
        line->first++;
        line->count--;
    }
    const uint32_t at = (line->first + line->count++) % GPIO_SIM_QUEUE_MAX;
    line->queue[at].time_ns = line->stamp_ns;
    line->queue[at].number = line->number;
    line->queue[at].active = line->level;
}

/* Runs the kernel's interrupt thread for a line: the thread reads the current level and queues an
 * edge. */
static void serve(struct gpio_lines_sim *sim, struct gpio_sim_line *line)
{
    const uint64_t time_ns = line->busy_until_ns;
    CORE_ASSERT(time_ns > 0);
    queue_edge(sim, line);
    line->busy_until_ns = 0;
    /* Another edge arrived while the kernel served this edge. The kernel now serves the other edge
     * and gives it the current time as its time stamp. */
    if (line->pending) {
        line->pending = false;
        line->stamp_ns = time_ns;
        line->busy_until_ns = time_ns + lateness_ns(sim);
    }
}

static void move_wire(struct gpio_lines_sim *sim, const struct gpio_sim_event *event)
{
    CORE_ASSERT(event->what <= GPIO_SIM_SPARK && event->role < GPIO_INPUT_COUNT);
    struct gpio_sim_line *line = &sim->lines[event->role];
    const bool is_spark = event->what == GPIO_SIM_SPARK;
    const bool is_edge = is_spark || line->level != event->active;
    line->level = is_spark ? line->level : event->active;
    if (!is_edge || !(sim->held & 1u << event->role)) {
        return;
    }
    if (line->busy_until_ns) {
        line->pending = true;
        return;
    }
    line->stamp_ns = event->time_ns;
    line->busy_until_ns = event->time_ns + lateness_ns(sim);
}

static void pull_chip(struct gpio_lines_sim *sim)
{
    CORE_ASSERT(!sim->chip_is_away);
    sim->chip_is_away = true;
    sim->went |= sim->held != 0;
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        const uint8_t level = sim->lines[i].level;
        sim->lines[i] = (struct gpio_sim_line){ .level = level };
    }
    memset(sim->outputs, 0, sizeof sim->outputs);
    sim->held = 0;
}

/* Returns the line that the kernel serves next, or null if the kernel is idle. */
static struct gpio_sim_line *next_served(struct gpio_lines_sim *sim)
{
    struct gpio_sim_line *first = NULL;
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        struct gpio_sim_line *line = &sim->lines[i];
        if (line->busy_until_ns && (!first || line->busy_until_ns < first->busy_until_ns)) {
            first = line;
        }
    }
    return first;
}

/* Executes the next event of the script or of the kernel if its time is at most `until_ns`. Returns
 * true if an event was executed, otherwise false. */
static bool advance(struct gpio_lines_sim *sim, uint64_t until_ns)
{
    struct gpio_sim_line *line = next_served(sim);
    const uint64_t served_ns = line ? line->busy_until_ns : NEVER;
    const uint64_t event_ns = sim->has_next ? sim->next_event.time_ns : NEVER;
    const uint64_t time_ns = served_ns <= event_ns ? served_ns : event_ns;
    if (time_ns > until_ns) {
        return false;
    }
    sim->now_ns = time_ns > sim->now_ns ? time_ns : sim->now_ns;
    if (served_ns <= event_ns) {
        CORE_ASSERT(line);
        serve(sim, line);
    } else {
        const struct gpio_sim_event event = sim->next_event;
        sim->has_next = sim->script.next(sim->script.self, &sim->next_event);
        switch (event.what) {
        case GPIO_SIM_GONE:
            pull_chip(sim);
            break;
        case GPIO_SIM_BACK:
            sim->chip_is_away = false;
            break;
        default:
            move_wire(sim, &event);
        }
    }
    return true;
}

/* ---- Simulated time ------------------------------------------------------------------------- */

void gpio_lines_sim_pass(struct gpio_lines_sim *sim, uint64_t ns)
{
    const uint64_t until_ns = sim->now_ns + ns;
    while (advance(sim, until_ns)) {
    }
    sim->now_ns = until_ns;
}

static bool has_queued_edges(const struct gpio_lines_sim *sim)
{
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        if (sim->lines[i].count > 0) {
            return true;
        }
    }
    return false;
}

/* ---- Operations of the GPIO backend --------------------------------------------------------- */

static void open_line(struct gpio_lines_sim *sim, const struct gpio_wire *wire, enum gpio_role role,
                      char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(role < GPIO_ROLE_COUNT && !(sim->held & 1u << role));
    if (sim->chip_is_away) {
        snprintf(why, HAL_TEXT_SIZE, "%u: the chip is away", role);
    } else if (sim->held_by_others & 1u << role) {
        snprintf(why, HAL_TEXT_SIZE, "%u is in use by 'another'", role);
    } else {
        sim->held |= 1u << role;
        sim->outputs[role] = gpio_role_begins_active(role);
        sim->rests[role] = (wire->bias == GPIO_BIAS_UP) != (wire->active_low);
    }
    if (gpio_role_is_input(role)) {
        sim->lines[role].last = sim->lines[role].level;
    }
}

static int sim_open(void *self, const struct gpio_wire wires[GPIO_ROLE_COUNT],
                    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE])
{
    struct gpio_lines_sim *sim = self;
    sim->open_count++;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        why[role][0] = '\0';
        if (wires[role].wired && !(sim->held & 1u << role)) {
            open_line(sim, &wires[role], role, why[role]);
        }
    }
    return sim->chip_is_away ? HAL_ERR_ABSENT : (int)sim->held;
}

static struct gpio_edge take_edge(struct gpio_lines_sim *sim, enum gpio_role role, bool was_full)
{
    struct gpio_sim_line *line = &sim->lines[role];
    CORE_ASSERT(line->count > 0);
    const uint32_t at = line->first++ % GPIO_SIM_QUEUE_MAX;
    line->count--;
    const uint32_t number = line->queue[at].number;
    const bool active = line->queue[at].active;
    const struct gpio_edge edge = {
        .time_ns = line->queue[at].time_ns,
        .role = (uint8_t)role,
        .active = active,
        .lost_before = sim->is_numbered ? number - line->seen - 1u
                                        : (uint32_t)(was_full && active == line->last),
    };
    line->seen = number;
    line->last = active;
    return edge;
}

/* Takes up to `max` edges from the queue of a line. A full queue drops edges. If the previous call
 * found a full queue, take_edge() therefore checks whether edges were lost before the first
 * edge. */
static uint32_t take_all(struct gpio_lines_sim *sim, enum gpio_role role, struct gpio_edge *out,
                         uint32_t max)
{
    CORE_ASSERT(role < GPIO_INPUT_COUNT && sim->lines[role].count <= sim->queue_size);
    struct gpio_sim_line *line = &sim->lines[role];
    const bool is_full = line->count == sim->queue_size;
    uint32_t count = 0;
    while (line->count > 0 && count < max) {
        out[count] = take_edge(sim, role, line->was_full && count == 0);
        count++;
    }
    if (count > 0) {
        line->was_full = is_full;
    }
    return count;
}

static int sim_wait(void *self, struct gpio_edge *out, uint32_t max, uint32_t timeout_ms)
{
    struct gpio_lines_sim *sim = self;
    const uint64_t until_ns = sim->now_ns + timeout_ms * (uint64_t)NS_PER_MS;
    while (!sim->went && !has_queued_edges(sim) && advance(sim, until_ns)) {
    }
    if (sim->went) {
        sim->went = false;
        return HAL_ERR_GONE;
    }
    uint32_t count = 0;
    for (enum gpio_role role = 0; role < GPIO_INPUT_COUNT; role++) {
        count += take_all(sim, role, out + count, max - count);
    }
    CORE_ASSERT(count <= max && sim->now_ns <= until_ns);
    if (count == 0) {
        sim->now_ns = until_ns;
    }
    return (int)count;
}

static int sim_level(void *self, enum gpio_role role)
{
    const struct gpio_lines_sim *sim = self;
    CORE_ASSERT(role < GPIO_ROLE_COUNT);
    if (!(sim->held & 1u << role)) {
        return HAL_ERR_GONE;
    }
    return gpio_role_is_input(role) ? sim->lines[role].level : sim->outputs[role];
}

static int sim_set(void *self, enum gpio_role role, bool active)
{
    struct gpio_lines_sim *sim = self;
    CORE_ASSERT(!gpio_role_is_input(role));
    if (!(sim->held & 1u << role)) {
        return HAL_ERR_GONE;
    }
    if (sim->failing_outputs & 1u << role) {
        return HAL_ERR_IO;
    }
    sim->outputs[role] = active;
    sim->sets[sim->set_count++ % GPIO_SIM_SETS_MAX] = (struct gpio_sim_set){
        .time_ns = sim->now_ns,
        .role = (uint8_t)role,
        .active = active,
    };
    return HAL_OK;
}

static bool sim_debounces(void *self, enum gpio_role role)
{
    const struct gpio_lines_sim *sim = self;
    (void)role;
    return sim->kernel_debounces;
}

static int sim_list(void *self, void (*report)(void *context, const struct gpio_line_info *line),
                    void *context)
{
    const struct gpio_lines_sim *sim = self;
    CORE_ASSERT(report);
    for (uint32_t i = 0; i < GPIO_ROLE_COUNT; i++) {
        struct gpio_line_info info = {
            .device = "gpiochip0",
            .chip = "memory",
            .offset = i,
            .used = (sim->held | sim->held_by_others) >> i & 1u,
            .is_output = !gpio_role_is_input(i),
        };
        snprintf(info.consumer, sizeof info.consumer, "%s",
                 sim->held_by_others & 1u << i ? "another"
                 : sim->held & 1u << i         ? "kingyo"
                                               : "");
        report(context, &info);
    }
    return GPIO_ROLE_COUNT;
}

static void sim_close(void *self)
{
    struct gpio_lines_sim *sim = self;
    /* Released outputs become inputs, as on most GPIO chips. */
    memcpy(sim->outputs, sim->rests, sizeof sim->outputs);
    sim->held = 0;
}

static const char *sim_describe(void *self)
{
    (void)self;
    return "lines of memory";
}

struct gpio_lines gpio_lines_sim_device(struct gpio_lines_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct gpio_lines_ops ops = {
        .open = sim_open,
        .wait = sim_wait,
        .level = sim_level,
        .set = sim_set,
        .debounces = sim_debounces,
        .list = sim_list,
        .close = sim_close,
        .describe = sim_describe,
    };
    return (struct gpio_lines){ .ops = &ops, .self = sim };
}

static uint64_t gpio_lines_sim_now_ns(void *self)
{
    const struct gpio_lines_sim *sim = self;
    return sim->now_ns;
}

struct hal_clock gpio_lines_sim_clock(struct gpio_lines_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_clock_ops ops = { .now_ns = gpio_lines_sim_now_ns };
    return (struct hal_clock){ .ops = &ops, .self = sim };
}

/* ---- Scripts of events ---------------------------------------------------------------------- */

static bool next_of_events(void *self, struct gpio_sim_event *out)
{
    struct gpio_sim_events *events = self;
    CORE_ASSERT(events->next <= events->count);
    if (events->next == events->count) {
        return false;
    }
    *out = events->events[events->next++];
    return true;
}

struct gpio_sim_script gpio_lines_sim_events_script(struct gpio_sim_events *events)
{
    CORE_ASSERT(events && (events->events || events->count == 0));
    return (struct gpio_sim_script){ .next = next_of_events, .self = events };
}

void gpio_lines_sim_init(struct gpio_lines_sim *sim, struct gpio_sim_script script, uint32_t seed)
{
    CORE_ASSERT(sim);
    memset(sim, 0, sizeof *sim);
    sim->queue_size = GPIO_SIM_QUEUE_MAX;
    sim->is_numbered = true;
    /* The seed must not be 0, because an xorshift generator with the state 0 would always return
     * 0. */
    sim->seed = seed ? seed : 1u;
    sim->script = script;
    sim->now_ns = 1u; /* The time starts at 1, because a busy_until_ns of 0 means that the kernel is
                         idle. */
    sim->has_next = script.next && script.next(script.self, &sim->next_event);
}
