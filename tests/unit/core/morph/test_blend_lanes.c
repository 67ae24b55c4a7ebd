/* test_blend_lanes.c -- checks that the SIMD code blends vertices to the same values as the scalar
 * code, bit for bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/morph/blend_lanes.h"

#define ANCHORS 7u
#define GUARD 0x7fedcbau

static struct species_vertex vertices[MESH_VERTEX_MAX];
static struct species_point points[MORPH_KEY_MAX][MESH_VERTEX_MAX];
static struct species_mesh mesh;
static struct morph_pose pose;
static vec3 alone[2][MESH_VERTEX_MAX + 1], together[2][MESH_VERTEX_MAX + 1];

static float drawn(uint32_t round, uint32_t *use, float low, float high)
{
    return rng_range((struct rng_key){ round, 0, (*use)++, RNG_TEST }, low, high);
}

static int16_t any_int16(uint32_t round, uint32_t *use)
{
    return (int16_t)drawn(round, use, -32767.0f, 32767.0f);
}

/* Fills the mesh with random points. About 10 % of the vertices have an anchor and a random mask,
 * because the SIMD code must treat such vertices separately. */
static void any_mesh(uint32_t round, uint32_t key_count, uint32_t vertex_count)
{
    uint32_t use = 0;
    mesh = (struct species_mesh){
        .vertex_count = vertex_count, .anchor_count = ANCHORS, .reach = 2.0f, .vertices = vertices
    };
    for (uint32_t i = 0; i < vertex_count; i++) {
        const bool plain = drawn(round, &use, 0.0f, 1.0f) < 0.8f || i < vertex_count / 2u;
        const uint8_t second = (uint8_t)drawn(round, &use, 0.0f, 255.0f);
        vertices[i] = (struct species_vertex){ .anchor = ANCHOR_NONE, .mask = { 255 } };
        if (!plain) {
            vertices[i].anchor = (uint8_t)drawn(round, &use, 0.0f, (float)ANCHORS);
            vertices[i].mask[0] = (uint8_t)(255u - second);
            vertices[i].mask[i % 3u + 1u] = second;
        }
        for (uint32_t key = 0; key < key_count; key++) {
            points[key][i] =
                (struct species_point){ any_int16(round, &use), any_int16(round, &use),
                                        any_int16(round, &use), any_int16(round, &use) };
        }
    }
    for (uint32_t key = 0; key < key_count; key++) {
        mesh.points[key] = points[key];
    }
}

static void any_pose(uint32_t round, uint32_t key_count)
{
    uint32_t use = 0;
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            const float weight = drawn(round + 1000u, &use, -0.4f, 1.0f);
            pose.weight[curve][key] = key < key_count && weight > -0.2f ? weight : 0.0f;
        }
    }
    for (uint32_t i = 0; i < ANCHORS; i++) {
        const float angle = drawn(round + 2000u, &use, -F_PI, F_PI);
        pose.anchor[i].position = v3(drawn(round, &use, -1.0f, 1.0f), 0.3f, -0.2f);
        pose.anchor[i].turn =
            (struct quat){ 0.6f * f_sin(angle), 0.0f, 0.8f * f_sin(angle), f_cos(angle) };
    }
}

static uint32_t *word_behind(vec3 *array)
{
    return (uint32_t *)(void *)&array[mesh.vertex_count];
}

static void assert_lanes_equal_single_vertices(uint32_t key_count)
{
    for (uint32_t i = 0; i < 2; i++) {
        *word_behind(alone[i]) = GUARD;
        *word_behind(together[i]) = GUARD;
    }
    blend_each(&mesh, key_count, &pose, 0, alone[0], alone[1]);
    morph_shape(&mesh, key_count, &pose, together[0], together[1]);
    for (uint32_t i = 0; i < 2; i++) {
        assert_memory_equal(alone[i], together[i], mesh.vertex_count * sizeof(vec3));
        assert_int_equal(*word_behind(together[i]), GUARD);
    }
}

static void test_four_lanes_and_one_blend_any_mesh_equally(void **state)
{
    (void)state;
    for (uint32_t round = 0; round < 400; round++) {
        const uint32_t key_count = 1u + round % MORPH_KEY_MAX;
        any_mesh(round, key_count, 1u + round % 61u);
        any_pose(round, key_count);
        assert_lanes_equal_single_vertices(key_count);
    }
}

static void test_four_lanes_and_one_blend_a_real_fish_equally(void **state)
{
    (void)state;
    struct morph_rig rig;
    morph_rig_init(&rig, &species_wakin.card, TEMPLATE_SMOOTH);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        mesh = species_wakin.lod[lod];
        for (int step = 0; step <= 100; step++) {
            morph_pose(&rig, &mesh, (float)step / 100.0f, &pose);
            assert_lanes_equal_single_vertices(rig.key_count);
        }
    }
}

static void test_positions_or_normals_can_be_blended_alone(void **state)
{
    (void)state;
    any_mesh(3, 3, 50);
    any_pose(3, 3);
    blend_each(&mesh, 3, &pose, 0, alone[0], alone[1]);
    morph_shape(&mesh, 3, &pose, together[0], NULL);
    morph_shape(&mesh, 3, &pose, NULL, together[1]);
    assert_memory_equal(alone[0], together[0], 50 * sizeof(vec3));
    assert_memory_equal(alone[1], together[1], 50 * sizeof(vec3));
}

static void test_an_absent_anchor_fails_an_assertion_in_simd(void **state)
{
    (void)state;
    any_mesh(4, 3, 50);
    any_pose(4, 3);
    vertices[5].anchor = ANCHORS;
    expect_assert_failure(morph_shape(&mesh, 3, &pose, together[0], together[1]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_four_lanes_and_one_blend_any_mesh_equally),
        cmocka_unit_test(test_four_lanes_and_one_blend_a_real_fish_equally),
        cmocka_unit_test(test_positions_or_normals_can_be_blended_alone),
        cmocka_unit_test(test_an_absent_anchor_fails_an_assertion_in_simd),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
