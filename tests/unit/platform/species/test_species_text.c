/* test_species_text.c -- what the bake answers to a maker's text, right and wrong. */
#include "platform/species/text.h"
#include "tests/unit/support/species_text.h"

static void test_a_whole_text_is_read_as_written(void **state)
{
    (void)state;
    assert_string_equal(complaint_of(HEAD KEYS KNOTS), "");
    assert_string_equal(species.id, "test");
    assert_int_equal(species.key_count, 3);
    assert_int_equal(species.curves[0].graph.knot_count, 3);
    assert_float_equal(species.keys[1].length_m, 0.020f, 1e-7f);
    assert_int_equal(species.keys[2].substep_count, 4);
    assert_int_equal(species.keys[2].coat.fin, 0xabcdef);
    assert_float_equal(species.keys[0].fins[PART_TAIL].rays[1].sweep_deg, -30.0f, 0.0f);
    assert_float_equal(species.curves[0].graph.knots[1].weight[1], 0.7f, 0.0f);
}

static void test_comments_and_blanks_say_nothing(void **state)
{
    (void)state;
    assert_string_equal(complaint_of("# a fish\n\n  \t\r\n" HEAD KEYS KNOTS "# end"), "");
}

static void test_a_complaint_names_file_line_and_what(void **state)
{
    (void)state;
    assert_string_equal(complaint_of("species test\n\nwings 2\n"),
                        "t.txt:3: 'wings' is no word of a species\n");
}

static void test_numbers_must_be_numbers_inside_their_range(void **state)
{
    (void)state;
    assert_refused("growth x 1 0\n", "t.txt:1: 'x' is not a number");
    assert_refused("growth 1.0e 1 0\n", "'1.0e' is not a number");
    assert_refused("growth nan 1 0\n", "'nan' is not a number");
    assert_refused("growth inf 1 0\n", "'inf' is not a number");
    assert_refused("growth 1e30 1 0\n", "1e30 is outside 0.01 .. 20");
    assert_refused("growth 1 1\n", "write: growth LENGTH_INF_M K_PER_YEAR T0_YEAR");
}

static void test_lines_of_a_key_or_fin_need_their_key_or_fin(void **state)
{
    (void)state;
    assert_refused("station 0 0 0 0 2\n", "'station' stands under a key");
    assert_refused("key a 10\nray 0 1 0 0\n", "t.txt:2: a ray stands under its fin");
    assert_refused("key a 10\nfin wing 0 1 0 0\n", "'wing' is no fin");
}

static void test_order_is_kept_from_snout_to_tail_and_from_short_to_long(void **state)
{
    (void)state;
    assert_refused("key a 10\nstation .1 .1 .1 0 2\n", "stations go from x 0 backward");
    assert_refused("key a 10\nkey b 10\n", "keys go from short to long");
    assert_refused(HEAD KEYS "knot .1 1 0 0\n", "knots go from progress 0 upward");
    assert_refused(HEAD KEYS KNOTS "key d 80\n", "all keys stand above the first knot");
}

static void test_weights_that_are_no_blend_are_refused_with_their_line(void **state)
{
    (void)state;
    assert_refused(HEAD KEYS "knot 0 .5 0 0\n", ": the weights' sum is 0.5, not 1");
    assert_refused(HEAD KEYS "knot 0 1.5 -.5 0\n", "1.5 is outside 0 .. 1");
    assert_refused(HEAD KEYS "knot 0 1 0\n", "one weight for each of the 3 keys");
}

static void test_a_text_that_ends_too_soon_is_refused(void **state)
{
    (void)state;
    assert_refused("# nothing\n", "no species ID");
    assert_refused(HEAD "key a 10\n" KEY_BODY, "fewer than three keys");
    assert_refused(HEAD KEYS "knot 0 1 0 0\n", "the graph needs knots from progress 0 to 1");
    assert_refused(HEAD KEYS "key d 80\nstation 0 0 0 0 2\n", "the graph needs knots");
    assert_refused("species test\n" KEYS KNOTS, "no growth or no hatch");
}

static void test_more_of_anything_than_its_maximum_is_refused(void **state)
{
    (void)state;
    static char text[TEXT_SIZE];
    int size = snprintf(text, TEXT_SIZE, "key a 10\n");
    for (int i = 0; i <= STATION_MAX; i++) {
        size +=
            snprintf(text + size, (size_t)(TEXT_SIZE - size), "station %g .1 .1 0 2\n", i / 100.0);
    }
    assert_refused(text, "more than 24 stations");
    memset(text, 'x', 1000);
    text[1000] = '\0';
    assert_refused(text, "t.txt:1: the line is longer than");
    assert_refused("growth 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24\n",
                   "more than 24 words");
}

/* What stands between the fences of the makers' page. */
static void test_the_makers_page_shows_a_species_that_bakes(void **state)
{
    (void)state;
    static char page[65536];
    FILE *file = fopen("assets/species/README.md", "r");
    assert_non_null(file);
    page[fread(page, 1, sizeof page - 1, file)] = '\0';
    fclose(file);
    char *from = strstr(page, "```\n");
    assert_non_null(from);
    char *to = strstr(from + 4, "```");
    assert_non_null(to);
    *to = '\0';
    assert_string_equal(complaint_of(from + 4), "");
    assert_string_equal(species.id, "dace");
    assert_int_equal(species.growth.point_count, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_whole_text_is_read_as_written),
        cmocka_unit_test(test_the_makers_page_shows_a_species_that_bakes),
        cmocka_unit_test(test_comments_and_blanks_say_nothing),
        cmocka_unit_test(test_a_complaint_names_file_line_and_what),
        cmocka_unit_test(test_numbers_must_be_numbers_inside_their_range),
        cmocka_unit_test(test_lines_of_a_key_or_fin_need_their_key_or_fin),
        cmocka_unit_test(test_order_is_kept_from_snout_to_tail_and_from_short_to_long),
        cmocka_unit_test(test_weights_that_are_no_blend_are_refused_with_their_line),
        cmocka_unit_test(test_a_text_that_ends_too_soon_is_refused),
        cmocka_unit_test(test_more_of_anything_than_its_maximum_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
