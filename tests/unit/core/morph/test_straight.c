/* test_straight.c -- checks the conversion of a species to the simpler morphing method of the 2005
 * thesis, which has only three key shapes. Each vertex moves in straight lines between the key
 * shapes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/support/barrel.h"

static struct barrel barrel;
static struct straight_memory memory;
static struct species out;
static struct morph_pose pose;
static vec3 ours[MESH_VERTEX_MAX], theirs[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];

static int new_barrel(void **state)
{
    (void)state;
    barrel_init(&barrel);
    return 0;
}

static void key_positions(const struct species *species, uint32_t key, vec3 *positions)
{
    const struct species_mesh *mesh = &species->lod[0];
    morph_key_pose(mesh, species->card.key_count, key, &pose);
    morph_shape(mesh, species->card.key_count, &pose, positions, normals);
}

static void test_every_key_keeps_its_shape_without_anchors(void **state)
{
    (void)state;
    straight_species(&barrel.species, &memory, &out);
    assert_int_equal(out.lod[0].anchor_count, 0);
    assert_int_equal(out.card.curve_count, 1);
    for (uint32_t key = 0; key < 3; key++) {
        key_positions(&barrel.species, key, ours);
        key_positions(&out, key, theirs);
        for (uint32_t i = 0; i < BARREL_VERTICES; i++) {
            assert_int_equal(out.lod[0].vertices[i].anchor, ANCHOR_NONE);
            assert_float_equal(v3_length(v3_sub(ours[i], theirs[i])), 0.0f, 2.0f / 32767.0f);
        }
    }
}

static void test_every_point_moves_straight_between_keys(void **state)
{
    (void)state;
    struct morph_rig rig;
    straight_species(&barrel.species, &memory, &out);
    morph_rig_init(&rig, &out.card, TEMPLATE_ORDINARY);
    key_positions(&out, 0, ours);
    key_positions(&out, 2, theirs);
    for (int step = 0; step <= 1000; step++) {
        static vec3 now[MESH_VERTEX_MAX];
        const float progress = (float)step / 1000.0f;
        morph_pose(&rig, &out.lod[0], progress, &pose);
        morph_shape(&out.lod[0], 3, &pose, now, NULL);
        const vec3 chord = v3_lerp(ours[BARREL_EYE], theirs[BARREL_EYE], progress);
        assert_float_equal(v3_length(v3_sub(now[BARREL_EYE], chord)), 0.0f, 1e-6f);
    }
}

static void test_masks_are_those_of_the_whole_fish(void **state)
{
    (void)state;
    barrel.vertices[3].mask[0] = 100;
    barrel.vertices[3].mask[2] = 155;
    straight_species(&barrel.species, &memory, &out);
    assert_int_equal(out.lod[0].vertices[3].mask[0], 255);
    assert_int_equal(out.lod[0].vertices[3].mask[2], 0);
}

/* The tip of the fin is 0.4 above its anchor, and the anchor is on the back at 0.2, so the tip is
 * at 0.6. The coordinates of the original mesh reach only to 0.5. The converted mesh has no
 * anchors, so its own coordinates must hold the tip: `reach` must increase from 0.5 to the next
 * size, 1. */
static void test_distant_points_on_anchors_widen_the_bounds(void **state)
{
    (void)state;
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        barrel.species.lod[lod].reach = 0.5f;
    }
    for (uint32_t key = 0; key < 3; key++) {
        /* If the reach is halved, a stored coordinate stands for half the distance. x and y are
         * doubled, so that the size in these directions stays the same. z is not doubled, so the
         * barrel becomes half as long. z is made even, because the conversion to a reach of 1 can
         * then halve it without rounding. */
        for (uint32_t i = 0; i < BARREL_VERTICES; i++) {
            struct species_point *p = &barrel.points[key][i];
            p->x = (int16_t)(p->x * 2);
            p->y = (int16_t)(p->y * 2);
            p->z = (int16_t)(p->z / 2 * 2 == p->z ? p->z : p->z - 1);
        }
        barrel.points[key][BARREL_RAY].y = (int16_t)(0.4f / 0.5f * 32767.0f);
    }
    straight_species(&barrel.species, &memory, &out);
    assert_true(out.lod[0].reach == 1.0f);
    key_positions(&barrel.species, 2, ours);
    key_positions(&out, 2, theirs);
    assert_float_equal(ours[BARREL_RAY].y, 0.6f, 1e-4f);
    for (uint32_t i = 0; i < BARREL_VERTICES; i++) {
        assert_float_equal(v3_length(v3_sub(ours[i], theirs[i])), 0.0f, 3.0f / 32767.0f);
    }
}

static void test_a_species_without_anchors_keeps_its_tables(void **state)
{
    (void)state;
    barrel.vertices[BARREL_EYE].anchor = ANCHOR_NONE;
    barrel.vertices[BARREL_RAY].anchor = ANCHOR_NONE;
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        barrel.species.lod[lod].anchor_count = 0;
    }
    straight_species(&barrel.species, &memory, &out);
    for (uint32_t key = 0; key < 3; key++) {
        assert_ptr_equal(out.lod[0].points[key], barrel.points[key]);
    }
}

static void test_the_thesis_method_uses_its_three_keys_and_its_template(void **state)
{
    (void)state;
    struct species_card *card = &barrel.species.card;
    card->key_count = 4;
    card->thesis_key[1] = 2;
    card->thesis_key[2] = 3;
    card->key_age_days[3] = 1000.0f;
    card->key_length_m[3] = 0.2f;
    card->key_names[3][0] = 'd';
    card->scale_knot_count = 2;
    graph_from_template(&card->curves[0], TEMPLATE_PAIRWISE, 4, SIMULTANEOUS_PEAK);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        barrel.species.lod[lod].points[3] = barrel.points[0];
        barrel.anchors[0].v[3] = 0.25f;
        barrel.anchors[1].u[3] = 0.75f;
    }
    straight_thesis(&barrel.species, &memory, &out);
    assert_int_equal(out.card.key_count, 3);
    assert_int_equal(out.card.thesis_key[2], 2);
    assert_int_equal(out.card.key_names[2][0], 'd');
    assert_true(out.card.key_age_days[1] == 100.0f && out.card.key_age_days[2] == 1000.0f);
    assert_int_equal(out.card.scale_knot_count, 0);
    assert_int_equal(out.card.curves[0].solved, 1);
    assert_true(out.card.curves[0].knots[1].weight[1] == SIMULTANEOUS_PEAK);
    const uint32_t key[3] = { 0, 2, 3 };
    for (uint32_t i = 0; i < 3; i++) {
        key_positions(&barrel.species, key[i], ours);
        key_positions(&out, i, theirs);
        for (uint32_t k = 0; k < BARREL_VERTICES; k++) {
            assert_float_equal(v3_length(v3_sub(ours[k], theirs[k])), 0.0f, 2.0f / 32767.0f);
        }
    }
}

/* The thesis shifts the growth curve so that the length at hatching is right (equation 3.3 in
 * section 3.2). The method of the thesis ignores lengths that were measured later. */
static void test_the_thesis_method_uses_the_lengths_of_its_shifted_curve(void **state)
{
    (void)state;
    straight_thesis(&barrel.species, &memory, &out);
    for (int step = 0; step <= 100; step++) {
        const float progress = (float)step / 100.0f, age = life_age_days(&out.card, progress);
        const float expected = 0.2f - (0.2f - 0.01f) * f_exp(-age / 365.25f);
        assert_float_equal(life_length_m(&out.card, progress) / expected, 1.0f, 1e-4f);
    }
    assert_float_equal(out.card.key_length_m[0], 0.01f, 1e-7f);
    /* In the species the length of this key is 80 mm, but the thesis' growth curve gives 55.5 mm at
     * its age. */
    assert_float_equal(out.card.key_length_m[2], 0.0555f, 1e-4f);
    const struct growth bigeye = { 2.0834f, 0.1985152f, -0.839f, 0.35f, 1, { { 0.0f, 0.003f } } };
    /* At the age of one year, this growth curve gives 63.7 cm before the shift, as the thesis
     * states, and 37.8 cm after it. */
    const struct growth shifted = growth_shifted(&bigeye);
    assert_float_equal(growth_length_m(&shifted, 0.0f), 0.003f, 1e-6f);
    assert_float_equal(growth_length_m(&shifted, 365.25f), 0.378f, 0.001f);
    assert_float_equal(growth_length_m(&shifted, 1.0f), 0.00413f, 1e-5f);
}

static void test_an_absent_thesis_key_fails_an_assertion(void **state)
{
    (void)state;
    barrel.species.card.thesis_key[2] = 3;
    expect_assert_failure(straight_thesis(&barrel.species, &memory, &out));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_every_key_keeps_its_shape_without_anchors, new_barrel),
        cmocka_unit_test_setup(test_every_point_moves_straight_between_keys, new_barrel),
        cmocka_unit_test_setup(test_masks_are_those_of_the_whole_fish, new_barrel),
        cmocka_unit_test_setup(test_distant_points_on_anchors_widen_the_bounds, new_barrel),
        cmocka_unit_test_setup(test_a_species_without_anchors_keeps_its_tables, new_barrel),
        cmocka_unit_test_setup(test_the_thesis_method_uses_its_three_keys_and_its_template,
                               new_barrel),
        cmocka_unit_test_setup(test_the_thesis_method_uses_the_lengths_of_its_shifted_curve,
                               new_barrel),
        cmocka_unit_test_setup(test_an_absent_thesis_key_fails_an_assertion, new_barrel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
