/* test_base.c -- checks vectors, angles, random numbers and hashes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "core/base/vec.h"

static void assert_vec3_near(vec3 actual, vec3 expected)
{
    if (v3_length(v3_sub(actual, expected)) > 1e-5f) {
        fail_msg("(%g, %g, %g), not (%g, %g, %g)", (double)actual.x, (double)actual.y,
                 (double)actual.z, (double)expected.x, (double)expected.y, (double)expected.z);
    }
}

static vec3 nose_of(struct angles angles)
{
    const struct basis basis = vec_basis_from_angles(angles);
    return v3_scale(basis.back, -1.0f);
}

static void test_a_body_without_rotation_faces_minus_z(void **state)
{
    (void)state;
    assert_vec3_near(nose_of((struct angles){ 0 }), v3(0, 0, -1));
}

static void test_positive_yaw_turns_the_nose_left(void **state)
{
    (void)state;
    assert_vec3_near(nose_of((struct angles){ .yaw_rad = F_PI / 2 }), v3(-1, 0, 0));
}

static void test_positive_pitch_lifts_the_nose_at_every_yaw(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        const struct angles angles = { .yaw_rad = (float)i * 0.5f, .pitch_rad = 0.5f };
        assert_true(fabsf(nose_of(angles).y - sinf(0.5f)) < 1e-5f);
    }
}

static void test_positive_roll_lowers_the_right_side(void **state)
{
    (void)state;
    const struct basis basis = vec_basis_from_angles((struct angles){ .roll_rad = 0.3f });
    assert_true(basis.right.y < -0.29f);
    assert_true(basis.up.x > 0.29f);
}

static void test_axes_stay_orthonormal_and_right_handed(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 1000; i++) {
        const struct rng_key key = { i, 0, 0, RNG_TEST };
        const struct rng_key other = { i, 1, 0, RNG_TEST };
        const struct basis b = vec_basis_from_angles((struct angles){
            rng_range(key, -9, 9), rng_range(other, -1.5f, 1.5f), rng_range(key, -3, 3) });
        const vec3 p = v3(0.3f, -0.2f, 0.7f);
        assert_vec3_near(v3_cross(b.right, b.up), b.back);
        assert_true(fabsf(v3_length(b.right) - 1.0f) < 1e-5f);
        assert_vec3_near(vec_basis_to_body(&b, vec_basis_to_world(&b, p)), p);
    }
}

static void test_normalizing_a_zero_vector_gives_the_fallback(void **state)
{
    (void)state;
    assert_vec3_near(v3_normalize_or(v3(0, 0, 0), v3(0, 1, 0)), v3(0, 1, 0));
    assert_vec3_near(v3_normalize_or(v3(0, 0, 5), v3(0, 1, 0)), v3(0, 0, 1));
}

static void test_a_random_number_depends_on_its_key_alone(void **state)
{
    (void)state;
    const uint32_t first = rng_u32((struct rng_key){ 1, 2, 3, 4 });
    assert_int_equal(rng_u32((struct rng_key){ 1, 2, 3, 4 }), first);
    assert_int_not_equal(rng_u32((struct rng_key){ 2, 2, 3, 4 }), first);
    assert_int_not_equal(rng_u32((struct rng_key){ 1, 3, 3, 4 }), first);
    assert_int_not_equal(rng_u32((struct rng_key){ 1, 2, 4, 4 }), first);
    assert_int_not_equal(rng_u32((struct rng_key){ 1, 2, 3, 5 }), first);
}

/* Applies a chi-squared test with 64 bins (63 degrees of freedom). For uniform numbers, a
 * chi-squared value above 110 has a probability of less than 1 in 4,000. */
static void test_uniform_numbers_fill_their_range_evenly(void **state)
{
    (void)state;
    enum { BINS = 64, DRAWS = 64000 };
    uint32_t count[BINS] = { 0 };
    for (uint32_t i = 0; i < DRAWS; i++) {
        const float u = rng_unit((struct rng_key){ 7, i, 1, RNG_TEST });
        assert_true(u >= 0.0f && u < 1.0f);
        count[(uint32_t)(u * BINS)]++;
    }
    double chi = 0;
    for (uint32_t i = 0; i < BINS; i++) {
        const double off = (double)count[i] - (double)DRAWS / BINS;
        chi += off * off / ((double)DRAWS / BINS);
    }
    assert_true(chi < 110.0);
}

static void test_normal_numbers_have_mean_zero_and_deviation_one(void **state)
{
    (void)state;
    double sum = 0, square = 0;
    const uint32_t draws = 50000;
    for (uint32_t i = 0; i < draws; i++) {
        const double x = (double)rng_normal((struct rng_key){ 3, i, 9, RNG_TEST });
        sum += x;
        square += x * x;
    }
    assert_true(fabs(sum / draws) < 0.02);
    assert_true(fabs(square / draws - 1.0) < 0.03);
}

static void test_fnv_gives_the_published_value_for_bytes(void **state)
{
    (void)state;
    assert_true(hash_bytes(HASH_START, "foobar", 6) == 0x85944171f73967e8ull);
    assert_true(hash_bytes(HASH_START, "", 0) == HASH_START);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_body_without_rotation_faces_minus_z),
        cmocka_unit_test(test_positive_yaw_turns_the_nose_left),
        cmocka_unit_test(test_positive_pitch_lifts_the_nose_at_every_yaw),
        cmocka_unit_test(test_positive_roll_lowers_the_right_side),
        cmocka_unit_test(test_axes_stay_orthonormal_and_right_handed),
        cmocka_unit_test(test_normalizing_a_zero_vector_gives_the_fallback),
        cmocka_unit_test(test_a_random_number_depends_on_its_key_alone),
        cmocka_unit_test(test_uniform_numbers_fill_their_range_evenly),
        cmocka_unit_test(test_normal_numbers_have_mean_zero_and_deviation_one),
        cmocka_unit_test(test_fnv_gives_the_published_value_for_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
