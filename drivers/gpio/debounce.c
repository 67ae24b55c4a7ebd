/* debounce.c -- implements the debouncing: accepts a level that was stable for the debounce
 * period. */
#include "drivers/gpio/debounce.h"

struct debounce debounce_begin(uint64_t period_ns, bool active, uint64_t now_ns)
{
    return (struct debounce){
        .period_ns = period_ns,
        .since_ns = now_ns,
        .raw = active,
        .stable = active,
    };
}

bool debounce_settle(struct debounce *debounce, uint64_t now_ns, struct debounce_edge_time *out)
{
    if (debounce->raw == debounce->stable || now_ns < debounce_due_ns(debounce)) {
        return false;
    }
    debounce->stable = debounce->raw;
    *out = (struct debounce_edge_time){ .time_ns = debounce->since_ns, .active = debounce->stable };
    return true;
}

bool debounce_edge(struct debounce *debounce, uint64_t time_ns, bool active,
                   struct debounce_edge_time *out)
{
    const bool turned = debounce_settle(debounce, time_ns, out);
    if (active != debounce->raw) {
        debounce->raw = active;
        debounce->since_ns = time_ns;
    }
    /* Completes the transition immediately if the period is 0. */
    return turned || debounce_settle(debounce, time_ns, out);
}

uint64_t debounce_due_ns(const struct debounce *debounce)
{
    return debounce->raw == debounce->stable ? UINT64_MAX
                                             : debounce->since_ns + debounce->period_ns;
}
