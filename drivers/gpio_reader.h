/* gpio_reader.h -- the thread that lives with the lines: edges in, lamps and pulses out.
 *
 * It alone touches the lines. What it saw waits in counters until the frame loop comes by, so a
 * loop that stands still for a second loses no coin; what the frame loop wants it finds there too.
 * A chip that goes away is looked for once a second, and so is a line that could not be had. */
#ifndef KINGYO_DRIVERS_GPIO_READER_H
#define KINGYO_DRIVERS_GPIO_READER_H

#include <pthread.h>
#include <stdatomic.h>

#include "drivers/coin_mech.h"
#include "drivers/gpio_input.h"
#include "drivers/pulse_train.h"

#define GPIO_OUTPUT_COUNT (GPIO_ROLE_COUNT - GPIO_INPUT_COUNT)
#define GPIO_WAIT_MS_MAX 20u /* How late a lamp may be, and a level that no edge told of. */
#define GPIO_COIN_LOOK_NS 5000000u /* A coin line's level is read so often: thrice in a pulse. */

/* What was counted since the lines were asked for first. */
struct gpio_total {
    uint32_t coins[COIN_LINE_COUNT];
    uint32_t too_short, stuck, cut; /* As coin_mech's, of all coin lines. */
    uint32_t doubtful;                     /* Two sparks, or a coin that nobody saw. */
    uint32_t lost_edges, lost_chips;
};

struct gpio_reader {
    struct gpio_lines lines;
    struct hal_clock clock;
    struct gpio_wire wires[GPIO_ROLE_COUNT]; /* With every time filled in. */

    /* The reader's own. */
    uint32_t had;                            /* Lines held, a bit each role. */
    uint32_t lit;                            /* Outputs that were last set active. */
    uint64_t retry_ns;                       /* When what is missing is asked for again. */
    uint64_t watch_ns;                       /* When every level is read again, */
    uint64_t coin_look_ns[COIN_LINE_COUNT];  /* and a coin line's. */
    struct gpio_input inputs[GPIO_INPUT_COUNT];
    struct coin_mech coin[COIN_LINE_COUNT];
    struct pulse_train trains[GPIO_OUTPUT_COUNT];
    uint32_t levels;                         /* Debounced, a bit each role. */
    struct gpio_total total;                 /* For whoever steps. */

    /* Between the threads. */
    _Atomic uint32_t held, pressed;          /* Bits of input roles; coins are never among them. */
    _Atomic uint32_t coins[COIN_LINE_COUNT]; /* Since they were last taken, */
    _Atomic uint32_t faults;                 /* likewise. */
    _Atomic uint32_t raw;                    /* Levels before they count, a bit each role; */
    _Atomic uint32_t edges[GPIO_INPUT_COUNT]; /* their changes, bounces too, */
    _Atomic uint32_t line_faults[GPIO_INPUT_COUNT]; /* and each line's faults: likewise. */
    _Atomic uint32_t missing;                /* Lines wired and not held, a bit each role. */
    _Atomic uint32_t wanted;                 /* Outputs that are to be active. */
    _Atomic uint32_t pulses[GPIO_OUTPUT_COUNT]; /* Asked for since the reader last looked. */
    _Atomic uint32_t owed;                   /* Pulses that have not ended, of all held outputs. */
    _Atomic uint32_t pending[GPIO_OUTPUT_COUNT]; /* Of each output, held or missing. */
    _Atomic int stop;
    pthread_t thread;
    int runs;

    pthread_mutex_t mutex;                   /* Over the words alone. */
    char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE];
    char text[HAL_TEXT_SIZE];
};

/* Asks for the lines once, without a thread: gpio_reader_step() is then the caller's to call.
 * Answers as gpio_lines_ops.open. The caller owns `reader`, which must not move. */
int gpio_reader_open(struct gpio_reader *reader, struct gpio_lines lines,
                     const struct gpio_wire wires[GPIO_ROLE_COUNT], struct hal_clock clock);

/* One round: waits for edges at most GPIO_WAIT_MS_MAX, takes them, sets the outputs. */
void gpio_reader_step(struct gpio_reader *reader);

/* Ends the lines: no coin is taken from now on, lamps go out, pulses that are owed are given up. */
void gpio_reader_close(struct gpio_reader *reader);

/* The thread that steps. 0, or HAL_ERR_IO where there can be none. */
int gpio_reader_start(struct gpio_reader *reader);

/* Lets owed pulses end for at most two seconds, ends the thread and closes. */
void gpio_reader_stop(struct gpio_reader *reader);

#endif
