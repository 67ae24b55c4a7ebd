/* test_draw_wires.c -- tests the position that is computed from the lengths of three draw wires,
 * and the rejection of impossible lengths. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/draw_wires.h"
#include "core/base/rng.h"

/* Positions of the three wire spools above the tank, as in poi.conf. */
static const vec3 mounts_m[3] = { { -0.45f, 0.75f, -0.30f },
                                  { 0.45f, 0.75f, -0.30f },
                                  { 0.0f, 0.75f, 0.35f } };

static float drawn(uint32_t n, uint32_t what, float low, float high)
{
    return rng_range((struct rng_key){ 11, n, what, RNG_TEST }, low, high);
}

/* Returns the random position number `n` within the space that a poi can reach: up to 10 cm beyond
 * the tank's walls, and from the floor to 30 cm above the water. */
static vec3 place_m(uint32_t n)
{
    return v3(drawn(n, 0, -0.525f, 0.525f), drawn(n, 1, -0.12f, 0.30f),
              drawn(n, 2, -0.375f, 0.375f));
}

static void test_the_position_follows_from_the_wire_lengths(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 5000; n++) {
        const vec3 eye_m = place_m(n);
        float length_m[3];
        vec3 found_m;
        draw_wires_lengths(mounts_m, eye_m, length_m);
        assert_int_equal(draw_wires_meet(mounts_m, length_m, &found_m), DRAW_WIRES_OK);
        assert_true(v3_length(v3_sub(found_m, eye_m)) < 1e-5f);
    }
}

static void test_spools_at_any_heights_and_in_any_order_give_the_position(void **state)
{
    (void)state;
    const vec3 a_m = { 0.1f, 0.9f, 0.4f }, b_m = { -0.5f, 0.7f, 0.0f }, c_m = { 0.4f, 0.6f, -0.3f };
    const vec3 odd_m[2][3] = { { a_m, b_m, c_m }, { c_m, a_m, b_m } };
    for (uint32_t k = 0; k < 2; k++) {
        assert_true(draw_wires_is_determined(odd_m[k]));
        const vec3 eye_m = { 0.05f, -0.03f, -0.02f };
        float length_m[3];
        vec3 found_m;
        draw_wires_lengths(odd_m[k], eye_m, length_m);
        assert_int_equal(draw_wires_meet(odd_m[k], length_m, &found_m), DRAW_WIRES_OK);
        assert_true(v3_length(v3_sub(found_m, eye_m)) < 1e-5f);
    }
}

static void test_one_converter_count_moves_the_position_by_about_1_mm(void **state)
{
    (void)state;
    float worst_m = 0.0f;
    for (uint32_t n = 0; n < 5000; n++) {
        const vec3 eye_m = place_m(n);
        float length_m[3];
        vec3 found_m;
        draw_wires_lengths(mounts_m, eye_m, length_m);
        for (uint32_t i = 0; i < 3; i++) {
            length_m[i] += drawn(n, 3 + i, -1.0f, 1.0f) < 0.0f ? -0.000244f : 0.000244f;
        }
        assert_int_equal(draw_wires_meet(mounts_m, length_m, &found_m), DRAW_WIRES_OK);
        worst_m = f_max(worst_m, v3_length(v3_sub(found_m, eye_m)));
    }
    print_message("# a step of 0.244 mm on each wire: at worst %.2f mm\n",
                  (double)(worst_m * 1000.0f));
    assert_true(worst_m < 0.0012f);
}

static void test_impossible_lengths_are_rejected_and_the_position_is_kept(void **state)
{
    (void)state;
    const float nan = __builtin_nanf("");
    const struct bad {
        float length_m[3];
        enum draw_wires_result result;
    } bad[] = {
        { { nan, 0.8f, 0.8f }, DRAW_WIRES_LENGTH },
        { { 0.8f, 0.0f, 0.8f }, DRAW_WIRES_LENGTH },
        { { 0.8f, 0.8f, -0.1f }, DRAW_WIRES_LENGTH },
        { { 0.8f, 0.8f, 3.0f }, DRAW_WIRES_LENGTH },
        /* These two spools are 90 cm apart, so their wires of 30 cm cannot meet. */
        { { 0.30f, 0.30f, 0.8f }, DRAW_WIRES_APART },
        { { 0.40f, 0.40f, 0.40f }, DRAW_WIRES_APART },
        /* With these lengths, the poi would be 5 cm below the spools, which is too high for a
         * poi. */
        { { 0.5431f, 0.5431f, 0.3536f }, DRAW_WIRES_HIGH },
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        vec3 kept_m = { 7, 7, 7 };
        assert_int_equal(draw_wires_meet(mounts_m, bad[i].length_m, &kept_m), bad[i].result);
        assert_float_equal(kept_m.x + kept_m.y + kept_m.z, 21.0f, 0.0f);
        assert_true(strlen(draw_wires_text(bad[i].result)) > 10);
    }
}

static void test_collinear_or_upright_spools_are_rejected(void **state)
{
    (void)state;
    const vec3 row_m[3] = { { -0.4f, 0.7f, 0 }, { 0, 0.7f, 0.01f }, { 0.4f, 0.7f, 0 } };
    const vec3 wall_m[3] = { { -0.4f, 0.2f, 0 }, { 0.4f, 0.2f, 0 }, { 0, 0.9f, 0 } };
    const vec3 twins_m[3] = { { -0.4f, 0.7f, 0 }, { -0.4f, 0.7f, 0 }, { 0, 0.7f, 0.4f } };
    assert_true(draw_wires_is_determined(mounts_m));
    assert_false(draw_wires_is_determined(row_m));
    assert_false(draw_wires_is_determined(wall_m));
    assert_false(draw_wires_is_determined(twins_m));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_position_follows_from_the_wire_lengths),
        cmocka_unit_test(test_spools_at_any_heights_and_in_any_order_give_the_position),
        cmocka_unit_test(test_one_converter_count_moves_the_position_by_about_1_mm),
        cmocka_unit_test(test_impossible_lengths_are_rejected_and_the_position_is_kept),
        cmocka_unit_test(test_collinear_or_upright_spools_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
