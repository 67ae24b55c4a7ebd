/* gpio_thread.h -- the thread that reads all input lines and drives all output lines.
 *
 * No other thread uses the lines. Results wait in atomic counters until the frame loop reads
 * them, so a frame loop that stalls for a second loses no coin. Commands of the frame loop go
 * the same way. A removed chip or a line that could not be requested is retried once a second. */
#ifndef KINGYO_DRIVERS_GPIO_GPIO_THREAD_H
#define KINGYO_DRIVERS_GPIO_GPIO_THREAD_H

#include <pthread.h>
#include <stdatomic.h>

#include "drivers/gpio/coin_mech.h"
#include "drivers/gpio/gpio_edge_filter.h"
#include "drivers/gpio/pulse_train.h"

#define GPIO_OUTPUT_COUNT (GPIO_ROLE_COUNT - GPIO_INPUT_COUNT)
/* Longest delay of an output change, and of a level change without an edge event. */
#define GPIO_WAIT_MS_MAX 20u
#define GPIO_COIN_POLL_NS 5000000u /* Polling interval of a coin line: three times in a pulse. */

/* Counts since the lines were first requested. */
struct gpio_total {
    uint32_t coins[COIN_LINE_COUNT];
    uint32_t too_short, stuck, cut; /* Sums over all coin lines, as in coin_mech. */
    /* Pairs of null edges (gpio_edge_filter.h): two glitches, or a missed coin. */
    uint32_t doubtful;
    uint32_t lost_edges, lost_chips;
};

struct gpio_thread {
    struct gpio_lines lines;
    struct hal_clock clock;
    struct gpio_wire wires[GPIO_ROLE_COUNT]; /* Wiring with all default times filled in. */

    /* The following fields are used only by the reader thread. */
    uint32_t had;                           /* Held lines, one bit for each role. */
    uint32_t lit;                           /* Outputs that were last set active. */
    uint64_t retry_ns;                      /* Time of the next request of missing lines. */
    uint64_t watch_ns;                      /* Next time at which all levels are read. */
    uint64_t coin_look_ns[COIN_LINE_COUNT]; /* Next time at which each coin line is read. */
    struct gpio_edge_filter inputs[GPIO_INPUT_COUNT];
    struct coin_mech coin[COIN_LINE_COUNT];
    struct pulse_train trains[GPIO_OUTPUT_COUNT];
    uint32_t levels;         /* Debounced levels, one bit for each role. */
    struct gpio_total total; /* Totals for the caller of gpio_thread_step(). */

    /* The following fields are shared by both threads. */
    /* Buttons that are down, and press edges, one bit for each role. */
    _Atomic uint32_t held, pressed;
    _Atomic uint32_t coins[COIN_LINE_COUNT];  /* Coins of each line since the last read. */
    _Atomic uint32_t faults;                  /* Faults since the last read. */
    _Atomic uint32_t raw;                     /* Levels before debouncing, one bit for each role. */
    _Atomic uint32_t edges[GPIO_INPUT_COUNT]; /* Edges including bounces, since the last read. */
    _Atomic uint32_t line_faults[GPIO_INPUT_COUNT]; /* Faults of each line, since the last read. */
    _Atomic uint32_t missing; /* Wired lines that are not held, one bit for each role. */
    _Atomic uint32_t wanted;  /* Outputs that must be active, one bit for each role. */
    /* Pulses requested and not yet taken by the reader. */
    _Atomic uint32_t pulses[GPIO_OUTPUT_COUNT];
    _Atomic uint32_t owed; /* Unfinished pulses of all held outputs. */
    /* Unfinished pulses of each output, held or missing. */
    _Atomic uint32_t pending[GPIO_OUTPUT_COUNT];
    _Atomic int stop;
    pthread_t thread;
    int runs;

    pthread_mutex_t mutex; /* Protects `why` and `text`. */
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE];
    char text[HAL_TEXT_SIZE];
};

/* Requests the lines once, without a thread; the caller then calls gpio_thread_step(). Returns
 * the result of gpio_lines_ops.open. The caller owns `reader`, which must not move. */
int gpio_thread_open(struct gpio_thread *reader, struct gpio_lines lines,
                     const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* Runs one iteration: waits for edges at most GPIO_WAIT_MS_MAX, processes them, and sets the
 * outputs. */
void gpio_thread_step(struct gpio_thread *reader);

/* Closes the lines: locks out coins, switches lamps off, and drops unfinished pulses. */
void gpio_thread_close(struct gpio_thread *reader);

/* Starts the thread. Returns HAL_OK, or HAL_ERR_IO if there is no thread. */
int gpio_thread_start(struct gpio_thread *reader);

/* Waits at most two seconds for unfinished pulses, ends the thread and closes the lines. */
void gpio_thread_stop(struct gpio_thread *reader);

#endif
