/* test_graph.c -- checks morph graphs, which give the blend weight of each key shape: the sum of
 * the weights, the curves, the templates and the solved key shapes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/morph/morph.h"

#define STEPS 1000

static const enum graph_template templates[] = { TEMPLATE_ORDINARY, TEMPLATE_PAIRWISE,
                                                 TEMPLATE_SIMULTANEOUS, TEMPLATE_SMOOTH };
#define TEMPLATES (sizeof templates / sizeof templates[0])

static struct graph graph_of(enum graph_template template_id, uint32_t key_count)
{
    struct graph graph;
    graph_from_template(&graph, template_id, key_count, SIMULTANEOUS_PEAK);
    return graph;
}

static struct species_card card_of(const struct graph *graph, uint32_t key_count)
{
    struct species_card card = { .key_count = (uint8_t)key_count, .curve_count = 1 };
    card.curves[0] = *graph;
    return card;
}

static struct morph_rig rig_of(const struct graph *graph, uint32_t key_count)
{
    const struct species_card card = card_of(graph, key_count);
    struct morph_rig rig;
    morph_rig_init(&rig, &card, TEMPLATE_OWN);
    return rig;
}

static void assert_blend(const float weights[MORPH_KEY_MAX], uint32_t key_count)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        assert_true(weights[i] >= 0.0f && weights[i] <= 1.0f);
        assert_true(i < key_count || weights[i] == 0.0f);
        sum += weights[i];
    }
    assert_float_equal(sum, 1.0f, 1e-6f);
}

static void test_every_template_keeps_the_constraint_at_knots_and_between(void **state)
{
    (void)state;
    for (uint32_t key_count = 2; key_count <= MORPH_KEY_MAX; key_count++) {
        for (uint32_t t = 0; t < TEMPLATES; t++) {
            const struct graph graph = graph_of(templates[t], key_count);
            assert_int_equal(graph_check(&graph, key_count).fault, GRAPH_GOOD);
            for (int step = 0; step <= STEPS; step++) {
                float weights[MORPH_KEY_MAX];
                graph_weights(&graph, key_count, (float)step / STEPS, weights);
                assert_blend(weights, key_count);
            }
        }
    }
}

/* Returns the next number in [0, 1) of a linear congruential generator, which gives the same
 * numbers in every run. */
static float next_share(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(*seed >> 8) / 16777216.0f;
}

static struct graph random_graph(uint32_t *seed, uint32_t key_count, enum graph_line line)
{
    struct graph graph = { .line = (uint8_t)line };
    graph.knot_count = (uint8_t)(2u + (uint32_t)(next_share(seed) * 10.99f));
    for (uint32_t i = 0; i < graph.knot_count; i++) {
        struct graph_knot *knot = &graph.knots[i];
        float sum = 0.0f;
        const float at = ((float)i + 0.9f * next_share(seed)) / (float)(graph.knot_count - 1);
        knot->progress = i == 0 ? 0.0f : i == graph.knot_count - 1u ? 1.0f : at * 0.95f;
        for (uint32_t key = 0; key < key_count; key++) {
            knot->weight[key] = f_max(next_share(seed) - 0.4f, 0.0f) + (key == 0 ? 1e-3f : 0.0f);
            sum += knot->weight[key];
        }
        for (uint32_t key = 0; key < key_count; key++) {
            knot->weight[key] /= sum;
        }
    }
    return graph;
}

static void test_any_good_graph_keeps_the_constraint_between_its_knots(void **state)
{
    (void)state;
    uint32_t seed = 5, good = 0;
    for (uint32_t round = 0; round < 200; round++) {
        const uint32_t key_count = 2u + round % 7u;
        const struct graph graph =
            random_graph(&seed, key_count, round % 2 ? GRAPH_SMOOTH : GRAPH_STRAIGHT);
        if (graph_check(&graph, key_count).fault != GRAPH_GOOD) {
            /* The random graph is not valid, because two of its knots may be in the wrong order. */
            continue;
        }
        good++;
        for (int step = 0; step <= STEPS; step++) {
            float weights[MORPH_KEY_MAX];
            graph_weights(&graph, key_count, (float)step / STEPS, weights);
            assert_blend(weights, key_count);
        }
    }
    assert_true(good > 150);
}

static void test_a_curve_passes_its_knots_exactly(void **state)
{
    (void)state;
    for (uint32_t t = 0; t < TEMPLATES; t++) {
        const struct graph graph = graph_of(templates[t], 5);
        for (uint32_t i = 0; i < graph.knot_count; i++) {
            float weights[MORPH_KEY_MAX];
            graph_weights(&graph, 5, graph.knots[i].progress, weights);
            for (uint32_t key = 0; key < 5; key++) {
                assert_float_equal(weights[key], graph.knots[i].weight[key], 1e-7f);
                assert_true(graph.knots[i].weight[key] < 1.0f || weights[key] == 1.0f);
            }
        }
    }
}

/* Returns the largest change of the slope of a weight between two successive steps. */
static float sharpest_corner(const struct graph *graph)
{
    float before[2][MORPH_KEY_MAX], sharpest = 0.0f;
    graph_weights(graph, 4, 0.0f, before[0]);
    graph_weights(graph, 4, 1.0f / STEPS, before[1]);
    for (int step = 2; step <= STEPS; step++) {
        float now[MORPH_KEY_MAX];
        graph_weights(graph, 4, (float)step / STEPS, now);
        for (uint32_t key = 0; key < 4; key++) {
            const float turn = now[key] - 2.0f * before[1][key] + before[0][key];
            sharpest = f_max(sharpest, f_abs(turn) * STEPS);
            before[0][key] = before[1][key];
            before[1][key] = now[key];
        }
    }
    return sharpest;
}

static void test_smooth_curves_have_no_corner_where_straight_ones_do(void **state)
{
    (void)state;
    struct graph graph = graph_of(TEMPLATE_SMOOTH, 4);
    assert_true(sharpest_corner(&graph) < 0.05f);
    graph.line = GRAPH_STRAIGHT;
    assert_true(sharpest_corner(&graph) > 1.0f);
}

static struct graph_verdict verdict_of(const struct graph *graph)
{
    return graph_check(graph, 3);
}

static void test_a_graph_check_names_the_broken_rule(void **state)
{
    (void)state;
    const struct graph good = graph_of(TEMPLATE_SIMULTANEOUS, 3);
    struct graph bad = good;
    bad.knot_count = 1;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_KNOT_COUNT);
    bad.knot_count = GRAPH_KNOT_MAX + 1;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_KNOT_COUNT);
    bad = good;
    bad.knots[0].progress = 0.01f;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_ENDS);
    bad = good;
    bad.knots[2].progress = 0.99f;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_ENDS);
    assert_int_equal(verdict_of(&bad).knot, 2);
    bad = good;
    bad.knots[1].progress = 0.0f;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_ORDER);
    assert_int_equal(verdict_of(&bad).knot, 1);
    bad.knots[1].progress = 0.0f / 0.0f;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_ORDER);
    bad = good;
    bad.knots[1].weight[0] = -0.15f;
    bad.knots[1].weight[2] = 0.45f;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_NEGATIVE);
    assert_int_equal(verdict_of(&bad).key, 0);
    bad.knots[1].weight[0] = 0.0f / 0.0f;
    assert_int_equal(verdict_of(&bad).fault, GRAPH_NEGATIVE);
}

static void test_a_sum_inside_the_tolerance_is_valid_and_one_outside_is_not(void **state)
{
    (void)state;
    struct graph graph = graph_of(TEMPLATE_PAIRWISE, 3);
    graph.knots[1].weight[0] = 9e-7f;
    assert_int_equal(verdict_of(&graph).fault, GRAPH_GOOD);
    graph.knots[1].weight[0] = 2e-6f;
    assert_int_equal(verdict_of(&graph).fault, GRAPH_SUM);
    assert_int_equal(verdict_of(&graph).knot, 1);
    assert_true(verdict_of(&graph).value > 1.0f);
}

static void test_a_graph_with_a_tiny_weight_of_a_key_cannot_be_solved(void **state)
{
    (void)state;
    struct graph graph = graph_of(TEMPLATE_SIMULTANEOUS, 3);
    graph.knots[1] = (struct graph_knot){ 0.5f, { 0.455f, 0.09f, 0.455f } };
    assert_int_equal(verdict_of(&graph).fault, GRAPH_UNSOLVABLE);
    assert_int_equal(verdict_of(&graph).key, 1);
    const struct morph_rig rig = rig_of(&graph, 3);
    assert_int_equal(rig.curves[0].solved, 0);
    assert_true(rig.solution[0][1][1] == 1.0f && rig.solution[0][1][0] == 0.0f);
    graph.knots[1] = (struct graph_knot){ 0.5f, { 0.445f, 0.11f, 0.445f } };
    assert_int_equal(verdict_of(&graph).fault, GRAPH_GOOD);
    graph.knots[1] = (struct graph_knot){ 0.5f, { 0.455f, 0.09f, 0.455f } };
    graph.solved = 0;
    assert_int_equal(verdict_of(&graph).fault, GRAPH_GOOD);
}

/* In section 4.2 of the 2005 thesis, the middle shape T is replaced by an exaggerated shape T' = (T
 * - 0.15 (S + U)) / 0.7, where S and U are the other shapes. The solution must have the same
 * factors. */
static void test_the_solved_middle_key_is_the_thesis_exaggeration(void **state)
{
    (void)state;
    const struct graph graph = graph_of(TEMPLATE_SIMULTANEOUS, 3);
    const struct morph_rig rig = rig_of(&graph, 3);
    const float expected[3][3] = { { 1.0f, 0.0f, 0.0f },
                                   { -0.15f / 0.7f, 1.0f / 0.7f, -0.15f / 0.7f },
                                   { 0.0f, 0.0f, 1.0f } };
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t j = 0; j < 3; j++) {
            assert_float_equal(rig.solution[0][i][j], expected[i][j], 1e-6f);
        }
    }
}

/* In this graph, each key has a smaller weight at its own progress than another key. The linear
 * equations for the shapes can then be solved only if rows are exchanged (pivoting). */
static void test_shapes_are_solved_for_any_dominant_key(void **state)
{
    (void)state;
    const struct graph graph = { .knot_count = 3,
                                 .solved = 1,
                                 .knots = { { 0.0f, { 0.1f, 0.7f, 0.2f } },
                                            { 0.5f, { 0.2f, 0.1f, 0.7f } },
                                            { 1.0f, { 0.7f, 0.2f, 0.1f } } } };
    float solution[MORPH_KEY_MAX][MORPH_KEY_MAX];
    uint32_t stuck;
    assert_true(graph_solve(&graph, 3, solution, &stuck));
    for (uint32_t key = 0; key < 3; key++) {
        for (uint32_t j = 0; j < 3; j++) {
            float drawn = 0.0f;
            for (uint32_t i = 0; i < 3; i++) {
                drawn += graph.knots[key].weight[i] * solution[i][j];
            }
            assert_float_equal(drawn, j == key ? 1.0f : 0.0f, 1e-5f);
        }
    }
}

static void test_a_solved_curve_passes_through_every_key_exactly(void **state)
{
    (void)state;
    for (uint32_t key_count = 3; key_count <= MORPH_KEY_MAX; key_count++) {
        for (uint32_t t = 2; t < TEMPLATES; t++) {
            const struct graph graph = graph_of(templates[t], key_count);
            const struct morph_rig rig = rig_of(&graph, key_count);
            for (uint32_t key = 0; key < key_count; key++) {
                float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
                morph_weights(&rig, (float)key / (float)(key_count - 1), weights);
                for (uint32_t j = 0; j < MORPH_KEY_MAX; j++) {
                    assert_true(weights[0][j] == (j == key ? 1.0f : 0.0f));
                }
            }
        }
    }
}

static void test_a_solved_curve_does_not_jump_at_a_key(void **state)
{
    (void)state;
    for (uint32_t key_count = 3; key_count <= MORPH_KEY_MAX; key_count++) {
        const struct graph graph = graph_of(TEMPLATE_SMOOTH, key_count);
        const struct morph_rig rig = rig_of(&graph, key_count);
        float before[MORPH_CURVE_MAX][MORPH_KEY_MAX];
        morph_weights(&rig, 0.0f, before);
        for (int step = 1; step <= STEPS; step++) {
            float now[MORPH_CURVE_MAX][MORPH_KEY_MAX], sum = 0.0f;
            morph_weights(&rig, (float)step / STEPS, now);
            for (uint32_t j = 0; j < key_count; j++) {
                assert_true(f_abs(now[0][j] - before[0][j]) < 3.0f * (float)key_count / STEPS);
                before[0][j] = now[0][j];
                sum += now[0][j];
            }
            assert_float_equal(sum, 1.0f, 2e-6f);
        }
    }
}

/* With solved shapes and smooth curves, three keys are blended at the same time, which bends the
 * path of a vertex. Two keys would give a straight path (figures 3.2 and 4.15 of the 2005
 * thesis). */
static void test_only_solved_smooth_curves_show_a_third_key_between_two(void **state)
{
    (void)state;
    float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
    struct graph graph = graph_of(TEMPLATE_SIMULTANEOUS, 3);
    struct morph_rig rig = rig_of(&graph, 3);
    morph_weights(&rig, 0.25f, weights);
    assert_true(weights[0][2] < -0.02f);
    /* With straight curves, only two keys are blended at the same time, although the shapes are
     * solved. */
    graph.line = GRAPH_STRAIGHT;
    rig = rig_of(&graph, 3);
    morph_weights(&rig, 0.25f, weights);
    assert_float_equal(weights[0][2], 0.0f, 1e-6f);
    assert_float_equal(weights[0][1], 0.5f, 1e-6f);
}

static void test_absent_curves_of_a_card_use_the_curve_of_the_whole_fish(void **state)
{
    (void)state;
    const struct graph graph = graph_of(TEMPLATE_PAIRWISE, 3);
    const struct morph_rig rig = rig_of(&graph, 3);
    float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
    morph_weights(&rig, 0.4f, weights);
    for (uint32_t curve = 1; curve < MORPH_CURVE_MAX; curve++) {
        assert_memory_equal(weights[curve], weights[0], sizeof weights[0]);
    }
}

static void test_a_template_outside_its_ranges_fails_an_assertion(void **state)
{
    (void)state;
    struct graph graph;
    expect_assert_failure(graph_from_template(&graph, TEMPLATE_OWN, 3, SIMULTANEOUS_PEAK));
    expect_assert_failure(graph_from_template(&graph, TEMPLATE_COUNT, 3, SIMULTANEOUS_PEAK));
    expect_assert_failure(graph_from_template(&graph, TEMPLATE_SIMULTANEOUS, 3, 0.5f));
    expect_assert_failure(graph_from_template(&graph, TEMPLATE_SIMULTANEOUS, 3, 1.01f));
    expect_assert_failure(graph_from_template(&graph, TEMPLATE_SMOOTH, 1, SIMULTANEOUS_PEAK));
    expect_assert_failure(graph_from_template(&graph, TEMPLATE_SMOOTH, 9, SIMULTANEOUS_PEAK));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_template_keeps_the_constraint_at_knots_and_between),
        cmocka_unit_test(test_any_good_graph_keeps_the_constraint_between_its_knots),
        cmocka_unit_test(test_a_curve_passes_its_knots_exactly),
        cmocka_unit_test(test_smooth_curves_have_no_corner_where_straight_ones_do),
        cmocka_unit_test(test_a_graph_check_names_the_broken_rule),
        cmocka_unit_test(test_a_sum_inside_the_tolerance_is_valid_and_one_outside_is_not),
        cmocka_unit_test(test_a_graph_with_a_tiny_weight_of_a_key_cannot_be_solved),
        cmocka_unit_test(test_the_solved_middle_key_is_the_thesis_exaggeration),
        cmocka_unit_test(test_shapes_are_solved_for_any_dominant_key),
        cmocka_unit_test(test_a_solved_curve_passes_through_every_key_exactly),
        cmocka_unit_test(test_a_solved_curve_does_not_jump_at_a_key),
        cmocka_unit_test(test_only_solved_smooth_curves_show_a_third_key_between_two),
        cmocka_unit_test(test_absent_curves_of_a_card_use_the_curve_of_the_whole_fish),
        cmocka_unit_test(test_a_template_outside_its_ranges_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
