/* gpio_input.h -- what to believe of one input line: its edges, and its level looked at now and
 * then. Pure.
 *
 * The kernel says the time of an edge well, and its direction badly: it reads the level only when
 * its thread comes round, and edges a few milliseconds apart were then seen with the wrong one. So
 * an edge is taken as a turn away from where the line was, whatever it says, unless edges are known
 * to be lost before it; and where the level disagrees with that for longer than an edge can be
 * under way, the level is right. */
#ifndef KINGYO_DRIVERS_GPIO_INPUT_H
#define KINGYO_DRIVERS_GPIO_INPUT_H

#include "drivers/debounce.h"
#include "drivers/gpio_lines.h"

#define GPIO_UNDER_WAY_NS 20000000u /* Three times the 6 ms at which edges were seen mistaken. */

struct gpio_input {
    struct debounce debounce;
    uint64_t mended_ns;    /* When the level was last believed against the edges. */
    uint64_t disagrees_ns; /* Since when it says something else; UINT64_MAX: it does not. */
    uint32_t turned;       /* Edges that were believed against their direction ... */
    uint32_t lost;         /* ... and edges that never came. Since the start. */
};

struct gpio_input gpio_input_begin(uint64_t debounce_ns, bool active, uint64_t now_ns);

/* An edge of this line, in the order of their times. True: a turn that counts. */
bool gpio_input_edge(struct gpio_input *input, const struct gpio_edge *edge,
                     struct debounce_turn *out);

/* The line's level, read at `now_ns` after every edge that had come was taken. True: a turn. */
bool gpio_input_level(struct gpio_input *input, uint64_t now_ns, bool active,
                      struct debounce_turn *out);

/* When the level should be read next; UINT64_MAX: whenever it is convenient. */
uint64_t gpio_input_due_ns(const struct gpio_input *input);

#endif
