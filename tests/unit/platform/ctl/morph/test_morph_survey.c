/* test_morph_survey.c -- Tests the survey of a species, which measures the flaws of its shapes
 * during growth. Each test adds one flaw to a fish and checks the measured value. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/ctl/morph/morph_survey.h"
#include "platform/species/part.h"

#define STEPS 20

/* A copy of the wakin (a goldfish), whose tables the tests change. */
static struct species fish;
static struct species_vertex vertices[MESH_VERTEX_MAX];
static struct species_point points[MORPH_KEY_MAX][MESH_VERTEX_MAX];
static uint16_t indices[MESH_INDEX_MAX];
static struct morph_rig rig;
static struct morph_survey survey;

static int new_fish(void **state)
{
    (void)state;
    fish = species_wakin;
    struct species_mesh *mesh = &fish.lod[0];
    memcpy(vertices, mesh->vertices, mesh->vertex_count * sizeof vertices[0]);
    memcpy(indices, mesh->indices, mesh->index_count * sizeof indices[0]);
    mesh->vertices = vertices;
    mesh->indices = indices;
    for (uint32_t key = 0; key < fish.card.key_count; key++) {
        memcpy(points[key], mesh->points[key], mesh->vertex_count * sizeof points[0][0]);
        mesh->points[key] = points[key];
    }
    morph_rig_init(&rig, &fish.card, TEMPLATE_OWN);
    return 0;
}

static void measure(void)
{
    morph_survey(&fish, &rig, 0, STEPS, &survey);
}

static uint32_t first_of(enum species_part part)
{
    uint32_t i = 0;
    while (vertices[i].part != part) {
        i++;
    }
    return i;
}

static int16_t counts(float lengths)
{
    return (int16_t)(lengths / fish.lod[0].reach * 32767.0f);
}

static void test_a_valid_fish_has_no_flaw(void **state)
{
    (void)state;
    measure();
    assert_true(survey.sum_error <= 1e-6f && survey.weight_min >= 0.0f);
    assert_int_equal(survey.keys_alone, fish.card.key_count);
    assert_true(survey.key_error.value == 0.0f);
    assert_int_equal(survey.flipped_skin + survey.flipped_fins, 0);
    assert_true(survey.body_in_body.value == 0.0f && survey.eye_in_body.value == 0.0f);
    assert_true(survey.pupil_in_body.value == 0.0f && survey.eye_in_eye.value == 0.0f);
    assert_true(survey.fin_in_body.value < 0.0005f && survey.volume_dip.value < 0.02f);
    static struct morph_pose pose;
    static struct morph_skin body;
    static vec3 positions[MESH_VERTEX_MAX];
    morph_pose(&rig, &fish.lod[0], 1.0f, &pose);
    morph_shape(&fish.lod[0], fish.card.key_count, &pose, positions, NULL);
    morph_skin_build(&body, &fish.lod[0], positions, PART_BODY, SIDE_MIDDLE);
    assert_true(morph_skin_volume(&body) > 0.0f);
}

static void test_a_graph_with_a_wrong_sum_or_a_negative_weight_is_detected(void **state)
{
    (void)state;
    rig.curves[0].knots[1].weight[0] += 0.01f;
    measure();
    assert_float_equal(survey.sum_error, 0.01f, 1e-4f);
    rig.curves[0].knots[1].weight[0] = -0.03f;
    measure();
    assert_float_equal(survey.weight_min, -0.03f, 1e-5f);
}

static void test_a_key_with_a_remaining_second_weight_is_detected(void **state)
{
    (void)state;
    struct graph *graph = &rig.curves[0];
    const uint32_t last = graph->knot_count - 1u;
    /* At the end of growth, the graph gives a small weight to key shape 0 in addition to the full
     * weight of the last key shape. */
    graph->knots[last].weight[0] = 1e-3f;
    measure();
    assert_true(survey.key_error.value > 1e-5f);
    assert_true(survey.key_error.progress == 1.0f);
}

static void test_a_key_that_never_has_full_weight_is_not_counted(void **state)
{
    (void)state;
    graph_from_template(&rig.curves[0], TEMPLATE_ORDINARY, rig.key_count, SIMULTANEOUS_PEAK);
    measure();
    assert_int_equal(survey.keys_alone, 2);
}

static void test_a_triangle_with_reversed_winding_is_detected(void **state)
{
    (void)state;
    const uint16_t kept = indices[300];
    assert_int_equal(vertices[kept].part, PART_BODY);
    indices[300] = indices[301];
    indices[301] = kept;
    measure();
    assert_int_equal(survey.flipped_skin, 1);
    assert_true(survey.flipped_at == 0.0f);
}

/* Mirrors the dorsal fin in the last key shape, so that the fin flips between the last two shape
 * keys. */
static void test_a_fin_that_flips_is_detected(void **state)
{
    (void)state;
    const uint32_t first = first_of(PART_DORSAL);
    const uint32_t last_key = fish.card.key_count - 1u;
    for (uint32_t i = first; vertices[i].part == PART_DORSAL; i++) {
        points[last_key][i].y = (int16_t)-points[last_key][i].y;
        points[last_key][i].z = (int16_t)(points[last_key][i].z / 2);
    }
    measure();
    const uint32_t seen = survey.flipped_fins;
    assert_true(seen > 0);
    assert_true(survey.flipped_at > 0.5f);
    /* The number of flips must not depend on the number of samples. */
    morph_survey(&fish, &rig, 0, 4 * STEPS, &survey);
    assert_int_equal(survey.flipped_fins, seen);
    morph_survey(&fish, &rig, 0, 5, &survey);
    assert_int_equal(survey.flipped_fins, seen);
}

/* The fin of a hatchling unfolds very fast, within a few hundredths of the growth. The unfolding
 * must not count as a flip, whatever the number of samples. */
static void test_a_fast_fin_rotation_is_not_a_flip(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        for (uint32_t steps = 3; steps < 100; steps += 16) {
            morph_rig_init(&rig, &species_table[i]->card, TEMPLATE_OWN);
            morph_survey(species_table[i], &rig, 0, steps, &survey);
            assert_int_equal(survey.flipped_fins, 0);
        }
    }
}

static void test_a_folded_surface_is_detected(void **state)
{
    (void)state;
    const struct species_mesh *mesh = &fish.lod[0];
    const uint32_t i = mesh->grid_first + mesh->grid_rings / 2u * (mesh->grid_spokes + 1u) +
                       mesh->grid_spokes / 4u;
    for (uint32_t key = 0; key < fish.card.key_count; key++) {
        /* Moves the vertex to the left through the opposite side of the body. */
        points[key][i].x = (int16_t)(-2 * points[key][i].x);
    }
    measure();
    assert_true(survey.body_in_body.value > 0.02f);
    assert_int_equal(survey.body_in_body.vertex, i);
}

static void test_an_eye_inside_the_head_is_detected(void **state)
{
    (void)state;
    for (uint32_t i = first_of(PART_EYE); vertices[i].part == PART_EYE; i++) {
        for (uint32_t key = 0; key < fish.card.key_count; key++) {
            /* Moves the eye into the head. */
            points[key][i].x = (int16_t)(points[key][i].x - counts(0.05f));
        }
    }
    measure();
    assert_true(survey.pupil_in_body.value > 0.005f);
    assert_true(survey.eye_in_body.value >= survey.pupil_in_body.value);
    assert_int_equal(vertices[survey.pupil_in_body.vertex].part, PART_EYE);
}

static void test_a_fin_tip_inside_the_body_is_detected(void **state)
{
    (void)state;
    uint32_t tip = first_of(PART_PECTORAL);
    while (vertices[tip].v < 1.0f) {
        tip++;
    }
    const float inward = vertices[tip].side == SIDE_LEFT ? 1.0f : -1.0f;
    for (uint32_t key = 0; key < fish.card.key_count; key++) {
        points[key][tip] = (struct species_point){ .x = counts(inward * 0.05f) };
    }
    measure();
    assert_true(survey.fin_in_body.value > 0.01f);
    assert_int_equal(survey.fin_in_body.vertex, tip);
}

/* The graph leads from the middle key shape to key 0 and back to the middle one. Key 0 is changed
 * to half the width of the middle one, so the fish becomes thinner between two equal shapes. */
static void test_a_stage_thinner_than_both_keys_is_detected(void **state)
{
    (void)state;
    const uint32_t middle = fish.card.key_count / 2u;
    struct graph graph = { .knot_count = 3 };
    graph.knots[0].weight[middle] = 1.0f;
    graph.knots[1] = (struct graph_knot){ .progress = 0.5f };
    graph.knots[1].weight[0] = 1.0f;
    graph.knots[2].progress = 1.0f;
    graph.knots[2].weight[middle] = 1.0f;
    rig.curves[0] = graph;
    for (uint32_t i = 0; i < fish.lod[0].vertex_count; i++) {
        points[0][i].x = (int16_t)(points[middle][i].x / 2);
    }
    measure();
    assert_true(survey.volume_dip.value > 0.02f);
}

static void test_a_hole_in_the_body_is_detected(void **state)
{
    (void)state;
    measure();
    assert_int_equal(survey.moments_open, 0);
    for (uint32_t i = 300; i < 390; i++) { /* The 90 indices are those of thirty triangles, which
                                              collapse to one point and leave a hole. */
        assert_int_equal(vertices[indices[i]].part, PART_BODY);
        indices[i] = indices[300];
    }
    measure();
    assert_true(survey.moments_open > STEPS);
}

static void test_a_key_of_a_different_size_is_detected(void **state)
{
    (void)state;
    measure();
    assert_true(survey.size_error.value < 0.01f);
    for (uint32_t i = 0; i < fish.lod[0].vertex_count; i++) {
        points[1][i].z = (int16_t)(points[1][i].z * 9 / 10);
    }
    measure();
    assert_true(survey.size_error.value > 0.04f);
    assert_float_equal(survey.size_error.progress, 1.0f / (float)(rig.key_count - 1u), 1e-6f);
}

static void test_key_ages_out_of_order_are_detected(void **state)
{
    (void)state;
    measure();
    assert_int_equal(survey.moments_not_older, 0);
    assert_true(survey.off_growth.value < 0.02f);
    assert_true(survey.progress_lost.value < 1e-3f && survey.length_lost.value < 1e-3f);
    /* Sets key shape 3 to almost the same age as key shape 2. */
    fish.card.key_age_days[3] = nextafterf(fish.card.key_age_days[2], 1e6f);
    measure();
    /* Four of the five samples between the two key shapes show no rise of the age. */
    assert_int_equal(survey.moments_not_older, 4);
    assert_float_equal(survey.age_stands_at, 0.55f, 1e-6f);
    assert_true(survey.progress_lost.value > 0.1f);
}

/* In key shape 3 the fish has a length of 45 mm. The test sets the age of this key to 200 days, at
 * which the growth curve gives 73.6 mm. */
static void test_a_key_off_the_growth_curve_is_detected(void **state)
{
    (void)state;
    fish.card.key_age_days[3] = 200.0f;
    measure();
    assert_float_equal(survey.off_growth.value, 1.0f - 45.0f / 73.6f, 1e-3f);
    assert_float_equal(survey.off_growth.progress, 0.75f, 1e-6f);
    fish.card.scale_knot_count = 2; /* With a manual table of lengths, the species may differ from
                                       the growth curve. */
    fish.card.scale_knots[0] = (struct scale_knot){ 0.0f, 0.005f };
    fish.card.scale_knots[1] = (struct scale_knot){ 1.0f, 0.150f };
    measure();
    assert_true(survey.off_growth.value == 0.0f);
}

static void test_only_a_linear_morph_follows_the_chord(void **state)
{
    (void)state;
    static struct straight_memory memory;
    static struct species straight;
    measure();
    assert_true(survey.dorsal_root > 0.001f);
    straight_species(&fish, &memory, &straight);
    morph_rig_init(&rig, &straight.card, TEMPLATE_ORDINARY);
    morph_survey(&straight, &rig, 0, STEPS, &survey);
    assert_true(survey.dorsal_root < 1e-6f && survey.eye_right < 1e-6f);
    assert_true(part_vertex_range(&straight.lod[0], PART_EYE, SIDE_LEFT) !=
                part_vertex_range(&straight.lod[0], PART_EYE, SIDE_RIGHT));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_a_valid_fish_has_no_flaw, new_fish),
        cmocka_unit_test_setup(test_a_graph_with_a_wrong_sum_or_a_negative_weight_is_detected,
                               new_fish),
        cmocka_unit_test_setup(test_a_key_with_a_remaining_second_weight_is_detected, new_fish),
        cmocka_unit_test_setup(test_a_key_that_never_has_full_weight_is_not_counted, new_fish),
        cmocka_unit_test_setup(test_a_triangle_with_reversed_winding_is_detected, new_fish),
        cmocka_unit_test_setup(test_a_fin_that_flips_is_detected, new_fish),
        cmocka_unit_test(test_a_fast_fin_rotation_is_not_a_flip),
        cmocka_unit_test_setup(test_a_folded_surface_is_detected, new_fish),
        cmocka_unit_test_setup(test_an_eye_inside_the_head_is_detected, new_fish),
        cmocka_unit_test_setup(test_a_fin_tip_inside_the_body_is_detected, new_fish),
        cmocka_unit_test_setup(test_a_stage_thinner_than_both_keys_is_detected, new_fish),
        cmocka_unit_test_setup(test_a_hole_in_the_body_is_detected, new_fish),
        cmocka_unit_test_setup(test_a_key_of_a_different_size_is_detected, new_fish),
        cmocka_unit_test_setup(test_key_ages_out_of_order_are_detected, new_fish),
        cmocka_unit_test_setup(test_a_key_off_the_growth_curve_is_detected, new_fish),
        cmocka_unit_test_setup(test_only_a_linear_morph_follows_the_chord, new_fish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
