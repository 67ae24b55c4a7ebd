/* test_wall_following.c -- checks that a single fish prefers the walls, as figure 2.3 of the 2013
 * thesis shows. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/tank.h"
#include "tests/unit/support/pond.h"

/* Number of bins of 2 cm between an end wall and the middle of the tank, which is 60 cm long. */
#define BINS 15u
#define BIN_M 0.02f
#define FISH 24u
#define MINUTES 20u

static struct tank tank;

struct histogram {
    /* Share of the time in each bin. The bin is given by the distance from the nearer end wall. */
    float share[BINS];
    float beside;    /* Share of the time within 6 cm of any wall. */
    float lengths_s; /* Mean speed in body lengths per second while the fish swims. */
};

static struct tank_config aquarium(uint32_t seed, float wall_follow)
{
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.fish_count = 1;
    config.seed = seed;
    config.size_m = v3(0.60f, 0.12f, 0.30f);
    config.wall_follow = wall_follow;
    return config;
}

static void watch(struct histogram *histogram, float *swims)
{
    const struct fish *fish = &tank.fish[0];
    const float end_m = 0.30f - f_abs(fish->position_m.x);
    const float side_m = 0.15f - f_abs(fish->position_m.z);
    const uint32_t bin = (uint32_t)f_clamp(end_m / BIN_M, 0.0f, (float)BINS - 0.5f);
    histogram->share[bin] += 1.0f;
    histogram->beside += f_min(end_m, side_m) < 0.06f;
    if (fish->gait == GAIT_SWIM) {
        histogram->lengths_s += v3_length(fish->velocity_m_s) / fish->length_m;
        *swims += 1.0f;
    }
}

/* Lets FISH fish swim, one after the other, in a tank of 60 x 30 cm. Returns the histogram of their
 * positions. */
static struct histogram histogram_of(float wall_follow)
{
    struct histogram histogram = { 0 };
    float swims = 0.0f, samples = 0.0f;
    for (uint32_t seed = 1; seed <= FISH; seed++) {
        const struct tank_config config = aquarium(seed, wall_follow);
        assert_true(tank_open(&tank, &config));
        for (uint32_t tick = 0; tick < MINUTES * 60u * CORE_TICK_HZ; tick++) {
            tank_tick(&tank, tick, NULL, 0);
            if (tick % 60u == 0 && tick > 60u * CORE_TICK_HZ) {
                watch(&histogram, &swims);
                samples += 1.0f;
            }
        }
    }
    for (uint32_t bin = 0; bin < BINS; bin++) {
        histogram.share[bin] /= samples;
        print_message("%2u cm %.4f\n", 2u * bin + 1u, (double)histogram.share[bin]);
    }
    histogram.beside /= samples;
    histogram.lengths_s /= swims;
    print_message("within 6 cm of a wall %.3f, %.2f lengths/s\n", (double)histogram.beside,
                  (double)histogram.lengths_s);
    return histogram;
}

/* Fits a line to ln(share) over the bins from `first` to 9. Returns the distance in metres over
 * which the share falls to 1/e, and writes the r squared of the fit. */
static float fall_off_m(const struct histogram *histogram, uint32_t first, float *r2)
{
    float n = 0.0f, sx = 0.0f, sy = 0.0f, sxx = 0.0f, sxy = 0.0f, syy = 0.0f;
    for (uint32_t bin = first; bin < 10u; bin++) {
        const float x = ((float)bin + 0.5f) * BIN_M, y = f_log(histogram->share[bin]);
        n += 1.0f;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
        syy += y * y;
    }
    const float over = n * sxy - sx * sy, under = n * sxx - sx * sx;
    *r2 = over * over / (under * (n * syy - sy * sy));
    return -under / over;
}

static void test_the_density_of_a_lone_fish_falls_with_the_distance_from_a_wall(void **state)
{
    (void)state;
    const struct histogram drawn = histogram_of(1.0f);
    float r2 = 0.0f;
    const float length_m = fall_off_m(&drawn, 1, &r2);
    print_message("falls to 1/e over %.1f cm, r2 %.3f\n", (double)(100.0f * length_m), (double)r2);
    /* The share of the time must fall to 1/e over about 7 cm. The walls attract the fish from a
     * distance of up to 20 cm. */
    assert_true(length_m > 0.06f && length_m < 0.085f);
    assert_true(r2 > 0.95f);
    /* The attraction must not stop the fish. Along the walls it must still swim at 0.85 lengths per
     * second or more. */
    assert_true(drawn.lengths_s > 0.85f);
    const struct histogram indifferent = histogram_of(0.0f);
    assert_true(drawn.beside > 0.7f);
    assert_true(drawn.beside > 1.3f * indifferent.beside);
}

static void test_the_wall_pull_falls_exponentially_and_ends_at_20_cm(void **state)
{
    (void)state;
    /* At a distance of 3 cm the fish is already beside the wall, so the wall must no longer attract
     * it. */
    assert_float_equal(behavior_wall_pull(0.03f, 0.05f), 0.0f, 0.0f);
    assert_float_equal(behavior_wall_pull(0.19f, 0.05f) / behavior_wall_pull(0.10f, 0.05f),
                       f_exp(-1.0f), 1e-4f);
    assert_float_equal(behavior_wall_pull(0.201f, 0.05f), 0.0f, 0.0f);
}

static void test_a_wall_turns_headings_toward_itself_by_the_shorter_way(void **state)
{
    (void)state;
    struct perception around = *pond_at(1, 0);
    around.wall_follow = 1.0f;
    for (int degrees = -170; degrees < 180; degrees += 20) {
        struct fish fish = { WAKIN(0.05f), .gait = GAIT_SWIM,
                             .position_m = { 0.425f - 0.10f, -0.06f, 0.0f } };
        fish.heading_rad = (float)degrees * F_DEG;
        /* The wall is in the direction +x, which is a yaw of -90 degrees. The attraction must never
         * turn the heading away from the wall. */
        const float off_rad = f_abs(f_wrap_angle(fish.heading_rad + 0.5f * F_PI));
        behavior_wall_follow(&fish, &around);
        assert_true(f_abs(f_wrap_angle(fish.heading_rad + 0.5f * F_PI)) < off_rad + 1e-6f);
        fish.heading_rad = (float)degrees * F_DEG;
        fish.gait = GAIT_REST;
        behavior_wall_follow(&fish, &around);
        assert_float_equal(fish.heading_rad, (float)degrees * F_DEG, 0.0f);
    }
}

static void test_no_preset_uses_the_wall_pull(void **state)
{
    (void)state;
    for (uint8_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        assert_float_equal(tank_config_of(preset).wall_follow, 0.0f, 0.0f);
    }
}

static void test_a_custom_tank_size_limits_the_fish_count_and_bad_sizes_are_rejected(void **state)
{
    (void)state;
    struct tank_config config = aquarium(1, 1.0f);
    assert_true(tank_open(&tank, &config));
    assert_float_equal(tank.size_m.x, 0.60f, 1e-6f);
    assert_float_equal(tank.size_m.z, 0.30f, 1e-6f);
    const uint32_t most = tank_config_fish_max(&config);
    /* The festival's tank has 47 dm^2 of water surface and this tank has 18 dm^2. The largest
     * number of fish must therefore be 18/47 of that of the festival's tank. */
    assert_in_range(most, 200, 300);
    config.fish_count = most + 1u;
    assert_false(tank_open(&tank, &config));
    const vec3 odd[] = { { 0.29f, 0, 0 }, { 2.01f, 0, 0 }, { 0, 0.04f, 0 },   { 0, 0.51f, 0 },
                         { 0, 0, 0.29f }, { 0, 0, 2.01f }, { -0.6f, 0, 0.3f } };
    for (uint32_t i = 0; i < sizeof odd / sizeof odd[0]; i++) {
        config = aquarium(1, 1.0f);
        config.size_m = odd[i];
        assert_false(tank_open(&tank, &config));
    }
    config = aquarium(1, 1.01f);
    assert_false(tank_open(&tank, &config));
    config = aquarium(1, -0.01f);
    assert_false(tank_open(&tank, &config));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_wall_pull_falls_exponentially_and_ends_at_20_cm),
        cmocka_unit_test(test_a_wall_turns_headings_toward_itself_by_the_shorter_way),
        cmocka_unit_test(test_no_preset_uses_the_wall_pull),
        cmocka_unit_test(test_a_custom_tank_size_limits_the_fish_count_and_bad_sizes_are_rejected),
        cmocka_unit_test(test_the_density_of_a_lone_fish_falls_with_the_distance_from_a_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
