/* coin_mech.h -- detects coins in the debounced pulses of a coin acceptor.
 *
 * A coin is a pulse whose width is between width_min_ns and width_max_ns. Common acceptors give
 * pulses of 25 to 100 ms +-20 % (DG600F, MEI CashFlow), and some acceptors give pulses of 200 ms. A
 * switch that the coin touches gives pulses of 20 to 100 ms.
 *
 * A shorter pulse is a glitch or a knock. A longer pulse is a stuck coin or manipulation with a
 * wire. Shorter and longer pulses are counted as faults and not as coins. Two pulses that are
 * closer together than COIN_GAP_NS are one pulse of a bouncing contact, so no coin is counted
 * twice. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_GPIO_COIN_MECH_H
#define KINGYO_DRIVERS_GPIO_COIN_MECH_H

#include <stdbool.h>
#include <stdint.h>

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
    bool spoilt;       /* True if the current pulse does not count, because its start was not
                          observed. */
    bool sticks;       /* True if the current pulse is too long and was already counted in
                          `stuck`. */
    uint64_t width_ns; /* Width of the last coin's pulse; 0 means no coin yet. */
    uint32_t coins, too_short, stuck; /* Numbers of coins, of too short pulses, and of too long
                                         pulses. The caller may set them to 0 after reading them. */
    uint32_t cut;                     /* Number of pulses whose end was not observed. The caller may
                                         set it to 0 after reading it. */
};

/* Returns the initial state. If `active` is true, a coin covers the sensor already at `now_ns`;
 * this coin is not counted. */
struct coin_mech coin_mech_begin(uint64_t width_min_ns, uint64_t width_max_ns, bool active,
                                 uint64_t now_ns);

/* Processes a transition of the debounced line to the level `active`. The transitions must be
 * passed in order of time. */
void coin_mech_edge(struct coin_mech *mech, uint64_t time_ns, bool active);

/* Performs the changes of state that are due at `now_ns`. All transitions before `now_ns` must have
 * been passed already. */
void coin_mech_settle(struct coin_mech *mech, uint64_t now_ns);

/* Handles the loss of the GPIO line. A pulse that had ended is classified, and an unfinished pulse
 * is counted in `cut`. */
void coin_mech_lose(struct coin_mech *mech);

/* Returns the time at which coin_mech_settle() must be called, or UINT64_MAX if the state cannot
 * change without a transition. */
uint64_t coin_mech_due_ns(const struct coin_mech *mech);

/* Returns the sum of all fault counts. */
static inline uint32_t coin_mech_faults(const struct coin_mech *mech)
{
    return mech->too_short + mech->stuck + mech->cut;
}

#endif
