/* solve.c -- computes exaggerated key shapes, so that a blended fish passes through every drawn
 * shape.
 *
 * A key shape (key) is one modelled growth stage. If a graph never gives key i the weight 1, the
 * fish never has exactly the drawn shape of key i. For example, TEMPLATE_SIMULTANEOUS gives an
 * inner key a weight of at most 0.7. In the 2005 thesis, the drawing is exaggerated by hand
 * until the blend is right. In this code, the drawn shape K_i is the true growth stage, and the
 * exaggerated shapes C_j, which are blended, are computed. M is the matrix of the graph's weights
 * at the progress of each key, and therefore K = M * C and C = M^-1 * K. For three keys S, T and U,
 * the exaggerated middle shape is T' = (T - 0.15 * (S + U)) / 0.7. The shapes C are never stored,
 * because blending C with the weights V equals blending K with the weights V * M^-1. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

/* Smallest pivot of the elimination. A smaller pivot would cause an exaggeration of more than ten
 * times, which is an error in the graph. */
#define PIVOT_MIN 0.1f

struct system {
    float left[MORPH_KEY_MAX][MORPH_KEY_MAX];
    float (*right)[MORPH_KEY_MAX];
};

static void swap_rows(float *a, float *b, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const float kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

/* Subtracts `factor` times the row `from` from the row `row`. */
static void subtract_row(float *row, const float *from, float factor, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        row[i] -= factor * from[i];
    }
}

/* Performs one Gauss-Jordan step on a column, with its largest remaining value as the pivot.
 * Returns false if the pivot is below PIVOT_MIN. */
static bool clear_column(struct system *s, uint32_t column, uint32_t count)
{
    uint32_t pivot = column;
    for (uint32_t row = column + 1; row < count; row++) {
        pivot = f_abs(s->left[row][column]) > f_abs(s->left[pivot][column]) ? row : pivot;
    }
    if (!(f_abs(s->left[pivot][column]) >= PIVOT_MIN)) {
        return false;
    }
    swap_rows(s->left[pivot], s->left[column], count);
    swap_rows(s->right[pivot], s->right[column], count);
    const float scale = s->left[column][column];
    for (uint32_t i = 0; i < count; i++) {
        s->left[column][i] /= scale;
        s->right[column][i] /= scale;
    }
    for (uint32_t row = 0; row < count; row++) {
        if (row != column) {
            const float factor = s->left[row][column];
            subtract_row(s->left[row], s->left[column], factor, count);
            subtract_row(s->right[row], s->right[column], factor, count);
        }
    }
    return true;
}

bool solve_graph(const struct graph *graph, uint32_t key_count,
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
