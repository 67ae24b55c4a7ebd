/* test_oxygen.c -- checks the oxygen saturation of water, which depends on temperature and
 * pressure, and the oxygen consumption of the fish in a tank. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/input.h"
#include "core/tank/tank.h"
#include "core/tank/tank_fields.h"

static struct tank tank;

struct row {
    float pressure_hpa;
    float mg_l[9]; /* Saturation at 0, 5, 10, 15, 20, 25, 28, 30 and 35 C. */
};

static const float row_c[9] = { 0, 5, 10, 15, 20, 25, 28, 30, 35 };

/* Published values (Benson & Krause 1984, as in the tables of the USGS), computed in double
 * precision. 980 hPa is the pressure in a typhoon, and 960 hPa is the pressure in its eye. */
static const struct row rows[] = {
    { 1013.25f, { 14.621f, 12.771f, 11.288f, 10.084f, 9.092f, 8.263f, 7.828f, 7.559f, 6.949f } },
    { 980.0f, { 14.139f, 12.349f, 10.913f, 9.748f, 8.787f, 7.984f, 7.561f, 7.300f, 6.708f } },
    { 960.0f, { 13.849f, 12.095f, 10.688f, 9.545f, 8.604f, 7.815f, 7.401f, 7.144f, 6.563f } },
};

static void test_saturation_equals_the_tables_at_three_pressures(void **state)
{
    (void)state;
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        for (size_t i = 0; i < 9; i++) {
            const float mg_l = oxygen_saturation_mg_l(row_c[i], rows[r].pressure_hpa);
            /* The tolerance allows for the published tables, which are rounded to 0.001 mg/L. */
            assert_float_equal(mg_l, rows[r].mg_l[i], 0.0011f);
        }
    }
}

static double exact_exp(double x)
{
    double sum = 1.0, term = 1.0;
    for (int i = 1; i < 60; i++) {
        term *= x / 64.0 / i;
        sum += term;
    }
    for (int i = 0; i < 6; i++) {
        sum *= sum;
    }
    return sum;
}

/* Computes the published formula of the saturation in double precision. */
static double exact_saturation(double t, double hpa)
{
    const double k = t + 273.15, p = hpa / 1013.25;
    const double ln_c = -139.34411 + 1.575701e5 / k - 6.642308e7 / (k * k) +
                        1.243800e10 / (k * k * k) - 8.621949e11 / (k * k * k * k);
    const double u = exact_exp(11.8571 - 3840.70 / k - 216961.0 / (k * k));
    const double theta = 0.000975 - 1.426e-5 * t + 6.436e-8 * t * t;
    return exact_exp(ln_c) * ((p - u) * (1.0 - theta * p)) / ((1.0 - u) * (1.0 - theta));
}

static void test_single_precision_has_a_relative_error_below_a_ten_thousandth(void **state)
{
    (void)state;
    double worst = 0.0;
    for (float t = OXYGEN_TEMPERATURE_MIN_C; t <= OXYGEN_TEMPERATURE_MAX_C; t += 0.125f) {
        for (float p = OXYGEN_PRESSURE_MIN_HPA; p <= OXYGEN_PRESSURE_MAX_HPA; p += 5.0f) {
            const double exact = exact_saturation((double)t, (double)p);
            const double off = (double)oxygen_saturation_mg_l(t, p) / exact - 1.0;
            worst = off > worst ? off : -off > worst ? -off : worst;
        }
    }
    print_message("worst relative error of saturation %.2g\n", worst);
    assert_true(worst < 1e-4);
}

/* Compares the consumption with published rates in mg/kg/h. A fish of 5 cm weighs 2.9 g, and a fish
 * of 4 cm weighs 1.46 g. */
static void test_oxygen_consumption_depends_on_mass_temperature_and_speed(void **state)
{
    (void)state;
    assert_float_equal(oxygen_breath_mg_h(0.0029f, 15.0f, 0.0f) / 0.0029f, 128.0f, 1.0f);
    assert_float_equal(oxygen_breath_mg_h(0.0029f, 20.0f, 0.0f) / 0.0029f, 169.0f, 1.0f);
    assert_float_equal(oxygen_breath_mg_h(0.0029f, 25.0f, 0.0f) / 0.0029f, 224.0f, 1.0f);
    assert_float_equal(oxygen_breath_mg_h(0.0029f, 30.0f, 0.0f) / 0.0029f, 296.0f, 1.0f);
    assert_float_equal(oxygen_breath_mg_h(0.00146f, 25.0f, 0.0f) / 0.00146f, 255.0f, 1.0f);
    const float at_rest = oxygen_breath_mg_h(0.0029f, 25.0f, 0.0f);
    const float swims = oxygen_breath_mg_h(0.0029f, 25.0f, 0.0525f);
    const float bursts = oxygen_breath_mg_h(0.0029f, 25.0f, 0.15f);
    assert_float_equal((swims - at_rest) / 0.0029f, 113.0f, 1.0f);
    assert_float_equal((bursts - at_rest) / 0.0029f, 324.0f, 1.0f);
}

static void test_small_fish_need_a_slightly_higher_oxygen_content(void **state)
{
    (void)state;
    assert_float_equal(oxygen_critical_mg_l(0.00146f), 1.3f, 0.01f);
    assert_float_equal(oxygen_critical_mg_l(0.0029f), 1.2f, 0.01f);
}

static void test_a_still_surface_replaces_a_third_of_the_deficit_in_an_hour(void **state)
{
    (void)state;
    assert_float_equal(oxygen_exchange_per_h(0.10f, 0), 0.30f, 1e-6f);
    assert_float_equal(oxygen_exchange_per_h(0.20f, 0), 0.15f, 1e-6f);
    assert_float_equal(oxygen_exchange_per_h(0.10f, 1) - 0.30f, 5.0f, 1e-5f);
}

struct shoal {
    uint32_t count;
    float mass_kg, litres;
};

static const struct shoal official = { 1000, 0.00146f, 88.4f };
static const struct shoal grown = { 1000, 0.0029f, 88.4f };
static const struct shoal of_2013 = { 600, 0.0029f, 176.8f };

/* Returns the conditions for the oxygen balance of fish that rest in water of 25 C. */
static struct oxygen_balance balance_of(const struct shoal *shoal, float exchange_per_h)
{
    return (struct oxygen_balance){
        .saturation_mg_l = oxygen_saturation_mg_l(25.0f, OXYGEN_PRESSURE_HPA),
        .exchange_per_h = exchange_per_h,
        .breath_mg_l_h =
            (float)shoal->count * oxygen_breath_mg_h(shoal->mass_kg, 25.0f, 0.0f) / shoal->litres,
        .critical_mg_l = oxygen_critical_mg_l(shoal->mass_kg),
    };
}

/* Returns the number of hours in which the oxygen falls from saturation to 2 mg/L, or 99 if it
 * stays above 2 mg/L for a day. */
static float hours_to_2_mg_l(const struct shoal *shoal, float exchange_per_h)
{
    const struct oxygen_balance balance = balance_of(shoal, exchange_per_h);
    float mg_l = balance.saturation_mg_l;
    for (float hours = 0.0f; hours < 24.0f; hours += 0.01f) {
        if (mg_l <= 2.0f) {
            return hours;
        }
        mg_l = oxygen_after(mg_l, &balance, 0.01f);
    }
    return 99.0f;
}

static float steady_mg_l(const struct shoal *shoal, float exchange_per_h)
{
    const struct oxygen_balance balance = balance_of(shoal, exchange_per_h);
    return oxygen_after(balance.saturation_mg_l, &balance, 24.0f);
}

static void test_the_championship_without_air_reaches_2_mg_l_in_1_5_hours(void **state)
{
    (void)state;
    assert_float_equal(balance_of(&official, 0.0f).breath_mg_l_h, 4.2f, 0.05f);
    assert_float_equal(hours_to_2_mg_l(&official, 0.0f), 1.5f, 0.05f);
    assert_float_equal(hours_to_2_mg_l(&official, 0.3f), 2.0f, 0.05f);
    assert_float_equal(balance_of(&grown, 0.0f).breath_mg_l_h, 7.3f, 0.1f);
    assert_float_equal(hours_to_2_mg_l(&grown, 0.0f), 0.86f, 0.02f);
    assert_float_equal(hours_to_2_mg_l(&grown, 0.3f), 1.0f, 0.05f);
}

static void test_the_thesis_tank_reaches_2_mg_l_in_3_hours_only_without_exchange(void **state)
{
    (void)state;
    assert_float_equal(balance_of(&of_2013, 0.0f).breath_mg_l_h, 2.2f, 0.05f);
    assert_float_equal(hours_to_2_mg_l(&of_2013, 0.0f), 2.9f, 0.1f);
    const struct oxygen_balance still = balance_of(&of_2013, 0.3f);
    assert_float_equal(oxygen_after(still.saturation_mg_l, &still, 6.0f), 2.16f, 0.05f);
}

static void test_an_air_stone_keeps_every_tank_well_above_2_mg_l(void **state)
{
    (void)state;
    assert_float_equal(steady_mg_l(&official, 2.0f), 6.2f, 0.1f);
    assert_float_equal(steady_mg_l(&official, 5.0f), 7.4f, 0.1f);
    assert_float_equal(steady_mg_l(&grown, 2.0f), 4.6f, 0.1f);
    assert_float_equal(steady_mg_l(&grown, 5.0f), 6.8f, 0.1f);
    assert_float_equal(steady_mg_l(&of_2013, 2.0f), 7.2f, 0.1f);
    assert_float_equal(steady_mg_l(&of_2013, 5.0f), 7.8f, 0.1f);
}

static void test_one_long_step_equals_many_short_steps_and_stays_positive(void **state)
{
    (void)state;
    const struct oxygen_balance balance = balance_of(&grown, 0.3f);
    float mg_l = balance.saturation_mg_l;
    for (int i = 0; i < 7200; i++) {
        mg_l = oxygen_after(mg_l, &balance, 1.0f / 3600.0f);
    }
    assert_float_equal(oxygen_after(balance.saturation_mg_l, &balance, 2.0f), mg_l, 0.01f);
    const struct oxygen_balance shut = balance_of(&grown, 0.0f);
    const float left = oxygen_after(0.5f, &shut, 10.0f);
    assert_true(left >= 0.0f && left < 0.01f);
    assert_float_equal(oxygen_after(3.0f, &(struct oxygen_balance){ .critical_mg_l = 1.0f }, 5.0f),
                       3.0f, 0.0f);
}

static struct tank_config official_config(void)
{
    struct tank_config config = tank_config_of(TANK_PRESET_OFFICIAL);
    config.fish_count = 100;
    config.area_scale = 0.1f;
    /* Compresses the time so that an hour of water chemistry passes in ten seconds. */
    config.time_compression = 360.0f;
    return config;
}

static void run(const struct tank_config *config, uint32_t seconds)
{
    assert_true(tank_open(&tank, config));
    for (uint32_t tick = 0; tick < seconds * CORE_TICK_HZ; tick++) {
        tank_tick(&tank, tick, NULL, 0);
    }
}

/* If all fish rested, they would consume 4.2 mg/L per hour. A third of the fish swim and consume
 * 1.5 times as much. The tank must consume the sum. */
static void test_a_tank_consumes_the_sum_of_its_fish_at_the_compressed_time(void **state)
{
    (void)state;
    struct tank_config config = official_config();
    run(&config, 5);
    const float half_an_hour = 8.263f - tank.oxygen.dissolved_mg_l;
    print_message("100 fish in a tenth of the official tank: %.2f mg/L in half an hour\n",
                  (double)half_an_hour);
    assert_true(half_an_hour > 1.9f && half_an_hour < 2.9f);
    config.time_compression = 0.0f;
    run(&config, 2);
    assert_float_equal(tank.oxygen.dissolved_mg_l, 8.263f, 0.002f);
    config.time_compression = 1.0f;
    run(&config, 10);
    assert_float_equal(8.263f - tank.oxygen.dissolved_mg_l, half_an_hour / 180.0f, 0.004f);
}

/* The compression of time must apply only to the chemistry of the water. The fish must move exactly
 * as without it. */
static void test_time_compression_does_not_change_the_motion_of_fish(void **state)
{
    (void)state;
    struct tank_config config = official_config();
    run(&config, 2);
    const uint64_t hurried = field_hash(HASH_START, &tank_quick_fields, &tank);
    config.time_compression = 1.0f;
    run(&config, 2);
    assert_true(field_hash(HASH_START, &tank_quick_fields, &tank) == hurried);
}

static void test_a_pump_and_cool_water_keep_the_oxygen(void **state)
{
    (void)state;
    struct tank_config config = official_config();
    run(&config, 5);
    const float warm = tank.oxygen.dissolved_mg_l;
    config.temperature_c = 15.0f;
    run(&config, 5);
    const float cool = tank.oxygen.dissolved_mg_l;
    config.temperature_c = 25.0f;
    config.pump = 1;
    run(&config, 5);
    const float aired = tank.oxygen.dissolved_mg_l;
    assert_true(cool > warm + 2.0f);
    assert_true(aired > warm + 1.0f);
}

static void refuse(struct tank_config config)
{
    tank.seed = 77;
    assert_false(tank_open(&tank, &config));
    assert_int_equal(tank.seed, 77);
}

static void test_water_values_out_of_range_are_rejected(void **state)
{
    (void)state;
    const float nan = __builtin_nanf("");
    struct tank_config config = official_config();
    config.temperature_c = 40.0f;
    config.pressure_hpa = 870.0f;
    config.oxygen_mg_l = 0.0f;
    config.time_compression = 1000.0f;
    assert_true(tank_open(&tank, &config));
    const float temperatures[] = { -0.1f, 40.1f, nan }, pressures[] = { 869.0f, 1086.0f, nan };
    const float oxygens[] = { -0.5f, 20.1f, nan }, compressions[] = { -1.0f, 1000.5f, nan };
    for (int i = 0; i < 3; i++) {
        struct tank_config hot = config, high = config, rich = config, quick = config;
        hot.temperature_c = temperatures[i];
        refuse(hot);
        high.pressure_hpa = pressures[i];
        refuse(high);
        rich.oxygen_mg_l = oxygens[i];
        refuse(rich);
        quick.time_compression = compressions[i];
        refuse(quick);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_saturation_equals_the_tables_at_three_pressures),
        cmocka_unit_test(test_single_precision_has_a_relative_error_below_a_ten_thousandth),
        cmocka_unit_test(test_oxygen_consumption_depends_on_mass_temperature_and_speed),
        cmocka_unit_test(test_small_fish_need_a_slightly_higher_oxygen_content),
        cmocka_unit_test(test_a_still_surface_replaces_a_third_of_the_deficit_in_an_hour),
        cmocka_unit_test(test_the_championship_without_air_reaches_2_mg_l_in_1_5_hours),
        cmocka_unit_test(test_the_thesis_tank_reaches_2_mg_l_in_3_hours_only_without_exchange),
        cmocka_unit_test(test_an_air_stone_keeps_every_tank_well_above_2_mg_l),
        cmocka_unit_test(test_one_long_step_equals_many_short_steps_and_stays_positive),
        cmocka_unit_test(test_a_tank_consumes_the_sum_of_its_fish_at_the_compressed_time),
        cmocka_unit_test(test_time_compression_does_not_change_the_motion_of_fish),
        cmocka_unit_test(test_a_pump_and_cool_water_keep_the_oxygen),
        cmocka_unit_test(test_water_values_out_of_range_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
