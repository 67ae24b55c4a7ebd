/* edges.c -- fuzz target: arbitrary edges and levels of an input line, which may contradict each
 * other. The edge filter (gpio_edge_filter.h) must return alternating changes in the order of time.
 * If the line stays constant, the filter must accept its level.
 *
 * The input begins with two bytes: the debounce period in 0.1 ms, and the first level. Two bytes
 * follow for each step, the low byte first. Their bits, from the lowest, are 12 bits of time in
 * units of 50 us, three bits for the kind of step, and the level. The kinds are an edge (0 and 1),
 * an edge with an older time stamp (2), an edge after lost edges (3), and a level that was read (4
 * to 7). */
#include "drivers/gpio/gpio_thread.h"
#include "tests/fuzz/trap.h"

#define TIME_NS 50000u

static struct debounce_edge_time last;
static uint64_t dated_ns; /* Time stamp of the newest edge that the filter received. */

static void take(bool turned, const struct debounce_edge_time *turn)
{
    if (turned) {
        HOLD(turn->active != last.active && turn->time_ns >= last.time_ns);
        last = *turn;
    }
}

static void step(struct gpio_edge_filter *input, uint64_t now_ns, uint32_t what, bool active)
{
    struct debounce_edge_time turn;
    if (what >= 4u) {
        take(gpio_edge_filter_level(input, now_ns, active, &turn), &turn);
        return;
    }
    dated_ns = what < 2u ? now_ns : dated_ns + (now_ns - dated_ns) / 8u;
    const struct gpio_edge edge = {
        .time_ns = dated_ns,
        .active = active,
        .lost_before = what == 3u ? 2u : 0u,
        .taken_ns = now_ns,
    };
    take(gpio_edge_filter_edge(input, &edge, &turn), &turn);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    uint64_t now_ns = 1000000000u;
    if (size < 2u) {
        return 0;
    }
    dated_ns = now_ns;
    last = (struct debounce_edge_time){ .time_ns = now_ns, .active = bytes[1] & 1u };
    struct gpio_edge_filter input =
        gpio_edge_filter_begin(bytes[0] * 100000ull, last.active, now_ns);
    for (size_t at = 2; at + 1u < size; at += 2) {
        const uint32_t word = (uint32_t)(bytes[at] | bytes[at + 1u] << 8);
        now_ns += (word & 0xfffu) * TIME_NS;
        step(&input, now_ns, word >> 12 & 7u, word >> 15 != 0);
    }
    /* From here on the line is constant. After several polls the filter must have accepted the
     * level of the line, whatever edges came before. */
    for (uint32_t i = 0; i < 4u; i++) {
        now_ns += 100000000u;
        step(&input, now_ns, 4u, true);
    }
    HOLD(last.active && input.debounce.stable && gpio_edge_filter_due_ns(&input) == UINT64_MAX);
    return 0;
}
