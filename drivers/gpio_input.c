/* gpio_input.c -- edges by their times, direction by turns, and the level as the last word. */
#include "drivers/gpio_input.h"

struct gpio_input gpio_input_begin(uint64_t debounce_ns, bool active, uint64_t now_ns)
{
    return (struct gpio_input){
        .debounce = debounce_begin(debounce_ns, active, now_ns),
        .disagrees_ns = UINT64_MAX,
    };
}

bool gpio_input_edge(struct gpio_input *input, const struct gpio_edge *edge,
                     struct debounce_turn *out)
{
    bool active = edge->active != 0;
    input->lost += edge->lost_before;
    if (edge->lost_before == 0 && active == input->debounce.raw) {
        if (edge->time_ns <= input->mended_ns) {
            return false; /* The one that was missed when the level was believed. */
        }
        active = !active;
        input->turned++;
    }
    input->disagrees_ns = UINT64_MAX;
    return debounce_edge(&input->debounce, edge->time_ns, active, out);
}

bool gpio_input_level(struct gpio_input *input, uint64_t now_ns, bool active,
                      struct debounce_turn *out)
{
    if (active == input->debounce.raw) {
        input->disagrees_ns = UINT64_MAX;
        return debounce_settle(&input->debounce, now_ns, out);
    }
    if (input->disagrees_ns == UINT64_MAX) {
        input->disagrees_ns = now_ns;
    }
    if (now_ns - input->disagrees_ns < GPIO_UNDER_WAY_NS) {
        return false;
    }
    const uint64_t since_ns = input->disagrees_ns;
    input->disagrees_ns = UINT64_MAX;
    input->mended_ns = now_ns;
    input->lost++;
    return debounce_edge(&input->debounce, since_ns, active, out);
}

uint64_t gpio_input_due_ns(const struct gpio_input *input)
{
    if (input->disagrees_ns != UINT64_MAX) {
        return input->disagrees_ns + GPIO_UNDER_WAY_NS;
    }
    return debounce_due_ns(&input->debounce);
}
