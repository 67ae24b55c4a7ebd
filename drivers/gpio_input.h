/* gpio_input.h -- what to believe of one input line: its edges, and its level looked at now and
 * then. Pure.
 *
 * The kernel says the time of an edge well, and its direction less well: its thread reads the level
 * when it comes round to it, and of edges a few milliseconds apart that was the next one's. So
 *  - an edge that changes nothing, a blink, tells of a level that came and went before the kernel
 *    looked: the line was not at rest, that is all;
 *  - two blinks of a line that rested (no bounce, no late end of one) are a pulse if the second
 *    is dated before anybody could see the first: the kernel was late by the whole pulse. Otherwise
 *    they are no more than two, or else the sparks of a relay, or of a lighter held to the slot,
 *    would be coins;
 *  - where the level disagrees with the edges for longer than an edge can be under way, edges were
 *    lost, and the level is right. */
#ifndef KINGYO_DRIVERS_GPIO_INPUT_H
#define KINGYO_DRIVERS_GPIO_INPUT_H

#include "drivers/debounce.h"
#include "drivers/gpio_lines.h"

#define GPIO_UNDER_WAY_NS 20000000u /* Three times the 6 ms at which edges were seen late. */
#define GPIO_PAIR_NS 2000000u /* From the kernel's telling of a blink to its next edge's date. */

struct gpio_input {
    struct debounce debounce;
    uint64_t blinked_ns; /* The last edge, where it was a blink out of rest; else UINT64_MAX. */
    uint64_t seen_ns;    /* When that was taken. */
    uint64_t doubted_ns; /* Since when the level is not what the edges say; UINT64_MAX: it is. */
    uint32_t blinks;     /* Edges that changed nothing, */
    uint32_t pairs;      /* pulses that were made of two of them, */
    uint32_t lost;       /* and edges that never came. Since the start. */
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

/* Up to when every turn of this line is known at `now_ns`: what still has to stand is not. */
uint64_t gpio_input_known_ns(const struct gpio_input *input, uint64_t now_ns);

#endif
