/* template.c -- writes standard deformation graphs (2005 thesis, figures 3.8 and 3.9). */
#include "core/morph/morph.h"

#include "core/base/panic.h"

static void ordinary(struct graph *graph, uint32_t key_count)
{
    graph->knot_count = 2;
    graph->knots[0].weight[0] = 1.0f;
    graph->knots[1].progress = 1.0f;
    graph->knots[1].weight[key_count - 1] = 1.0f;
}

/* Adds one knot for each key. At its own knot, an inner key has the weight `peak`, and each of its
 * two neighbours has the weight (1 - peak) / 2. The first and the last key have the weight 1 at
 * their own knots. */
static void hats(struct graph *graph, uint32_t key_count, float peak)
{
    graph->knot_count = (uint8_t)key_count;
    for (uint32_t i = 0; i < key_count; i++) {
        struct graph_knot *knot = &graph->knots[i];
        const bool inner = i > 0 && i < key_count - 1;
        knot->progress = (float)i / (float)(key_count - 1);
        knot->weight[i] = inner ? peak : 1.0f;
        if (inner) {
            knot->weight[i - 1] = 0.5f * (1.0f - peak);
            knot->weight[i + 1] = 0.5f * (1.0f - peak);
        }
    }
}

void template_graph(struct graph *graph, enum graph_template template_id, uint32_t key_count,
                    float peak)
{
    CORE_ASSERT(key_count >= 2 && key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(template_id > TEMPLATE_OWN && template_id < TEMPLATE_COUNT);
    CORE_ASSERT(peak > 0.5f && peak <= 1.0f);
    *graph = (struct graph){ 0 };
    switch (template_id) {
    case TEMPLATE_ORDINARY:
        ordinary(graph, key_count);
        break;
    case TEMPLATE_PAIRWISE:
        hats(graph, key_count, 1.0f);
        break;
    case TEMPLATE_SIMULTANEOUS:
        hats(graph, key_count, peak);
        graph->line = GRAPH_SMOOTH;
        graph->solved = 1;
        break;
    default:
        hats(graph, key_count, 2.0f / 3.0f); /* The weights at an inner knot are 1/6, 4/6 and 1/6,
                                                as for a cubic B-spline. */
        graph->line = GRAPH_SMOOTH;
        graph->solved = 1;
        break;
    }
}
