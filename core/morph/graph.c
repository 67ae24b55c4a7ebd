/* graph.c -- evaluates deformation graphs, which give the weight of each key shape (modelled growth
 * stage) as a fish grows. */
#include "core/morph/morph.h"

#include "core/base/panic.h"
#include "core/morph/cubic.h"

#define SUM_ERROR_MAX 1e-6f

static struct graph_verdict check_knot(const struct graph *graph, uint32_t key_count,
                                       uint32_t index)
{
    const struct graph_knot *knot = &graph->knots[index];
    float sum = 0.0f;
    if (!f_is_finite(knot->progress) || (index > 0 && !(knot->progress > knot[-1].progress))) {
        return (struct graph_verdict){ GRAPH_ORDER, (uint8_t)index, 0, knot->progress };
    }
    for (uint32_t key = 0; key < key_count; key++) {
        if (!(knot->weight[key] >= 0.0f)) {
            return (struct graph_verdict){ GRAPH_NEGATIVE, (uint8_t)index, (uint8_t)key,
                                           knot->weight[key] };
        }
        sum += knot->weight[key];
    }
    if (!(f_abs(sum - 1.0f) <= SUM_ERROR_MAX)) {
        return (struct graph_verdict){ GRAPH_SUM, (uint8_t)index, 0, sum };
    }
    return (struct graph_verdict){ GRAPH_GOOD, 0, 0, 0.0f };
}

struct graph_verdict graph_check(const struct graph *graph, uint32_t key_count)
{
    CORE_ASSERT(key_count >= 2 && key_count <= MORPH_KEY_MAX);
    if (graph->knot_count < 2 || graph->knot_count > GRAPH_KNOT_MAX) {
        return (struct graph_verdict){ GRAPH_KNOT_COUNT, 0, 0, (float)graph->knot_count };
    }
    const uint32_t last = graph->knot_count - 1u;
    for (uint32_t i = 0; i <= last; i++) {
        const struct graph_verdict verdict = check_knot(graph, key_count, i);
        if (verdict.fault != GRAPH_GOOD) {
            return verdict;
        }
    }
    if (graph->knots[0].progress != 0.0f || graph->knots[last].progress != 1.0f) {
        const uint32_t knot = graph->knots[0].progress != 0.0f ? 0 : last;
        return (struct graph_verdict){ GRAPH_ENDS, (uint8_t)knot, 0, graph->knots[knot].progress };
    }
    float solution[MORPH_KEY_MAX][MORPH_KEY_MAX];
    uint32_t stuck = 0;
    if (graph->solved && !solve_graph(graph, key_count, solution, &stuck)) {
        return (struct graph_verdict){ GRAPH_UNSOLVABLE, 0, (uint8_t)stuck, 0.0f };
    }
    return (struct graph_verdict){ GRAPH_GOOD, 0, 0, 0.0f };
}

static float smooth_weight(const struct graph *graph, uint32_t key, float progress)
{
    struct cubic_point points[GRAPH_KNOT_MAX];
    for (uint32_t i = 0; i < graph->knot_count; i++) {
        points[i] = (struct cubic_point){ graph->knots[i].progress, graph->knots[i].weight[key] };
    }
    /* A monotone cubic curve through weights is never negative except by rounding errors, which the
     * clamp removes. */
    return f_max(cubic_curve(points, graph->knot_count, progress), 0.0f);
}

static void smooth_weights(const struct graph *graph, uint32_t key_count, float progress,
                           float weights[MORPH_KEY_MAX])
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < key_count; i++) {
        weights[i] = smooth_weight(graph, i, progress);
        sum += weights[i];
    }
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        weights[i] = i < key_count ? weights[i] / sum : 0.0f;
    }
}

static void straight_weights(const struct graph *graph, uint32_t key_count, float progress,
                             float weights[MORPH_KEY_MAX])
{
    uint32_t next = 1;
    while (next + 1u < graph->knot_count && progress > graph->knots[next].progress) {
        next++;
    }
    const struct graph_knot *from = &graph->knots[next - 1], *to = &graph->knots[next];
    const float t =
        f_clamp((progress - from->progress) / (to->progress - from->progress), 0.0f, 1.0f);
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        /* The interpolation gives exact values at both knots. The result is negative only if a knot
         * has a negative weight. */
        weights[i] = i < key_count ? from->weight[i] * (1.0f - t) + to->weight[i] * t : 0.0f;
    }
}

void graph_weights(const struct graph *graph, uint32_t key_count, float progress,
                   float weights[MORPH_KEY_MAX])
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    CORE_ASSERT(graph->knot_count >= 2 && graph->knot_count <= GRAPH_KNOT_MAX);
    if (graph->line == GRAPH_SMOOTH) {
        smooth_weights(graph, key_count, progress, weights);
    } else {
        straight_weights(graph, key_count, progress, weights);
    }
}
