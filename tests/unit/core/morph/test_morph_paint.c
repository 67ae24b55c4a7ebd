/* test_morph_paint.c -- checks the coats and marks of fish: the area that each kind of mark covers,
 * and the continuity of the colours. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/morph/mark.h"
#include "core/morph/morph.h"

#define STEPS 200
#define GROWTH_STEPS 4000
#define RIGHT_FLANK 0.25f
#define LEFT_FLANK 0.75f

static float cover(struct species_mark mark, float u, float v)
{
    const struct species_vertex at = { .u = u, .v = v, .part = mark.part };
    const struct mark_point point = mark_point_of(&at, FORM_FUSIFORM);
    return mark_cover(&mark, &point);
}

/* Returns the fraction of the right flank that a mark covers. */
static float covered_area(struct species_mark mark)
{
    float sum = 0.0f;
    for (int i = 0; i < STEPS; i++) {
        for (int j = 0; j < STEPS; j++) {
            sum += cover(mark, ((float)i + 0.5f) / STEPS, 0.5f * ((float)j + 0.5f) / STEPS);
        }
    }
    return sum / (STEPS * STEPS);
}

/* Returns how often the mark begins along a path from snout to tail. The path is at the girth
 * coordinate `v`. */
static int entered_along(struct species_mark mark, float v)
{
    int count = 0;
    for (int i = 1; i < 1000; i++) {
        count += cover(mark, (float)i / 1000.0f, v) >= 0.5f &&
                 cover(mark, (float)(i - 1) / 1000.0f, v) < 0.5f;
    }
    return count;
}

static int entered_round(struct species_mark mark, float u)
{
    int count = 0;
    for (int i = 1; i < 1000; i++) {
        count += cover(mark, u, 0.5f * (float)i / 1000.0f) >= 0.5f &&
                 cover(mark, u, 0.5f * (float)(i - 1) / 1000.0f) < 0.5f;
    }
    return count;
}

static void test_the_area_of_spots_follows_their_count_and_radius(void **state)
{
    (void)state;
    struct species_mark m = { .kind = MARK_SPOTS,
                              .count = 10,
                              .seed = 1,
                              .width = 0.02f,
                              .from = 0.1f,
                              .to = 0.5f,
                              .high = 1.0f };
    /* Area of one spot, as a fraction of the area of a flank that is 1 long and 0.36 high. */
    const float one = 3.1416f * 0.02f * 0.02f / 0.36f;
    const float ten = covered_area(m);
    m.count = 40;
    m.width = 0.01f;
    const float forty = covered_area(m);
    /* The tolerance is wide, because the spots have random radii and each fills a whole number of
     * cells. */
    assert_float_equal(ten / one, 10.0f, 3.0f);
    assert_float_equal(forty / one * 4.0f, 40.0f, 10.0f);
    assert_float_equal(cover(m, 0.7f, RIGHT_FLANK), 0.0f, 0.0f);
}

static void test_spots_depend_on_the_seed_and_the_flank(void **state)
{
    (void)state;
    struct species_mark m = {
        .kind = MARK_SPOTS, .count = 30, .seed = 1, .width = 0.02f, .to = 1.0f, .high = 1.0f
    };
    struct species_mark other = m;
    other.seed = 2;
    float by_seed = 0.0f, by_flank = 0.0f;
    for (int i = 0; i < STEPS; i++) {
        const float u = (float)i / STEPS;
        by_seed += f_abs(cover(m, u, RIGHT_FLANK) - cover(other, u, RIGHT_FLANK));
        by_flank += f_abs(cover(m, u, RIGHT_FLANK) - cover(m, u, LEFT_FLANK));
    }
    assert_true(by_seed > 5.0f);
    assert_true(by_flank > 5.0f);
}

static void test_bars_have_the_given_count_and_slant(void **state)
{
    (void)state;
    struct species_mark m = {
        .kind = MARK_BANDS, .count = 4, .width = 0.06f, .from = 0.2f, .to = 0.8f, .high = 1.0f
    };
    assert_int_equal(entered_along(m, RIGHT_FLANK), 4);
    assert_float_equal(cover(m, 0.275f, 0.1f), 1.0f, 1e-3f);
    /* The bar is slanted, so its upper end is shifted by 0.05 toward the tail. */
    m.slant = 0.1f;
    assert_float_equal(cover(m, 0.275f, 0.02f), 0.0f, 1e-3f);
    assert_float_equal(cover(m, 0.325f, 0.02f), 1.0f, 1e-3f);
    m.low = 0.5f;
    assert_float_equal(cover(m, 0.275f, 0.4f), 0.0f, 1e-3f);
}

static void test_stripes_run_along_the_flank(void **state)
{
    (void)state;
    const struct species_mark m = {
        .kind = MARK_STRIPES, .count = 3, .width = 0.08f, .to = 1.0f, .low = 0.2f, .high = 0.8f
    };
    assert_int_equal(entered_round(m, 0.5f), 3);
    /* The path begins inside the stripe, so it does not enter the stripe. */
    assert_int_equal(entered_along(m, RIGHT_FLANK), 0);
    assert_float_equal(cover(m, 0.5f, RIGHT_FLANK), 1.0f, 1e-3f);
}

static void test_every_row_has_its_dots(void **state)
{
    (void)state;
    const struct species_mark m = { .kind = MARK_ROWS,
                                    .count = 8,
                                    .seed = 1,
                                    .width = 0.02f,
                                    .from = 0.1f,
                                    .to = 0.9f,
                                    .low = 0.4f,
                                    .high = 0.6f };
    assert_int_equal(entered_along(m, RIGHT_FLANK), 8);
    assert_float_equal(cover(m, 0.5f, 0.05f), 0.0f, 0.0f);
}

static void test_a_margin_is_on_the_outer_part_of_its_own_fin(void **state)
{
    (void)state;
    struct species_mark m = { .kind = MARK_EDGE, .part = PART_DORSAL, .width = 0.2f, .to = 1.0f };
    assert_float_equal(cover(m, 0.5f, 0.95f), 1.0f, 1e-3f);
    assert_float_equal(cover(m, 0.5f, 0.6f), 0.0f, 1e-3f);
    const struct species_vertex anal = { .u = 0.5f, .v = 0.95f, .part = PART_ANAL };
    const struct mark_point point = mark_point_of(&anal, FORM_FUSIFORM);
    assert_float_equal(mark_cover(&m, &point), 0.0f, 0.0f);
}

static void test_a_blind_side_is_one_flank_and_its_paired_fins(void **state)
{
    (void)state;
    const struct species_mark m = {
        .kind = MARK_SIDE, .count = SIDE_RIGHT, .width = 0.1f, .to = 1.0f
    };
    assert_float_equal(cover(m, 0.5f, RIGHT_FLANK), 1.0f, 1e-3f);
    assert_float_equal(cover(m, 0.5f, LEFT_FLANK), 0.0f, 1e-3f);
    /* On the middle of the back (v = 0), the fish still has the colour of the left flank. */
    assert_float_equal(cover(m, 0.5f, 0.0f), 0.0f, 0.0f);
    assert_float_equal(cover(m, 0.5f, 0.01f), 0.0f, 0.0f);
    /* The colour changes gradually from v = 0.04 to v = 0.10. */
    assert_float_equal(cover(m, 0.5f, 0.04f), 0.0f, 0.01f);
    assert_float_equal(cover(m, 0.5f, 0.10f), 1.0f, 0.01f);
    struct species_vertex fin = { .part = PART_PECTORAL, .side = SIDE_RIGHT };
    struct mark_point point = mark_point_of(&fin, FORM_FUSIFORM);
    assert_float_equal(mark_cover(&m, &point), 1.0f, 1e-3f);
    fin.side = SIDE_LEFT;
    point = mark_point_of(&fin, FORM_FUSIFORM);
    assert_float_equal(mark_cover(&m, &point), 0.0f, 1e-3f);
}

/* Returns the difference of the colours at two points of a young fish, which has the shape of key
 * 2. */
static float unlike(const struct species *species, struct species_vertex a, struct species_vertex b)
{
    const float weights[MORPH_KEY_MAX] = { 0.0f, 0.0f, 1.0f };
    return v3_length(
        v3_sub(paint_at(species, weights, &a).colour, paint_at(species, weights, &b).colour));
}

static void test_skin_colour_blends_into_the_tail_fin_colour(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_vertex fin = { .u = 0.5f, .part = PART_TAIL };
        const struct species_vertex end = { .u = 1.0f, .v = 0.25f, .part = PART_BODY };
        const struct species_vertex stalk = { .u = 0.95f, .v = 0.25f, .part = PART_BODY };
        /* The whip tail of a ray (MOTION_WING) has no fin at its end, so rays are skipped. */
        if (species_table[i]->card.motion != MOTION_WING) {
            assert_true(unlike(species_table[i], end, fin) <=
                        0.15f * unlike(species_table[i], stalk, fin) + 0.01f);
        }
    }
}

static void test_mouth_and_gill_are_fine_lines_of_the_head(void **state)
{
    (void)state;
    const struct species_mark mouth = {
        .kind = MARK_MOUTH, .width = 0.006f, .to = 0.06f, .low = 0.4f, .high = 0.5f
    };
    const struct species_mark gill = {
        .kind = MARK_GILL, .width = 0.01f, .to = 0.3f, .slant = 0.25f, .low = 0.1f, .high = 0.8f
    };
    assert_float_equal(cover(mouth, 0.001f, RIGHT_FLANK), 1.0f, 1e-3f);
    assert_float_equal(cover(mouth, 0.1f, RIGHT_FLANK), 0.0f, 0.0f);
    assert_int_equal(entered_along(gill, 0.27f), 1);
    assert_true(covered_area(mouth) > 0.0f && covered_area(mouth) < 0.01f);
    assert_true(covered_area(gill) > 0.0f && covered_area(gill) < 0.02f);
}

static void test_a_pupil_is_black_and_never_transparent(void **state)
{
    (void)state;
    struct species one = { .card.key_count = 3 };
    one.coats[0] = (struct species_coat){ .iris = 0xffd040, .flank = 0x808080, .clear = 255 };
    const float weights[MORPH_KEY_MAX] = { 1.0f };
    struct species_vertex at = { .part = PART_EYE, .u = 0.2f };
    assert_true(paint_at(&one, weights, &at).colour.x < 0.05f);
    at.u = 0.7f;
    assert_true(paint_at(&one, weights, &at).colour.x > 0.9f);
    assert_float_equal(paint_at(&one, weights, &at).clear, 0.0f, 0.0f);
    at.part = PART_BODY;
    assert_float_equal(paint_at(&one, weights, &at).clear, 1.0f, 1e-5f);
}

static void test_negative_weights_of_solved_shapes_remove_no_colour(void **state)
{
    (void)state;
    struct species two = { .card.key_count = 3 };
    two.coats[0].flank = two.coats[0].back = two.coats[0].belly = 0xffffff;
    const float weights[MORPH_KEY_MAX] = { 1.2f, -0.2f, 0.0f };
    const struct species_vertex at = { .u = 0.5f, .v = RIGHT_FLANK };
    assert_float_equal(paint_at(&two, weights, &at).colour.y, 1.0f, 1e-4f);
}

/* Samples points on the whole body of every built-in species at small steps of growth. In one step,
 * no colour may change by much. */
static void test_paint_changes_continuously_as_every_species_grows(void **state)
{
    (void)state;
    for (uint32_t s = 0; s < species_table_count; s++) {
        const struct species *species = species_table[s];
        const struct species_mesh *mesh = &species->lod[1];
        struct morph_rig rig;
        morph_rig_init(&rig, &species->card, TEMPLATE_PAIRWISE);
        for (uint32_t i = 0; i < mesh->vertex_count; i += 3) {
            struct paint before = { .clear = -1.0f };
            for (int step = 0; step <= GROWTH_STEPS; step++) {
                float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
                morph_weights(&rig, (float)step / (float)GROWTH_STEPS, weights);
                const struct paint now = paint_at(species, weights[0], &mesh->vertices[i]);
                assert_true(now.clear >= 0.0f && now.clear <= 1.0f);
                assert_true(now.shine >= 0.0f && now.shine <= 1.0f);
                if (step > 0) {
                    assert_true(v3_length(v3_sub(now.colour, before.colour)) < 0.05f);
                    assert_true(f_abs(now.clear - before.clear) < 0.02f);
                }
                before = now;
            }
        }
    }
}

/* In both coats, mark number 0 has the same kind and count, so the two marks are blended to one
 * mark. At half progress, this mark must be half way between the two positions, and its colour must
 * have full strength. */
static void test_a_mark_of_two_keys_moves_and_does_not_fade(void **state)
{
    (void)state;
    struct species two = { .card.key_count = 3 };
    struct species_mark bar = { .kind = MARK_BANDS,
                                .count = 1,
                                .width = 0.1f,
                                .colour = 0xffffff,
                                .from = 0.2f,
                                .to = 0.3f,
                                .high = 1.0f };
    two.coats[0].marks[0] = bar;
    bar.from = 0.6f;
    bar.to = 0.7f;
    two.coats[1].marks[0] = bar;
    two.coats[0].mark_count = two.coats[1].mark_count = 1;
    const float weights[MORPH_KEY_MAX] = { 0.5f, 0.5f };
    struct species_vertex at = { .u = 0.45f, .v = RIGHT_FLANK };
    assert_float_equal(paint_at(&two, weights, &at).colour.x, 1.0f, 1e-3f);
    at.u = 0.25f;
    assert_float_equal(paint_at(&two, weights, &at).colour.x, 0.0f, 1e-3f);
    /* Marks with different counts cannot be blended to one mark, so each of the two marks has half
     * strength. */
    two.coats[1].marks[0].count = 2;
    assert_float_equal(paint_at(&two, weights, &at).colour.x, 0.5f, 1e-3f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_area_of_spots_follows_their_count_and_radius),
        cmocka_unit_test(test_spots_depend_on_the_seed_and_the_flank),
        cmocka_unit_test(test_bars_have_the_given_count_and_slant),
        cmocka_unit_test(test_stripes_run_along_the_flank),
        cmocka_unit_test(test_every_row_has_its_dots),
        cmocka_unit_test(test_a_margin_is_on_the_outer_part_of_its_own_fin),
        cmocka_unit_test(test_a_blind_side_is_one_flank_and_its_paired_fins),
        cmocka_unit_test(test_skin_colour_blends_into_the_tail_fin_colour),
        cmocka_unit_test(test_mouth_and_gill_are_fine_lines_of_the_head),
        cmocka_unit_test(test_a_pupil_is_black_and_never_transparent),
        cmocka_unit_test(test_negative_weights_of_solved_shapes_remove_no_colour),
        cmocka_unit_test(test_a_mark_of_two_keys_moves_and_does_not_fade),
        cmocka_unit_test(test_paint_changes_continuously_as_every_species_grows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
