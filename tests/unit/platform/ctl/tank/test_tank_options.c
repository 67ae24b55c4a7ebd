/* test_tank_options.c -- Tests the options of `kingyoctl tank` and the limits of their values. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/ctl/tank/tank_options.h"

#define WORDS_MAX 40

static struct tank_options plan;

/* Parses the options in `line`, which are separated by blanks. Discards all messages on standard
 * error. */
static enum exit_code read_plan(const char *line)
{
    static char text[512];
    const char *argv[WORDS_MAX];
    int argc = 0;
    snprintf(text, sizeof text, "%s", line);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " ")) {
        argv[argc++] = word;
    }
    fflush(stderr);
    const int shown = dup(STDERR_FILENO);
    assert_non_null(freopen("/dev/null", "w", stderr));
    const enum exit_code code = tank_options_read(&plan, argc, argv);
    fflush(stderr);
    dup2(shown, STDERR_FILENO);
    close(shown);
    return code;
}

static void test_the_default_options_are_the_thesis_tank_for_ten_seconds(void **state)
{
    (void)state;
    assert_int_equal(read_plan(""), EXIT_OK);
    assert_int_equal(plan.config.preset, TANK_PRESET_THESIS);
    assert_int_equal(plan.config.fish_count, 600);
    assert_int_equal(plan.tick_count, 1200);
    assert_int_equal(plan.trace_every, 12);
    assert_int_equal(plan.observe_every, 0);
    assert_true(plan.config.stamina_min == 0.30f && plan.config.stamina_max == 1.0f);
}

static void test_every_tank_option_is_stored(void **state)
{
    (void)state;
    assert_int_equal(
        read_plan("--preset official --fish 321 --area-scale 0.5 --seconds 2.5 --seed 4294967295 "
                  "--stamina 20 --temperature-c 30 --pressure-hpa 990 --oxygen-mg-l 3.5 --pump on "
                  "--time-compression 60 --shade 1,-2,10,0,5 --shade 3,4,5,1,2 --poi-path p.csv "
                  "--place q.csv --pairs all --trace t.csv --trace-every 1 --observe-every 7 "
                  "--json"),
        EXIT_OK);
    assert_int_equal(plan.config.preset, TANK_PRESET_OFFICIAL);
    assert_int_equal(plan.config.fish_count, 321);
    assert_true(plan.config.area_scale == 0.5f);
    assert_int_equal(plan.tick_count, 300);
    assert_int_equal(plan.config.seed, UINT32_MAX);
    assert_true(plan.config.stamina_min == 0.2f && plan.config.stamina_max == 0.2f);
    assert_true(plan.config.temperature_c == 30.0f && plan.config.pressure_hpa == 990.0f);
    assert_true(plan.config.oxygen_mg_l == 3.5f && plan.config.time_compression == 60.0f);
    assert_int_equal(plan.config.pump, 1);
    assert_int_equal(plan.config.search, PAIR_SEARCH_ALL);
    assert_int_equal(plan.shade_count, 2);
    assert_true(plan.shade[0].z_m == -0.02 && plan.shade[1].to_s == 2.0);
    assert_string_equal(plan.poi_path, "p.csv");
    assert_string_equal(plan.place, "q.csv");
    assert_string_equal(plan.trace, "t.csv");
    assert_int_equal(plan.trace_every, 1);
    assert_int_equal(plan.observe_every, 7);
    assert_int_equal(plan.as_json, 1);
}

static void test_a_larger_tank_allows_more_fish_at_equal_density(void **state)
{
    (void)state;
    assert_int_equal(read_plan("--area-scale 0.5"), EXIT_OK);
    assert_int_equal(plan.config.fish_count, 300);
    assert_int_equal(read_plan("--area-scale 2"), EXIT_OK);
    assert_int_equal(plan.config.fish_count, 1200);
    assert_int_equal(read_plan("--area-scale 250"), EXIT_USAGE);
    assert_int_equal(read_plan("--area-scale 250 --fish 100"), EXIT_OK);
    assert_int_equal(plan.config.fish_count, 100);
}

static void test_limits_of_tank_options_are_accepted_and_values_beyond_rejected(void **state)
{
    static const struct {
        const char *low, *high, *below, *above;
    } ends[] = {
        { "--area-scale 0.05", "--area-scale 250 --fish 1", "--area-scale 0.049",
          "--area-scale 250.1" },
        { "--seconds 0.1", "--seconds 36000", "--seconds 0.09", "--seconds 36001" },
        { "--seed 0", "--seed 4294967295", "--seed -1", "--seed 4294967296" },
        { "--stamina 0", "--stamina 100", "--stamina -0.1", "--stamina 100.1" },
        { "--temperature-c 0", "--temperature-c 40", "--temperature-c -1", "--temperature-c 41" },
        { "--pressure-hpa 870", "--pressure-hpa 1085", "--pressure-hpa 869",
          "--pressure-hpa 1086" },
        { "--oxygen-mg-l 0", "--oxygen-mg-l 20", "--oxygen-mg-l -1", "--oxygen-mg-l 20.1" },
        { "--time-compression 0", "--time-compression 1000", "--time-compression -1",
          "--time-compression 1001" },
        { "--trace-every 1", "--trace-every 4320000", "--trace-every 0", "--trace-every 4320001" },
        { "--wall-follow 0", "--wall-follow 1", "--wall-follow -0.1", "--wall-follow 1.1" },
        { "--size-cm 30,5,30", "--size-cm 200,50,200 --fish 9", "--size-cm 29,5,30",
          "--size-cm 200,51,200 --fish 9" },
        { "--fish 1", "--fish 1500", "--fish 0", "--fish 4000000000" },
        { "--shade 0,0,1,0,1", "--shade 0,0,30,0,36000", "--shade 0,0,0.9,0,1",
          "--shade 0,0,31,0,1" },
    };
    (void)state;
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        assert_int_equal(read_plan(ends[i].low), EXIT_OK);
        assert_int_equal(read_plan(ends[i].high), EXIT_OK);
        assert_int_equal(read_plan(ends[i].below), EXIT_USAGE);
        assert_int_equal(read_plan(ends[i].above), EXIT_USAGE);
    }
}

static void test_an_invalid_tank_option_value_is_rejected(void **state)
{
    /* clang-format off */
    static const char *const wrong[] = {
        "--fish", "--fish many", "--fish 1.5", "--seconds nan", "--seconds inf", "--stamina 0x10",
        "--preset pond", "--preset", "--pump maybe", "--pump", "--pairs some", "--pairs",
        "--spaces", "--spaces cone",
        "--shade", "--shade 1,2,3,4", "--shade 1,2,3,4,5,6", "--shade 0,0,5,3,3",
        "--shade a,b,c,d,e", "--shade 0,0,5,-1,3", "--trace", "--place", "--poi-path",
        "--trace-every 1.5", "--bogus",
        "fish", "--seed 1e99", "--size-cm 60,20",
        "--size-cm", "--size-cm 60,20,30,1", "--temperature-c 2O",
    };
    /* clang-format on */
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_int_equal(read_plan(wrong[i]), EXIT_USAGE);
    }
}

static void test_at_most_four_fans_are_accepted(void **state)
{
    (void)state;
    assert_int_equal(read_plan("--shade 0,0,5,0,1 --shade 0,0,5,0,1 --shade 0,0,5,0,1 "
                               "--shade 0,0,5,0,1"),
                     EXIT_OK);
    assert_int_equal(read_plan("--shade 0,0,5,0,1 --shade 0,0,5,0,1 --shade 0,0,5,0,1 "
                               "--shade 0,0,5,0,1 --shade 0,0,5,0,1"),
                     EXIT_USAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_default_options_are_the_thesis_tank_for_ten_seconds),
        cmocka_unit_test(test_every_tank_option_is_stored),
        cmocka_unit_test(test_a_larger_tank_allows_more_fish_at_equal_density),
        cmocka_unit_test(test_limits_of_tank_options_are_accepted_and_values_beyond_rejected),
        cmocka_unit_test(test_an_invalid_tank_option_value_is_rejected),
        cmocka_unit_test(test_at_most_four_fans_are_accepted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
