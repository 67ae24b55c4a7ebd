/* gpio_input.h -- what to believe of one input line: its edges, and its level looked at now and
 * then. Pure.
 *
 * The kernel says the time of an edge well, and its direction less well: its thread reads the level
 * when it comes round to it, and of edges a few milliseconds apart that was the next one's. So
 *  - an edge that changes nothing, a blink, tells of a level that came and went before the kernel
 *    looked: the line was not at rest, that is all;
 *  - where that level was read between, twice, before the edge dated ahead of it was told, the
 *    kernel was late by that much and the edge is the one to that level: a coin's pulse that was
 *    over before the kernel looked is a pulse;
 *  - two blinks that nobody saw a level between are never a pulse: a kernel that was late by a
 *    whole coin and two sparks of a relay, or of a lighter held to the slot, look alike to a reader
 *    that was not run meanwhile. They are counted as doubtful, for the operator;
 *  - where the level disagrees with the edges for longer than an edge can be under way, edges were
 *    lost, and the level is right; what is dated before that and comes after it is old news. */
#ifndef KINGYO_DRIVERS_GPIO_INPUT_H
#define KINGYO_DRIVERS_GPIO_INPUT_H

#include "drivers/debounce.h"
#include "drivers/gpio_lines.h"

#define GPIO_UNDER_WAY_NS 20000000u /* Three times the 6 ms at which edges were seen late. */
#define GPIO_PROOF_NS 4000000u /* Between two looks, less than GPIO_COIN_LOOK_NS: no spark lasts. */
#define GPIO_PAIR_NS 2000000u  /* From the telling of a blink to the date of its masked next one. */

/* Looks in a row that found another level than the edges say, by the times before each of them;
 * UINT64_MAX: none. */
struct gpio_looks {
    uint64_t since_ns, last_ns; /* The first and the last of them ... */
    uint64_t back_ns;           /* ... and the one behind them that found it as the edges say. */
};

struct gpio_input {
    struct debounce debounce;
    uint64_t blinked_ns;  /* The last edge, where it was a blink out of rest; else UINT64_MAX. */
    uint64_t told_ns;     /* When that was taken. */
    uint64_t believed_ns; /* Up to when the level was believed against the edges. */
    struct gpio_looks other;
    uint32_t blinks;      /* Edges that changed nothing, */
    uint32_t late;        /* edges that a level read before they were told put right, */
    uint32_t doubtful;    /* pairs of blinks: two sparks, or a pulse that nobody saw, */
    uint32_t lost;        /* and edges that came too late, or never. Since the start. */
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
