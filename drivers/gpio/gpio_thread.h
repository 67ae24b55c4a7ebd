/* gpio_thread.h -- the GPIO thread, which reads all input lines and drives all output lines: the
 * cabinet's buttons, coin acceptors, lamps, coin meter and ticket dispenser.
 *
 * No other thread uses the lines. The results are kept in atomic counters until the frame loop
 * reads them, so no coin is lost while the frame loop stalls for a second. Commands of the frame
 * loop use atomic variables too. Lines that could not be requested, and lines of a removed chip,
 * are requested again once a second.
 *
 * The first part of this header processes the signals of single lines: debouncing, a filter for the
 * edges of the kernel, coin detection, and pulses of an output (gpio_signal.c). These functions are
 * pure: they use no device and no clock. Times are in ns on CLOCK_MONOTONIC, and the caller passes
 * them in non-decreasing order. */
#pragma once

#include <pthread.h>
#include <stdatomic.h>

#include "drivers/gpio/gpio_lines.h"

/* ---- Debouncing ------------------------------------------------------------------------------
 *
 * A level is accepted after it was stable for the debounce period. The resulting transition has the
 * time at which the level began. The width of a pulse therefore does not depend on when these
 * functions are called. */

struct debounce {
    /* Debounce period. 0 means that every edge is accepted, because the kernel debounces the
     * line. */
    uint64_t period_ns;
    uint64_t since_ns; /* Time at which the level `raw` began. */
    bool raw;          /* Level after the last edge, before debouncing. */
    bool stable;       /* Level after debouncing. */
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

/* Returns the time at which gpio_debounce_settle() must be called, or UINT64_MAX if only the next
 * edge of the line can change the state. */
uint64_t gpio_debounce_due_ns(const struct debounce *debounce);

/* ---- Edge filter ------------------------------------------------------------------------------
 *
 * The filter processes the kernel's edge events and the levels that the GPIO thread polls. An edge
 * event has a time stamp and a level. The time stamp is accurate. The level may be wrong, because
 * the kernel reads the level some milliseconds after the interrupt. Further edges may occur in this
 * time.
 *
 * A null edge is an edge event whose level equals the level before the event. The line changed and
 * changed back before the kernel read the level. The filter distinguishes four cases:
 *
 * - A single null edge restarts the debounce period and has no other effect.
 * - A null edge is corrected if polls over GPIO_PROOF_NS read the opposite level before the null
 *   edge arrived. The kernel then read the level too late. The filter processes the null edge as an
 *   edge to the polled level, so that a coin pulse that has already ended is still counted.
 * - Two null edges without such polls are never counted as a pulse. The pair may be a coin pulse
 *   that the kernel read too late, or two glitches from a relay or a lighter. The filter only
 *   counts the pair as doubtful.
 * - Polls that read the opposite level for GPIO_UNDER_WAY_NS prove that an edge event was lost,
 *   because no edge event is delayed for longer. The filter accepts the polled level and ignores
 *   edge events with earlier time stamps. */

/* Longest expected delay of an edge event: three times the observed delay of 6 ms, rounded up to
 * 20 ms. */
#define GPIO_UNDER_WAY_NS 20000000u
/* Two polls that read equal levels prove a stable level if at least this time lies between them.
 * The time is longer than a glitch and shorter than GPIO_COIN_POLL_NS. */
#define GPIO_PROOF_NS 4000000u
/* Longest time from the arrival of one null edge (an edge event without a change of the level) to
 * the time stamp of the next null edge of the same pulse. Null edges with a longer pause between
 * them cannot belong to one pulse. */
#define GPIO_PAIR_NS 2000000u

/* Times of consecutive polls that read a level other than the level after the last edge. Such polls
 * show that an edge was missed. Each time is taken just before the poll. UINT64_MAX means that
 * there was no such poll. */
struct gpio_poll_edges {
    /* Times of the first poll (`since_ns`) and of the last poll (`last_ns`) that read a level other
     * than the level after the last edge. */
    uint64_t since_ns, last_ns;
    /* Time of the first poll after `last_ns` whose level equals the level after the last edge. */
    uint64_t back_ns;
};

struct gpio_edge_filter {
    struct debounce debounce;
    /* Time stamp of the last edge event if that event was a null edge (an edge event without a
     * change of the level) on an idle line, otherwise UINT64_MAX. */
    uint64_t blinked_ns;
    /* Time at which the GPIO thread received the last null edge (an edge event without a change of
     * the level). */
    uint64_t reported_ns;
    /* Time of the newest polled level that the filter accepted in place of edge events. Edge events
     * with time stamps up to this time are ignored. */
    uint64_t accepted_ns;
    /* Times of the polls that read a level other than the level after the last edge. */
    struct gpio_poll_edges other;
    /* Number of null edges (edge events without a change of the level) since
     * gpio_edge_filter_begin(). */
    uint32_t blinks;
    /* Number of edges whose wrong direction was corrected by a polled level, since
     * gpio_edge_filter_begin(). */
    uint32_t late;
    /* Number of pairs of null edges (edge events without a change of the level) that are either two
     * glitches or a missed pulse. The caller may set this number to 0 after reading it. */
    uint32_t doubtful;
    /* Number of edges that were lost or arrived too late. The caller may set this number to 0 after
     * reading it. */
    uint32_t lost;
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

/* Returns the time at which the level of the line should be polled next, or UINT64_MAX if no poll
 * is needed. */
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
    /* Shortest and longest width of a coin pulse. A pulse with exactly one of these widths is a
     * coin too. */
    uint64_t width_min_ns, width_max_ns;
    /* Times at which the current pulse started (`begin_ns`) and ended (`end_ns`). */
    uint64_t begin_ns, end_ns;
    uint8_t state; /* State of the current pulse (enum coin_state). */
    /* True if the current pulse must not be counted as a coin, because its start was not
     * observed. */
    bool ignored;
    /* True if the current pulse is too long and was already counted in `stuck`. */
    bool sticks;
    uint64_t width_ns; /* Width of the last coin's pulse. 0 means no coin yet. */
    /* Numbers of coins, of pulses that were too short, and of pulses that were too long. The caller
     * may set these numbers to 0 after reading them. */
    uint32_t coins, too_short, stuck;
    /* Number of pulses whose end was not observed. The caller may set this number to 0 after
     * reading it. */
    uint32_t cut;
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

/* Returns the time at which gpio_coin_settle() must be called, or UINT64_MAX if only the next edge
 * of the line can change the state. */
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
    /* Nominal length of a pulse, and nominal length of the pause after each pulse. */
    uint64_t on_ns, off_ns;
    uint64_t until_ns; /* Time at which the current pulse or pause ends. */
    uint32_t left;     /* Number of pulses that have not started yet. */
    bool on;           /* True during a pulse. */
};

/* Adds `count` pulses. The sum saturates at UINT32_MAX. */
void gpio_pulses_add(struct pulse_train *train, uint32_t count);

/* Returns the level of the output at `now_ns`. True means that a pulse is active. `now_ns` must not
 * decrease. */
bool gpio_pulses_at(struct pulse_train *train, uint64_t now_ns);

/* Returns the time at which the level changes next, or UINT64_MAX if no pulse is left. */
uint64_t gpio_pulses_due_ns(const struct pulse_train *train);

/* ---- The thread -------------------------------------------------------------------------------*/

#define GPIO_OUTPUT_COUNT (GPIO_ROLE_COUNT - GPIO_INPUT_COUNT)
/* Longest wait of the GPIO thread for edges, in ms. An output changes at most this much later. */
#define GPIO_WAIT_MS_MAX 20u
/* Polling interval of a coin line. The level is polled at least three times during each valid
 * pulse. */
#define GPIO_COIN_POLL_NS 5000000u

/* Counts since gpio_thread_open(). */
struct gpio_total {
    uint32_t coins[COIN_LINE_COUNT];
    /* Numbers of pulses that were too short, too long (`stuck`) or unfinished (`cut`), summed over
     * all coin lines. */
    uint32_t too_short, stuck, cut;
    /* Number of pairs of null edges (edge events without a change of the level). Each pair is
     * either two glitches or a missed coin. */
    uint32_t doubtful;
    /* Number of lost edges (`lost_edges`), and number of removals of a chip (`lost_chips`). */
    uint32_t lost_edges, lost_chips;
};

struct gpio_thread {
    struct gpio_lines lines;
    struct hal_clock clock;
    /* Wiring of each role, with the default times filled in. */
    struct gpio_wire wires[GPIO_ROLE_COUNT];

    /* Only the GPIO thread uses the fields from `had` to `total`. `total` may also be read by the
     * caller of gpio_thread_step(). */
    uint32_t had; /* Lines that the GPIO thread has requested successfully (held lines), one bit for
                     each role. */
    /* Outputs whose last set level is active, one bit for each role. */
    uint32_t lit;
    /* Outputs whose last set() failed although the line is held, one bit for each role. */
    uint32_t failing;
    uint64_t retry_ns; /* Time at which missing lines are requested next. */
    /* Time at which the levels of all lines are read next. */
    uint64_t watch_ns;
    uint64_t coin_poll_ns[COIN_LINE_COUNT]; /* Time at which each coin line is polled next. */
    struct gpio_edge_filter inputs[GPIO_INPUT_COUNT];
    struct coin_mech coin[COIN_LINE_COUNT];
    struct pulse_train trains[GPIO_OUTPUT_COUNT];
    uint32_t levels;         /* Debounced levels of the buttons, one bit for each role. */
    struct gpio_total total; /* Totals, which the caller of gpio_thread_step() may read. */

    /* The GPIO thread and the frame loop share the atomic fields from `held` to `stop`. */
    /* Debounced buttons that are pressed (`held`), and buttons that were pressed since the frame
     * loop's last read (`pressed`), one bit for each role. */
    _Atomic uint32_t held, pressed;
    /* Number of coins of each line since the frame loop's last read. */
    _Atomic uint32_t coins[COIN_LINE_COUNT];
    /* Number of faults since the frame loop's last read. */
    _Atomic uint32_t faults;
    _Atomic uint32_t raw; /* Levels before debouncing, one bit for each role. */
    /* Number of edges of each line since the frame loop's last read, including bounces. */
    _Atomic uint32_t edges[GPIO_INPUT_COUNT];
    /* Number of faults of each line since the frame loop's last read. */
    _Atomic uint32_t line_faults[GPIO_INPUT_COUNT];
    /* Wired lines that the GPIO thread does not hold, one bit for each role. */
    _Atomic uint32_t missing;
    /* Outputs that the frame loop has set active, one bit for each role. */
    _Atomic uint32_t wanted;
    /* Number of pulses of each output that are requested and not yet taken over by the GPIO
     * thread. */
    _Atomic uint32_t pulses[GPIO_OUTPUT_COUNT];
    _Atomic uint32_t owed; /* Sum of the unfinished pulses of all held outputs. */
    /* Number of unfinished pulses of each output, whether the output is held or missing. */
    _Atomic uint32_t pending[GPIO_OUTPUT_COUNT];
    atomic_bool stop; /* True if the GPIO thread must end. */
    pthread_t thread;
    bool runs; /* True while the GPIO thread exists. */

    pthread_mutex_t mutex; /* Protects `why` and `text`. */
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE];
    /* Description of the held lines (requested successfully) and of the missing lines. */
    char text[HAL_TEXT_SIZE];
    char described[HAL_TEXT_SIZE]; /* Copy of `text` that describe() returns to the frame loop. */
};

/* Initializes `reader` and requests the lines once, without starting a thread. A caller without a
 * thread then calls gpio_thread_step(). Returns the result of gpio_lines_ops.open. The caller owns
 * `reader`, which must not move. */
int gpio_thread_open(struct gpio_thread *reader, struct gpio_lines lines,
                     const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* Runs one iteration: waits for edges at most GPIO_WAIT_MS_MAX, processes them, and sets the
 * outputs. */
void gpio_thread_step(struct gpio_thread *reader);

/* Closes the lines. Coins are locked out, lamps are switched off, and unfinished pulses are
 * dropped. */
void gpio_thread_close(struct gpio_thread *reader);

/* Initializes `reader` as gpio_thread_open() does and starts the GPIO thread. Returns HAL_OK even
 * if lines are missing. describe() and gpio_thread_why() name the missing lines. Returns HAL_ERR_IO
 * if the thread cannot be created. After HAL_ERR_IO, gpio_thread_stop() must not be called. */
int gpio_thread_start(struct gpio_thread *reader, struct gpio_lines lines,
                      const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* Waits at most two seconds for unfinished pulses, ends the GPIO thread and closes the lines. The
 * bias (gpio_config.h) then sets the level of each line. */
void gpio_thread_stop(struct gpio_thread *reader);

/* Returns the input device. Each button press and each coin is reported in exactly one sample. */
struct hal_buttons gpio_thread_buttons(struct gpio_thread *reader);

/* Returns the output device. The functions of the device return HAL_ERR_ABSENT for roles that are
 * not wired. Lamps and locks change within GPIO_WAIT_MS_MAX. */
struct hal_switches gpio_thread_switches(struct gpio_thread *reader);

/* Copies to `out` the reason why the line of `role` is missing or does not switch. Writes "" if the
 * line works or is not wired. */
void gpio_thread_why(struct gpio_thread *reader, enum gpio_role role, char out[HAL_TEXT_SIZE]);

/* ---- Functions that gpio_thread.c and gpio_device.c share ------------------------------------ */

/* gpio_device.c: requests the missing lines. Returns the result of gpio_lines_ops.open. */
int gpio_thread_request(struct gpio_thread *reader);
/* gpio_device.c: writes the text of describe(), which names the missing lines and the outputs that
 * do not switch. */
void gpio_thread_describe(struct gpio_thread *reader);
/* gpio_device.c: marks the lines of removed chips as missing. Counts one fault if at least one line
 * is newly missing. */
void gpio_thread_lose(struct gpio_thread *reader);
/* gpio_thread.c: the function poll() of the input device. */
int gpio_thread_poll(void *reader, struct button_sample *out);
