/* test_textures.c -- Tests how frequent the patterns, colours and varieties of goldfish are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "platform/render/fish_colours.h"
#include "platform/render/textures.h"

#define FISH_COUNT 10000u
#define PLAIN_LAYERS 3.0f /* Layers that are all red or have a pale belly. */

static uint32_t look_of(uint32_t index)
{
    return rng_u32((struct rng_key){ 1, 0, index, RNG_FISH_LOOK });
}

static void test_twelve_of_sixteen_fish_are_plain_and_one_is_black(void **state)
{
    (void)state;
    uint32_t plain = 0;
    uint32_t black = 0;
    for (uint32_t i = 0; i < FISH_COUNT; i++) {
        const uint32_t look = look_of(i);
        const uint32_t is_black = textures_hue(look) > 1.0f;
        black += is_black;
        plain += !is_black && textures_pattern(look) < PLAIN_LAYERS;
    }
    assert_in_range(plain, FISH_COUNT * 73u / 100u, FISH_COUNT * 77u / 100u);
    assert_in_range(black, FISH_COUNT * 5u / 100u, FISH_COUNT * 8u / 100u);
}

static void test_black_fish_are_demekin_and_a_few_fish_with_patches_are_ryukin(void **state)
{
    (void)state;
    uint32_t ryukin = 0;
    for (uint32_t i = 0; i < FISH_COUNT; i++) {
        const uint32_t look = look_of(i);
        const struct species *const variety = textures_variety(look);
        assert_int_equal(variety == &species_demekin, textures_hue(look) > 1.0f);
        assert_true(variety != &species_ryukin || textures_pattern(look) >= PLAIN_LAYERS);
        ryukin += variety == &species_ryukin;
    }
    assert_in_range(ryukin, FISH_COUNT * 2u / 100u, FISH_COUNT * 4u / 100u);
}

/* The fish pass draws all varieties with the triangles, the attributes and the graphs of the
 * wakin. */
static void check_twin_of_wakin(const struct species *variety)
{
    assert_int_equal(variety->card.key_count, species_wakin.card.key_count);
    assert_memory_equal(variety->card.key_length_m, species_wakin.card.key_length_m,
                        sizeof species_wakin.card.key_length_m);
    assert_memory_equal(variety->card.curves, species_wakin.card.curves,
                        sizeof species_wakin.card.curves);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *const mesh = &variety->lod[lod];
        const struct species_mesh *const wakin = &species_wakin.lod[lod];
        assert_int_equal(mesh->vertex_count, wakin->vertex_count);
        assert_int_equal(mesh->index_count, wakin->index_count);
        assert_memory_equal(mesh->indices, wakin->indices,
                            wakin->index_count * sizeof *wakin->indices);
        for (uint32_t i = 0; i < wakin->vertex_count; i++) {
            const struct species_vertex *const vertex = &mesh->vertices[i];
            const struct species_vertex *const other = &wakin->vertices[i];
            assert_int_equal(vertex->part, other->part);
            assert_int_equal(vertex->side, other->side);
            assert_memory_equal(vertex->mask, other->mask, sizeof other->mask);
            assert_true(vertex->part == PART_TAIL || f_abs(vertex->u - other->u) < 0.05f);
        }
    }
}

static void test_each_variety_has_the_topology_and_growth_of_the_wakin(void **state)
{
    (void)state;
    check_twin_of_wakin(&species_demekin);
    check_twin_of_wakin(&species_ryukin);
}

/* Returns the largest distance of the vertices of `part` from the midline in the key `key`, in body
 * lengths. Distances of an eye are from its anchor on the skin. */
static float reach_of(const struct species *species, enum species_part part, uint32_t key)
{
    const struct species_mesh *const mesh = &species->lod[0];
    int32_t reach = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const int32_t x = mesh->points[key][i].x;
        reach = mesh->vertices[i].part == part && x > reach ? x : reach;
    }
    return (float)reach * mesh->reach / 32767.0f;
}

static void test_a_demekin_has_telescope_eyes_and_both_varieties_have_a_wide_tail(void **state)
{
    (void)state;
    const uint32_t fish_of_a_stall = 3, fry = 0;
    assert_true(reach_of(&species_demekin, PART_EYE, fish_of_a_stall) >
                3.0f * reach_of(&species_wakin, PART_EYE, fish_of_a_stall));
    assert_float_equal(reach_of(&species_demekin, PART_EYE, fry),
                       reach_of(&species_wakin, PART_EYE, fry), 0.002f);
    const float narrow = reach_of(&species_wakin, PART_TAIL, fish_of_a_stall);
    assert_true(reach_of(&species_demekin, PART_TAIL, fish_of_a_stall) > 1.7f * narrow);
    assert_true(reach_of(&species_ryukin, PART_TAIL, fish_of_a_stall) > 1.7f * narrow);
    assert_true(reach_of(&species_demekin, PART_BODY, fish_of_a_stall) >
                1.3f * reach_of(&species_wakin, PART_BODY, fish_of_a_stall));
}

static void test_a_black_fish_is_dark_at_the_back_and_bronze_when_young(void **state)
{
    (void)state;
    struct fish_colours black, red, young, young_red;
    fish_colours_compute(&black, 1.0f, 1.5f, 1.0f);
    fish_colours_compute(&red, 1.0f, 0.5f, 1.0f);
    fish_colours_compute(&young, 0.0f, 1.5f, 1.0f);
    fish_colours_compute(&young_red, 0.0f, 0.5f, 1.0f);
    assert_true(black.stain_back[0] < 0.1f && red.stain_back[0] > 0.9f);
    assert_float_equal(young.stain_back[0], young_red.stain_back[0], 1e-6f);
    /* Bronze has more red than green, and more green than blue. */
    assert_true(young.stain_back[0] > 1.15f * young.stain_back[1]);
    assert_true(young.stain_back[1] > 1.5f * young.stain_back[2]);
}

/* The hue of a fish decides how much green its red skin has. Few fish are gold. */
static void test_red_fish_range_from_deep_red_to_pale_gold(void **state)
{
    (void)state;
    uint32_t deep = 0, orange = 0, gold = 0;
    for (uint32_t i = 0; i < FISH_COUNT; i++) {
        float red[3];
        fish_colours_red(red, (float)i / (float)(FISH_COUNT - 1u));
        assert_true(red[0] > red[1] && red[1] > red[2]);
        deep += red[1] < 0.16f;
        orange += red[1] > 0.33f && red[1] < 0.52f;
        gold += red[1] >= 0.52f;
    }
    assert_in_range(deep, FISH_COUNT / 10u, FISH_COUNT / 4u);
    assert_in_range(orange, FISH_COUNT / 10u, FISH_COUNT / 3u);
    assert_in_range(gold, FISH_COUNT / 50u, FISH_COUNT / 10u);
}

static void test_strong_light_is_attenuated_and_keeps_its_colour(void **state)
{
    (void)state;
    struct fish_colours dim = { .stain_back = { 1.0f, 1.0f, 1.0f } };
    struct fish_colours bright = dim;
    fish_colours_illuminate(&dim, (const float[3]){ 0.4f, 0.4f, 0.4f });
    fish_colours_illuminate(&bright, (const float[3]){ 2.0f, 1.5f, 1.0f });
    assert_in_range((uint32_t)(dim.stain_back[0] * 1000.0f), 450u, 550u);
    assert_in_range((uint32_t)(bright.stain_back[0] * 1000.0f), 1100u, 1400u);
    assert_float_equal(bright.stain_back[1], 0.75f * bright.stain_back[0], 1e-5f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_twelve_of_sixteen_fish_are_plain_and_one_is_black),
        cmocka_unit_test(test_black_fish_are_demekin_and_a_few_fish_with_patches_are_ryukin),
        cmocka_unit_test(test_each_variety_has_the_topology_and_growth_of_the_wakin),
        cmocka_unit_test(test_a_demekin_has_telescope_eyes_and_both_varieties_have_a_wide_tail),
        cmocka_unit_test(test_a_black_fish_is_dark_at_the_back_and_bronze_when_young),
        cmocka_unit_test(test_red_fish_range_from_deep_red_to_pale_gold),
        cmocka_unit_test(test_strong_light_is_attenuated_and_keeps_its_colour),
    };
    return cmocka_run_group_tests_name("textures", tests, NULL, NULL);
}
