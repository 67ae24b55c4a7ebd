/* test_fish_preview.c -- Tests the pictures of every built-in species, and the pieces into which a
 * mesh is cut for an export. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <string.h>

#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_export.h"

#define SIDE 240u

static struct fish_preview portrait;
static struct morph_mesh cut;

static const struct species *take(uint32_t index, float progress)
{
    const struct species *species = species_table[index];
    struct morph_rig rig;
    morph_rig_init(&rig, &species->card, TEMPLATE_OWN);
    fish_preview_pose(&portrait, species, &rig, progress);
    morph_mesh_cut(&species->lod[0], portrait.positions, portrait.normals, &cut);
    return species;
}

static void test_every_fish_fits_its_bounds_with_its_nose_left(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        take(i, 1.0f);
        struct fish_preview_bounds side = fish_preview_nowhere, above = fish_preview_nowhere;
        fish_preview_measure(&portrait, VIEW_SIDE, &side);
        fish_preview_measure(&portrait, VIEW_ABOVE, &above);
        assert_true(f_abs(side.left + 0.5f) < 0.02f); /* Pictures have the unit body length, and the
                                                         snout is at z = -0.5. */
        assert_true(side.right > side.left + 0.9f);
        assert_true(above.left == side.left && above.right == side.right);
        assert_true(side.high > side.low && above.high > above.low);
    }
}

/* Counts the drawn pixels in the columns of the fish and in the margins. The margins must stay
 * empty. */
static void test_every_fish_is_drawn_within_bounds_in_every_view(void **state)
{
    (void)state;
    struct canvas canvas;
    struct raster raster;
    for (uint32_t i = 0; i < species_table_count; i++) {
        take(i, 1.0f);
        for (uint32_t view = 0; view < VIEW_COUNT; view++) {
            struct fish_preview_bounds b = fish_preview_nowhere;
            assert_true(canvas_open(&canvas, SIDE, SIDE) && raster_open(&raster, SIDE, SIDE));
            fish_preview_measure(&portrait, (enum fish_preview_view)view, &b);
            const float scale = 0.8f * (float)SIDE / (b.right - b.left);
            fish_preview_draw(&portrait, (enum fish_preview_view)view, 0.5f * (b.left + b.right),
                              0.5f * (b.low + b.high), scale, &raster);
            assert_true(raster_finish(&raster, &canvas, 0, 0));
            uint32_t inside = 0, outside = 0;
            for (uint32_t k = 0; k < SIDE * SIDE; k++) {
                const uint32_t x = k % SIDE;
                const bool lit = canvas.pixels[k].x + canvas.pixels[k].y > 0.002f;
                inside += lit && x >= 23 && x < SIDE - 23;
                outside += lit && (x < 23 || x >= SIDE - 23);
            }
            assert_true(inside > SIDE * SIDE / 200 && outside == 0);
            raster_close(&raster);
            canvas_close(&canvas);
        }
    }
}

static void test_every_triangle_is_in_one_piece_and_each_sheet_is_included_once(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_mesh *mesh = &take(i, 1.0f)->lod[0];
        uint32_t solid = 0, sheets = 0, cut_solid = 0, cut_sheets = 0;
        for (uint32_t k = 0; k < mesh->index_count; k += 3) {
            *(mesh->vertices[mesh->indices[k]].part >= PART_TAIL ? &sheets : &solid) += 1;
        }
        for (uint32_t p = 0; p < cut.piece_count; p++) {
            *(cut.pieces[p].part >= PART_TAIL ? &cut_sheets : &cut_solid) +=
                cut.pieces[p].face_count;
        }
        assert_int_equal(cut_solid, solid);
        assert_int_equal(2 * cut_sheets, sheets);
        assert_int_equal(cut.face_count, cut_solid + cut_sheets);
    }
}

static void test_a_piece_has_one_part_one_side_and_a_unique_name(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_mesh *mesh = &take(i, 0.5f)->lod[0];
        char names[PIECE_MAX][PIECE_NAME_SIZE];
        for (uint32_t p = 0; p < cut.piece_count; p++) {
            morph_piece_name(&cut.pieces[p], names[p]);
            for (uint32_t q = 0; q < p; q++) {
                assert_string_not_equal(names[p], names[q]);
            }
            for (uint32_t k = 0; k < cut.pieces[p].face_count; k++) {
                const uint16_t at = cut.faces[cut.pieces[p].face_first + k][0];
                assert_int_equal(mesh->vertices[at].part, cut.pieces[p].part);
                assert_int_equal(mesh->vertices[at].side, cut.pieces[p].side);
            }
        }
        assert_string_equal(names[0], "body");
    }
}

/* For a graph that shows only one key shape, the vertex colours must be valid. The vertices of the
 * eyes must have the colours that paint_at() computes. */
static void test_vertex_colours_match_the_surrounding_texture(void **state)
{
    (void)state;
    static struct paint paints[MESH_VERTEX_MAX];
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species *species = take(i, 1.0f);
        const float weights[MORPH_KEY_MAX] = { [0] = 1.0f };
        morph_mesh_paint(species, weights, &cut, paints);
        for (uint32_t k = 0; k < cut.face_count; k++) {
            const struct paint *paint = &paints[cut.faces[k][0]];
            assert_true(v3_is_finite(paint->colour));
            assert_true(paint->colour.x >= 0.0f && paint->colour.x <= 1.0f);
            assert_true(paint->clear >= 0.0f && paint->clear <= 1.0f);
        }
        for (uint32_t v = 0; v < species->lod[0].vertex_count; v++) {
            const struct species_vertex *at = &species->lod[0].vertices[v];
            const struct paint alone = paint_at(species, weights, at);
            if (at->part == PART_EYE) {
                assert_true(f_abs(paints[v].colour.x - alone.colour.x) < 1e-4f);
            }
        }
    }
}

/* This fish has eight key shapes that are much taller than long, so a sheet with all of them would
 * be very large. The size of the picture must be limited. */
static void test_the_sheet_size_is_limited_for_a_very_tall_fish(void **state)
{
    (void)state;
    static struct species tower;
    static struct species_point points[MESH_VERTEX_MAX];
    static struct morph_options pick;
    tower = *species_table[0];
    const struct species_mesh *mesh = &species_table[0]->lod[0];
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        points[i] = mesh->points[tower.card.key_count - 1u][i];
        points[i].y = (int16_t)(points[i].y > 0 ? 32767 : -32767);
    }
    tower.lod[0].reach = 4.0f;
    for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
        tower.lod[0].points[key] = points;
        tower.card.key_length_m[key] = 0.01f * (float)(key + 1u);
        tower.card.key_age_days[key] = 10.0f * (float)(key + 1u);
    }
    tower.card.key_count = MORPH_KEY_MAX;
    pick.drawn = pick.fish = &tower;
    morph_rig_init(&pick.rig, &tower.card, TEMPLATE_PAIRWISE);
    assert_int_equal(morph_sheet_write(&pick, "/dev/null"), EXIT_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_fish_fits_its_bounds_with_its_nose_left),
        cmocka_unit_test(test_every_fish_is_drawn_within_bounds_in_every_view),
        cmocka_unit_test(test_every_triangle_is_in_one_piece_and_each_sheet_is_included_once),
        cmocka_unit_test(test_a_piece_has_one_part_one_side_and_a_unique_name),
        cmocka_unit_test(test_the_sheet_size_is_limited_for_a_very_tall_fish),
        cmocka_unit_test(test_vertex_colours_match_the_surrounding_texture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
