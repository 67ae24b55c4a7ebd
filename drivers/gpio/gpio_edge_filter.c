/* gpio_edge_filter.c -- implements the edge filter: corrects the kernel's edges by polled
 * levels. */
#include "drivers/gpio/gpio_edge_filter.h"

#define NEVER UINT64_MAX

static const struct gpio_poll_edges no_looks = { NEVER, NEVER, NEVER };

struct gpio_edge_filter gpio_edge_filter_begin(uint64_t debounce_ns, bool active, uint64_t now_ns)
{
    return (struct gpio_edge_filter){
        .debounce = debounce_begin(debounce_ns, active, now_ns),
        .blinked_ns = NEVER,
        .other = no_looks,
    };
}

/* ---- Polled levels -------------------------------------------------------------------------- */

/* Returns true while the last polled level differs from the level after the last edge. */
static bool is_doubted(const struct gpio_poll_edges *other)
{
    return other->since_ns != NEVER && other->back_ns == NEVER;
}

/* Returns true if polls over GPIO_PROOF_NS saw the different level. The kernel's edge event is then
 * late by more than the length of a glitch. */
static bool is_proof(const struct gpio_poll_edges *other)
{
    return other->since_ns != NEVER && other->last_ns - other->since_ns >= GPIO_PROOF_NS;
}

/* Discards the recorded polls. Counts one lost edge if the polls proved a level that has ended,
 * unless `is_explained` is true. */
static void end_looks(struct gpio_edge_filter *input, bool is_explained)
{
    const struct gpio_poll_edges *other = &input->other;
    input->lost += !is_explained && is_proof(other) && !is_doubted(other);
    input->other = no_looks;
}

/* ---- Edges ---------------------------------------------------------------------------------- */

/* Applies an edge event that arrived late: its direction is replaced by the level that was polled
 * after the edge. */
static bool take_late(struct gpio_edge_filter *input, uint64_t time_ns,
                      struct debounce_edge_time *out)
{
    struct debounce *debounce = &input->debounce;
    const bool before = debounce->raw;
    const uint64_t back_ns = input->other.back_ns;
    input->late++;
    input->blinked_ns = NEVER;
    /* Later edge events of the same pulse, up to this time, are ignored. */
    input->believed_ns = back_ns == NEVER ? input->other.last_ns : back_ns;
    end_looks(input, true);
    const bool turned = debounce_edge(debounce, time_ns, !before, out);
    return turned || back_ns == NEVER ? turned : debounce_edge(debounce, back_ns, before, out);
}

/* Processes a null edge (an event without a change of the level). The line changed and changed
 * back, so the debounce period starts again. */
static bool take_blink(struct gpio_edge_filter *input, const struct gpio_edge *edge,
                       struct debounce_edge_time *out)
{
    struct debounce *debounce = &input->debounce;
    if (debounce->period_ns == 0) {
        return false; /* The kernel debounces this line, so null edges have no meaning. */
    }
    input->blinks++;
    const bool is_pair = input->blinked_ns != NEVER &&
                         edge->time_ns <= input->told_ns + GPIO_PAIR_NS &&
                         edge->time_ns >= input->blinked_ns + debounce->period_ns;
    const bool active = debounce->raw;
    const bool rests =
        !active && !debounce->stable && edge->time_ns >= debounce->since_ns + GPIO_UNDER_WAY_NS;
    input->doubtful += is_pair;
    input->blinked_ns = rests && !is_pair ? edge->time_ns : NEVER;
    input->told_ns = edge->taken_ns;
    struct debounce_edge_time none;
    const bool turned = debounce_edge(debounce, edge->time_ns, !active, out);
    /* The line changes back at the same time, so no transition can complete. */
    debounce_edge(debounce, edge->time_ns, active, &none);
    return turned;
}

bool gpio_edge_filter_edge(struct gpio_edge_filter *input, const struct gpio_edge *edge,
                           struct debounce_edge_time *out)
{
    const struct gpio_poll_edges *other = &input->other;
    const bool active = edge->active != 0;
    const bool changes = active != input->debounce.raw;
    input->lost += edge->lost_before;
    if (edge->time_ns <= input->believed_ns) {
        return false; /* The edge is older than an accepted polled level. */
    }
    if (edge->lost_before == 0 && is_proof(other) && edge->time_ns <= other->since_ns &&
        (!changes || !is_doubted(other))) {
        return take_late(input, edge->time_ns, out);
    }
    end_looks(input, false);
    if (edge->lost_before == 0 && !changes) {
        return take_blink(input, edge, out);
    }
    input->blinked_ns = NEVER;
    return debounce_edge(&input->debounce, edge->time_ns, active, out);
}

/* ---- Levels that were read ------------------------------------------------------------------ */

/* Records a poll at `now_ns` whose level differs from the level after the last edge. Returns true
 * if the polled level has lasted for GPIO_UNDER_WAY_NS and must be accepted. */
static bool doubt(struct gpio_edge_filter *input, uint64_t now_ns)
{
    struct gpio_poll_edges *other = &input->other;
    if (!is_doubted(other)) {
        end_looks(input, false);
        other->since_ns = now_ns;
    }
    other->last_ns = now_ns;
    return now_ns - other->since_ns >= GPIO_UNDER_WAY_NS;
}

bool gpio_edge_filter_level(struct gpio_edge_filter *input, uint64_t now_ns, bool active,
                            struct debounce_edge_time *out)
{
    bool turned = false;
    if (active != input->debounce.raw) {
        if (!doubt(input, now_ns)) {
            return false;
        }
        turned = debounce_edge(&input->debounce, input->other.since_ns, active, out);
        input->believed_ns = now_ns;
        input->blinked_ns = NEVER;
        input->lost++;
        input->other = no_looks;
    } else if (is_doubted(&input->other)) {
        input->other.back_ns = now_ns;
        if (!is_proof(&input->other)) {
            input->other = no_looks;
        }
    }
    return turned || debounce_settle(&input->debounce, now_ns, out);
}

uint64_t gpio_edge_filter_due_ns(const struct gpio_edge_filter *input)
{
    return is_doubted(&input->other) ? input->other.since_ns + GPIO_UNDER_WAY_NS
                                     : debounce_due_ns(&input->debounce);
}

uint64_t gpio_edge_filter_known_ns(const struct gpio_edge_filter *input, uint64_t now_ns)
{
    const struct debounce *debounce = &input->debounce;
    const uint64_t pending_ns = debounce->raw != debounce->stable ? debounce->since_ns : now_ns;
    const uint64_t known_ns = pending_ns < now_ns ? pending_ns : now_ns;
    return is_doubted(&input->other) && input->other.since_ns < known_ns ? input->other.since_ns
                                                                         : known_ns;
}
