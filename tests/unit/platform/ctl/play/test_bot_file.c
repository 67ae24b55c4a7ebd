/* test_bot_file.c -- Tests the bot file, which sets the technique of a simulated player, and the
 * message for each error in the file. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/ctl/play/bot_file.h"

static const struct technique untouched = { .wet = 0.123f };

static int is(const struct technique *technique, const struct technique *other)
{
    return memcmp(technique, other, sizeof *technique) == 0;
}

static struct technique technique_of(const char *text)
{
    struct technique technique = untouched;
    struct bot_file_problem problem = { 0 };
    if (bot_file_parse(text, strlen(text), &technique, &problem) != 0) {
        fail_msg("line %u: %s", problem.line, problem.text);
    }
    return technique;
}

/* Asserts that the parser rejects `text` at `line` with `needle` in the message, and leaves the
 * technique unchanged. */
static void expect_refused(const char *text, uint32_t line, const char *needle)
{
    struct technique technique = untouched;
    struct bot_file_problem problem = { 0 };
    assert_int_equal(bot_file_parse(text, strlen(text), &technique, &problem), -1);
    assert_true(is(&technique, &untouched));
    assert_int_equal(problem.line, line);
    if (!strstr(problem.text, needle)) {
        fail_msg("'%s' does not mention '%s'", problem.text, needle);
    }
    assert_null(strchr(problem.text, '\n'));
}

static void test_a_file_with_only_a_base_gives_that_bot(void **state)
{
    (void)state;
    const struct technique novice = technique_of("base=novice\n");
    const struct technique expert = technique_of("base=expert");
    assert_true(is(&novice, &technique_novice));
    assert_true(is(&expert, &technique_expert));
    assert_false(is(&novice, &technique_expert));
}

static void test_one_key_changes_one_field_and_no_other(void **state)
{
    (void)state;
    struct technique expected = technique_expert;
    expected.wet = 0.5f;
    struct technique read = technique_of("wet=0.5\n");
    assert_true(is(&read, &expected));
    expected = technique_novice;
    expected.side = SIDE_TAIL;
    read = technique_of("base=novice\nside=tail\n");
    assert_true(is(&read, &expected));
    expected = technique_expert;
    expected.fish_max = 8;
    read = technique_of("fish_max=8\n");
    assert_true(is(&read, &expected));
}

/* All twenty values of the bot file are different, so that two exchanged fields would be
 * detected. */
static void test_every_key_reaches_its_field(void **state)
{
    (void)state;
    static const struct technique expected = {
        .wet = 0.25f,
        .entry_deg = 31.0f,
        .glide_deg = 32.0f,
        .side = SIDE_TAIL,
        .place = PLACE_CENTRE,
        .lift = LIFT_FAST,
        .hunt = HUNT_CHASE,
        .fish_max = 5,
        .fish_m = 0.045f,
        .arm_m_s = 0.61f,
        .dip_m_s = 0.62f,
        .glide_m_s = 0.63f,
        .lift_m_s = 0.64f,
        .carry_m_s = 0.65f,
        .drain_s = 0.71f,
        .patience_s = 0.72f,
        .aim_m = 0.011f,
        .tremor_m = 0.002f,
        .reaction_min_s = 0.31f,
        .reaction_max_s = 0.32f,
    };
    const struct technique read = technique_of(
        "wet=0.25\nentry_deg=31\nglide_deg=32\nside=tail\nplace=centre\nlift=fast\nhunt=chase\n"
        "fish_max=5\nfish_m=0.045\n"
        "arm_m_s=0.61\ndip_m_s=0.62\nglide_m_s=0.63\nlift_m_s=0.64\ncarry_m_s=0.65\n"
        "drain_s=0.71\npatience_s=0.72\naim_m=0.011\ntremor_m=0.002\nreaction_min_s=0.31\n"
        "reaction_max_s=0.32\n");
    assert_true(is(&read, &expected));
}

static void test_every_keyword_sets_its_value(void **state)
{
    (void)state;
    assert_int_equal(technique_of("side=any").side, SIDE_ANY);
    assert_int_equal(technique_of("side=head").side, SIDE_HEAD);
    assert_int_equal(technique_of("place=rim").place, PLACE_RIM);
    assert_int_equal(technique_of("lift=drained").lift, LIFT_DRAINED);
    assert_int_equal(technique_of("hunt=shade").hunt, HUNT_SHADE);
}

static void test_blanks_comments_and_crlf_are_ignored(void **state)
{
    (void)state;
    struct technique expected = technique_novice;
    expected.wet = 0.75f;
    const struct technique read =
        technique_of("\xEF\xBB\xBF# who\r\n\r\n  base = novice\t# first\r\n"
                     "\twet =\t.75   # three quarters\r\n#end");
    assert_true(is(&read, &expected));
}

static void test_the_limits_of_each_range_are_accepted_and_values_beyond_rejected(void **state)
{
    (void)state;
    assert_true(technique_of("wet=0").wet <= 0.0f);
    assert_true(technique_of("entry_deg=60").entry_deg >= 60.0f);
    assert_true(technique_of("arm_m_s=2").arm_m_s >= 2.0f);
    expect_refused("wet=1.001", 1, "0 to 1");
    expect_refused("wet=-0.001", 1, "0 to 1");
    expect_refused("entry_deg=60.1", 1, "0 to 60");
    expect_refused("arm_m_s=0", 1, "over 0 to 2");
    expect_refused("arm_m_s=1e-60", 1, "over 0 to 2");
    expect_refused("arm_m_s=2.01", 1, "over 0 to 2");
    expect_refused("fish_max=0", 1, "1 to 8");
    expect_refused("fish_max=9", 1, "1 to 8");
    expect_refused("fish_max=2.5", 1, "1 to 8");
    expect_refused("reaction_min_s=0.149", 1, "0.15 to 1");
}

static void test_keywords_and_numbers_are_not_interchangeable(void **state)
{
    (void)state;
    expect_refused("wet=half", 1, "'half'");
    expect_refused("wet=nan", 1, "'nan'");
    expect_refused("wet=0x1", 1, "'0x1'");
    expect_refused("wet=0.5 m", 1, "'0.5 m'");
    expect_refused("wet=", 1, "''");
    expect_refused("side=1", 1, "any|head|tail");
    expect_refused("side=Head", 1, "any|head|tail");
    expect_refused("side=heads", 1, "any|head|tail");
}

static void test_an_unknown_key_is_reported_with_its_line(void **state)
{
    (void)state;
    expect_refused("base=novice\n\nwett=0.5\n", 3, "'wett' is no key");
    expect_refused("WET=0.5", 1, "'WET' is no key");
    expect_refused("=0.5", 1, "'' is no key");
    expect_refused("wet", 1, "no '='");
    expect_refused("wet:0.5", 1, "no '='");
}

static void test_a_duplicate_key_is_rejected_even_with_an_equal_value(void **state)
{
    (void)state;
    expect_refused("wet=0.5\nlift=fast\nwet=0.5\n", 3, "line 1");
    expect_refused("base=novice\nbase=novice\n", 2, "line 1");
}

static void test_the_base_must_come_first_and_be_one_of_two(void **state)
{
    (void)state;
    expect_refused("wet=0.5\nbase=novice\n", 2, "line 1");
    expect_refused("base=master\n", 1, "novice|expert");
}

static void test_a_reversed_reaction_range_is_rejected(void **state)
{
    (void)state;
    expect_refused("reaction_max_s=0.3\nreaction_min_s=0.4\nwet=1\n", 2, "0.4");
    assert_true(technique_of("reaction_min_s=0.4\nreaction_max_s=0.4").reaction_max_s > 0.39f);
}

static void test_an_empty_bot_file_is_rejected(void **state)
{
    (void)state;
    expect_refused("", 0, "no key");
    expect_refused("\n# wet=1\n", 0, "no key");
}

static void test_a_binary_bot_file_is_rejected_at_its_first_invalid_line(void **state)
{
    (void)state;
    static const char bytes[] = "wet=1\nlift\0=fast\n";
    struct technique technique = untouched;
    struct bot_file_problem problem = { 0 };
    char line[1000];
    assert_int_equal(bot_file_parse(bytes, sizeof bytes - 1, &technique, &problem), -1);
    assert_int_equal(problem.line, 2);
    expect_refused("\033[2J=\001\r2\177", 1, "'?[2J' is no key");
    expect_refused("wet=\001\r2\177", 1, "'??2?'");
    memset(line, 'a', sizeof line - 1);
    line[sizeof line - 1] = '\0';
    expect_refused(line, 1, "the line has more than 199 characters");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_file_with_only_a_base_gives_that_bot),
        cmocka_unit_test(test_one_key_changes_one_field_and_no_other),
        cmocka_unit_test(test_every_key_reaches_its_field),
        cmocka_unit_test(test_every_keyword_sets_its_value),
        cmocka_unit_test(test_blanks_comments_and_crlf_are_ignored),
        cmocka_unit_test(test_the_limits_of_each_range_are_accepted_and_values_beyond_rejected),
        cmocka_unit_test(test_keywords_and_numbers_are_not_interchangeable),
        cmocka_unit_test(test_an_unknown_key_is_reported_with_its_line),
        cmocka_unit_test(test_a_duplicate_key_is_rejected_even_with_an_equal_value),
        cmocka_unit_test(test_the_base_must_come_first_and_be_one_of_two),
        cmocka_unit_test(test_a_reversed_reaction_range_is_rejected),
        cmocka_unit_test(test_an_empty_bot_file_is_rejected),
        cmocka_unit_test(test_a_binary_bot_file_is_rejected_at_its_first_invalid_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
