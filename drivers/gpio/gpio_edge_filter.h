/* gpio_edge_filter.h -- filters the edges of one input line with the help of polled levels.
 *
 * The kernel's time stamp of an edge is accurate, but its direction may be wrong. The kernel's
 * interrupt thread reads the level some milliseconds after the interrupt, and further edges may
 * have passed meanwhile. Therefore these rules apply:
 *
 * - A null edge is an edge event whose level equals the level before the event. The line changed
 *   and changed back before the kernel read the level. A null edge only restarts the debounce
 *   period.
 * - If two polls read the opposite level before a null edge arrived, the kernel read the level too
 *   late. The null edge is then treated as the edge to the polled level. A coin pulse that ended
 *   before the kernel read the level is therefore still counted.
 * - Two null edges without a polled level between them are never counted as a pulse. The pair may
 *   be a coin pulse that the kernel read too late, or two glitches from a relay or a lighter. The
 *   pair is counted as doubtful.
 * - If the polled level differs from the level after the last edge for longer than an edge event
 *   can be delayed, edges were lost. The polled level is then accepted, and edges with earlier time
 *   stamps are ignored.
 *
 * Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_EDGE_FILTER_H
#define KINGYO_DRIVERS_GPIO_GPIO_EDGE_FILTER_H

#include "drivers/gpio/debounce.h"
#include "drivers/gpio/gpio_lines.h"

/* Longest expected delay of an edge event: three times the observed delay of 6 ms, rounded up to
 * 20 ms. */
#define GPIO_UNDER_WAY_NS 20000000u
/* Two polls that read equal levels prove a stable level if at least this time lies between them.
 * The time is longer than a glitch and shorter than GPIO_COIN_POLL_NS. */
#define GPIO_PROOF_NS 4000000u
/* Largest time from the arrival of one null edge to the time stamp of the next null edge. If the
 * time is longer, the two null edges cannot belong to one pulse. */
#define GPIO_PAIR_NS 2000000u

/* Times of consecutive polls that read another level than the level after the last edge. Each time
 * is taken just before the poll. UINT64_MAX means that there was no poll. */
struct gpio_poll_edges {
    uint64_t since_ns, last_ns; /* Times of the first (`since_ns`) and of the last poll (`last_ns`)
                                   that did not read the level after the last edge. */
    uint64_t back_ns;           /* Time of the first poll after `last_ns` whose level equals the
                                   level after the last edge. */
};

struct gpio_edge_filter {
    struct debounce debounce;
    /* Time stamp of the last edge if that edge was a null edge on an idle line, otherwise
     * UINT64_MAX. */
    uint64_t blinked_ns;
    uint64_t told_ns; /* Time at which the GPIO thread received the last null edge. */
    /* Edges up to this time are ignored, because a polled level replaced them. */
    uint64_t believed_ns;
    struct gpio_poll_edges other; /* Polls whose level differs from the level after the last
                                     edge. */
    uint32_t blinks; /* Number of null edges (edge events without a change of the level) since
                        gpio_edge_filter_begin(). */
    uint32_t late;   /* Number of edges whose wrong direction was corrected by a polled level, since
                        gpio_edge_filter_begin(). */
    /* Number of pairs of null edges that are either two glitches or a missed pulse. The caller may
     * set it to 0 after reading it. */
    uint32_t doubtful;
    uint32_t lost; /* Number of edges that were lost or arrived too late. The caller may set it to 0
                      after reading it. */
};

/* Returns the state of a line whose level has been `active` since the time `now_ns`. */
struct gpio_edge_filter gpio_edge_filter_begin(uint64_t debounce_ns, bool active, uint64_t now_ns);

/* Processes an edge of the filtered line. The edges must be passed in order of time. Returns true
 * and fills `out` if the edge completes a debounced transition. */
bool gpio_edge_filter_edge(struct gpio_edge_filter *input, const struct gpio_edge *edge,
                           struct debounce_edge_time *out);

/* Processes the level that was read at `now_ns`, after all available edges were passed. Returns
 * true and fills `out` if the level completes a debounced transition. */
bool gpio_edge_filter_level(struct gpio_edge_filter *input, uint64_t now_ns, bool active,
                            struct debounce_edge_time *out);

/* Returns the time at which the level should be read next, or UINT64_MAX if there is no
 * deadline. */
uint64_t gpio_edge_filter_due_ns(const struct gpio_edge_filter *input);

/* Returns the time before which all transitions of the line are known. A level that is still being
 * debounced counts as unknown. */
uint64_t gpio_edge_filter_known_ns(const struct gpio_edge_filter *input, uint64_t now_ns);

#endif
