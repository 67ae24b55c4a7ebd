/* gpio_signal.c -- processes the signals of single GPIO lines: debouncing, edge filter, coins and
 * output pulses. */
#include "drivers/gpio/gpio_thread.h"

#include "core/base/panic.h"

#define NEVER UINT64_MAX

/* ---- Debouncing ----------------------------------------------------------------------------- */

struct debounce gpio_debounce_begin(uint64_t period_ns, bool active, uint64_t now_ns)
{
    return (struct debounce){
        .period_ns = period_ns,
        .since_ns = now_ns,
        .raw = active,
        .stable = active,
    };
}

bool gpio_debounce_settle(struct debounce *debounce, uint64_t now_ns,
                          struct debounce_edge_time *out)
{
    if (debounce->raw == debounce->stable || now_ns < gpio_debounce_due_ns(debounce)) {
        return false;
    }
    CORE_ASSERT(out);
    debounce->stable = debounce->raw;
    *out = (struct debounce_edge_time){ .time_ns = debounce->since_ns, .active = debounce->stable };
    return true;
}

bool gpio_debounce_edge(struct debounce *debounce, uint64_t time_ns, bool active,
                        struct debounce_edge_time *out)
{
    CORE_ASSERT(out);
    const bool turned = gpio_debounce_settle(debounce, time_ns, out);
    if (active != debounce->raw) {
        debounce->raw = active;
        debounce->since_ns = time_ns;
    }
    /* If the debounce period is 0, the transition to `active` completes immediately. */
    return turned || gpio_debounce_settle(debounce, time_ns, out);
}

uint64_t gpio_debounce_due_ns(const struct debounce *debounce)
{
    return debounce->raw == debounce->stable ? UINT64_MAX
                                             : debounce->since_ns + debounce->period_ns;
}

/* ---- Edge filter: polled levels -------------------------------------------------------------- */

static const struct gpio_poll_edges no_polls = { NEVER, NEVER, NEVER };

struct gpio_edge_filter gpio_edge_filter_begin(uint64_t debounce_ns, bool active, uint64_t now_ns)
{
    return (struct gpio_edge_filter){
        .debounce = gpio_debounce_begin(debounce_ns, active, now_ns),
        .blinked_ns = NEVER,
        .other = no_polls,
    };
}

/* Returns true while the level that was polled last differs from the level after the last edge. */
static bool has_conflict(const struct gpio_poll_edges *other)
{
    /* The times of the first poll (`since_ns`) and of the last poll (`last_ns`) are either both set
     * or both NEVER. */
    CORE_ASSERT((other->since_ns == NEVER) == (other->last_ns == NEVER));
    CORE_ASSERT(other->back_ns == NEVER || other->since_ns != NEVER);
    return other->since_ns != NEVER && other->back_ns == NEVER;
}

/* Returns true if polls over at least GPIO_PROOF_NS read a level that differs from the level after
 * the last edge. The edge event of the kernel is then late by more than the length of a glitch. */
static bool is_proof(const struct gpio_poll_edges *other)
{
    return other->since_ns != NEVER && other->last_ns - other->since_ns >= GPIO_PROOF_NS;
}

/* Discards the recorded polls. If the polls prove that the line changed and has already changed
 * back, one edge counts as lost, unless a late edge event explains the change (`is_explained`). */
static void discard_polls(struct gpio_edge_filter *input, bool is_explained)
{
    const struct gpio_poll_edges *other = &input->other;
    input->lost += !is_explained && is_proof(other) && !has_conflict(other);
    input->other = no_polls;
}

/* ---- Edge filter: edges ---------------------------------------------------------------------- */

/* Applies an edge event that arrived after the change of level was polled. The direction of the
 * event is ignored, because the polled level is more reliable. */
static bool accept_late_pulse(struct gpio_edge_filter *input, uint64_t time_ns,
                              struct debounce_edge_time *out)
{
    struct debounce *debounce = &input->debounce;
    const bool before = debounce->raw;
    const uint64_t back_ns = input->other.back_ns;
    CORE_ASSERT(is_proof(&input->other));
    input->late++;
    input->blinked_ns = NEVER;
    /* Later edge events with time stamps up to `accepted_ns` belong to the same pulse and are
     * ignored. */
    input->accepted_ns = back_ns == NEVER ? input->other.last_ns : back_ns;
    discard_polls(input, true);
    const bool turned = gpio_debounce_edge(debounce, time_ns, !before, out);
    return turned || back_ns == NEVER ? turned : gpio_debounce_edge(debounce, back_ns, before, out);
}

/* Processes a null edge (an edge event without a change of the level). A null edge means that the
 * line changed and changed back, so the debounce period starts again. */
static bool take_blink(struct gpio_edge_filter *input, const struct gpio_edge *edge,
                       struct debounce_edge_time *out)
{
    struct debounce *debounce = &input->debounce;
    if (debounce->period_ns == 0) {
        /* The kernel debounces this line. A null edge (an event without a change of the level) is
         * then not a sign of a pulse and is ignored. */
        return false;
    }
    CORE_ASSERT(edge->active == debounce->raw);
    input->blinks++;
    const bool is_pair = input->blinked_ns != NEVER &&
                         edge->time_ns <= input->reported_ns + GPIO_PAIR_NS &&
                         edge->time_ns >= input->blinked_ns + debounce->period_ns;
    const bool active = debounce->raw;
    const bool rests =
        !active && !debounce->stable && edge->time_ns >= debounce->since_ns + GPIO_UNDER_WAY_NS;
    input->doubtful += is_pair;
    input->blinked_ns = rests && !is_pair ? edge->time_ns : NEVER;
    input->reported_ns = edge->taken_ns;
    struct debounce_edge_time none;
    const bool turned = gpio_debounce_edge(debounce, edge->time_ns, !active, out);
    /* A null edge is processed as two edges with the same time, so no transition can complete
     * between them. */
    gpio_debounce_edge(debounce, edge->time_ns, active, &none);
    return turned;
}

bool gpio_edge_filter_edge(struct gpio_edge_filter *input, const struct gpio_edge *edge,
                           struct debounce_edge_time *out)
{
    const struct gpio_poll_edges *other = &input->other;
    const bool changes = edge->active != input->debounce.raw;
    CORE_ASSERT(input->accepted_ns != NEVER);
    input->lost += edge->lost_before;
    if (edge->time_ns <= input->accepted_ns) {
        /* The filter has already accepted a polled level that includes the effect of this edge.
         * Therefore the edge is ignored. */
        return false;
    }
    if (edge->lost_before == 0 && is_proof(other) && edge->time_ns <= other->since_ns &&
        (!changes || !has_conflict(other))) {
        return accept_late_pulse(input, edge->time_ns, out);
    }
    discard_polls(input, false);
    if (edge->lost_before == 0 && !changes) {
        return take_blink(input, edge, out);
    }
    input->blinked_ns = NEVER;
    return gpio_debounce_edge(&input->debounce, edge->time_ns, edge->active, out);
}

/* ---- Edge filter: levels that were read ------------------------------------------------------ */

bool gpio_edge_filter_level(struct gpio_edge_filter *input, uint64_t now_ns, bool active,
                            struct debounce_edge_time *out)
{
    CORE_ASSERT(out);
    struct gpio_poll_edges *other = &input->other;
    bool turned = false;
    if (active != input->debounce.raw) {
        if (!has_conflict(other)) {
            discard_polls(input, false);
            other->since_ns = now_ns;
        }
        other->last_ns = now_ns;
        if (now_ns - other->since_ns < GPIO_UNDER_WAY_NS) {
            return false;
        }
        turned = gpio_debounce_edge(&input->debounce, other->since_ns, active, out);
        input->accepted_ns = now_ns;
        input->blinked_ns = NEVER;
        input->lost++;
        *other = no_polls;
    } else if (has_conflict(other)) {
        other->back_ns = now_ns;
        if (!is_proof(other)) {
            *other = no_polls;
        }
    }
    return turned || gpio_debounce_settle(&input->debounce, now_ns, out);
}

uint64_t gpio_edge_filter_due_ns(const struct gpio_edge_filter *input)
{
    return has_conflict(&input->other) ? input->other.since_ns + GPIO_UNDER_WAY_NS
                                       : gpio_debounce_due_ns(&input->debounce);
}

uint64_t gpio_edge_filter_known_ns(const struct gpio_edge_filter *input, uint64_t now_ns)
{
    const struct debounce *debounce = &input->debounce;
    const uint64_t pending_ns = debounce->raw != debounce->stable ? debounce->since_ns : now_ns;
    const uint64_t known_ns = pending_ns < now_ns ? pending_ns : now_ns;
    return has_conflict(&input->other) && input->other.since_ns < known_ns ? input->other.since_ns
                                                                           : known_ns;
}

/* ---- Coins ---------------------------------------------------------------------------------- */

struct coin_mech gpio_coin_begin(uint64_t width_min_ns, uint64_t width_max_ns, bool active,
                                 uint64_t now_ns)
{
    CORE_ASSERT(width_min_ns <= width_max_ns);
    return (struct coin_mech){
        .width_min_ns = width_min_ns,
        .width_max_ns = width_max_ns,
        .begin_ns = now_ns,
        .state = active ? COIN_FALLS : COIN_IDLE,
        .ignored = active,
    };
}

static void classify_pulse(struct coin_mech *mech)
{
    CORE_ASSERT(mech->state == COIN_FELL);
    const uint64_t width_ns = mech->end_ns - mech->begin_ns;
    if (!mech->ignored && !mech->sticks) {
        if (width_ns < mech->width_min_ns) {
            mech->too_short++;
        } else {
            mech->coins++;
            mech->width_ns = width_ns;
        }
    }
    mech->state = COIN_IDLE;
    mech->ignored = mech->sticks = false;
}

uint64_t gpio_coin_due_ns(const struct coin_mech *mech)
{
    CORE_ASSERT(mech->state <= COIN_FELL);
    switch (mech->state) {
    case COIN_FALLS:
        return mech->sticks ? UINT64_MAX : mech->begin_ns + mech->width_max_ns + 1u;
    case COIN_FELL:
        return mech->end_ns + COIN_GAP_NS;
    default:
        return UINT64_MAX;
    }
}

void gpio_coin_settle(struct coin_mech *mech, uint64_t now_ns)
{
    if (now_ns < gpio_coin_due_ns(mech)) {
        return;
    }
    if (mech->state == COIN_FELL) {
        classify_pulse(mech);
    } else {
        CORE_ASSERT(mech->state == COIN_FALLS && !mech->sticks);
        mech->sticks = true;
        mech->stuck++;
    }
}

void gpio_coin_edge(struct coin_mech *mech, uint64_t time_ns, bool active)
{
    gpio_coin_settle(mech, time_ns);
    if (active && mech->state == COIN_IDLE) {
        mech->begin_ns = time_ns;
    }
    if (active) {
        /* A pulse that begins less than COIN_GAP_NS after the end of the previous pulse continues
         * the previous pulse. */
        mech->state = COIN_FALLS;
    } else if (mech->state == COIN_FALLS) {
        mech->state = COIN_FELL;
        mech->end_ns = time_ns;
    }
}

void gpio_coin_lose(struct coin_mech *mech)
{
    CORE_ASSERT(mech->state <= COIN_FELL);
    if (mech->state == COIN_FELL) {
        classify_pulse(mech);
        return;
    }
    mech->cut += mech->state == COIN_FALLS && !mech->ignored && !mech->sticks;
    mech->state = COIN_IDLE;
    mech->ignored = mech->sticks = false;
}

/* ---- Output pulses -------------------------------------------------------------------------- */

void gpio_pulses_add(struct pulse_train *train, uint32_t count)
{
    const uint32_t room = UINT32_MAX - train->left;
    train->left += count < room ? count : room;
}

uint64_t gpio_pulses_due_ns(const struct pulse_train *train)
{
    CORE_ASSERT(train);
    return train->on || train->left > 0 ? train->until_ns : UINT64_MAX;
}

bool gpio_pulses_at(struct pulse_train *train, uint64_t now_ns)
{
    if (now_ns < gpio_pulses_due_ns(train)) {
        return train->on;
    }
    CORE_ASSERT(train->on || train->left > 0);
    train->on = !train->on;
    train->left -= train->on;
    train->until_ns = now_ns + (train->on ? train->on_ns : train->off_ns);
    return train->on;
}
