/* coin_mech.h -- coins out of the pulses of a coin acceptor. Pure.
 *
 * A coin is a pulse whose width lies in the window. Acceptors of the common kinds give 25 to 100 ms
 * +-20 % (DG600F, MEI CashFlow), some 200; a switch that a coin brushes, 20 to 100. What is shorter
 * is a spark or a knock; what is longer is a coin that sticks, or somebody with a wire. Neither is
 * counted, both are faults. A pulse that was seen once is never counted twice: two that are closer
 * than the gap are one whose contact jumped. */
#ifndef KINGYO_DRIVERS_COIN_MECH_H
#define KINGYO_DRIVERS_COIN_MECH_H

#include <stdbool.h>
#include <stdint.h>

#define COIN_GAP_NS 10000000u /* Acceptors that say a coin's worth by pulses rest 20 ms and more. */

enum coin_state {
    COIN_IDLE = 0,
    COIN_FALLS, /* Active. */
    COIN_FELL,  /* Inactive for less than the gap. */
};

struct coin_mech {
    uint64_t width_min_ns, width_max_ns; /* Both count. */
    uint64_t begin_ns, end_ns;           /* Of the pulse that is under way. */
    uint8_t state;                       /* enum coin_state */
    bool spoilt;                         /* This pulse is none: nobody saw it begin whole. */
    bool sticks;                         /* It is too long, which was told. */
    uint64_t width_ns;                   /* Of the last coin. */
    uint32_t coins, too_short, stuck;    /* Since the start. */
    uint32_t cut;                        /* Pulses that nobody saw to their end. */
};

/* `active`: something covers the sensor already, which is no coin. */
struct coin_mech coin_mech_begin(uint64_t width_min_ns, uint64_t width_max_ns, bool active,
                                 uint64_t now_ns);

/* The debounced line turned; turns in the order of their times. */
void coin_mech_turn(struct coin_mech *mech, uint64_t time_ns, bool active);

/* `now_ns` is here, and no turn before it is still to come. */
void coin_mech_settle(struct coin_mech *mech, uint64_t now_ns);

/* The line is gone: a pulse that had ended counts, one that had not is cut. */
void coin_mech_lose(struct coin_mech *mech);

/* When settle() will have something to say; UINT64_MAX: not before the next turn. */
uint64_t coin_mech_due_ns(const struct coin_mech *mech);

static inline uint32_t coin_mech_faults(const struct coin_mech *mech)
{
    return mech->too_short + mech->stuck + mech->cut;
}

#endif
