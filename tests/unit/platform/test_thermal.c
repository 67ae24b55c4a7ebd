/* test_thermal.c -- Tests the thermal margin, which is the number of degrees left until the
 * processor is throttled. Files in a temporary folder simulate the sensors. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/thermal.h"

static char root[64];
static time_t calendar_is_ahead_s;

/* Replaces the function of the C library, so that a test can set the calendar ahead. */
int clock_gettime(clockid_t clock, struct timespec *out)
{
    const int result = (int)syscall(SYS_clock_gettime, clock, out);
    out->tv_sec += clock == CLOCK_REALTIME ? calendar_is_ahead_s : 0;
    return result;
}

static int set_up(void **state)
{
    (void)state;
    strcpy(root, "/tmp/kingyo-heat-XXXXXX");
    return mkdtemp(root) == NULL;
}

static int tear_down(void **state)
{
    char command[128];
    (void)state;
    snprintf(command, sizeof command, "rm -r %s", root);
    return system(command);
}

static void zone(uint32_t index, const char *name, const char *words)
{
    char path[192];
    snprintf(path, sizeof path, "%s/thermal_zone%u", root, index);
    mkdir(path, 0700);
    snprintf(path, sizeof path, "%s/thermal_zone%u/%s", root, index, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(words, file);
    fclose(file);
}

static void test_the_default_throttle_limit_is_80_degrees(void **state)
{
    (void)state;
    zone(0, "temp", "61234\n");
    zone(0, "trip_point_0_type", "critical\n");
    zone(0, "trip_point_0_temp", "110000\n");
    assert_int_equal(thermal_read(root), 80000 - 61234);
}

static void test_a_passive_trip_point_of_the_zone_is_the_throttle_limit(void **state)
{
    (void)state;
    zone(0, "temp", "70000\n");
    zone(0, "trip_point_0_type", "passive\n");
    zone(0, "trip_point_0_temp", "95000\n");
    zone(0, "trip_point_1_type", "passive\n");
    zone(0, "trip_point_1_temp", "85000\n");
    zone(0, "trip_point_2_type", "active\n"); /* A trip point of the type "active" only starts a
                                                 fan, so it is not a limit for the margin. */
    zone(0, "trip_point_2_temp", "50000\n");
    assert_int_equal(thermal_read(root), 15000);
}

static void test_the_temperature_is_that_of_the_hottest_zone(void **state)
{
    (void)state;
    zone(0, "temp", "40000\n");
    zone(1, "temp", "82500\n");
    zone(2, "temp", "60000\n");
    assert_int_equal(thermal_read(root), -2500);
}

static void test_invalid_temperatures_are_ignored(void **state)
{
    (void)state;
    assert_int_equal(thermal_read("/nonexistent"), THERMAL_UNKNOWN_MDEG);
    assert_int_equal(thermal_read(root), THERMAL_UNKNOWN_MDEG);
    static const char *const words[] = {
        "", "-274000\n", "0\n", "4294967295\n", "warm\n", "45C\n"
    };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        zone(0, "temp", words[i]);
        assert_int_equal(thermal_read(root), THERMAL_UNKNOWN_MDEG);
    }
}

static void test_the_thermal_thread_reads_the_sensor_and_stops_immediately(void **state)
{
    (void)state;
    static struct thermal thermal;
    zone(0, "temp", "30000\n");
    thermal.root = root;
    thermal_start(&thermal);
    for (uint32_t i = 0; i < 500 && atomic_load(&thermal.measured_count) == 0; i++) {
        usleep(10000);
    }
    assert_int_equal(atomic_load(&thermal.margin_mdeg), 50000);
    thermal_stop(&thermal); /* The next reading is due in five seconds, but the stop must not wait
                               for it. */
    thermal_stop(&thermal);
    assert_false(thermal.runs);
}

/* Without a clock battery, the calendar of a board may be far ahead until the network time sets it
 * back. The thread must read the temperature in the meantime and afterwards. */
static void test_a_clock_set_back_does_not_delay_the_temperature(void **state)
{
    (void)state;
    static struct thermal thermal;
    calendar_is_ahead_s = 1000000000;
    zone(0, "temp", "30000\n");
    thermal.root = root;
    thermal_start(&thermal);
    for (uint32_t i = 0; i < 1000 && atomic_load(&thermal.measured_count) < 2u; i++) {
        usleep(10000);
    }
    thermal_stop(&thermal);
    calendar_is_ahead_s = 0;
    assert_true(atomic_load(&thermal.measured_count) >= 2u);
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_the_default_throttle_limit_is_80_degrees),
        TEST(test_a_passive_trip_point_of_the_zone_is_the_throttle_limit),
        TEST(test_the_temperature_is_that_of_the_hottest_zone),
        TEST(test_invalid_temperatures_are_ignored),
        TEST(test_the_thermal_thread_reads_the_sensor_and_stops_immediately),
        TEST(test_a_clock_set_back_does_not_delay_the_temperature),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
