/* test_poi_config.c -- tests the parser of the configuration file of a poi. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/poi_config.h"

static struct poi_config config;

static int fresh(void **state)
{
    (void)state;
    poi_config_init(&config);
    return 0;
}

static int read_line(const char *line)
{
    const char *why = NULL;
    const int result = poi_config_line(&config, line, &why);
    assert_true(result >= 0 || (why && strlen(why) > 10));
    return result;
}

static void test_each_line_sets_its_option(void **state)
{
    (void)state;
    assert_int_equal(read_line("  adc =\tads1115   # a remark\n"), 1);
    assert_string_equal(config.adc, "ads1115");
    assert_int_equal(read_line("spool2 = 5  450 750 -300"), 1);
    assert_int_equal(config.channel[1], 5);
    assert_float_equal(config.spool_m[1].z, -0.3f, 1e-6f);
    assert_int_equal(read_line("wire3=251.5 0.2441"), 1);
    assert_float_equal(config.zero_m[2], 0.2515f, 1e-6f);
    assert_float_equal(config.step_m[2], 0.0002441f, 1e-9f);
    assert_int_equal(read_line("imu_axes = +x +z -y"), 1);
    assert_float_equal(config.imu_row[2].y, -1.0f, 0.0f);
    assert_int_equal(read_line("motor = 0 1 200 0.25"), 1);
    assert_int_equal(config.pwm_channel, 1);
    assert_int_equal(read_line("motor = none"), 1);
    assert_int_equal(config.pwm_chip, -1);
    assert_int_equal(read_line("mark = 1 2 3"), 1);
    assert_int_equal(config.mark_count, 1);
    assert_int_equal(read_line(""), 0);
    assert_int_equal(read_line("   # only a remark"), 0);
}

static void test_invalid_lines_are_rejected(void **state)
{
    (void)state;
    static const char *const bad[] = {
        "adc",
        "nonsense = 1",
        "adc = ../../etc",
        "adc = a_name_of_more_than_thirty_one_letters",
        "spool1 = 0 1 2",
        "spool1 = 0 1 2 3 4",
        "spool1 = 1.5 1 2 3",
        "spool1 = -1 1 2 3",
        "spool1 = 32 1 2 3",
        "wire1 = 200 0",
        "wire1 = nan 1",
        "ring = 1 2",
        "ring = 1 2 4000",
        /* These axes are left-handed. No mounting of the sensor can give such axes. */
        "imu_axes = +x +y -z",
        "imu_axes = +x +x +y",
        "imu_axes = x y z",
        "imu_axes = +x +y +z +x",
        "gyro_bias = 0 0 1",
        "ahead_s = -1",
        "motor = 0 0 5 0.2",
        "motor = 0 0 200 1",
    };
    const struct poi_config before = config;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(read_line(bad[i]), -1);
        assert_memory_equal(&config, &before, sizeof config);
    }
    char endless[400];
    memset(endless, ' ', sizeof endless - 1);
    endless[sizeof endless - 1] = '\0';
    assert_int_equal(read_line(endless), -1);
    for (uint32_t i = 0; i < POI_CONFIG_MARK_MAX; i++) {
        assert_int_equal(read_line("mark = 1 2 3"), 1);
    }
    assert_int_equal(read_line("mark = 1 2 3"), -1);
}

static void test_invalid_spool_positions_and_shared_channels_are_rejected(void **state)
{
    (void)state;
    const char *why = NULL;
    assert_true(poi_config_is_sound(&config, &why));
    assert_false(poi_config_is_calibrated(&config));
    read_line("spool3 = 1 0 750 350");
    assert_false(poi_config_is_sound(&config, &why));
    assert_non_null(strstr(why, "channel"));
    read_line("spool3 = 2 0 750 -300");
    assert_false(poi_config_is_sound(&config, &why));
    assert_non_null(strstr(why, "apart"));
}

static void test_the_supplied_file_has_the_defaults_and_lacks_only_calibration(void **state)
{
    (void)state;
    struct poi_config shipped;
    poi_config_init(&shipped);
    assert_true(poi_config_load(&shipped, "board/poi-gadget/poi.conf"));
    assert_int_equal(shipped.mark_count, 4);
    shipped.mark_count = 0;
    memset(shipped.mark_m, 0, sizeof shipped.mark_m);
    for (uint32_t i = 0; i < DRAW_WIRE_COUNT; i++) {
        assert_true(v3_length(v3_sub(shipped.spool_m[i], config.spool_m[i])) < 1e-6f);
        assert_int_equal(shipped.channel[i], config.channel[i]);
    }
    assert_string_equal(shipped.adc, config.adc);
    assert_string_equal(shipped.imu, config.imu);
    assert_true(v3_length(v3_sub(shipped.ring_m, config.ring_m)) < 1e-6f);
    assert_false(poi_config_is_calibrated(&shipped));
    assert_false(poi_config_load(&shipped, "board/poi-gadget/there-is-none"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_each_line_sets_its_option, fresh),
        cmocka_unit_test_setup(test_invalid_lines_are_rejected, fresh),
        cmocka_unit_test_setup(test_invalid_spool_positions_and_shared_channels_are_rejected,
                               fresh),
        cmocka_unit_test_setup(test_the_supplied_file_has_the_defaults_and_lacks_only_calibration,
                               fresh),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
