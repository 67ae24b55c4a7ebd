/* test_loft.c -- Tests the module `loft`, which converts the text description of a fish (outlines,
 * eyes, fins) to a mesh. */
#include "platform/species/shape.h"
#include "tests/unit/support/species_text.h"

#include <math.h>

#include "core/base/fmath.h"

static struct loft loft;

static struct species_text *drawn(const char *head, const char *more, const char *tail)
{
    static char text[TEXT_SIZE];
    snprintf(text, sizeof text,
             HEAD "%skey a 10\n%s" KEY_BODY "key b 20\n%s" KEY_BODY "key c 40\n%s" KEY_BODY "%s",
             head, more, more, more, tail);
    assert_string_equal(complaint_of(text), "");
    return &species;
}

static const struct loft *lofted(const char *head, const char *more, const char *tail)
{
    species_loft(drawn(head, more, tail), &species_detail[0], &loft);
    return &loft;
}

/* Returns the size of a key shape. The size is computed from the mesh alone, as the species defines
 * it (for example as total length), and must be 1. */
static float measured(const struct species *s, const vec3 *at, const struct species_mesh *mesh)
{
    float front = 9.0f, rear = -9.0f, right = -9.0f, left = 9.0f, fork = -9.0f, root = -9.0f;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *v = &mesh->vertices[i];
        front = f_min(front, at[i].z);
        rear = f_max(rear, at[i].z);
        right = f_max(right, at[i].x);
        left = f_min(left, at[i].x);
        fork = v->part == PART_TAIL && v->v == 1.0f && f_abs(v->u - 0.5f) < 0.01f ? at[i].z : fork;
        root = v->part == PART_BODY && v->u == 1.0f && i >= mesh->grid_first &&
                       i < mesh->grid_first + mesh->grid_rings * (mesh->grid_spokes + 1u)
                   ? at[i].z
                   : root;
    }
    switch (s->card.measure) {
    case MEASURE_TOTAL:
        return rear - front;
    case MEASURE_STANDARD:
        return root - front;
    case MEASURE_FORK:
        return fork - front;
    default:
        return right - left;
    }
}

static void test_every_key_of_every_species_has_measure_1(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species *s = species_table[i];
        for (uint32_t key = 0; key < s->card.key_count; key++) {
            static vec3 at[MESH_VERTEX_MAX];
            static struct morph_pose pose;
            morph_key_pose(&s->lod[0], s->card.key_count, key, &pose);
            morph_shape(&s->lod[0], s->card.key_count, &pose, at, NULL);
            /* The tolerance is needed because the outermost point of a shape may lie between two
             * vertices. */
            assert_float_equal(measured(s, at, &s->lod[0]), 1.0f, 0.01f);
        }
    }
}

/* The tail must extend equally far to the right and to the left. */
static void test_every_tail_is_symmetric(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        const struct species_mesh *mesh = &species_table[i]->lod[0];
        for (uint32_t key = 0; key < species_table[i]->card.key_count; key++) {
            float right = 0.0f, left = 0.0f;
            for (uint32_t j = 0; j < mesh->vertex_count; j++) {
                const float x = morph_position(mesh, key, j).x;
                if (mesh->vertices[j].part == PART_TAIL) {
                    right = f_max(right, x);
                    left = f_max(left, -x);
                }
            }
            assert_float_equal(right, left, 0.05f * right + 1e-3f);
        }
    }
}

static void test_a_tail_root_is_rounded_off(void **state)
{
    (void)state;
    const struct loft *l = lofted("", "", "template pairwise\n");
    const uint32_t row = l->grid_spokes + 1u, cap = l->grid_first + l->grid_rings * row;
    const vec3 back = l->positions[0][cap - row], round = l->positions[0][cap];
    const vec3 point = l->positions[0][cap + row];
    const float there = (round.z - back.z) / (point.z - back.z);
    const float left = (round.y - point.y) / (back.y - point.y);
    assert_in_range((uint32_t)(100.0f * there), 40, 80);
    /* If the root were a straight cone from the body to its tip, `left` would be 1 - `there`. A
     * rounded root is wider than this cone. */
    assert_true(left > 1.15f * (1.0f - there));
    assert_float_equal(there * there + left * left, 1.0f, 0.01f);
}

static void test_rings_advance_to_the_tail_root_and_are_denser_in_curved_outlines(void **state)
{
    (void)state;
    const struct loft *l = lofted("", "", "template pairwise\n");
    const uint32_t row = l->grid_spokes + 1;
    float before = 0.0f, head_gap = 0.0f, widest = 0.0f;
    bool at_gill = false;
    for (uint32_t ring = 0; ring < l->grid_rings; ring++) {
        const float u = l->vertices[l->grid_first + ring * row].u;
        assert_true(u > before);
        at_gill = at_gill || u == GILL_U;
        head_gap = ring == 0 ? u : head_gap;
        widest = f_max(widest, u - before);
        before = u;
    }
    assert_float_equal(before, 1.0f, 0.0f);
    assert_true(at_gill);
    assert_true(head_gap < 0.25f * widest); /* The snout is more curved than the flank, so rings are
                                               denser there. */
    assert_true(widest < 0.16f);            /* No gap may be large, because a swimming body bends
                                               everywhere. */
}

static void test_body_coordinates_keep_the_gill_cover_at_its_drawn_position(void **state)
{
    (void)state;
    const struct key_text *key = &drawn("", "gill .2\n", "template pairwise\n")->keys[0];
    assert_float_equal((float)shape_body_x(key, (double)GILL_U), 0.2f, 1e-6f);
    assert_float_equal((float)shape_body_x(key, 1.0), 1.0f, 1e-6f);
    for (int i = 0; i <= 20; i++) {
        assert_float_equal((float)shape_body_u(key, shape_body_x(key, i / 20.0)), (float)i / 20.0f,
                           1e-5f);
    }
}

static void test_fins_and_eyes_have_anchors_and_body_and_tail_have_none(void **state)
{
    (void)state;
    const struct loft *l = lofted("", "finlets upper 3 .82 .96 .03 50\n", "template pairwise\n");
    uint32_t turning = 0;
    for (uint32_t i = 0; i < l->vertex_count; i++) {
        const struct species_vertex *v = &l->vertices[i];
        const bool rides = v->part != PART_BODY && v->part != PART_TAIL;
        assert_int_equal(v->anchor != ANCHOR_NONE, rides);
        assert_true(!rides || v->anchor < l->anchor_count);
        assert_int_equal(rides && l->anchors[v->anchor].turns, v->part == PART_EYE);
    }
    for (uint32_t i = 0; i < l->anchor_count; i++) {
        turning += l->anchors[i].turns;
        for (uint32_t key = 0; key < 3; key++) {
            assert_true(l->anchors[i].u[key] >= 0.0f && l->anchors[i].u[key] <= 1.0f);
        }
    }
    assert_int_equal(turning, 2);
}

static void test_a_migrating_eye_moves_over_the_back_to_the_other_flank(void **state)
{
    (void)state;
    struct species_text *text = drawn("", "", "template smooth\n");
    text->keys[1].eyes[0].turn_deg = 90.0f;
    text->keys[2].eyes[0].turn_deg = 180.0f;
    const struct ball own = shape_eye_ball(&text->keys[0], 0),
                      top = shape_eye_ball(&text->keys[1], 0);
    const struct ball other = shape_eye_ball(&text->keys[2], 0),
                      left = shape_eye_ball(&text->keys[0], 1);
    assert_true(own.v > 0.1 && own.v < 0.3);
    assert_float_equal((float)top.v, 0.0f, 1e-6f);
    /* After the migration, the eye must be at the place of the left eye. v wraps around at 1, so
     * the two values may differ by 1. */
    assert_float_equal((float)(other.v + 1.0), (float)left.v, 1e-6f);
}

/* A bulge of 0.5 means that the eye protrudes by half of its diameter. The diameter is 0.08. */
static void test_an_eye_protrudes_by_its_bulge(void **state)
{
    (void)state;
    struct species_text *text = drawn("", "", "template smooth\n");
    text->keys[0].eyes[0].bulge = 0.5f;
    const struct ball ball = shape_eye_ball(&text->keys[0], 0);
    assert_float_equal((float)(ball.out - ball.sunk), 0.5f * 0.08f, 1e-5f);
    assert_true(ball.in > 0.0 && ball.sunk > 0.0);
}

static void test_eyes_of_a_thin_head_do_not_intersect(void **state)
{
    (void)state;
    struct species_text *text = drawn("", "", "template smooth\n");
    for (uint32_t i = 0; i < text->keys[0].substep_count; i++) {
        /* The body becomes as thin as that of a leptocephalus (larva of an eel). */
        text->keys[0].stations[i].width = 0.010f;
    }
    const struct ball ball = shape_eye_ball(&text->keys[0], 0);
    /* The width of the body is 0.01. Each eye must end before half of this width, so that it does
     * not touch the eye of the other side. */
    assert_true(ball.sunk + ball.in < 0.005);
}

static void test_a_fin_ray_has_its_root_inside_the_body_and_its_second_point_outside(void **state)
{
    (void)state;
    const struct key_text *key = &drawn("", "", "template smooth\n")->keys[0];
    const enum species_part parts[] = { PART_DORSAL, PART_ANAL };
    for (int i = 0; i < 2; i++) {
        for (int at = 0; at <= 10; at++) {
            const v3d root = shape_fin_point(key, parts[i], at / 10.0, 0.0);
            const v3d out = shape_fin_point(key, parts[i], at / 10.0, 0.01);
            const struct station there = shape_section(key, root.z),
                                 beyond = shape_section(key, out.z);
            assert_true(fabs(root.y - (double)there.offset) < 0.5 * (double)there.depth);
            assert_true(fabs(out.y - (double)beyond.offset) > 0.5 * (double)beyond.depth);
        }
    }
}

static void test_confluent_fins_end_at_the_tail_edges(void **state)
{
    (void)state;
    const struct key_text *key = &drawn("confluent\n", "", "template smooth\n")->keys[0];
    for (int i = 0; i <= 4; i++) {
        const v3d dorsal = shape_fin_point(key, PART_DORSAL, 1.0, i / 4.0);
        const v3d anal = shape_fin_point(key, PART_ANAL, 1.0, i / 4.0);
        assert_true(v3d_length(v3d_sub(dorsal, shape_fin_point(key, PART_TAIL, 0.0, i / 4.0))) <
                    1e-9);
        assert_true(v3d_length(v3d_sub(anal, shape_fin_point(key, PART_TAIL, 1.0, i / 4.0))) <
                    1e-9);
    }
}

/* The half of a double tail that the text describes is on the right side, and the other half is its
 * mirror image. Both halves meet at the fold on the midline. */
static void test_a_double_tail_has_two_mirrored_halves(void **state)
{
    (void)state;
    const struct key_text *key = &drawn("double\n", "", "template smooth\n")->keys[0];
    for (int i = 0; i <= 8; i++) {
        for (int k = 0; k <= 4; k++) {
            const v3d right = shape_fin_point(key, PART_TAIL, i / 16.0, k / 4.0);
            const v3d left = shape_fin_point(key, PART_TAIL, 1.0 - i / 16.0, k / 4.0);
            assert_true(fabs(right.x + left.x) < 1e-12);
            assert_true(fabs(right.y - left.y) < 1e-12 && fabs(right.z - left.z) < 1e-12);
            assert_true(i < 8 || right.x == 0.0);
        }
    }
    /* The first ray of the text is the fold, and the last ray is the lower edge of each half. */
    assert_true(shape_fin_point(key, PART_TAIL, 0.5, 0.0).y >
                shape_fin_point(key, PART_TAIL, 0.0, 0.0).y);
}

/* Two curves cover the same area, so each curve gets half of 255. If both halves were rounded up to
 * 128, their sum would exceed 255. */
static void test_masks_that_round_up_together_still_sum_to_255(void **state)
{
    (void)state;
    const struct loft *l = lofted("", "",
                                  "template pairwise\n"
                                  "curve here\narea 0 1 0 1 .1\ntemplate smooth\n"
                                  "curve there\narea 0 1 0 1 .1\ntemplate smooth\n");
    uint32_t halved = 0;
    for (uint32_t i = 0; i < l->vertex_count; i++) {
        const struct species_vertex *v = &l->vertices[i];
        assert_int_equal(v->mask[0] + v->mask[1] + v->mask[2] + v->mask[3], 255);
        halved += v->mask[1] == 127 && v->mask[2] == 128;
    }
    assert_true(halved > 100);
}

static void test_masks_sum_to_255_and_are_continuous(void **state)
{
    (void)state;
    const struct loft *l = lofted("", "",
                                  "template pairwise\ncurve front head eye\n"
                                  "template smooth\ncurve fins dorsal tail\n"
                                  "template smooth\n");
    for (uint32_t i = 0; i < l->vertex_count; i++) {
        const struct species_vertex *v = &l->vertices[i];
        assert_int_equal(v->mask[0] + v->mask[1] + v->mask[2] + v->mask[3], 255);
        assert_true(v->part != PART_EYE || v->mask[1] == 255);
        assert_true(v->part != PART_DORSAL || v->mask[2] == 255);
        assert_true(v->part != PART_ANAL || v->mask[0] == 255);
        /* At the root of the tail fin (v = 0), curve 2 must have no influence. */
        assert_true(v->part != PART_TAIL || v->v > 0.0f || v->mask[2] == 0);
        assert_true(v->part != PART_TAIL || v->v < 1.0f || v->mask[2] == 255);
        assert_true(v->part != PART_BODY || v->u > 0.2f || v->mask[1] == 255);
        assert_true(v->part != PART_BODY || v->u < 0.4f || v->mask[1] == 0);
    }
}

static void test_a_curve_area_has_a_soft_mask(void **state)
{
    (void)state;
    const struct loft *l = lofted("", "",
                                  "template pairwise\ncurve hump\n"
                                  "area .4 .6 .5 1 .1\ntemplate smooth\n");
    bool soft = false;
    for (uint32_t i = 0; i < l->vertex_count; i++) {
        const struct species_vertex *v = &l->vertices[i];
        const bool on_back = v->v < 0.1f || v->v > 0.9f;
        if (v->part == PART_BODY && on_back && v->u > 0.42f && v->u < 0.58f) {
            assert_int_equal(v->mask[1], 255);
        }
        if (v->part != PART_BODY || v->u < 0.29f || v->u > 0.71f) {
            assert_int_equal(v->mask[1], 0);
        }
        soft = soft || (v->mask[1] > 0 && v->mask[1] < 255);
    }
    assert_true(soft);
}

static void test_a_long_fin_uses_a_coarser_quantization(void **state)
{
    (void)state;
    assert_float_equal(lofted("", "", "template smooth\n")->reach, 1.0f, 0.0f);
    for (uint32_t i = 0; i < species_table_count; i++) {
        const float reach = species_table[i]->card.measure == MEASURE_DISC ? 4.0f : 1.0f;
        assert_float_equal(species_table[i]->lod[0].reach, reach, 0.0f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_key_of_every_species_has_measure_1),
        cmocka_unit_test(test_every_tail_is_symmetric),
        cmocka_unit_test(test_a_tail_root_is_rounded_off),
        cmocka_unit_test(test_rings_advance_to_the_tail_root_and_are_denser_in_curved_outlines),
        cmocka_unit_test(test_body_coordinates_keep_the_gill_cover_at_its_drawn_position),
        cmocka_unit_test(test_fins_and_eyes_have_anchors_and_body_and_tail_have_none),
        cmocka_unit_test(test_a_migrating_eye_moves_over_the_back_to_the_other_flank),
        cmocka_unit_test(test_an_eye_protrudes_by_its_bulge),
        cmocka_unit_test(test_eyes_of_a_thin_head_do_not_intersect),
        cmocka_unit_test(test_a_fin_ray_has_its_root_inside_the_body_and_its_second_point_outside),
        cmocka_unit_test(test_confluent_fins_end_at_the_tail_edges),
        cmocka_unit_test(test_a_double_tail_has_two_mirrored_halves),
        cmocka_unit_test(test_masks_that_round_up_together_still_sum_to_255),
        cmocka_unit_test(test_masks_sum_to_255_and_are_continuous),
        cmocka_unit_test(test_a_curve_area_has_a_soft_mask),
        cmocka_unit_test(test_a_long_fin_uses_a_coarser_quantization),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
