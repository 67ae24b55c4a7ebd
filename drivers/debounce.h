/* debounce.h -- which of a contact's many edges is the turn that somebody meant. Pure.
 *
 * A level counts once it has stood still for the period, and its turn is dated back to when it
 * began to: how late anybody looks changes nothing, so a pulse keeps its width. */
#ifndef KINGYO_DRIVERS_DEBOUNCE_H
#define KINGYO_DRIVERS_DEBOUNCE_H

#include <stdbool.h>
#include <stdint.h>

struct debounce {
    uint64_t period_ns; /* 0: every edge counts; the kernel has done it. */
    uint64_t since_ns;  /* When `raw` began. */
    bool raw;           /* As the last edge left it. */
    bool stable;        /* What counts. */
};

/* A turn that counts. */
struct debounce_turn {
    uint64_t time_ns;
    bool active;
};

struct debounce debounce_begin(uint64_t period_ns, bool active, uint64_t now_ns);

/* An edge to `active`, edges in the order of their times. True: a turn came of it or before it. */
bool debounce_edge(struct debounce *debounce, uint64_t time_ns, bool active,
                   struct debounce_turn *out);

/* `now_ns` is here, and no edge before it is still to come. True: a turn. */
bool debounce_settle(struct debounce *debounce, uint64_t now_ns, struct debounce_turn *out);

/* When settle() will have something to say; UINT64_MAX: not before the next edge. */
uint64_t debounce_due_ns(const struct debounce *debounce);

#endif
