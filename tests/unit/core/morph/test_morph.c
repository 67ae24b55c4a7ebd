/* test_morph.c -- checks the blend weights of the key shapes and the blended shape (equations 3.1
 * and 3.2 of the 2005 thesis). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/morph/morph.h"

#define STEPS 1000

static const struct species *const wakin = &species_wakin;

static void weights_at(const struct species *species, float progress, float weights[MORPH_KEY_MAX])
{
    graph_weights(&species->card.curves[0], species->card.key_count, progress, weights);
}

static void ordinary_at(const struct species *species, float progress, float weights[MORPH_KEY_MAX])
{
    struct graph graph;
    graph_from_template(&graph, TEMPLATE_ORDINARY, species->card.key_count, SIMULTANEOUS_PEAK);
    graph_weights(&graph, species->card.key_count, progress, weights);
}

static void blend(const struct species_mesh *mesh, uint32_t key_count, const float *weights,
                  vec3 *positions, vec3 *normals)
{
    static struct morph_pose pose;
    for (uint32_t key = 0; key < key_count; key++) {
        pose.weight[0][key] = weights[key];
    }
    morph_shape(mesh, key_count, &pose, positions, normals);
}

static void assert_weights_are_a_blend(const float weights[MORPH_KEY_MAX], uint32_t key_count)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        assert_true(weights[i] >= 0.0f);
        assert_true(i < key_count || weights[i] == 0.0f);
        sum += weights[i];
    }
    assert_float_equal(sum, 1.0f, 1e-6f);
}

static void test_weights_are_never_negative_and_sum_to_one(void **state)
{
    (void)state;
    float weights[MORPH_KEY_MAX];
    for (int step = 0; step <= STEPS; step++) {
        weights_at(wakin, (float)step / STEPS, weights);
        assert_weights_are_a_blend(weights, wakin->card.key_count);
        ordinary_at(wakin, (float)step / STEPS, weights);
        assert_weights_are_a_blend(weights, wakin->card.key_count);
    }
}

/* Checks a graph in which three keys have a weight at the same time. The weights in the middle are
 * 15, 70 and 15 %, as in the second graph of the thesis (section 4.2). In that graph the weight of
 * the middle key is never above 70 %. */
static void test_a_graph_of_three_keys_keeps_its_sum_between_knots(void **state)
{
    (void)state;
    struct species three = *wakin;
    three.card.curves[0].knots[1] = (struct graph_knot){ 0.5f, { 0.15f, 0.7f, 0.15f } };
    float weights[MORPH_KEY_MAX];
    for (int step = 0; step <= STEPS; step++) {
        weights_at(&three, (float)step / STEPS, weights);
        assert_weights_are_a_blend(weights, three.card.key_count);
        assert_true(weights[1] <= 0.7f + 1e-6f);
    }
}

static void test_each_key_has_full_weight_at_its_own_length(void **state)
{
    (void)state;
    for (uint32_t key = 0; key < wakin->card.key_count; key++) {
        float weights[MORPH_KEY_MAX];
        const float progress = morph_progress(&wakin->card, wakin->card.key_length_m[key]);
        assert_true(progress == (float)key / (float)(wakin->card.key_count - 1));
        weights_at(wakin, progress, weights);
        assert_true(weights[key] == 1.0f);
    }
}

static void test_progress_rises_with_length_and_stops_at_the_keys_ends(void **state)
{
    (void)state;
    float before = 0.0f;
    for (float length_m = 0.001f; length_m < 0.4f; length_m *= 1.01f) {
        const float progress = morph_progress(&wakin->card, length_m);
        assert_true(progress >= before && progress <= 1.0f);
        before = progress;
    }
    assert_true(morph_progress(&wakin->card, 0.001f) == 0.0f);
    assert_true(before == 1.0f);
}

static void test_lengths_between_keys_are_interpolated_geometrically(void **state)
{
    (void)state;
    /* The length of 10 mm is the geometric mean of the lengths of the larva (5 mm) and the green
     * fry, aoko (20 mm), which are the first two of five keys. The fish is therefore half way to
     * the second key, which is a progress of 0.125. */
    assert_float_equal(morph_progress(&wakin->card, 0.010f), 0.125f, 1e-5f);
}

/* A normal is encoded as a point on an unfolded octahedron with 254 steps in each direction. The
 * test excludes the edge of the unfolded octahedron, because two codes give the same normal
 * there. */
static void test_a_normal_is_encoded_to_the_nearest_step(void **state)
{
    (void)state;
    for (int32_t x = -126; x <= 126; x++) {
        for (int32_t y = -126; y <= 126; y++) {
            const int16_t folded = (int16_t)((x + 127) * 256 + y + 127 - 32767);
            assert_int_equal(morph_fold_normal(morph_normal(folded)), folded);
        }
    }
}

static void test_a_progress_outside_the_graph_fails_an_assertion(void **state)
{
    (void)state;
    float weights[MORPH_KEY_MAX];
    expect_assert_failure(weights_at(wakin, -0.01f, weights));
    expect_assert_failure(weights_at(wakin, 1.01f, weights));
    expect_assert_failure(ordinary_at(wakin, 1.01f, weights));
}

static void test_a_key_blended_alone_equals_the_key_bit_for_bit(void **state)
{
    (void)state;
    static vec3 positions[MESH_VERTEX_MAX];
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &wakin->lod[lod];
        for (uint32_t key = 0; key < wakin->card.key_count; key++) {
            float weights[MORPH_KEY_MAX] = { 0 };
            weights[key] = 1.0f;
            blend(mesh, wakin->card.key_count, weights, positions, NULL);
            for (uint32_t i = 0; i < mesh->vertex_count; i++) {
                const vec3 away = v3_sub(positions[i], morph_position(mesh, key, i));
                assert_true(away.x == 0.0f && away.y == 0.0f && away.z == 0.0f);
            }
        }
    }
}

static void test_a_blend_is_the_weighted_sum_and_its_normals_are_unit(void **state)
{
    (void)state;
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    const struct species_mesh *mesh = &wakin->lod[0];
    const float weights[MORPH_KEY_MAX] = { 0.15f, 0.7f, 0.15f };
    blend(mesh, 3, weights, positions, normals);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const float z = 0.15f * morph_position(mesh, 0, i).z + 0.7f * morph_position(mesh, 1, i).z +
                        0.15f * morph_position(mesh, 2, i).z;
        assert_float_equal(positions[i].z, z, 1e-6f);
        assert_float_equal(v3_length(normals[i]), 1.0f, 1e-5f);
    }
}

static float body_volume(const struct species_mesh *mesh, const vec3 *positions)
{
    float volume = 0.0f;
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        const uint16_t *corner = &mesh->indices[i];
        if (mesh->vertices[corner[0]].part == PART_BODY) {
            volume +=
                v3_dot(positions[corner[0]], v3_cross(positions[corner[1]], positions[corner[2]])) /
                6.0f;
        }
    }
    return volume;
}

static void assert_no_triangle_is_flipped(const struct species_mesh *mesh, const vec3 *positions,
                                          const vec3 *normals)
{
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        const uint16_t *corner = &mesh->indices[i];
        const vec3 face = v3_cross(v3_sub(positions[corner[1]], positions[corner[0]]),
                                   v3_sub(positions[corner[2]], positions[corner[0]]));
        for (int k = 0; k < 3 && mesh->vertices[corner[0]].part < PART_TAIL; k++) {
            assert_true(v3_dot(face, normals[corner[k]]) > 0.0f);
        }
    }
}

/* The body of a wakin (a goldfish breed) becomes deeper from key to key. No stage may therefore
 * have less volume than the stage before. */
static void test_every_stage_between_keys_is_a_complete_fish(void **state)
{
    (void)state;
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &wakin->lod[lod];
        float volume_before = 0.0f;
        for (int step = 0; step <= 100; step++) {
            float weights[MORPH_KEY_MAX];
            weights_at(wakin, (float)step / 100.0f, weights);
            blend(mesh, wakin->card.key_count, weights, positions, normals);
            assert_no_triangle_is_flipped(mesh, positions, normals);
            const float volume = body_volume(mesh, positions);
            assert_true(volume > volume_before * 0.999f);
            volume_before = volume;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_weights_are_never_negative_and_sum_to_one),
        cmocka_unit_test(test_a_graph_of_three_keys_keeps_its_sum_between_knots),
        cmocka_unit_test(test_each_key_has_full_weight_at_its_own_length),
        cmocka_unit_test(test_progress_rises_with_length_and_stops_at_the_keys_ends),
        cmocka_unit_test(test_lengths_between_keys_are_interpolated_geometrically),
        cmocka_unit_test(test_a_normal_is_encoded_to_the_nearest_step),
        cmocka_unit_test(test_a_progress_outside_the_graph_fails_an_assertion),
        cmocka_unit_test(test_a_key_blended_alone_equals_the_key_bit_for_bit),
        cmocka_unit_test(test_every_stage_between_keys_is_a_complete_fish),
        cmocka_unit_test(test_a_blend_is_the_weighted_sum_and_its_normals_are_unit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
