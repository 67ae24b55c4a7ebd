/* test_simd.c -- checks that each lane of a SIMD function equals the scalar function bit for bit,
 * over millions of values.
 *
 * This file is built for four lanes. test_simd_wide.c builds it again for eight lanes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/base/simd.h"
#include "core/base/vec.h"

#define ROUNDS 400000u

static uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float special(uint32_t which)
{
    static const float values[] = { 0.0f,        -0.0f,       1.0f,        -1.0f,
                                    0.5f,        -0.5f,       F_PI,        -F_PI,
                                    F_TAU,       -F_TAU,      F_PI / 2.0f, 1e-30f,
                                    -1e-30f,     8388607.5f,  8388608.0f,  -8388608.0f,
                                    16777215.0f, 0.41421356f, 0.99999994f, -0.99999994f,
                                    2.5f,        -2.5f };
    return values[which % (sizeof values / sizeof values[0])];
}

/* Returns a value with a magnitude from 1e-6 to 1e3. One time in 16, returns a special value
 * instead. */
static float value(uint32_t round, uint32_t who)
{
    const struct rng_key kind = { 1, round, who, RNG_TEST }, size = { 2, round, who, RNG_TEST };
    if (rng_u32(kind) % 16u == 0) {
        return special(rng_u32(size));
    }
    const float magnitude = f_exp(rng_range(size, -13.8f, 6.9f));
    return rng_u32(kind) & 16u ? -magnitude : magnitude;
}

static flanes values(uint32_t round, uint32_t who)
{
    flanes a;
    for (uint32_t lane = 0; lane < SIMD_LANES; lane++) {
        a[lane] = value(round * SIMD_LANES + lane, who);
    }
    return a;
}

static void check(flanes got, int lane, float expected, const char *what, float x, float y)
{
    if (bits_of(got[lane]) != bits_of(expected)) {
        fail_msg("%s(%.9g, %.9g): lane %d has %.9g, the scalar form %.9g", what, (double)x,
                 (double)y, lane, (double)got[lane], (double)expected);
    }
}

#define CHECK_1(name, reach)                                                                       \
    do {                                                                                           \
        for (uint32_t round = 0; round < ROUNDS; round++) {                                        \
            const flanes x = values(round, 0),                                                     \
                         inside = simd_clamp(x, -(simd_splat(reach)), simd_splat(reach));          \
            const flanes got = simd_##name(inside);                                                \
            for (int lane = 0; lane < SIMD_LANES; lane++) {                                        \
                check(got, lane, f_##name(inside[lane]), #name, inside[lane], 0.0f);               \
            }                                                                                      \
        }                                                                                          \
    } while (0)

#define CHECK_2(name)                                                                              \
    do {                                                                                           \
        for (uint32_t round = 0; round < ROUNDS; round++) {                                        \
            const flanes x = values(round, 0), y = values(round, 1);                               \
            const flanes got = simd_##name(x, y);                                                  \
            for (int lane = 0; lane < SIMD_LANES; lane++) {                                        \
                check(got, lane, f_##name(x[lane], y[lane]), #name, x[lane], y[lane]);             \
            }                                                                                      \
        }                                                                                          \
    } while (0)

static void test_floors_roots_and_wraps_equal_the_scalar_form(void **state)
{
    (void)state;
    CHECK_1(floor, 1e9f);
    CHECK_1(abs, 1e9f);
    CHECK_1(wrap_angle, 1000.0f);
    for (uint32_t round = 0; round < ROUNDS; round++) {
        const flanes x = simd_abs(values(round, 0));
        const flanes got = simd_sqrt(x);
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            check(got, lane, f_sqrt(x[lane]), "sqrt", x[lane], 0.0f);
        }
    }
}

static void test_sines_and_cosines_equal_the_scalar_form(void **state)
{
    (void)state;
    for (uint32_t round = 0; round < ROUNDS; round++) {
        const flanes x = simd_clamp(values(round, 0), simd_splat(-1000.0f), simd_splat(1000.0f));
        const struct simd_sin_cos got = simd_sin_cos(x);
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            check(got.sin, lane, f_sin(x[lane]), "sin", x[lane], 0.0f);
            check(got.cos, lane, f_cos(x[lane]), "cos", x[lane], 0.0f);
        }
    }
}

static void test_minimum_and_maximum_equal_the_scalar_form(void **state)
{
    (void)state;
    CHECK_2(min);
    CHECK_2(max);
    for (uint32_t round = 0; round < ROUNDS; round++) {
        const flanes x = values(round, 0), y = values(round, 1), t = values(round, 2);
        const flanes clamped = simd_clamp(x, y, t), between = simd_lerp(x, y, t);
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            check(clamped, lane, f_clamp(x[lane], y[lane], t[lane]), "clamp", x[lane], y[lane]);
            check(between, lane, f_lerp(x[lane], y[lane], t[lane]), "lerp", x[lane], y[lane]);
        }
    }
}

static void test_one_value_fills_all_lanes_sign_of_zero_included(void **state)
{
    (void)state;
    for (uint32_t which = 0; which < 64; which++) {
        const flanes a = simd_splat(special(which));
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            check(a, lane, special(which), "of", special(which), 0.0f);
        }
    }
}

static void test_a_mask_selects_and_counts_by_lane(void **state)
{
    (void)state;
    for (uint32_t bits = 0; bits < 1u << SIMD_LANES; bits++) {
        ilanes mask;
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            mask[lane] = bits >> lane & 1u ? -1 : 0;
        }
        assert_int_equal(simd_bits(mask), bits);
        const flanes got = simd_select(mask, simd_splat(-0.0f), simd_splat(2.0f));
        for (int lane = 0; lane < SIMD_LANES; lane++) {
            check(got, lane, bits >> lane & 1u ? -0.0f : 2.0f, "select", 0.0f, 0.0f);
        }
    }
}

/* A quad is four successive floats of a record. In this test records have 7 floats, and the quad
 * consists of members 2 to 5. */
static void test_quads_of_records_transpose_to_columns_and_back(void **state)
{
    (void)state;
    float record[SIMD_LANES][7], copy[SIMD_LANES][7];
    for (int lane = 0; lane < SIMD_LANES; lane++) {
        for (int member = 0; member < 7; member++) {
            record[lane][member] = (float)(10 * lane + member);
            copy[lane][member] = -1.0f;
        }
    }
    flanes column[4];
    simd_load_quads(column, &record[0][2], sizeof record[0]);
    simd_store_quads(&copy[0][2], sizeof copy[0], column);
    for (int lane = 0; lane < SIMD_LANES; lane++) {
        for (int member = 0; member < 7; member++) {
            const int is_copied = member >= 2 && member < 6;
            if (is_copied) {
                check(column[member - 2], lane, record[lane][member], "column", 0.0f, 0.0f);
            }
            const float expected = is_copied ? record[lane][member] : -1.0f;
            assert_float_equal(copy[lane][member], expected, 0.0f);
        }
    }
}

#ifdef SIMD_WIDE
static bool machine_has_it(void)
{
    return __builtin_cpu_supports("avx2");
}
#else
static bool machine_has_it(void)
{
    return true;
}
#endif

int main(void)
{
    if (!machine_has_it()) {
        print_message("1..1\nok 1 - eight lanes # SKIP this processor has no AVX2\n");
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_floors_roots_and_wraps_equal_the_scalar_form),
        cmocka_unit_test(test_sines_and_cosines_equal_the_scalar_form),
        cmocka_unit_test(test_minimum_and_maximum_equal_the_scalar_form),
        cmocka_unit_test(test_one_value_fills_all_lanes_sign_of_zero_included),
        cmocka_unit_test(test_a_mask_selects_and_counts_by_lane),
        cmocka_unit_test(test_quads_of_records_transpose_to_columns_and_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
