/* rig.c -- prepares the deformation graphs of a fish, and computes the weights of its drawn keys
 * from the graphs. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

static void unit_solution(float solution[MORPH_KEY_MAX][MORPH_KEY_MAX])
{
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        for (uint32_t j = 0; j < MORPH_KEY_MAX; j++) {
            solution[i][j] = i == j ? 1.0f : 0.0f;
        }
    }
}

void morph_rig_init(struct morph_rig *rig, const struct species_card *card,
                    enum graph_template template_id)
{
    CORE_ASSERT(card->curve_count >= 1 && card->curve_count <= MORPH_CURVE_MAX);
    *rig = (struct morph_rig){ .key_count = card->key_count, .curve_count = card->curve_count };
    for (uint32_t curve = 0; curve < card->curve_count; curve++) {
        struct graph *graph = &rig->curves[curve];
        uint32_t stuck;
        *graph = card->curves[curve];
        if (template_id != TEMPLATE_OWN) {
            template_graph(graph, template_id, card->key_count, SIMULTANEOUS_PEAK);
        }
        if (!graph->solved || !solve_graph(graph, card->key_count, rig->solution[curve], &stuck)) {
            unit_solution(rig->solution[curve]);
            graph->solved = 0;
        }
    }
}

/* Converts the weights of the exaggerated key shapes to weights of the drawn keys by multiplication
 * with the matrix `solution` (M^-1 in solve.c). At the progress of key i, key i gets exactly the
 * weight 1, without rounding errors. */
static void solve_weights(const struct morph_rig *rig, uint32_t curve, float progress,
                          float weights[MORPH_KEY_MAX])
{
    const float last = (float)(rig->key_count - 1u);
    float drawn[MORPH_KEY_MAX] = { 0 };
    for (uint32_t j = 0; j < rig->key_count; j++) {
        for (uint32_t i = 0; i < rig->key_count; i++) {
            drawn[j] += weights[i] * rig->solution[curve][i][j];
        }
    }
    for (uint32_t key = 0; key < rig->key_count; key++) {
        if (progress == (float)key / last) {
            for (uint32_t j = 0; j < rig->key_count; j++) {
                drawn[j] = j == key ? 1.0f : 0.0f;
            }
        }
    }
    for (uint32_t j = 0; j < rig->key_count; j++) {
        weights[j] = drawn[j];
    }
}

void morph_weights(const struct morph_rig *rig, float progress,
                   float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX])
{
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        const uint32_t from = curve < rig->curve_count ? curve : 0;
        graph_weights(&rig->curves[from], rig->key_count, progress, weights[curve]);
        if (rig->curves[from].solved) {
            solve_weights(rig, from, progress, weights[curve]);
        }
    }
}
