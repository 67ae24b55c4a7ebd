/* graph.c -- checks, evaluates, solves and writes deformation graphs, which give the weight of each
 * key shape (modelled growth stage) as a fish grows. */
#include "core/morph/morph.h"

#include <stddef.h>

#include "core/base/panic.h"
#include "core/morph/cubic.h"

#define SUM_ERROR_MAX 1e-6f
/* Smallest pivot of the Gauss-Jordan elimination that computes the exaggerated key shapes. A
 * smaller pivot would cause an exaggeration of more than ten times, which is an error in the
 * graph. */
#define PIVOT_MIN 0.1f

static struct graph_verdict check_knot(const struct graph *graph, uint32_t key_count, uint8_t index)
{
    const struct graph_knot *knot = &graph->knots[index];
    float sum = 0.0f;
    if (!f_is_finite(knot->progress) || (index > 0 && !(knot->progress > knot[-1].progress))) {
        return (struct graph_verdict){ GRAPH_ORDER, index, 0, knot->progress };
    }
    for (uint32_t key = 0; key < key_count; key++) {
        if (!(knot->weight[key] >= 0.0f)) {
            return (struct graph_verdict){ GRAPH_NEGATIVE, index, (uint8_t)key, knot->weight[key] };
        }
        sum += knot->weight[key];
    }
    if (!(f_abs(sum - 1.0f) <= SUM_ERROR_MAX)) {
        return (struct graph_verdict){ GRAPH_SUM, index, 0, sum };
    }
    return (struct graph_verdict){ GRAPH_GOOD, 0, 0, 0.0f };
}

struct graph_verdict graph_check(const struct graph *graph, uint32_t key_count)
{
    CORE_ASSERT(key_count >= 2 && key_count <= MORPH_KEY_MAX);
    if (graph->knot_count < 2 || graph->knot_count > GRAPH_KNOT_MAX) {
        return (struct graph_verdict){ GRAPH_KNOT_COUNT, 0, 0, (float)graph->knot_count };
    }
    for (uint8_t i = 0; i < graph->knot_count; i++) {
        const struct graph_verdict verdict = check_knot(graph, key_count, i);
        if (verdict.fault != GRAPH_GOOD) {
            return verdict;
        }
    }
    const uint8_t end = graph->knots[0].progress != 0.0f ? 0 : (uint8_t)(graph->knot_count - 1u);
    if (graph->knots[end].progress != (end == 0 ? 0.0f : 1.0f)) {
        return (struct graph_verdict){ GRAPH_ENDS, end, 0, graph->knots[end].progress };
    }
    float solution[MORPH_KEY_MAX][MORPH_KEY_MAX];
    uint32_t stuck = 0;
    if (graph->solved && !graph_solve(graph, key_count, solution, &stuck)) {
        return (struct graph_verdict){ GRAPH_UNSOLVABLE, 0, (uint8_t)stuck, 0.0f };
    }
    return (struct graph_verdict){ GRAPH_GOOD, 0, 0, 0.0f };
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
        /* The interpolation returns exactly the weights of a knot at that knot. A result is
         * negative only if a knot has a negative weight. */
        weights[i] = i < key_count ? from->weight[i] * (1.0f - t) + to->weight[i] * t : 0.0f;
    }
}

void graph_weights(const struct graph *graph, uint32_t key_count, float progress,
                   float weights[MORPH_KEY_MAX])
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    CORE_ASSERT(graph->knot_count >= 2 && graph->knot_count <= GRAPH_KNOT_MAX);
    CORE_ASSERT(key_count >= 1 && key_count <= MORPH_KEY_MAX);
    if (graph->line != GRAPH_SMOOTH) {
        straight_weights(graph, key_count, progress, weights);
        return;
    }
    float sum = 0.0f;
    for (uint32_t key = 0; key < key_count; key++) {
        struct cubic_point points[GRAPH_KNOT_MAX];
        for (uint32_t i = 0; i < graph->knot_count; i++) {
            const struct graph_knot *knot = &graph->knots[i];
            points[i] = (struct cubic_point){ knot->progress, knot->weight[key] };
        }
        /* A monotone cubic curve through weights is never negative except by rounding errors, which
         * the lower limit removes. */
        weights[key] = f_max(cubic_curve(points, graph->knot_count, progress, NULL), 0.0f);
        sum += weights[key];
    }
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        weights[i] = i < key_count ? weights[i] / sum : 0.0f;
    }
}

/* ---- Exaggerated key shapes ----------------------------------------------------------------- */

/* For a solved graph, the code exaggerates the key shapes, so that the blended fish passes through
 * every drawn shape. If a graph never gives key i the weight 1, the fish never has exactly the
 * drawn shape of key i. For example, TEMPLATE_SIMULTANEOUS gives an inner key a weight of at most
 * 0.7.
 *
 * In the 2005 thesis, the artist exaggerates the drawing by hand until the blended fish has the
 * desired shape. In this code, the drawn shape K_i is the true growth stage, and the exaggerated
 * shapes C_j are computed and blended.
 *
 * M is the matrix of the graph's weights at the progress of each key. Therefore K = M * C and
 * C = M^-1 * K. For three keys S, T and U, the exaggerated middle shape is
 * T' = (T - 0.15 * (S + U)) / 0.7.
 *
 * The shapes C are never stored, because blending C with the weights V equals blending K with the
 * weights V * M^-1. */
struct system {
    float left[MORPH_KEY_MAX][MORPH_KEY_MAX];
    float (*right)[MORPH_KEY_MAX];
};

/* Performs one Gauss-Jordan step on a column, with its largest remaining value as the pivot.
 * Returns false if the pivot is below PIVOT_MIN. */
static bool clear_column(struct system *s, uint32_t column, uint32_t count)
{
    uint32_t pivot = column;
    CORE_ASSERT(column < count && count <= MORPH_KEY_MAX);
    for (uint32_t row = column + 1; row < count; row++) {
        pivot = f_abs(s->left[row][column]) > f_abs(s->left[pivot][column]) ? row : pivot;
    }
    const float scale = s->left[pivot][column];
    if (!(f_abs(scale) >= PIVOT_MIN)) {
        return false;
    }
    /* Swaps the rows `pivot` and `column`, and divides the row `column` by the pivot. */
    for (uint32_t i = 0; i < count; i++) {
        const float left = s->left[pivot][i], right = s->right[pivot][i];
        s->left[pivot][i] = s->left[column][i];
        s->right[pivot][i] = s->right[column][i];
        s->left[column][i] = left / scale;
        s->right[column][i] = right / scale;
    }
    for (uint32_t row = 0; row < count; row++) {
        const float factor = s->left[row][column];
        for (uint32_t i = 0; row != column && i < count; i++) {
            s->left[row][i] -= factor * s->left[column][i];
            s->right[row][i] -= factor * s->right[column][i];
        }
    }
    return true;
}

bool graph_solve(const struct graph *graph, uint32_t key_count,
                 float solution[MORPH_KEY_MAX][MORPH_KEY_MAX], uint32_t *stuck)
{
    struct system system = { .right = solution };
    CORE_ASSERT(key_count >= 2 && key_count <= MORPH_KEY_MAX);
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        for (uint32_t j = 0; j < MORPH_KEY_MAX; j++) {
            solution[i][j] = i == j && i < key_count ? 1.0f : 0.0f;
        }
        if (i < key_count) {
            graph_weights(graph, key_count, (float)i / (float)(key_count - 1), system.left[i]);
        }
    }
    for (uint32_t column = 0; column < key_count; column++) {
        if (!clear_column(&system, column, key_count)) {
            *stuck = column;
            return false;
        }
    }
    return true;
}

/* ---- Standard graphs (2005 thesis, figures 3.8 and 3.9) ------------------------------------- */

void graph_from_template(struct graph *graph, enum graph_template template_id, uint32_t key_count,
                         float peak)
{
    CORE_ASSERT(key_count >= 2 && key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(template_id > TEMPLATE_OWN && template_id < TEMPLATE_COUNT);
    CORE_ASSERT(peak > 0.5f && peak <= 1.0f);
    *graph = (struct graph){ 0 };
    if (template_id == TEMPLATE_ORDINARY) {
        graph->knot_count = 2;
        graph->knots[0].weight[0] = 1.0f;
        graph->knots[1].progress = 1.0f;
        graph->knots[1].weight[key_count - 1] = 1.0f;
        return;
    }
    /* Adds one knot for each key. At its own knot, an inner key has the weight `own`, and each of
     * its two neighbours has the weight (1 - own) / 2. The first and the last key have the weight 1
     * at their own knots. For TEMPLATE_SMOOTH, the weights at an inner knot are 1/6, 4/6 and 1/6,
     * as for a cubic B-spline. */
    const float own = template_id == TEMPLATE_PAIRWISE       ? 1.0f
                      : template_id == TEMPLATE_SIMULTANEOUS ? peak
                                                             : 2.0f / 3.0f;
    graph->knot_count = (uint8_t)key_count;
    graph->line = template_id == TEMPLATE_PAIRWISE ? GRAPH_STRAIGHT : GRAPH_SMOOTH;
    graph->solved = template_id != TEMPLATE_PAIRWISE;
    for (uint32_t i = 0; i < key_count; i++) {
        struct graph_knot *knot = &graph->knots[i];
        const bool inner = i > 0 && i < key_count - 1;
        knot->progress = (float)i / (float)(key_count - 1);
        knot->weight[i] = inner ? own : 1.0f;
        if (inner) {
            knot->weight[i - 1] = knot->weight[i + 1] = 0.5f * (1.0f - own);
        }
    }
}
