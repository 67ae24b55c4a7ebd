/* coin.c -- fuzz target: arbitrary edges of a coin line, polled at arbitrary times. The decoder
 * must count the same coins and faults as a reference decoder, which has the complete list of
 * edges.
 *
 * The input begins with four bytes: the debounce period in 0.1 ms, the smallest pulse width of a
 * coin in ms, the range of valid widths above it in ms, and the first level of the line. Two bytes
 * follow for each edge, the low byte first. Their bits, from the lowest, are 13 bits of time since
 * the last edge in units of 50 us, one bit for a poll just before the edge, one bit for a poll just
 * after the edge, and the new level. */
#include "drivers/gpio/gpio_thread.h"
#include "tests/fuzz/trap.h"

#define EDGE_MAX 2048u
#define TIME_NS 50000u
#define HOUR_NS 3600000000000ull

struct edge {
    uint64_t time_ns;
    bool active, looks_before, looks_after;
};

struct tally {
    uint32_t coins, too_short, stuck;
};

struct slot {
    uint64_t period_ns, width_min_ns, width_max_ns, begin_ns, end_ns;
    bool active;
    uint32_t edge_count;
    struct edge edge[EDGE_MAX];
};

/* ---- Reference: the complete list of edges -------------------------------------------------- */

static uint32_t turns_of(const struct slot *slot, struct debounce_edge_time turn[EDGE_MAX])
{
    bool stable = slot->active, raw = slot->active;
    uint64_t since_ns = slot->begin_ns;
    uint32_t count = 0;
    for (uint32_t i = 0; i <= slot->edge_count; i++) {
        const bool is_end = i == slot->edge_count;
        const uint64_t now_ns = is_end ? slot->end_ns : slot->edge[i].time_ns;
        if (raw != stable && now_ns - since_ns >= slot->period_ns) {
            stable = raw;
            turn[count++] = (struct debounce_edge_time){ .time_ns = since_ns, .active = raw };
        }
        if (!is_end && slot->edge[i].active != raw) {
            raw = slot->edge[i].active;
            since_ns = now_ns;
        }
    }
    return count;
}

static void check_coin(const struct slot *slot, struct tally *tally, uint64_t begin_ns,
                       uint64_t end_ns, bool is_first, bool is_over)
{
    const uint64_t width_ns = end_ns - begin_ns;
    if (width_ns > slot->width_max_ns) {
        tally->stuck++;
    } else if (is_over && !(is_first && slot->active)) {
        *(width_ns < slot->width_min_ns ? &tally->too_short : &tally->coins) += 1u;
    }
}

static struct tally count_all(const struct slot *slot)
{
    static struct debounce_edge_time turn[EDGE_MAX];
    const uint32_t count = turns_of(slot, turn);
    struct tally tally = { 0 };
    bool falls = slot->active, is_first = true;
    uint64_t begin_ns = slot->begin_ns, fell_ns = 0;
    /* True after a pulse that began at `fell_ns` has ended, as long as the pulse may still continue
     * after a gap shorter than COIN_GAP_NS. */
    bool waits = false;
    for (uint32_t i = 0; i < count; i++) {
        if (!turn[i].active) {
            fell_ns = turn[i].time_ns;
            falls = false;
            waits = true;
            continue;
        }
        if (waits && turn[i].time_ns - fell_ns >= COIN_GAP_NS) {
            check_coin(slot, &tally, begin_ns, fell_ns, is_first, true);
            waits = false;
        }
        if (!waits) {
            is_first = i == 0 && slot->active;
            begin_ns = turn[i].time_ns;
        }
        waits = false;
        falls = true;
    }
    if (waits || falls) {
        check_coin(slot, &tally, begin_ns, falls ? slot->end_ns : fell_ns, is_first, waits);
    }
    return tally;
}

/* ---- Decoder: edges as they arrive ---------------------------------------------------------- */

static void take(struct coin_mech *mech, bool turned, const struct debounce_edge_time *turn,
                 struct debounce_edge_time *last)
{
    if (turned) {
        HOLD(turn->active != last->active && turn->time_ns >= last->time_ns);
        gpio_coin_edge(mech, turn->time_ns, turn->active);
        *last = *turn;
    }
}

static void look(struct coin_mech *mech, struct debounce *line, uint64_t now_ns,
                 struct debounce_edge_time *last)
{
    struct debounce_edge_time turn;
    take(mech, gpio_debounce_settle(line, now_ns, &turn), &turn, last);
    gpio_coin_settle(mech, line->raw != line->stable ? line->since_ns : now_ns);
}

static struct tally count_live(const struct slot *slot)
{
    struct debounce line = gpio_debounce_begin(slot->period_ns, slot->active, slot->begin_ns);
    struct coin_mech mech =
        gpio_coin_begin(slot->width_min_ns, slot->width_max_ns, slot->active, slot->begin_ns);
    struct debounce_edge_time turn, last = { .time_ns = slot->begin_ns, .active = slot->active };
    for (uint32_t i = 0; i < slot->edge_count; i++) {
        const struct edge *edge = &slot->edge[i];
        if (edge->looks_before) {
            look(&mech, &line, edge->time_ns, &last);
        }
        take(&mech, gpio_debounce_edge(&line, edge->time_ns, edge->active, &turn), &turn, &last);
        if (edge->looks_after) {
            look(&mech, &line, edge->time_ns, &last);
        }
    }
    look(&mech, &line, slot->end_ns, &last);
    HOLD(gpio_coin_due_ns(&mech) == UINT64_MAX || mech.state == COIN_IDLE);
    HOLD(mech.cut == 0 && gpio_coin_faults(&mech) == mech.too_short + mech.stuck);
    return (struct tally){ mech.coins, mech.too_short, mech.stuck };
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct slot slot;
    if (size < 4u) {
        return 0;
    }
    slot.period_ns = bytes[0] * 100000ull;
    slot.width_min_ns = bytes[1] * 1000000ull;
    slot.width_max_ns = slot.width_min_ns + bytes[2] * 1000000ull;
    slot.active = bytes[3] & 1u;
    slot.begin_ns = slot.end_ns = 1000000000u;
    slot.edge_count = 0;
    for (size_t at = 4; at + 1u < size && slot.edge_count < EDGE_MAX; at += 2) {
        const uint32_t word = (uint32_t)(bytes[at] | bytes[at + 1u] << 8);
        slot.end_ns += (word & 0x1fffu) * TIME_NS;
        slot.edge[slot.edge_count++] = (struct edge){
            .time_ns = slot.end_ns,
            .looks_before = (word >> 13 & 1u) != 0,
            .looks_after = (word >> 14 & 1u) != 0,
            .active = word >> 15 != 0,
        };
    }
    slot.end_ns += HOUR_NS;
    const struct tally all = count_all(&slot), live = count_live(&slot);
    HOLD(all.coins == live.coins && all.too_short == live.too_short && all.stuck == live.stuck);
    return 0;
}
