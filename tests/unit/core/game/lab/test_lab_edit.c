/* test_lab_edit.c -- checks that a morph graph stays valid after any edit. The knots must be in
 * ascending order, no weight may be negative, and the weights of a knot must sum to 1. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/game/lab/lab_edit.h"

static const struct species_card *card;
static struct lab_edit edit;

static int setup(void **state)
{
    (void)state;
    card = &species_table[0]->card;
    lab_edit_own(&edit, card);
    return 0;
}

static float sum_at(uint32_t knot)
{
    float sum = 0.0f;
    for (uint32_t key = 0; key < card->key_count; key++) {
        assert_true(edit.graph.knots[knot].weight[key] >= 0.0f);
        sum += edit.graph.knots[knot].weight[key];
    }
    return sum;
}

static void test_the_other_weights_share_the_rest_in_proportion(void **state)
{
    (void)state;
    float *weight = edit.graph.knots[1].weight;
    memset(weight, 0, sizeof edit.graph.knots[1].weight);
    weight[0] = 0.5f;
    weight[1] = 0.3f;
    weight[2] = 0.2f;
    lab_edit_weigh(&edit, card->key_count, 1, 0, 0.75f);
    assert_float_equal(weight[0], 0.75f, 1e-6f);
    assert_float_equal(weight[1], 0.15f, 1e-6f);
    assert_float_equal(weight[2], 0.10f, 1e-6f);
    assert_float_equal(sum_at(1), 1.0f, 1e-6f);
}

static void test_the_neighbours_share_the_rest_equally_if_the_others_are_zero(void **state)
{
    (void)state;
    float *weight = edit.graph.knots[1].weight;
    memset(weight, 0, sizeof edit.graph.knots[1].weight);
    weight[1] = 1.0f;
    lab_edit_weigh(&edit, card->key_count, 1, 1, 0.4f);
    assert_float_equal(weight[0], 0.3f, 1e-6f);
    assert_float_equal(weight[1], 0.4f, 1e-6f);
    assert_float_equal(weight[2], 0.3f, 1e-6f);
    memset(weight, 0, sizeof edit.graph.knots[1].weight);
    /* The first key has only one neighbour, so this neighbour gets the whole remaining weight. */
    weight[0] = 1.0f;
    lab_edit_weigh(&edit, card->key_count, 1, 0, 0.4f);
    assert_float_equal(weight[1], 0.6f, 1e-6f);
}

static void test_weights_are_clamped_to_their_bounds(void **state)
{
    (void)state;
    lab_edit_weigh(&edit, card->key_count, 1, 0, 7.0f);
    assert_float_equal(edit.graph.knots[1].weight[0], 1.0f, 0.0f);
    assert_float_equal(sum_at(1), 1.0f, 1e-6f);
    lab_edit_weigh(&edit, card->key_count, 1, 0, -3.0f);
    assert_float_equal(edit.graph.knots[1].weight[0], 0.0f, 0.0f);
    assert_float_equal(sum_at(1), 1.0f, 1e-6f);
}

static void test_knots_keep_their_order_and_end_knots_keep_their_positions(void **state)
{
    (void)state;
    struct graph_knot *knots = edit.graph.knots;
    lab_edit_move(&edit, 1, 0.9f);
    assert_float_equal(knots[1].progress, knots[2].progress - LAB_KNOT_GAP, 1e-6f);
    lab_edit_move(&edit, 1, -1.0f);
    assert_float_equal(knots[1].progress, LAB_KNOT_GAP, 1e-6f);
    lab_edit_move(&edit, 0, 0.3f);
    assert_float_equal(knots[0].progress, 0.0f, 0.0f);
    lab_edit_move(&edit, edit.graph.knot_count - 1u, 0.3f);
    assert_float_equal(knots[edit.graph.knot_count - 1u].progress, 1.0f, 0.0f);
}

static void test_a_new_knot_does_not_change_a_straight_line(void **state)
{
    (void)state;
    lab_edit_template(&edit, card, TEMPLATE_PAIRWISE);
    const struct graph before = edit.graph;
    const uint32_t knot = lab_edit_add(&edit, card->key_count, 0.11f);
    assert_int_equal(knot, 1);
    assert_int_equal(edit.graph.knot_count, before.knot_count + 1u);
    for (uint32_t i = 0; i <= 100; i++) {
        float was[MORPH_KEY_MAX], is[MORPH_KEY_MAX];
        graph_weights(&before, card->key_count, 0.01f * (float)i, was);
        graph_weights(&edit.graph, card->key_count, 0.01f * (float)i, is);
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            assert_float_equal(is[key], was[key], 2e-6f);
        }
    }
    assert_true(lab_edit_remove(&edit, 0.12f));
    assert_true(lab_edit_same(
        &edit, &(struct lab_edit){ .template_id = TEMPLATE_PAIRWISE, .graph = before }));
}

static void test_a_curve_has_two_to_twelve_knots(void **state)
{
    (void)state;
    for (uint32_t i = 1; i < 40; i++) {
        lab_edit_add(&edit, card->key_count, 0.025f * (float)i);
        assert_in_range(edit.graph.knot_count, 2, GRAPH_KNOT_MAX);
    }
    assert_int_equal(edit.graph.knot_count, GRAPH_KNOT_MAX);
    assert_int_equal(lab_edit_add(&edit, card->key_count, 0.987f), LAB_NO_KNOT);
    while (lab_edit_remove(&edit, 0.5f)) {
    }
    assert_int_equal(edit.graph.knot_count, 2);
    /* The place 0.001 is too close to the first knot (at 0), so no knot is added. */
    assert_int_equal(lab_edit_add(&edit, card->key_count, 0.001f), LAB_NO_KNOT);
}

static void test_each_template_of_the_editor_belongs_to_the_species(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < species_table_count; i++) {
        card = &species_table[i]->card;
        lab_edit_own(&edit, card);
        for (uint32_t template_id = TEMPLATE_OWN; template_id < TEMPLATE_COUNT; template_id++) {
            struct species_card applied;
            lab_edit_template(&edit, card, (enum graph_template)template_id);
            assert_true(lab_edit_is_valid(&edit, card));
            lab_edit_apply(&edit, card, &applied);
            const uint32_t curve = card->curve_count - 1u;
            const struct graph *part =
                template_id == TEMPLATE_OWN && curve > 0 ? &card->curves[curve] : &edit.graph;
            assert_memory_equal(&applied.curves[curve], part, sizeof *part);
        }
    }
}

/* Makes ten thousand random edits to the knots of each species. */
static void test_ten_thousand_random_edits_leave_a_valid_graph(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 10000; i++) {
        const struct rng_key draw = { 4, i, 0, RNG_TEST };
        const uint32_t bits = rng_u32(draw);
        const float a = (float)(bits & 1023u) / 800.0f - 0.1f;
        const float b = (float)(bits >> 10 & 1023u) / 800.0f - 0.1f;
        const uint32_t knot = (bits >> 20) % edit.graph.knot_count;
        lab_edit_weigh(&edit, card->key_count, knot, (bits >> 24) % card->key_count, a);
        lab_edit_move(&edit, knot, b);
        if (bits >> 28 == 1u) {
            lab_edit_add(&edit, card->key_count, f_clamp(b, 0.0f, 1.0f));
        } else if (bits >> 28 == 2u) {
            lab_edit_remove(&edit, b);
        }
        /* Clears `solved`, because graph_check() would otherwise require that the shapes can be
         * solved. Random weights may not allow this. */
        edit.graph.solved = 0;
        assert_int_equal(graph_check(&edit.graph, card->key_count).fault, GRAPH_GOOD);
        for (uint32_t k = 0; k < edit.graph.knot_count; k++) {
            assert_float_equal(sum_at(k), 1.0f, 1e-6f);
        }
    }
}

/* Rounding errors must not accumulate over many edits. The limit in this test is a third of the
 * tolerance of graph_check(). */
static void test_weights_sum_to_one_after_any_edit(void **state)
{
    (void)state;
    struct lab_edit many = { .graph.knot_count = 2 };
    many.graph.knots[0].weight[0] = 1.0f;
    for (uint32_t i = 0; i < 10000; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ 3, i, 0, RNG_TEST });
        lab_edit_weigh(&many, MORPH_KEY_MAX, 0, bits % MORPH_KEY_MAX,
                       (float)(bits >> 8 & 0xffffu) / 65535.0f);
        double sum = 0.0;
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            assert_true(many.graph.knots[0].weight[key] >= 0.0f);
            sum += (double)many.graph.knots[0].weight[key];
        }
        assert_true(sum > 1.0 - 3e-7 && sum < 1.0 + 3e-7);
    }
}

static void test_the_first_edit_makes_the_growth_curve_custom(void **state)
{
    (void)state;
    struct scale_knot knots[GRAPH_KNOT_MAX];
    struct species_card applied;
    assert_int_equal(edit.scale_knot_count, 0);
    assert_int_equal(lab_edit_scale_knots(&edit, card, knots), card->key_count);
    lab_edit_size(&edit, card, 2, 0.05f);
    assert_int_equal(edit.scale_knot_count, card->key_count);
    lab_edit_apply(&edit, card, &applied);
    const float at = 2.0f / (float)(card->key_count - 1u);
    assert_float_equal(life_length_m(&applied, at), 0.05f, 1e-5f);
    assert_float_equal(life_length_m(&applied, 0.0f), life_length_m(card, 0.0f), 1e-6f);
    assert_true(lab_edit_is_valid(&edit, card));
    const uint32_t added = lab_edit_size_add(&edit, card, 0.1f);
    assert_int_equal(added, 1);
    lab_edit_size_move(&edit, card, added, 0.9f);
    assert_true(edit.scale_knots[1].progress < edit.scale_knots[2].progress);
    assert_true(lab_edit_size_remove(&edit, card, 0.1f));
    assert_true(lab_edit_is_valid(&edit, card));
}

/* When a knot is selected, the lab creates a custom size curve through all knots. As long as no
 * knot is moved, this curve must give the same lengths. Only near the conger's least length it may
 * differ by up to 3 %. */
static void test_a_size_knot_that_is_not_moved_changes_no_length(void **state)
{
    (void)state;
    for (uint32_t s = 0; s < species_table_count; s++) {
        const struct species_card *own = &species_table[s]->card;
        struct scale_knot knots[GRAPH_KNOT_MAX];
        struct lab_edit touched;
        struct species_card applied;
        const uint32_t conger = strcmp(own->id, "kuroanago") == 0 ? s : SPECIES_MAX;
        lab_edit_own(&touched, own);
        const uint32_t count = lab_edit_scale_knots(&touched, own, knots);
        const uint32_t middle = count / 2u;
        lab_edit_size_move(&touched, own, middle, knots[middle].progress);
        lab_edit_size(&touched, own, middle, knots[middle].length_m);
        assert_true(lab_edit_is_valid(&touched, own));
        lab_edit_apply(&touched, own, &applied);
        for (uint32_t i = 0; i <= 1000; i++) {
            const float progress = (float)i / 1000.0f, before = life_length_m(own, progress);
            const float after = life_length_m(&applied, progress);
            if (f_abs(after / before - 1.0f) > (s == conger ? 0.03f : 1e-5f)) {
                fail_msg("%s at %.3f: %.4f m for %.4f", own->id, (double)progress, (double)after,
                         (double)before);
            }
        }
    }
}

/* The conger has its least length (56.0 mm) not at a key, but between the shrinking larva and the
 * young eel. */
static void test_the_conger_keeps_its_least_length_with_a_custom_curve(void **state)
{
    (void)state;
    const struct species_card *conger = &species_table[0]->card;
    struct scale_knot knots[GRAPH_KNOT_MAX];
    struct lab_edit own;
    for (uint32_t s = 0; s < species_table_count; s++) {
        const struct species_card *is = &species_table[s]->card;
        conger = strcmp(is->id, "kuroanago") == 0 ? is : conger;
    }
    lab_edit_own(&own, conger);
    const uint32_t count = lab_edit_scale_knots(&own, conger, knots);
    assert_in_range(count, conger->key_count + 1u, GRAPH_KNOT_MAX);
    uint32_t least = 0;
    for (uint32_t i = 1; i < count; i++) {
        assert_true(knots[i].progress > knots[i - 1u].progress);
        least = knots[i].length_m < knots[least].length_m ? i : least;
    }
    assert_float_equal(knots[least].length_m, 0.056f, 1e-6f);
    assert_float_equal(life_age_days(conger, knots[least].progress), 240.0f, 0.1f);
}

static void test_the_length_axis_maps_forward_and_back(void **state)
{
    (void)state;
    for (float length_m = 0.004f; length_m < 0.3f; length_m *= 1.3f) {
        const float share = lab_length_share(card, length_m);
        assert_float_equal(lab_length_of_share(card, share), length_m, 1e-4f * length_m);
    }
    assert_true(lab_length_share(card, card->key_length_m[0]) > 0.0f);
    assert_true(lab_length_share(card, card->key_length_m[card->key_count - 1u]) < 1.0f);
}

static void test_a_book_with_an_invalid_card_or_graph_is_rejected(void **state)
{
    (void)state;
    static struct lab_book book;
    memset(&book, 0, sizeof book);
    assert_true(lab_book_is_valid(&book));
    book.card_count = 1;
    assert_false(lab_book_is_valid(&book)); /* This species card has only zero bytes. */
    book.cards[0] = *card;
    assert_true(lab_book_is_valid(&book));
    assert_int_equal(lab_book_count(&book), species_table_count + 1u);
    book.cards[0].key_length_m[1] = -1.0f;
    assert_false(lab_book_is_valid(&book));
    book.cards[0] = *card;
    /* Fills the id of the species card completely, so that it has no terminating zero byte. */
    memset(book.cards[0].id, 'x', sizeof book.cards[0].id);
    assert_false(lab_book_is_valid(&book));
    book.cards[0] = *card;
    book.has_edit[0] = 1;
    assert_false(lab_book_is_valid(&book)); /* The edited graph of the first species is still
                                               empty. */
    lab_edit_own(&book.edits[0], card);
    assert_true(lab_book_is_valid(&book));
    book.edits[0].graph.knots[1].weight[0] += 0.25f;
    assert_false(lab_book_is_valid(&book));
    book.card_count = SPECIES_EXTRA_MAX + 1u;
    assert_false(lab_book_is_valid(&book));
}

/* Each function that SPOIL() defines makes one value of a valid card invalid, as a disk error or a
 * manipulated file may do. */
#define SPOIL(name, what)                                                                          \
    static void name(struct species_card *c)                                                       \
    {                                                                                              \
        what;                                                                                      \
    }

SPOIL(age_without_end, c->key_age_days[c->key_count - 1u] = 1.0f / 0.0f)
SPOIL(age_no_number, c->key_age_days[1] = 0.0f / 0.0f)
SPOIL(ages_that_stand, c->key_age_days[2] = c->key_age_days[1])
SPOIL(age_beyond_all, c->key_age_days[c->key_count - 1u] = 14611.0f)
SPOIL(length_not_grown, c->key_length_m[1] *= 1.03f)
SPOIL(first_point_no_number, c->growth.points[0].age_days = 0.0f / 0.0f)
SPOIL(first_point_late, c->growth.points[0].age_days = 0.5f)
SPOIL(points_that_stand,
      c->growth.points[c->growth.point_count] = c->growth.points[c->growth.point_count - 1u];
      c->growth.point_count++)
SPOIL(no_points, c->growth.point_count = 0)
SPOIL(fade_none, c->growth.fade_year = 0.0f)
SPOIL(fade_without_end, c->growth.fade_year = 1.0f / 0.0f)
SPOIL(k_no_number, c->growth.k_per_year = 0.0f / 0.0f)
SPOIL(k_too_fast, c->growth.k_per_year = 10.1f)
SPOIL(t0_far, c->growth.t0_year = -1e30f)
SPOIL(inf_no_number, c->growth.length_inf_m = 0.0f / 0.0f)
SPOIL(inf_too_long, c->growth.length_inf_m = 21.0f)
SPOIL(thesis_key_far, c->thesis_key[2] = c->key_count)
SPOIL(thesis_keys_back, c->thesis_key[0] = c->thesis_key[1])
SPOIL(thesis_template_far, c->thesis_template = TEMPLATE_COUNT)
SPOIL(measure_far, c->measure = MEASURE_DISC + 1u)
SPOIL(motion_far, c->motion = MOTION_WING + 1u)
SPOIL(form_far, c->form = FORM_PUFFER + 1u)
SPOIL(curve_line_far, c->curves[c->curve_count - 1u].line = GRAPH_SMOOTH + 1u)
SPOIL(curve_solved_far, c->curves[c->curve_count - 1u].solved = 2)
SPOIL(curve_without_name, c->curve_names[0][0] = 0)
SPOIL(key_with_space, c->key_names[0][1] = ' ')
SPOIL(id_with_slash, c->id[0] = '/')
SPOIL(id_with_a_tail, c->id[SPECIES_NAME_SIZE - 1u] = 'x')
SPOIL(two_keys, c->key_count = 2)

static void test_a_card_with_one_invalid_number_is_rejected(void **state)
{
    (void)state;
    /* clang-format off */
    static const struct spoil {
        const char *name;
        void (*spoil)(struct species_card *);
    } spoils[] = {
#define ROW(name) { #name, name }
        ROW(age_without_end), ROW(age_no_number), ROW(ages_that_stand), ROW(age_beyond_all),
        ROW(length_not_grown), ROW(first_point_no_number), ROW(first_point_late),
        ROW(points_that_stand), ROW(no_points), ROW(fade_none), ROW(fade_without_end),
        ROW(k_no_number), ROW(k_too_fast), ROW(t0_far), ROW(inf_no_number), ROW(inf_too_long),
        ROW(thesis_key_far), ROW(thesis_keys_back), ROW(thesis_template_far), ROW(measure_far),
        ROW(motion_far), ROW(form_far), ROW(curve_line_far), ROW(curve_solved_far),
        ROW(curve_without_name), ROW(key_with_space), ROW(id_with_slash), ROW(id_with_a_tail),
        ROW(two_keys),
    };
    /* clang-format on */
    static struct lab_book book;
    for (uint32_t s = 0; s < species_table_count; s++) {
        book.card_count = 1;
        book.cards[0] = species_table[s]->card;
        assert_true(lab_book_is_valid(&book));
        for (size_t i = 0; i < sizeof spoils / sizeof *spoils; i++) {
            book.cards[0] = species_table[s]->card;
            spoils[i].spoil(&book.cards[0]);
            if (lab_book_is_valid(&book)) {
                fail_msg("%s of %s", spoils[i].name, species_table[s]->card.id);
            }
        }
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, setup)
    const struct CMUnitTest tests[] = {
        TEST(test_the_other_weights_share_the_rest_in_proportion),
        TEST(test_the_neighbours_share_the_rest_equally_if_the_others_are_zero),
        TEST(test_weights_are_clamped_to_their_bounds),
        TEST(test_knots_keep_their_order_and_end_knots_keep_their_positions),
        TEST(test_a_new_knot_does_not_change_a_straight_line),
        TEST(test_a_curve_has_two_to_twelve_knots),
        TEST(test_each_template_of_the_editor_belongs_to_the_species),
        TEST(test_ten_thousand_random_edits_leave_a_valid_graph),
        TEST(test_weights_sum_to_one_after_any_edit),
        TEST(test_the_first_edit_makes_the_growth_curve_custom),
        TEST(test_a_size_knot_that_is_not_moved_changes_no_length),
        TEST(test_the_conger_keeps_its_least_length_with_a_custom_curve),
        TEST(test_the_length_axis_maps_forward_and_back),
        TEST(test_a_book_with_an_invalid_card_or_graph_is_rejected),
        TEST(test_a_card_with_one_invalid_number_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
