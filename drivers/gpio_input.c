/* gpio_input.c -- edges by their times, blinks in pairs, and the level as the last word. */
#include "drivers/gpio_input.h"

#define NEVER UINT64_MAX

struct gpio_input gpio_input_begin(uint64_t debounce_ns, bool active, uint64_t now_ns)
{
    return (struct gpio_input){
        .debounce = debounce_begin(debounce_ns, active, now_ns),
        .blinked_ns = NEVER,
        .doubted_ns = NEVER,
    };
}

/* The line left its level and was back before the kernel looked. */
static bool take_blink(struct gpio_input *input, uint64_t time_ns, struct debounce_turn *out)
{
    struct debounce *debounce = &input->debounce;
    const bool active = debounce->raw;
    if (debounce->period_ns == 0 || time_ns <= input->mended_ns) {
        return false; /* No bounce to be seen; or the edge that was missed when it was mended. */
    }
    if (input->blinked_ns != NEVER) { /* The second: a pulse between the two. */
        const uint64_t begin_ns = input->blinked_ns;
        input->blinked_ns = NEVER;
        input->late++;
        debounce_edge(debounce, begin_ns, !active, out); /* It settled up to there before. */
        return debounce_edge(debounce, time_ns, active, out);
    }
    input->blinked_ns = time_ns;
    const bool turned = debounce_edge(debounce, time_ns, !active, out);
    struct debounce_turn none;
    debounce_edge(debounce, time_ns, active, &none); /* At the same time: nothing can settle. */
    return turned;
}

bool gpio_input_edge(struct gpio_input *input, const struct gpio_edge *edge,
                     struct debounce_turn *out)
{
    const bool active = edge->active != 0;
    input->lost += edge->lost_before;
    input->doubted_ns = NEVER;
    if (edge->lost_before == 0 && active == input->debounce.raw) {
        return take_blink(input, edge->time_ns, out);
    }
    input->blinked_ns = NEVER;
    return debounce_edge(&input->debounce, edge->time_ns, active, out);
}

/* Whether a second edge could still make a pulse of the one that changed nothing. It is dated when
 * the kernel read the first, which was before anybody saw that. */
static bool may_be_pair(const struct gpio_input *input, uint64_t now_ns)
{
    const uint64_t seen_ns = input->doubted_ns == NEVER ? now_ns : input->doubted_ns;
    return input->blinked_ns != NEVER &&
           seen_ns >= input->blinked_ns + input->debounce.period_ns;
}

/* The level was in doubt for so long that no edge can explain it any more. */
static bool mend(struct gpio_input *input, uint64_t now_ns, bool active, struct debounce_turn *out)
{
    const uint64_t since_ns = input->doubted_ns;
    input->mended_ns = now_ns;
    input->lost++;
    return debounce_edge(&input->debounce, since_ns, active, out);
}

bool gpio_input_level(struct gpio_input *input, uint64_t now_ns, bool active,
                      struct debounce_turn *out)
{
    const bool disagrees = active != input->debounce.raw;
    bool turned = false;
    if (disagrees || may_be_pair(input, now_ns)) {
        input->doubted_ns = input->doubted_ns == NEVER ? now_ns : input->doubted_ns;
        if (now_ns - input->doubted_ns < GPIO_UNDER_WAY_NS) {
            return false;
        }
        turned = disagrees && mend(input, now_ns, active, out);
    }
    input->blinked_ns = input->doubted_ns = NEVER;
    return turned || debounce_settle(&input->debounce, now_ns, out);
}

uint64_t gpio_input_due_ns(const struct gpio_input *input)
{
    if (input->doubted_ns != NEVER) {
        return input->doubted_ns + GPIO_UNDER_WAY_NS;
    }
    return input->blinked_ns != NEVER ? input->blinked_ns : debounce_due_ns(&input->debounce);
}

uint64_t gpio_input_known_ns(const struct gpio_input *input, uint64_t now_ns)
{
    const struct debounce *debounce = &input->debounce;
    const uint64_t doubts_ns[] = {
        debounce->raw != debounce->stable ? debounce->since_ns : NEVER,
        input->blinked_ns,
        input->doubted_ns,
    };
    uint64_t known_ns = now_ns;
    for (uint32_t i = 0; i < sizeof doubts_ns / sizeof doubts_ns[0]; i++) {
        known_ns = doubts_ns[i] < known_ns ? doubts_ns[i] : known_ns;
    }
    return known_ns;
}
