/* test_hull.c -- checks the distance between a bowl's hull and a fish's box. The computed distance
 * is compared with the distance to sample points of the hull. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/tank/collision/box.h"
#include "tests/unit/support/pond.h"

#define ROWS 240
#define COLUMNS 480

static const struct hull hull = { { 0.0f, 0.012f, 0.0f }, 0.075f, 0.055f };

static float draw(uint32_t who, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 9, which, who, RNG_TEST }, low, high);
}

static double part(vec3 axis, const double p[3])
{
    return (double)axis.x * p[0] + (double)axis.y * p[1] + (double)axis.z * p[2];
}

/* Returns the distance between the box and a point. The result is 0 if the point is inside the
 * box. */
static double box_to_point_m(const struct box *box, const double at[3])
{
    const double p[3] = { at[0] - (double)box->centre_m.x, at[1] - (double)box->centre_m.y,
                          at[2] - (double)box->centre_m.z };
    const double x = fmax(fabs(part(box->axes.right, p)) - (double)box->half_m.x, 0.0);
    const double y = fmax(fabs(part(box->axes.up, p)) - (double)box->half_m.y, 0.0);
    const double z = fmax(fabs(part(box->axes.back, p)) - (double)box->half_m.z, 0.0);
    return sqrt(x * x + y * y + z * z);
}

/* Returns the smallest distance between the box and 115,200 sample points, which are on the hull
 * below its opening. */
static double sampled_m(const struct box *box)
{
    double least_m = 1.0;
    for (int r = 0; r < ROWS; r++) {
        const double down = 0.5 * M_PI * (r + 0.5) / ROWS;
        for (int c = 0; c < COLUMNS; c++) {
            const double round = 2.0 * M_PI * c / COLUMNS;
            const double p[3] = { 0.075 * cos(down) * cos(round), 0.012 - 0.055 * sin(down),
                                  0.075 * cos(down) * sin(round) };
            least_m = fmin(least_m, box_to_point_m(box, p));
        }
    }
    return least_m;
}

static struct box fish_near(uint32_t who)
{
    const float round_rad = draw(who, 1, -F_PI, F_PI), down_rad = draw(who, 2, 0.35f, 1.5f);
    const float out = draw(who, 3, 1.05f, 1.6f);
    const float level_m = out * 0.075f * f_cos(down_rad);
    const struct fish fish = {
        .position_m = v3(level_m * f_cos(round_rad), 0.012f - out * 0.055f * f_sin(down_rad),
                         level_m * f_sin(round_rad)),
        .angles = { draw(who, 4, -F_PI, F_PI), draw(who, 5, -0.6f, 0.6f), 0.0f },
        WAKIN(0.045f),
    };
    return fish_box(&fish);
}

static void test_the_distance_to_a_hull_is_that_of_its_nearest_point(void **state)
{
    (void)state;
    double worst_m = 0.0, worst_share = 0.0;
    uint32_t apart = 0, touching = 0;
    for (uint32_t i = 0; i < 400; i++) {
        const struct box box = fish_near(i);
        const double measured_m = (double)shape_touch_hull(&hull, &box).gap_m,
                     true_m = sampled_m(&box);
        if (true_m > 0.0005) {
            assert_true(measured_m > 0.0);
        }
        if (true_m > 0.0005 && true_m < 0.003 && measured_m < (double)SHAPE_TOUCH_FAR_M) {
            apart++;
            worst_share = fmax(worst_share, fabs(measured_m - true_m) / true_m);
        }
        if (measured_m < -0.0005) {
            touching++;
            worst_m = fmax(worst_m, true_m);
        }
    }
    print_message("%u apart, wrong by %.0f %% at worst; %u touching, truly apart by %.3f mm\n",
                  apart, 100.0 * worst_share, touching, 1000.0 * worst_m);
    assert_true(apart > 10 && touching > 10);
    assert_true(worst_m < 0.0005);
    assert_true(worst_share < 0.08);
}

/* A few moves along the separation vector must bring a box out of the hull, because the contact
 * solver relies on this. */
static void test_the_separation_vector_leads_out_of_the_hull(void **state)
{
    (void)state;
    uint32_t touching = 0;
    for (uint32_t i = 0; i < 400; i++) {
        struct box box = fish_near(i);
        struct touch touch = shape_touch_hull(&hull, &box);
        touching += touch.gap_m < 0.0f;
        for (int k = 0; k < 8 && touch.gap_m < 0.0f; k++) {
            box.centre_m = v3_muladd(box.centre_m, touch.out, -touch.gap_m);
            touch = shape_touch_hull(&hull, &box);
        }
        assert_true(touch.gap_m > -0.0001f);
    }
    assert_true(touching > 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_distance_to_a_hull_is_that_of_its_nearest_point),
        cmocka_unit_test(test_the_separation_vector_leads_out_of_the_hull),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
