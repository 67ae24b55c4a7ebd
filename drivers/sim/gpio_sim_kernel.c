/* gpio_sim_kernel.c -- models the wires, the kernel's delayed interrupt thread, and the queues of
 * edges. */
#include "drivers/sim/gpio_sim_kernel.h"

#include <assert.h>
#include <string.h>

#define NEVER UINT64_MAX

/* Returns a random delay from late_min_ns to late_max_ns by the xorshift32 generator. */
static uint64_t lateness_ns(struct gpio_lines_sim *sim)
{
    sim->seed ^= sim->seed << 13;
    sim->seed ^= sim->seed >> 17;
    sim->seed ^= sim->seed << 5;
    const uint64_t range_ns = sim->late_max_ns - sim->late_min_ns + 1u;
    return sim->late_min_ns + sim->seed % range_ns;
}

static void gpio_sim_kernel_push(struct gpio_lines_sim *sim, struct gpio_sim_line *line)
{
    line->number++;
    if (line->count == sim->queue_size) {
        sim->dropped++;
        if (!sim->is_numbered) {
            return;
        }
        line->first++; /* The second version of the kernel's interface drops the oldest edge. */
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
    gpio_sim_kernel_push(sim, line);
    line->busy_until_ns = 0;
    if (line->pending) { /* The edge that arrived while the kernel served this edge is served next.
                            Its time stamp is the current time. */
        line->pending = 0;
        line->stamp_ns = time_ns;
        line->busy_until_ns = time_ns + lateness_ns(sim);
    }
}

static void move_wire(struct gpio_lines_sim *sim, const struct gpio_sim_event *event)
{
    struct gpio_sim_line *line = &sim->lines[event->role];
    const bool is_spark = event->what == GPIO_SIM_SPARK;
    const bool is_edge = is_spark || line->level != event->active;
    line->level = is_spark ? line->level : event->active;
    if (!is_edge || !(sim->held & 1u << event->role)) {
        return;
    }
    if (line->busy_until_ns) {
        line->pending = 1;
        return;
    }
    line->stamp_ns = event->time_ns;
    line->busy_until_ns = event->time_ns + lateness_ns(sim);
}

static void pull_chip(struct gpio_lines_sim *sim)
{
    sim->chip_is_away = true;
    sim->went |= sim->held != 0;
    for (uint32_t i = 0; i < GPIO_INPUT_COUNT; i++) {
        const uint8_t level = sim->lines[i].level;
        sim->lines[i] = (struct gpio_sim_line){ .level = level };
    }
    memset(sim->outputs, 0, sizeof sim->outputs);
    sim->held = 0;
}

static void happen(struct gpio_lines_sim *sim, const struct gpio_sim_event *event)
{
    switch (event->what) {
    case GPIO_SIM_GONE:
        pull_chip(sim);
        break;
    case GPIO_SIM_BACK:
        sim->chip_is_away = false;
        break;
    default:
        assert(event->role < GPIO_INPUT_COUNT);
        move_wire(sim, event);
    }
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

bool gpio_sim_advance(struct gpio_lines_sim *sim, uint64_t until_ns)
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
        serve(sim, line);
    } else {
        const struct gpio_sim_event event = sim->next_event;
        sim->has_next = sim->script.next(sim->script.self, &sim->next_event);
        happen(sim, &event);
    }
    return true;
}
