/* debounce.h -- filters contact bounce. Pure.
 *
 * A level counts after it was stable for the period. The resulting transition gets the time at
 * which the level began. The width of a pulse therefore does not depend on when these functions
 * are called. */
#ifndef KINGYO_DRIVERS_GPIO_DEBOUNCE_H
#define KINGYO_DRIVERS_GPIO_DEBOUNCE_H

#include <stdbool.h>
#include <stdint.h>

struct debounce {
    uint64_t period_ns; /* 0: every edge counts, because the kernel debounces. */
    uint64_t since_ns;  /* Time at which `raw` began. */
    bool raw;           /* Level after the last edge, not debounced. */
    bool stable;        /* Level after debouncing. */
};

/* A debounced transition. */
struct debounce_edge_time {
    uint64_t time_ns;
    bool active;
};

/* Returns the state of a line that has been at `active` since `now_ns`. */
struct debounce debounce_begin(uint64_t period_ns, bool active, uint64_t now_ns);

/* Processes an edge to `active`; edges must come in order of time. Returns true if a transition
 * was completed. */
bool debounce_edge(struct debounce *debounce, uint64_t time_ns, bool active,
                   struct debounce_edge_time *out);

/* Evaluates the state at `now_ns`, before which no further edge may follow. Returns true if a
 * transition was completed. */
bool debounce_settle(struct debounce *debounce, uint64_t now_ns, struct debounce_edge_time *out);

/* Returns when debounce_settle() must be called, or UINT64_MAX if only an edge requires it. */
uint64_t debounce_due_ns(const struct debounce *debounce);

#endif
