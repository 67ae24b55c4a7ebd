/* debounce.h -- filters the bounce of a contact.
 *
 * A level is accepted after it was stable for the debounce period. The resulting transition has the
 * time at which the level began. The width of a pulse therefore does not depend on when these
 * functions are called. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_GPIO_DEBOUNCE_H
#define KINGYO_DRIVERS_GPIO_DEBOUNCE_H

#include <stdbool.h>
#include <stdint.h>

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
struct debounce debounce_begin(uint64_t period_ns, bool active, uint64_t now_ns);

/* Processes an edge to the level `active`. The edges must be passed in order of time. Returns true
 * and fills `out` if a transition was completed. */
bool debounce_edge(struct debounce *debounce, uint64_t time_ns, bool active,
                   struct debounce_edge_time *out);

/* Performs the change of state that is due at `now_ns`. All edges before `now_ns` must have been
 * passed already. Returns true and fills `out` if a transition was completed. */
bool debounce_settle(struct debounce *debounce, uint64_t now_ns, struct debounce_edge_time *out);

/* Returns the time at which debounce_settle() must be called, or UINT64_MAX if the state cannot
 * change without an edge. */
uint64_t debounce_due_ns(const struct debounce *debounce);

#endif
