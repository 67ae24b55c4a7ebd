/* gpio_thread.h -- the GPIO thread, which reads all input lines and drives all output lines.
 *
 * No other thread uses the lines. The results are kept in atomic counters until the frame loop
 * reads them, so no coin is lost while the frame loop stalls for a second. Commands of the frame
 * loop use atomic variables too. Lines that could not be requested, and lines of a removed chip,
 * are requested again once a second. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_THREAD_H
#define KINGYO_DRIVERS_GPIO_GPIO_THREAD_H

#include <pthread.h>
#include <stdatomic.h>

#include "drivers/gpio/gpio_signal.h"

#define GPIO_OUTPUT_COUNT (GPIO_ROLE_COUNT - GPIO_INPUT_COUNT)
/* Longest wait of the GPIO thread for edges, in ms. An output changes at most this much later. */
#define GPIO_WAIT_MS_MAX 20u
/* Polling interval of a coin line. The level is polled at least three times during each valid
 * pulse. */
#define GPIO_COIN_POLL_NS 5000000u

/* Counts since gpio_thread_open(). */
struct gpio_total {
    uint32_t coins[COIN_LINE_COUNT];
    uint32_t too_short, stuck, cut; /* Numbers of pulses that were too short, too long (`stuck`)
                                       or unfinished (`cut`), summed over all coin lines
                                       (gpio_signal.h). */
    /* Number of pairs of null edges (gpio_signal.h). Each pair is either two glitches or a
     * missed coin. */
    uint32_t doubtful;
    uint32_t lost_edges, lost_chips; /* Number of lost edges (`lost_edges`), and number of removals
                                        of a chip (`lost_chips`). */
};

struct gpio_thread {
    struct gpio_lines lines;
    struct hal_clock clock;
    struct gpio_wire wires[GPIO_ROLE_COUNT]; /* Wiring of each role, with the default times filled
                                                in. */

    /* Only the GPIO thread uses the fields from `had` to `total`. `total` may also be read by the
     * caller of gpio_thread_step(). */
    uint32_t had;                           /* Lines that the GPIO thread has requested successfully
                                               (held lines), one bit for each role. */
    uint32_t lit;                           /* Outputs whose last set level is active, one bit for
                                               each role. */
    uint64_t retry_ns;                      /* Time at which missing lines are requested next. */
    uint64_t watch_ns;                      /* Time at which the levels of all lines are read
                                               next. */
    uint64_t coin_look_ns[COIN_LINE_COUNT]; /* Time at which each coin line is polled next. */
    struct gpio_edge_filter inputs[GPIO_INPUT_COUNT];
    struct coin_mech coin[COIN_LINE_COUNT];
    struct pulse_train trains[GPIO_OUTPUT_COUNT];
    uint32_t levels;         /* Debounced levels of the buttons, one bit for each role. */
    struct gpio_total total; /* Totals, which the caller of gpio_thread_step() may read. */

    /* The GPIO thread and the frame loop share the atomic fields from `held` to `stop`. */
    /* Debounced buttons that are pressed (`held`), and buttons that were pressed since the frame
     * loop's last read (`pressed`), one bit for each role. */
    _Atomic uint32_t held, pressed;
    _Atomic uint32_t coins[COIN_LINE_COUNT];  /* Number of coins of each line since the frame loop's
                                                 last read. */
    _Atomic uint32_t faults;                  /* Number of faults since the frame loop's last
                                                 read. */
    _Atomic uint32_t raw;                     /* Levels before debouncing, one bit for each role. */
    _Atomic uint32_t edges[GPIO_INPUT_COUNT]; /* Number of edges of each line since the frame loop's
                                                 last read, including bounces. */
    _Atomic uint32_t line_faults[GPIO_INPUT_COUNT]; /* Number of faults of each line since the frame
                                                       loop's last read. */
    _Atomic uint32_t missing; /* Wired lines that the GPIO thread does not hold, one bit for each
                                 role. */
    _Atomic uint32_t wanted;  /* Outputs that the frame loop has set active, one bit for each
                                 role. */
    /* Number of pulses of each output that are requested and not yet taken over by the GPIO
     * thread. */
    _Atomic uint32_t pulses[GPIO_OUTPUT_COUNT];
    _Atomic uint32_t owed; /* Sum of the unfinished pulses of all held outputs. */
    /* Number of unfinished pulses of each output, whether the output is held or missing. */
    _Atomic uint32_t pending[GPIO_OUTPUT_COUNT];
    _Atomic int stop; /* 1 if the GPIO thread must end, otherwise 0. */
    pthread_t thread;
    int runs; /* 1 while the GPIO thread exists, otherwise 0. */

    pthread_mutex_t mutex; /* Protects `why` and `text`. */
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE];
    char text[HAL_TEXT_SIZE]; /* Description of the held lines (requested successfully) and of the
                                 missing lines. */
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

#endif
