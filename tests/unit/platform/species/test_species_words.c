/* test_species_words.c -- Tests each keyword of a species text: the value that the keyword sets,
 * and the errors that are reported. */
#include "platform/species/text.h"
#include "tests/unit/support/species_text.h"

/* Returns a valid species text with the lines `more` added to its head. */
static const char *with_head(const char *more)
{
    static char text[TEXT_SIZE];
    snprintf(text, sizeof text, HEAD "%s" KEYS "template pairwise\n", more);
    return text;
}

/* Returns a valid species text with the lines `more` added to its first key shape. */
static const char *with_key(const char *more)
{
    static char text[TEXT_SIZE];
    snprintf(text, sizeof text,
             HEAD "key a 10\n%s" KEY_BODY "key b 20\n" KEY_BODY "key c 40\n" KEY_BODY
                  "template pairwise\n",
             more);
    return text;
}

/* Returns a species text with the lines `tail` in place of the morph graph. */
static const char *with_tail(const char *tail)
{
    static char text[TEXT_SIZE];
    snprintf(text, sizeof text, HEAD KEYS "%s", tail);
    return text;
}

static void assert_read(const char *text)
{
    assert_string_equal(complaint_of(text), "");
}

static void test_measure_form_and_motion_are_selected_by_name(void **state)
{
    (void)state;
    assert_read(with_head("measure fork\nform compressed\nmotion tuna\n"));
    assert_int_equal(species.card.measure, MEASURE_FORK);
    assert_int_equal(species.card.form, FORM_COMPRESSED);
    assert_int_equal(species.card.motion, MOTION_TUNA);
    assert_refused(
        with_head("measure weight\n"),
        "t.txt:4: 'weight' is not a measure; valid words are: total, standard, fork, disc\n");
    assert_refused(with_head("form round\n"), "fusiform, compressed, depressed, eel, puffer");
    assert_refused(with_head("motion\n"), "write: motion motion");
}

static void test_absent_fins_are_declared_once_for_all_keys(void **state)
{
    (void)state;
    assert_refused(with_head("without pelvic\n"),
                   "the species has no pelvic ('without' at the top)");
    assert_refused(with_head("without wings\n"),
                   "'wings' is not a fin; valid words are: tail, dorsal, anal, pectoral, pelvic");
    assert_refused(with_head("without\n"), "write: without FIN ..");
    assert_refused(HEAD "key a 10\nstation 0 .1 .1 0 2\nstation .4 .1 .1 0 2\n"
                        "station .7 .1 .1 0 2\nstation 1 .1 .1 0 2\neye .1 0 .05 .1\n"
                        "key b 20\nkey c 30\ntemplate pairwise\n",
                   "t.txt:4: key a: the tail needs two or more rays from 0 to 1 (or write");
}

static void test_points_extend_the_growth_curve_from_hatching(void **state)
{
    (void)state;
    assert_read(with_head("point 30 9\npoint 60 18\n"));
    assert_int_equal(species.card.growth.point_count, 3);
    assert_float_equal(species.card.growth.points[1].age_days, 30.0f, 0.0f);
    assert_float_equal(species.card.growth.points[2].length_m, 0.018f, 1e-7f);
    assert_refused(with_head("point 30 9\npoint 30 18\n"),
                   "the age must increase from point to point");
    assert_refused(with_head("point 0 9\n"), "the age must increase from point to point");
    assert_refused("species t\npoint 30 9\n",
                   "t.txt:2: a 'point' line must be below the 'hatch' line");
    assert_refused("hatch .01 .1\nhatch .01 .1\n",
                   "only one 'hatch' line is allowed, above the points");
    static char text[TEXT_SIZE];
    int size = snprintf(text, sizeof text, HEAD);
    for (int i = 1; i <= (int)GROWTH_POINT_MAX; i++) {
        size += snprintf(text + size, sizeof text - (size_t)size, "point %d %d\n", i, 5 + i);
    }
    assert_refused(text, "more than 12 points");
}

static void test_keys_with_an_age_may_shrink(void **state)
{
    (void)state;
    assert_read(HEAD "point 20 10\npoint 40 30\npoint 60.5 20\n"
                     "key a 10 20\n" KEY_BODY "key b 30 40\n" KEY_BODY "key c 20 60.5\n" KEY_BODY
                     "template pairwise\n");
    assert_float_equal(species.card.key_age_days[2], 60.5f, 0.0f);
    assert_float_equal(species.card.key_length_m[2], 0.02f, 1e-7f);
    assert_refused(HEAD "key a 10 20\nkey b 5\n", "otherwise write the age: key NAME MM AGE_DAYS");
    assert_refused(HEAD "key a 10\nkey a 20\n", "t.txt:5: the key a exists already");
    assert_refused(HEAD "key a 10 1 2\n", "write: key NAME MM [AGE_DAYS]");
    assert_refused(HEAD "point 90 10\nkey a 10 90\n" KEY_BODY "key b 20 80\n" KEY_BODY
                        "key c 40 99\n" KEY_BODY "template pairwise\n",
                   "key b (80 days) is not older than key a (90 days)");
}

static void test_a_given_age_must_match_the_growth_curve(void **state)
{
    (void)state;
    assert_refused(HEAD "point 20 10\npoint 40 20\n"
                        "key a 10 20\n" KEY_BODY "key b 20.5 40\n" KEY_BODY "key c 40 90\n" KEY_BODY
                        "template pairwise\n",
                   "t.txt:28: key b is 20.5 mm long at 40 days, but the growth curve gives 20 mm; "
                   "write a point");
    assert_read(HEAD "point 20 10\npoint 40 20\npoint 90 40\n"
                     "key a 10 20\n" KEY_BODY "key b 20.3 40\n" KEY_BODY "key c 40 90\n" KEY_BODY
                     "template pairwise\n");
}

static void test_a_key_beyond_the_maximum_length_is_rejected_with_its_line(void **state)
{
    (void)state;
    assert_refused(
        HEAD "key a 10\n" KEY_BODY "key b 20\n" KEY_BODY "key c 900\n" KEY_BODY
             "template pairwise\n",
        "t.txt:48: key c is 900 mm long, but the growth curve never has this length (300 mm at");
}

static void test_gills_must_be_in_all_keys_or_none(void **state)
{
    (void)state;
    assert_refused(
        with_key("gill .3\n"),
        "key b has no gill, but the first key has one; write a gill in all keys or in none");
    assert_refused(with_key("gill 0.9\n"), "0.9 is outside 0.02 .. 0.6");
}

static void test_eyes_are_a_pair_or_separate_and_can_migrate(void **state)
{
    (void)state;
    assert_read(with_key(""));
    assert_float_equal(species.keys[0].eyes[1].x, 0.1f, 0.0f);
    assert_refused(with_key("eye left .1 0 .05 .2\n"), "the left eye exists already");
    assert_refused(with_key("eye up .1 0 .05 .2\n"),
                   "'up' is not a side; valid words are: right, left");
    assert_refused(with_key("eye .1 0 .05\n"), "write: eye X Y DIAMETER BULGE, or eye right|left");
    assert_refused(with_key("eye right .1 0 .05 .2 181\n"), "181 is outside 0 .. 180");
    assert_refused(with_key("eye .1 0 .05 .2 90\n"), "write: eye X Y DIAMETER BULGE");
    const char *one = HEAD "key a 10\n" KEY_BODY "key b 20\neye right .1 0 .05 .2 90\n";
    complaint_of(one);
    assert_float_equal(species.keys[1].eyes[0].turn_deg, 90.0f, 0.0f);
    assert_float_equal(species.keys[1].eyes[1].diameter, 0.0f, 0.0f);
}

static void test_second_dorsal_and_finlets_must_be_in_all_keys_or_none(void **state)
{
    (void)state;
    assert_refused(with_key("finlets upper 9 .6 .95 .03 50\n"),
                   "key b has 0 upper finlets, but key a has 9");
    assert_refused(with_key("fin dorsal2 .6 .7 0 0\nray 0 .1 30 0\nray 1 .1 30 0\n"),
                   "key b: the dorsal2 needs two or more rays from 0 to 1");
    assert_refused(with_key("finlets upper 11 .6 .95 .03 50\n"), "11 is outside 1 .. 10");
    assert_refused(with_key("finlets upper 2.5 .6 .95 .03 50\n"), "2.5 is not a whole number");
    assert_refused(with_key("finlets upper 2 .8 .7 .03 50\n"), "the row ends before it starts");
    assert_refused(with_key("finlets middle 2 .8 .9 .03 50\n"),
                   "'middle' is not a row of finlets; valid words are: upper, lower");
}

static void test_confluent_requires_the_joined_fins(void **state)
{
    (void)state;
    assert_read(with_head("confluent\n"));
    assert_true(species.keys[2].confluent);
    assert_refused(with_head("confluent 1\n"), "write: confluent");
}

static void test_a_double_tail_cannot_be_confluent(void **state)
{
    (void)state;
    assert_read(with_head("double\n"));
    assert_true(species.keys[2].double_tail);
    assert_refused(with_head("double 2\n"), "write: double");
    assert_refused(with_head("double\nconfluent\n"), "confluent fins cannot have a double tail");
}

static void test_a_coat_has_five_colours_and_two_shares(void **state)
{
    (void)state;
    assert_read(with_key(""));
    assert_int_equal(species.keys[0].coat.iris, 0xc0a040);
    assert_int_equal(species.keys[0].coat.clear, 0);
    assert_int_equal(species.keys[0].coat.shine, 128);
    assert_refused(with_key("coat 00000g 0 0 0 0 0 0\n"), "'00000g' is not a colour");
    assert_refused(with_key("coat 000000 000000 000000 000000 000000 2 0\n"), "2 is outside");
    assert_refused(with_key("coat 000000 000000\n"), "write: coat BACK FLANK BELLY FIN IRIS");
}

static void test_a_mark_has_a_kind_a_part_a_colour_and_settings(void **state)
{
    (void)state;
    assert_read(with_key("mark bands body ff0000 count 3 from .2 to .8 slant -.2 width .05\n"
                         "mark edge dorsal2 00ff00\nmark side right eeeeee\n"));
    const struct species_mark *m = species.keys[0].coat.marks;
    assert_int_equal(species.keys[0].coat.mark_count, 3);
    assert_int_equal(m[0].kind, MARK_BANDS);
    assert_int_equal(m[0].count, 3);
    assert_float_equal(m[0].slant, -0.2f, 0.0f);
    assert_int_equal(m[1].part, PART_DORSAL_2);
    assert_float_equal(m[1].width, 0.15f, 0.0f); /* The species text gives no width for this mark,
                                                    so the default of 0.15 applies. */
    assert_int_equal(m[2].count, SIDE_RIGHT);
}

static void test_invalid_marks_are_rejected(void **state)
{
    (void)state;
    assert_refused(
        with_key("mark dots body ff0000\n"),
        "'dots' is not a kind of mark; valid words are: spots, bands, stripes, edge, patch, side, "
        "rows, mouth, gill");
    assert_refused(with_key("mark spots wing ff0000\n"),
                   "'wing' is not a part; valid words are: body, eye, tail");
    assert_refused(with_key("mark side body ff0000\n"),
                   "'body' is not a side; valid words are: right, left");
    assert_refused(with_key("mark mouth tail ff0000\n"), "a mouth must be on the body");
    assert_refused(with_key("mark spots body ff0000 size 3\n"),
                   "'size' is not a setting of a mark");
    assert_refused(with_key("mark spots body ff0000 count\n"), "a number is missing after 'count'");
    assert_refused(with_key("mark spots body ff0000 count 121\n"), "121 is outside 1 .. 120");
    assert_refused(with_key("mark spots body ff0000 from .5 to .4\n"),
                   "the mark ends before it starts");
    assert_refused(with_key("mark spots body\n"), "write: mark KIND PART COLOUR");
    assert_refused("mark spots body ff0000\n", "t.txt:1: 'mark' must be below a 'key' line");
    static char text[TEXT_SIZE];
    int size = snprintf(text, sizeof text, HEAD "key a 10\n");
    for (uint32_t i = 0; i <= MARK_MAX; i++) {
        size += snprintf(text + size, sizeof text - (size_t)size, "mark spots body ff0000\n");
    }
    assert_refused(text, "more than 8 marks");
}

static void test_a_template_line_defines_a_whole_graph(void **state)
{
    (void)state;
    assert_read(with_tail("template simultaneous .8\n"));
    assert_int_equal(species.card.curves[0].knot_count, 3);
    assert_int_equal(species.card.curves[0].solved, 1);
    assert_float_equal(species.card.curves[0].knots[1].weight[1], 0.8f, 1e-6f);
    assert_refused(
        with_tail("template round\n"),
        "'round' is not a template; valid words are: ordinary, pairwise, simultaneous, smooth");
    assert_refused(with_tail("template pairwise .8\n"), "only the simultaneous template has");
    assert_refused(with_tail("template simultaneous 1\n"), "1 is outside 0.51 .. 0.99");
    assert_refused(with_tail("knot 0 1 0 0\ntemplate smooth\n"), "either one template or knots");
    assert_refused(HEAD "template smooth\n", "'template' must be below the keys");
}

static void test_graph_lines_are_straight_smooth_or_solved(void **state)
{
    (void)state;
    assert_read(with_tail(KNOTS "line smooth\n"));
    assert_int_equal(species.card.curves[0].line, GRAPH_SMOOTH);
    assert_int_equal(species.card.curves[0].solved, 0);
    assert_read(with_tail(KNOTS "line solved\n"));
    assert_int_equal(species.card.curves[0].solved, 1);
    assert_refused(with_tail("line bent\n"),
                   "'bent' is not a line; valid words are: straight, smooth, solved");
    assert_refused(with_tail("knot 0 1 0 0\nknot 1 0 0 1\nline solved\n"),
                   "the graph of whole cannot be solved, because key b has too little weight");
    assert_refused(with_tail("line solved\ntemplate pairwise\n"),
                   "a 'line' line must be below the 'template' line");
    assert_refused(with_tail("line smooth\ntemplate pairwise\n"),
                   "must be below the 'template' line");
}

static void test_parts_can_have_their_own_curves(void **state)
{
    (void)state;
    assert_read(with_tail("template pairwise\ncurve front head eye\ntemplate smooth\n"
                          "curve hump\narea .3 .5 .6 1 .1\n" KNOTS));
    assert_int_equal(species.card.curve_count, 3);
    assert_string_equal(species.card.curve_names[1], "front");
    assert_int_equal(species.curves[1].parts, 1u << PART_HEAD | 1u << PART_EYE);
    assert_int_equal(species.curves[2].area_count, 1);
    assert_float_equal(species.curves[2].areas[0].soft, 0.1f, 0.0f);
    assert_int_equal(species.card.curves[2].knot_count, 3);
}

static void test_empty_and_duplicate_curves_are_rejected(void **state)
{
    (void)state;
    assert_refused(with_tail("curve front head\n"),
                   "must be below the keys and the graph of the whole");
    assert_refused(with_tail("template smooth\ncurve a wing\n"),
                   "'wing' is not a part; valid words are: eye, tail");
    assert_refused(with_tail("template smooth\ncurve a eye\ntemplate smooth\ncurve b eye\n"),
                   "the eye already moves by the curve a");
    assert_refused(with_tail("template smooth\ncurve a\ntemplate smooth\n"),
                   "curve a moves no part and no area");
    assert_refused(with_tail("template smooth\ncurve a eye\n"),
                   "the graph of curve a needs knots from progress 0 to 1, or a template");
    assert_refused(with_tail("template smooth\narea .1 .2 0 1 .1\n"),
                   "must be below a 'curve' line");
    assert_refused(with_tail("template smooth\ncurve a\narea .3 .2 0 1 .1\n"),
                   "the area ends before it starts");
    assert_refused(with_tail("template smooth\ncurve a eye\ntemplate smooth\ncurve b tail\n"
                             "template smooth\ncurve c anal\ntemplate smooth\ncurve d dorsal\n"),
                   "more than 3 curves");
}

static void test_manual_scale_knots_cover_progress_0_to_1(void **state)
{
    (void)state;
    assert_read(with_head("scale 0 10\nscale .5 125.5\nscale 1 56\n"));
    assert_int_equal(species.card.scale_knot_count, 3);
    assert_float_equal(species.card.scale_knots[1].length_m, 0.1255f, 1e-6f);
    assert_refused(with_head("scale .1 10\n"), "the first scale knot must be at progress 0");
    assert_refused(with_head("scale 0 10\nscale .5 20\n"),
                   "the last scale knot must be at progress 1");
}

static void test_the_thesis_keys_are_three_drawn_keys(void **state)
{
    (void)state;
    assert_read(with_tail("template smooth\nthesis a b c simultaneous\n"));
    assert_int_equal(species.card.thesis_template, TEMPLATE_SIMULTANEOUS);
    assert_int_equal(species.card.thesis_key[2], 2);
    assert_refused(with_tail("thesis a b d pairwise\n"), "no key above has the name 'd'");
    assert_refused(with_tail("thesis a c b pairwise\n"), "must be in the order of their ages");
    assert_refused(
        with_tail("thesis a b c smooth\n"),
        "'smooth' is not a template of the thesis; valid words are: pairwise, simultaneous");
}

static void test_a_drawing_beyond_the_mesh_limits_is_rejected(void **state)
{
    (void)state;
    assert_refused(with_head("measure disc\n"), "a point is 6 times the measured length away");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_measure_form_and_motion_are_selected_by_name),
        cmocka_unit_test(test_absent_fins_are_declared_once_for_all_keys),
        cmocka_unit_test(test_points_extend_the_growth_curve_from_hatching),
        cmocka_unit_test(test_keys_with_an_age_may_shrink),
        cmocka_unit_test(test_a_given_age_must_match_the_growth_curve),
        cmocka_unit_test(test_a_key_beyond_the_maximum_length_is_rejected_with_its_line),
        cmocka_unit_test(test_gills_must_be_in_all_keys_or_none),
        cmocka_unit_test(test_eyes_are_a_pair_or_separate_and_can_migrate),
        cmocka_unit_test(test_second_dorsal_and_finlets_must_be_in_all_keys_or_none),
        cmocka_unit_test(test_confluent_requires_the_joined_fins),
        cmocka_unit_test(test_a_double_tail_cannot_be_confluent),
        cmocka_unit_test(test_a_coat_has_five_colours_and_two_shares),
        cmocka_unit_test(test_a_mark_has_a_kind_a_part_a_colour_and_settings),
        cmocka_unit_test(test_invalid_marks_are_rejected),
        cmocka_unit_test(test_a_template_line_defines_a_whole_graph),
        cmocka_unit_test(test_graph_lines_are_straight_smooth_or_solved),
        cmocka_unit_test(test_parts_can_have_their_own_curves),
        cmocka_unit_test(test_empty_and_duplicate_curves_are_rejected),
        cmocka_unit_test(test_manual_scale_knots_cover_progress_0_to_1),
        cmocka_unit_test(test_the_thesis_keys_are_three_drawn_keys),
        cmocka_unit_test(test_a_drawing_beyond_the_mesh_limits_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
