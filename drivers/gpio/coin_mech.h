/* coin_mech.h -- detects coins in the debounced pulses of a coin acceptor. Pure.
 *
 * A coin is a pulse whose width is inside the window. Common acceptors give pulses of 25 to 100
 * ms +-20 % (DG600F, MEI CashFlow), and some of 200 ms. A switch touched by a coin gives 20 to
 * 100 ms. A shorter pulse is a glitch or a knock. A longer pulse is a stuck coin or manipulation
 * with a wire. Both are faults and count no coin. Two pulses closer than the gap are one pulse
 * with a bouncing contact, so no coin is counted twice. */
#ifndef KINGYO_DRIVERS_GPIO_COIN_MECH_H
#define KINGYO_DRIVERS_GPIO_COIN_MECH_H

#include <stdbool.h>
#include <stdint.h>

/* Acceptors that report a coin's value by several pulses pause for 20 ms or more. */
#define COIN_GAP_NS 10000000u

enum coin_state {
    COIN_IDLE = 0,
    COIN_FALLS, /* A pulse has begun and the line is active. */
    COIN_FELL,  /* A pulse has ended, less than the gap ago. */
};

struct coin_mech {
    uint64_t width_min_ns, width_max_ns; /* Shortest and longest width of a coin, both inclusive. */
    uint64_t begin_ns, end_ns;           /* Start and end of the current pulse. */
    uint8_t state;                       /* enum coin_state */
    bool spoilt;       /* 1 if the pulse does not count, because its start was not seen. */
    bool sticks;       /* 1 if the pulse is too long and was counted as stuck. */
    uint64_t width_ns; /* Width of the last coin. */
    uint32_t coins, too_short, stuck; /* Coins and faults since the start. */
    uint32_t cut;                     /* Pulses whose end was not seen, since the start. */
};

/* Returns the initial state. If `active` is set, the sensor is already covered, which does not
 * count as a coin. */
struct coin_mech coin_mech_begin(uint64_t width_min_ns, uint64_t width_max_ns, bool active,
                                 uint64_t now_ns);

/* Processes a transition of the debounced line; transitions must come in order of time. */
void coin_mech_edge(struct coin_mech *mech, uint64_t time_ns, bool active);

/* Evaluates the state at `now_ns`, before which no further transition may follow. */
void coin_mech_settle(struct coin_mech *mech, uint64_t now_ns);

/* Handles the loss of the line: a pulse that had ended counts, and an unfinished one is counted
 * as cut. */
void coin_mech_lose(struct coin_mech *mech);

/* Returns when coin_mech_settle() must be called, or UINT64_MAX if only a transition requires
 * it. */
uint64_t coin_mech_due_ns(const struct coin_mech *mech);

/* Returns the sum of all fault counts. */
static inline uint32_t coin_mech_faults(const struct coin_mech *mech)
{
    return mech->too_short + mech->stuck + mech->cut;
}

#endif
