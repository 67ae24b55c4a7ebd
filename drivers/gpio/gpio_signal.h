/* gpio_signal.h -- processes the signals of single GPIO lines: debouncing, a filter for the edges
 * of the kernel, coin detection, and pulses of an output.
 *
 * All functions are pure: they use no device and no clock. Times are in ns on CLOCK_MONOTONIC, and
 * the caller passes them in non-decreasing order. The GPIO thread (gpio_thread.h) owns the states
 * and calls the functions. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_SIGNAL_H
#define KINGYO_DRIVERS_GPIO_GPIO_SIGNAL_H

#include "drivers/gpio/gpio_lines.h"

/* ---- Debouncing ------------------------------------------------------------------------------
 *
 * A level is accepted after it was stable for the debounce period. The resulting transition has the
 * time at which the level began. The width of a pulse therefore does not depend on when these
 * functions are called. */

struct debounce {
    uint64_t period_ns; /* Debounce period. 0 means that every edge is accepted, because the kernel
                           debounces the line. */
    uint64_t since_ns;  /* Time at which the level `raw` began. */
    bool raw;           /* Level after the last edge, before debouncing. */
    bool stable;        /* Level after debouncing. */
};

/* A debounced transition to the level `active`, with the time at which that level began. */
struct debounce_edge_time {
    uint64_t time_ns;
    bool active;
};

/* Returns the state of a line whose level has been `active` since the time `now_ns`. */
struct debounce gpio_debounce_begin(uint64_t period_ns, bool active, uint64_t now_ns);

/* Processes an edge to the level `active`. The edges must be passed in order of time. Returns true
 * and fills `out` if a transition was completed. */
bool gpio_debounce_edge(struct debounce *debounce, uint64_t time_ns, bool active,
                        struct debounce_edge_time *out);

/* Performs the change of state that is due at `now_ns`. All edges before `now_ns` must have been
 * passed already. Returns true and fills `out` if a transition was completed. */
bool gpio_debounce_settle(struct debounce *debounce, uint64_t now_ns,
                          struct debounce_edge_time *out);

/* Returns the time at which gpio_debounce_settle() must be called, or UINT64_MAX if the state
 * cannot change without an edge. */
uint64_t gpio_debounce_due_ns(const struct debounce *debounce);

/* ---- Edge filter ------------------------------------------------------------------------------
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
 *   stamps are ignored. */

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
    uint32_t lost; /* Number of edges that were lost or arrived too late. The caller may set the
                      number to 0 after reading it. */
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

/* ---- Coins -----------------------------------------------------------------------------------
 *
 * A coin is a pulse whose width is between width_min_ns and width_max_ns. Common acceptors give
 * pulses of 25 to 100 ms +-20 % (DG600F, MEI CashFlow), and some acceptors give pulses of 200 ms. A
 * switch that the coin touches gives pulses of 20 to 100 ms.
 *
 * A shorter pulse is a glitch or a knock. A longer pulse is a stuck coin or manipulation with a
 * wire. Shorter and longer pulses are counted as faults and not as coins. Two pulses that are
 * closer together than COIN_GAP_NS are one pulse of a bouncing contact, so no coin is counted
 * twice. */

/* Shortest pause between two pulses. Acceptors that report a coin's value by several pulses pause
 * for 20 ms or more. */
#define COIN_GAP_NS 10000000u

enum coin_state {
    COIN_IDLE = 0,
    COIN_FALLS, /* A pulse has begun, and the line is active. */
    COIN_FELL,  /* A pulse has ended, less than COIN_GAP_NS ago. */
};

struct coin_mech {
    uint64_t width_min_ns, width_max_ns; /* Shortest and longest width of a coin pulse. A pulse with
                                            exactly one of these widths is a coin too. */
    uint64_t begin_ns, end_ns;           /* Times at which the current pulse started (`begin_ns`)
                                            and ended (`end_ns`). */
    uint8_t state;                       /* State of the current pulse (enum coin_state). */
    bool spoilt;       /* True if the current pulse is not counted as a coin, because its start was
                          not observed. */
    bool sticks;       /* True if the current pulse is too long and was already counted in
                          `stuck`. */
    uint64_t width_ns; /* Width of the last coin's pulse; 0 means no coin yet. */
    uint32_t coins, too_short, stuck; /* Numbers of coins, of too short pulses, and of too long
                                         pulses. The caller may set them to 0 after reading them. */
    uint32_t cut;                     /* Number of pulses whose end was not observed. The caller may
                                         set it to 0 after reading it. */
};

/* Returns the initial state. If `active` is true, a coin already covers the sensor at `now_ns`.
 * This coin is not counted. */
struct coin_mech gpio_coin_begin(uint64_t width_min_ns, uint64_t width_max_ns, bool active,
                                 uint64_t now_ns);

/* Processes a transition of the debounced line to the level `active`. The transitions must be
 * passed in order of time. */
void gpio_coin_edge(struct coin_mech *mech, uint64_t time_ns, bool active);

/* Performs the changes of state that are due at `now_ns`. All transitions before `now_ns` must have
 * been passed already. */
void gpio_coin_settle(struct coin_mech *mech, uint64_t now_ns);

/* Handles the loss of the GPIO line. A pulse that had ended is classified, and an unfinished pulse
 * is counted in `cut`. */
void gpio_coin_lose(struct coin_mech *mech);

/* Returns the time at which gpio_coin_settle() must be called, or UINT64_MAX if the state cannot
 * change without a transition. */
uint64_t gpio_coin_due_ns(const struct coin_mech *mech);

/* Returns the sum of all fault counts. */
static inline uint32_t gpio_coin_faults(const struct coin_mech *mech)
{
    return mech->too_short + mech->stuck + mech->cut;
}

/* ---- Output pulses ---------------------------------------------------------------------------
 *
 * A pulse and the pause after it have at least their nominal length. If the caller is late, a pulse
 * becomes longer, but pulses are never lost or merged. */

struct pulse_train {
    uint64_t on_ns, off_ns; /* Nominal length of a pulse, and of the pause after it. */
    uint64_t until_ns;      /* Time at which the current pulse or pause ends. */
    uint32_t left;          /* Number of pulses that have not started yet. */
    bool on;                /* True during a pulse. */
};

/* Adds `count` pulses. The sum saturates at UINT32_MAX. */
void gpio_pulses_add(struct pulse_train *train, uint32_t count);

/* Returns the level of the output at `now_ns`; true means that a pulse is active. `now_ns` must not
 * decrease. */
bool gpio_pulses_at(struct pulse_train *train, uint64_t now_ns);

/* Returns the time at which the level changes next, or UINT64_MAX if no pulse is left. */
uint64_t gpio_pulses_due_ns(const struct pulse_train *train);

#endif
