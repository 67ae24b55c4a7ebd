/* device_edges.c -- any edges and levels of an input line, true or not: turns that alternate, in
 * the order of their times, and a line that stands still is believed in the end.
 *
 * Input: the debounce period in 0.1 ms and the first level; then two bytes a step, low first: 12
 * bits of time in 50 us, three that say what comes (an edge, one that is told late, one behind lost
 * ones, a level), and the level that it claims. */
#include "drivers/gpio_input.h"
#include "tests/fuzz/trap.h"

#define TIME_NS 50000u

static struct debounce_turn last;
static uint64_t dated_ns; /* The newest edge. */

static void take(bool turned, const struct debounce_turn *turn)
{
    if (turned) {
        HOLD(turn->active != last.active && turn->time_ns >= last.time_ns);
        last = *turn;
    }
}

static void step(struct gpio_input *input, uint64_t now_ns, uint32_t what, bool active)
{
    struct debounce_turn turn;
    if (what >= 4u) {
        take(gpio_input_level(input, now_ns, active, &turn), &turn);
        return;
    }
    dated_ns = what < 2u ? now_ns : dated_ns + (now_ns - dated_ns) / 8u;
    const struct gpio_edge edge = {
        .time_ns = dated_ns, .active = active, .lost_before = what == 3u ? 2u : 0u,
        .taken_ns = now_ns,
    };
    take(gpio_input_edge(input, &edge, &turn), &turn);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    uint64_t now_ns = 1000000000u;
    if (size < 2u) {
        return 0;
    }
    dated_ns = now_ns;
    last = (struct debounce_turn){ .time_ns = now_ns, .active = bytes[1] & 1u };
    struct gpio_input input = gpio_input_begin(bytes[0] * 100000ull, last.active, now_ns);
    for (size_t at = 2; at + 1u < size; at += 2) {
        const uint32_t word = (uint32_t)(bytes[at] | bytes[at + 1u] << 8);
        now_ns += (word & 0xfffu) * TIME_NS;
        step(&input, now_ns, word >> 12 & 7u, word >> 15 != 0);
    }
    /* The line now stands, whatever its edges have said: asked often enough, it is believed. */
    for (uint32_t i = 0; i < 4u; i++) {
        now_ns += 100000000u;
        step(&input, now_ns, 4u, true);
    }
    HOLD(last.active && input.debounce.stable && gpio_input_due_ns(&input) == UINT64_MAX);
    return 0;
}
