/* gpio_input.c -- edges by their times, and the level as the last word. */
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

/* A pulse from the blink before to this one: both were read when it was over. */
static bool take_pair(struct gpio_input *input, uint64_t end_ns, struct debounce_turn *out)
{
    struct debounce *debounce = &input->debounce;
    const bool active = debounce->raw;
    const uint64_t begin_ns = input->blinked_ns;
    input->blinked_ns = NEVER;
    input->pairs++;
    debounce_edge(debounce, begin_ns, !active, out); /* Out of rest: nothing is to be settled. */
    return debounce_edge(debounce, end_ns, active, out);
}

/* The line left its level and was back before the kernel looked: what stood, stands anew. */
static bool take_blink(struct gpio_input *input, const struct gpio_edge *edge,
                       struct debounce_turn *out)
{
    struct debounce *debounce = &input->debounce;
    if (debounce->period_ns == 0) {
        return false; /* What the kernel debounced does not blink. */
    }
    input->blinks++;
    if (input->blinked_ns != NEVER && edge->time_ns <= input->seen_ns + GPIO_PAIR_NS) {
        return take_pair(input, edge->time_ns, out);
    }
    const bool active = debounce->raw;
    const bool rests = !active && !debounce->stable &&
                       edge->time_ns >= debounce->since_ns + GPIO_UNDER_WAY_NS;
    input->blinked_ns = rests ? edge->time_ns : NEVER;
    input->seen_ns = edge->taken_ns;
    struct debounce_turn none;
    const bool turned = debounce_edge(debounce, edge->time_ns, !active, out);
    debounce_edge(debounce, edge->time_ns, active, &none); /* At once: nothing can settle. */
    return turned;
}

bool gpio_input_edge(struct gpio_input *input, const struct gpio_edge *edge,
                     struct debounce_turn *out)
{
    const bool active = edge->active != 0;
    input->lost += edge->lost_before;
    input->doubted_ns = NEVER;
    if (edge->lost_before == 0 && active == input->debounce.raw) {
        return take_blink(input, edge, out);
    }
    input->blinked_ns = NEVER;
    return debounce_edge(&input->debounce, edge->time_ns, active, out);
}

bool gpio_input_level(struct gpio_input *input, uint64_t now_ns, bool active,
                      struct debounce_turn *out)
{
    bool turned = false;
    if (active != input->debounce.raw) {
        input->doubted_ns = input->doubted_ns == NEVER ? now_ns : input->doubted_ns;
        if (now_ns - input->doubted_ns < GPIO_UNDER_WAY_NS) {
            return false;
        }
        turned = debounce_edge(&input->debounce, input->doubted_ns, active, out);
        input->blinked_ns = NEVER;
        input->lost++;
    }
    input->doubted_ns = NEVER;
    return turned || debounce_settle(&input->debounce, now_ns, out);
}

uint64_t gpio_input_due_ns(const struct gpio_input *input)
{
    return input->doubted_ns != NEVER ? input->doubted_ns + GPIO_UNDER_WAY_NS
                                      : debounce_due_ns(&input->debounce);
}

uint64_t gpio_input_known_ns(const struct gpio_input *input, uint64_t now_ns)
{
    const struct debounce *debounce = &input->debounce;
    const uint64_t pending_ns = debounce->raw != debounce->stable ? debounce->since_ns : now_ns;
    const uint64_t known_ns = pending_ns < now_ns ? pending_ns : now_ns;
    return input->doubted_ns < known_ns ? input->doubted_ns : known_ns;
}
