/* test_shape_tests.c -- checks the distance between a fish's box and a poi's ring. The computed
 * distance is compared with the distance to about 1,000 points of the ring. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/fmath.h"
#include "core/base/rng.h"
#include "core/tank/collision/box.h"

#define WALK_POINTS 1024
/* Tolerance in metres (0.06 mm). The spacing of the sample points alone causes an error of 0.01
 * mm. */
#define EXACT_M 0.00006f

static float draw(uint32_t which, uint32_t i, float low, float high)
{
    return rng_range((struct rng_key){ 7, i, which, RNG_TEST }, low, high);
}

static struct ring ring_of(uint32_t i)
{
    const struct angles tilt = { draw(0, i, -F_PI, F_PI), draw(1, i, -1.5f, 1.5f),
                                 draw(2, i, -1.5f, 1.5f) };
    return (struct ring){ { draw(3, i, -0.3f, 0.3f), draw(4, i, -0.2f, 0.0f), 0.1f },
                          vec_basis_from_angles(tilt).up,
                          0.0432f,
                          0.0033f };
}

/* Returns a random box near the ring. The box is 3 to 15 cm long. */
static struct box box_by(const struct ring *ring, uint32_t i)
{
    const float length_m = draw(5, i, 0.03f, 0.15f);
    const struct angles pose = { draw(6, i, -F_PI, F_PI), draw(7, i, -0.8f, 0.8f),
                                 draw(8, i, -0.5f, 0.5f) };
    const float far_m = 0.08f;
    const vec3 off =
        v3(draw(9, i, -far_m, far_m), draw(10, i, -far_m, far_m), draw(11, i, -far_m, far_m));
    return (struct box){ v3_add(ring->centre_m, off), vec_basis_from_angles(pose),
                         v3(0.1f * length_m, 0.2f * length_m, 0.5f * length_m) };
}

/* Returns the distance between the ring's centre line and the box, which is computed from points
 * along the ring. The result is negative if the centre line is inside the box. */
static float walked_m(const struct ring *ring, const struct box *box)
{
    const vec3 other = f_abs(ring->normal.y) < 0.7f ? v3(0.0f, 1.0f, 0.0f) : v3(1.0f, 0.0f, 0.0f);
    const vec3 east = v3_normalize_or(v3_cross(ring->normal, other), other);
    const vec3 north = v3_cross(ring->normal, east);
    float least_m = SHAPE_TOUCH_FAR_M;
    for (int k = 0; k < WALK_POINTS; k++) {
        const float angle_rad = F_TAU * (float)k / (float)WALK_POINTS;
        const vec3 away =
            v3_add(v3_scale(east, f_cos(angle_rad)), v3_scale(north, f_sin(angle_rad)));
        vec3 unused;
        const vec3 point_m = v3_muladd(ring->centre_m, away, ring->middle_m);
        least_m = f_min(least_m, shape_touch_point_m(box, point_m, &unused));
    }
    return least_m;
}

static void test_the_distance_to_a_ring_is_that_of_its_nearest_point(void **state)
{
    (void)state;
    uint32_t touching = 0, clear = 0, through = 0;
    for (uint32_t i = 0; i < 6000; i++) {
        const struct ring ring = ring_of(i);
        const struct box box = box_by(&ring, i);
        const float line_m = walked_m(&ring, &box), gap_m = shape_touch_ring(&ring, &box).gap_m;
        if (line_m > EXACT_M && line_m < ring.tube_m) {
            assert_float_equal(gap_m, line_m - ring.tube_m, EXACT_M);
            touching++;
        } else if (line_m >= ring.tube_m) {
            assert_true(gap_m > -EXACT_M);
            clear++;
        } else if (line_m < -EXACT_M) {
            assert_true(gap_m < EXACT_M + line_m - ring.tube_m);
            through++;
        }
    }
    assert_true(touching > 150 && clear > 1000 && through > 500);
}

static void test_the_separation_vector_leads_off_the_ring(void **state)
{
    (void)state;
    uint32_t touching = 0, freed = 0;
    for (uint32_t i = 0; i < 6000; i++) {
        const struct ring ring = ring_of(i);
        struct box box = box_by(&ring, i);
        const struct touch touch = shape_touch_ring(&ring, &box);
        if (touch.gap_m < 0.0f) {
            assert_float_equal(v3_length(touch.out), 1.0f, 1e-4f);
            const float before_m = walked_m(&ring, &box);
            box.centre_m = v3_muladd(box.centre_m, touch.out, -touch.gap_m);
            touching++;
            freed += walked_m(&ring, &box) > f_max(before_m, 0.0f);
        }
    }
    assert_true(touching > 700);
    /* A box that is between two parts of the ring cannot be freed in one step. The test therefore
     * requires that only 80 % of the boxes are free. */
    assert_true(freed * 10u > touching * 8u);
}

static void test_a_fish_over_the_middle_is_clear_of_the_ring_at_every_heading(void **state)
{
    (void)state;
    const struct ring ring = { { 0.0f, -0.05f, 0.0f }, { 0.0f, 1.0f, 0.0f }, 0.0432f, 0.0033f };
    for (uint32_t i = 0; i < 64; i++) {
        const struct angles pose = { F_TAU * (float)i / 64.0f, 0.0f, 0.0f };
        const struct box small = { ring.centre_m,
                                   vec_basis_from_angles(pose),
                                   { 0.004f, 0.008f, 0.0395f } };
        const struct box wide = { ring.centre_m,
                                  vec_basis_from_angles(pose),
                                  { 0.004f, 0.008f, 0.0405f } };
        assert_true(shape_touch_ring(&ring, &small).gap_m > -EXACT_M);
        assert_true(shape_touch_ring(&ring, &wide).gap_m < -0.0004f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_distance_to_a_ring_is_that_of_its_nearest_point),
        cmocka_unit_test(test_the_separation_vector_leads_off_the_ring),
        cmocka_unit_test(test_a_fish_over_the_middle_is_clear_of_the_ring_at_every_heading),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
