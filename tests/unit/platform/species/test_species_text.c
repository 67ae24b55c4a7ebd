/* test_species_text.c -- Tests the parser of species texts, which describe fish, with valid and
 * invalid texts. */
#include "platform/species/text.h"
#include "tests/unit/support/species_text.h"

static void test_a_complete_species_text_is_read(void **state)
{
    (void)state;
    assert_string_equal(complaint_of(HEAD KEYS KNOTS), "");
    assert_string_equal(species.card.id, "test");
    assert_int_equal(species.card.key_count, 3);
    assert_int_equal(species.card.curves[0].knot_count, 3);
    assert_float_equal(species.card.key_length_m[1], 0.020f, 1e-7f);
    assert_int_equal(species.keys[2].substep_count, 4);
    assert_int_equal(species.keys[2].coat.fin, 0xabcdef);
    assert_float_equal(species.keys[0].fins[PART_TAIL].rays[1].sweep_deg, -30.0f, 0.0f);
    assert_float_equal(species.card.curves[0].knots[1].weight[1], 0.7f, 0.0f);
}

static void test_comments_and_blanks_are_ignored(void **state)
{
    (void)state;
    assert_string_equal(complaint_of("# a fish\n\n  \t\r\n" HEAD KEYS KNOTS "# end"), "");
}

static void test_an_error_names_file_line_and_cause(void **state)
{
    (void)state;
    assert_string_equal(complaint_of("species test\n\nwings 2\n"),
                        "t.txt:3: 'wings' is not a keyword of a species text\n");
}

static void test_invalid_and_out_of_range_numbers_are_rejected(void **state)
{
    (void)state;
    assert_refused("growth x 1 0\n", "t.txt:1: 'x' is not a number");
    assert_refused("growth 1.0e 1 0\n", "'1.0e' is not a number");
    assert_refused("growth nan 1 0\n", "'nan' is not a number");
    assert_refused("growth inf 1 0\n", "'inf' is not a number");
    assert_refused("growth 1e30 1 0\n", "1e30 is outside 0.01 .. 20");
    assert_refused("growth 1 1\n", "write: growth LENGTH_INF_M K_PER_YEAR T0_YEAR");
}

static void test_lines_of_a_key_or_fin_require_that_key_or_fin(void **state)
{
    (void)state;
    assert_refused("station 0 0 0 0 2\n", "'station' must be below a 'key' line");
    assert_refused("key a 10\nray 0 1 0 0\n", "t.txt:2: a 'ray' line must be below a 'fin' line");
    assert_refused("key a 10\nfin wing 0 1 0 0\n", "'wing' is not a fin");
}

static void test_stations_and_keys_must_be_in_order(void **state)
{
    (void)state;
    assert_refused("key a 10\nstation .1 .1 .1 0 2\n",
                   "the first station must be at x 0, and x must increase");
    assert_refused("key a 10\nkey b 10\n", "the length must increase from key to key");
    assert_refused(HEAD KEYS "knot .1 1 0 0\n", "the first knot must be at progress 0");
    assert_refused(HEAD KEYS KNOTS "key d 80\n", "all keys must be above the first knot");
}

static void test_weights_that_do_not_sum_to_one_are_rejected_with_their_line(void **state)
{
    (void)state;
    assert_refused(HEAD KEYS "knot 0 .5 0 0\n", ": the sum of the weights is 0.5, but must be 1");
    assert_refused(HEAD KEYS "knot 0 1.5 -.5 0\n", "1.5 is outside 0 .. 1");
    assert_refused(HEAD KEYS "knot 0 1 0\n", "one weight for each of the 3 keys");
}

static void test_a_truncated_species_text_is_rejected(void **state)
{
    (void)state;
    assert_refused("# nothing\n", "the line 'species ID' is missing");
    assert_refused(HEAD "key a 10\n" KEY_BODY, "the species has fewer than three keys");
    assert_refused(HEAD KEYS "knot 0 1 0 0\n", "the graph needs knots from progress 0 to 1");
    assert_refused(HEAD KEYS "key d 80\nstation 0 0 0 0 2\n", "the graph needs knots");
    assert_refused("species test\n" KEYS KNOTS, "the line 'growth' or 'hatch' is missing");
}

static void test_counts_beyond_their_maximum_are_rejected(void **state)
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

/* Reads the example that stands between the first code fences of the manual page. */
static void test_the_example_of_the_manual_is_valid(void **state)
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
    assert_string_equal(species.card.id, "dace");
    assert_int_equal(species.card.growth.point_count, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_complete_species_text_is_read),
        cmocka_unit_test(test_the_example_of_the_manual_is_valid),
        cmocka_unit_test(test_comments_and_blanks_are_ignored),
        cmocka_unit_test(test_an_error_names_file_line_and_cause),
        cmocka_unit_test(test_invalid_and_out_of_range_numbers_are_rejected),
        cmocka_unit_test(test_lines_of_a_key_or_fin_require_that_key_or_fin),
        cmocka_unit_test(test_stations_and_keys_must_be_in_order),
        cmocka_unit_test(test_weights_that_do_not_sum_to_one_are_rejected_with_their_line),
        cmocka_unit_test(test_a_truncated_species_text_is_rejected),
        cmocka_unit_test(test_counts_beyond_their_maximum_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
