/* gpio_edge_filter.h -- filters the edges of one input line with polled levels. Pure.
 *
 * The kernel's time stamp of an edge is accurate, but its direction may be wrong. The interrupt
 * thread reads the level some milliseconds later, after further edges may have passed. Therefore
 * these rules apply:
 *
 * - A null edge is an edge event to the level that the line already had. The line changed and
 *   changed back before the kernel read the level. A null edge only restarts the debounce time.
 * - If the level in between was polled twice before the edge event arrived, the kernel was late.
 *   The event is then the edge to the polled level, so a coin pulse that ended before the kernel
 *   read the level still counts.
 * - Two null edges without a polled level in between never count as a pulse. A late kernel with
 *   a coin, and two glitches of a relay or a lighter, cannot be distinguished if the reader did
 *   not run meanwhile. Such pairs are counted as doubtful.
 * - If the level differs from the edges for longer than an edge event can be delayed, edges were
 *   lost and the level is taken. Edges with earlier time stamps are then ignored. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_EDGE_FILTER_H
#define KINGYO_DRIVERS_GPIO_GPIO_EDGE_FILTER_H

#include "drivers/gpio/debounce.h"
#include "drivers/gpio/gpio_lines.h"

/* Longest delay of an edge event; three times the observed 6 ms. */
#define GPIO_UNDER_WAY_NS 20000000u
/* Polling span that proves a stable level: longer than a glitch, and shorter than
 * GPIO_COIN_POLL_NS. */
#define GPIO_PROOF_NS 4000000u
/* Longest time from receiving a null edge to the time stamp of the masked edge after it. */
#define GPIO_PAIR_NS 2000000u

/* Consecutive polls whose level differs from the edges, by the time before each poll.
 * UINT64_MAX: none. */
struct gpio_poll_edges {
    uint64_t since_ns, last_ns; /* First and last poll with the other level. */
    uint64_t back_ns;           /* First later poll with the expected level. */
};

struct gpio_edge_filter {
    struct debounce debounce;
    /* Time stamp of the last edge if it was a null edge at rest, otherwise UINT64_MAX. */
    uint64_t blinked_ns;
    uint64_t told_ns; /* Time at which the edge `blinked_ns` was received. */
    /* Edges up to this time are ignored, because a polled level replaced them. */
    uint64_t believed_ns;
    struct gpio_poll_edges other;
    uint32_t blinks; /* Null edges since the start. */
    uint32_t late;   /* Late edges corrected by a polled level, since the start. */
    /* Pairs of null edges, either two glitches or a missed pulse, since the start. */
    uint32_t doubtful;
    uint32_t lost; /* Edges lost or too late, since the start. */
};

/* Returns the state of a line that has been at `active` since `now_ns`. */
struct gpio_edge_filter gpio_edge_filter_begin(uint64_t debounce_ns, bool active, uint64_t now_ns);

/* Processes an edge of this line; edges must come in order of time. Returns true if a debounced
 * transition results. */
bool gpio_edge_filter_edge(struct gpio_edge_filter *input, const struct gpio_edge *edge,
                           struct debounce_edge_time *out);

/* Processes the level read at `now_ns`, after all available edges. Returns true if a debounced
 * transition results. */
bool gpio_edge_filter_level(struct gpio_edge_filter *input, uint64_t now_ns, bool active,
                            struct debounce_edge_time *out);

/* Returns when the level should be read next, or UINT64_MAX if there is no deadline. */
uint64_t gpio_edge_filter_due_ns(const struct gpio_edge_filter *input);

/* Returns the time before which all transitions of this line are known. A level that is still
 * being debounced is not known yet. */
uint64_t gpio_edge_filter_known_ns(const struct gpio_edge_filter *input, uint64_t now_ns);

#endif
