/* test_specimen.c -- Tests the geometry of a specimen, which is a single drawn fish: its position,
 * its bounds, and the texture coordinates of its vertices. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/render/paint_atlas.h"
#include "platform/render/specimen.h"

static struct specimen fish_of(const struct species *species)
{
    return (struct specimen){
        .species = species, .progress = 0.5f, .x_px = 300.0f, .y_px = 200.0f, .length_px = 100.0f
    };
}

static void assert_seen(const struct specimen *fish, vec3 point, float x_px, float y_px)
{
    float at[2];
    specimen_project(fish, point, at);
    assert_float_equal(at[0], x_px, 1e-3f);
    assert_float_equal(at[1], y_px, 1e-3f);
}

static void test_an_unrotated_specimen_shows_its_left_side_with_the_nose_to_the_left(void **state)
{
    (void)state;
    const struct specimen fish = fish_of(&species_wakin);
    assert_seen(&fish, v3(0.0f, 0.0f, -0.5f), 250.0f, 200.0f);
    assert_seen(&fish, v3(0.0f, 0.2f, 0.0f), 300.0f, 180.0f);
    assert_true(specimen_axes(&fish).toward.x < -0.99f);
}

static void test_yaw_pitch_and_roll_rotate_a_specimen_as_documented(void **state)
{
    (void)state;
    const vec3 nose = v3(0.0f, 0.0f, -0.5f), back = v3(0.0f, 0.5f, 0.0f);
    struct specimen fish = fish_of(&species_wakin);
    fish.yaw_rad = 0.3f;
    assert_true(v3_dot(specimen_axes(&fish).toward, nose) > 0.1f);
    fish.yaw_rad = 0.0f;
    fish.pitch_rad = 0.3f;
    assert_true(v3_dot(specimen_axes(&fish).toward, back) > 0.1f);
    fish.pitch_rad = 0.0f;
    fish.roll_rad = 0.5f * F_PI;
    assert_seen(&fish, nose, 300.0f, 250.0f);
}

static void test_the_axes_of_a_rotated_specimen_stay_orthogonal(void **state)
{
    (void)state;
    struct specimen fish = fish_of(&species_wakin);
    fish.yaw_rad = 1.1f;
    fish.pitch_rad = -0.7f;
    fish.roll_rad = 2.3f;
    const struct specimen_axes axes = specimen_axes(&fish);
    const vec3 square = v3_sub(v3_cross(axes.right, axes.up), axes.toward);
    assert_float_equal(v3_length(axes.right), 1.0f, 1e-5f);
    /* The cross product of right and up is toward, so the axes are right-handed and the fish is not
     * mirrored. */
    assert_float_equal(v3_length(square), 0.0f, 1e-5f);
}

/* In every key shape, all vertices must be inside the box, and the fish must fill the box in width
 * or height. */
static void test_a_fitted_fish_fills_its_box_at_every_age(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        struct specimen fish = fish_of(species_table[i]);
        vec3 points[MESH_VERTEX_MAX];
        struct morph_pose pose;
        struct morph_rig rig;
        float low[2] = { 1e9f, 1e9f }, high[2] = { -1e9f, -1e9f };
        const struct species_mesh *const mesh = &species_table[i]->lod[1];
        const uint32_t last = species_table[i]->card.key_count - 1u;
        specimen_portrait(&fish);
        specimen_fit(&fish, 10.0f, 20.0f, 400.0f, 300.0f);
        morph_rig_init(&rig, &species_table[i]->card, TEMPLATE_PAIRWISE);
        for (uint32_t key = 0; key <= last; key++) {
            morph_pose(&rig, mesh, (float)key / (float)last, &pose);
            morph_shape(mesh, last + 1u, &pose, points, NULL);
            for (uint32_t k = 0; k < mesh->vertex_count; k++) {
                float at[2];
                specimen_project(&fish, points[k], at);
                for (uint32_t d = 0; d < 2; d++) {
                    low[d] = f_min(low[d], at[d]);
                    high[d] = f_max(high[d], at[d]);
                }
            }
        }
        assert_true(low[0] >= 9.9f && high[0] <= 410.1f && low[1] >= 19.9f && high[1] <= 320.1f);
        assert_true(high[0] - low[0] > 399.0f || high[1] - low[1] > 299.0f);
    }
}

static void test_paint_atlas_at_inverts_paint_atlas_find(void **state)
{
    (void)state;
    uint32_t count = 0;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_mesh *const mesh = &species_table[i]->lod[0];
        for (uint32_t k = 0; k < mesh->vertex_count; k++, count++) {
            const struct species_vertex *const vertex = &mesh->vertices[k];
            struct species_vertex found;
            float uv[2];
            paint_atlas_find(vertex, uv);
            assert_true(
                paint_atlas_at(uv[0] * (float)PAINT_SIZE, uv[1] * (float)PAINT_SIZE, &found));
            assert_int_equal(found.part, vertex->part);
            assert_true(vertex->part == PART_BODY || found.side == vertex->side);
            assert_float_equal(found.u, f_clamp(vertex->u, 0.0f, 1.0f), 1e-4f);
            assert_float_equal(found.v, f_clamp(vertex->v, 0.0f, 1.0f), 1e-4f);
        }
    }
    assert_true(count > 3000u);
}

/* Texture filtering reads up to half a texel around a point. Near the edge of a part, it must not
 * read texels of another part. */
static void test_no_vertex_lies_within_half_a_texel_of_another_part(void **state)
{
    (void)state;
    const struct species_mesh *const mesh = &species_wakin.lod[0];
    for (uint32_t k = 0; k < mesh->vertex_count; k++) {
        float uv[2];
        struct species_vertex found;
        paint_atlas_find(&mesh->vertices[k], uv);
        for (uint32_t corner = 0; corner < 4; corner++) {
            const float x = uv[0] * (float)PAINT_SIZE + (corner & 1u ? 0.49f : -0.49f);
            const float y = uv[1] * (float)PAINT_SIZE + (corner & 2u ? 0.49f : -0.49f);
            assert_true(paint_atlas_at(x, y, &found));
            assert_int_equal(found.part, mesh->vertices[k].part);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_unrotated_specimen_shows_its_left_side_with_the_nose_to_the_left),
        cmocka_unit_test(test_yaw_pitch_and_roll_rotate_a_specimen_as_documented),
        cmocka_unit_test(test_the_axes_of_a_rotated_specimen_stay_orthogonal),
        cmocka_unit_test(test_a_fitted_fish_fills_its_box_at_every_age),
        cmocka_unit_test(test_paint_atlas_at_inverts_paint_atlas_find),
        cmocka_unit_test(test_no_vertex_lies_within_half_a_texel_of_another_part),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
