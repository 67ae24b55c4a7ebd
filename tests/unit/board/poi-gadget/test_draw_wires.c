/* test_draw_wires.c -- three lengths into a point and back, and lengths that are of no point. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/draw_wires.h"
#include "core/base/rng.h"

/* Over the festival tank, as poi.conf hangs them. */
static const vec3 stall_m[3] = { { -0.45f, 0.75f, -0.30f },
                                 { 0.45f, 0.75f, -0.30f },
                                 { 0.0f, 0.75f, 0.35f } };

static float drawn(uint32_t n, uint32_t what, float low, float high)
{
    return rng_range((struct rng_key){ 11, n, what, RNG_TEST }, low, high);
}

/* Wherever a hand plays: beyond the walls by 10 cm, from the floor to 30 cm over the water. */
static vec3 place_m(uint32_t n)
{
    return v3(drawn(n, 0, -0.525f, 0.525f), drawn(n, 1, -0.12f, 0.30f),
              drawn(n, 2, -0.375f, 0.375f));
}

static void test_the_wires_lengths_give_back_the_place(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 5000; n++) {
        const vec3 eye_m = place_m(n);
        float length_m[3];
        vec3 found_m;
        draw_wires_lengths(stall_m, eye_m, length_m);
        assert_int_equal(draw_wires_meet(stall_m, length_m, &found_m), DRAW_WIRES_OK);
        assert_true(v3_length(v3_sub(found_m, eye_m)) < 1e-5f);
    }
}

static void test_spools_that_hang_at_odd_heights_in_any_order_do_as_well(void **state)
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

static void test_a_step_of_a_converter_moves_the_place_by_about_a_millimetre(void **state)
{
    (void)state;
    float worst_m = 0.0f;
    for (uint32_t n = 0; n < 5000; n++) {
        const vec3 eye_m = place_m(n);
        float length_m[3];
        vec3 found_m;
        draw_wires_lengths(stall_m, eye_m, length_m);
        for (uint32_t i = 0; i < 3; i++) {
            length_m[i] += drawn(n, 3 + i, -1.0f, 1.0f) < 0.0f ? -0.000244f : 0.000244f;
        }
        assert_int_equal(draw_wires_meet(stall_m, length_m, &found_m), DRAW_WIRES_OK);
        worst_m = f_max(worst_m, v3_length(v3_sub(found_m, eye_m)));
    }
    print_message("# a step of 0.244 mm on each wire: at worst %.2f mm\n",
                  (double)(worst_m * 1000.0f));
    assert_true(worst_m < 0.0012f);
}

static void test_what_is_no_place_is_refused_and_the_last_place_kept(void **state)
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
        { { 0.30f, 0.30f, 0.8f }, DRAW_WIRES_APART }, /* Two ends 90 cm apart cannot touch. */
        { { 0.40f, 0.40f, 0.40f }, DRAW_WIRES_APART },
        { { 0.5431f, 0.5431f, 0.3536f }, DRAW_WIRES_HIGH }, /* 5 cm under the spools. */
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        vec3 kept_m = { 7, 7, 7 };
        assert_int_equal(draw_wires_meet(stall_m, bad[i].length_m, &kept_m), bad[i].result);
        assert_float_equal(kept_m.x + kept_m.y + kept_m.z, 21.0f, 0.0f);
        assert_true(strlen(draw_wires_text(bad[i].result)) > 10);
    }
}

static void test_spools_in_a_row_or_on_a_wall_cannot_tell(void **state)
{
    (void)state;
    const vec3 row_m[3] = { { -0.4f, 0.7f, 0 }, { 0, 0.7f, 0.01f }, { 0.4f, 0.7f, 0 } };
    const vec3 wall_m[3] = { { -0.4f, 0.2f, 0 }, { 0.4f, 0.2f, 0 }, { 0, 0.9f, 0 } };
    const vec3 twins_m[3] = { { -0.4f, 0.7f, 0 }, { -0.4f, 0.7f, 0 }, { 0, 0.7f, 0.4f } };
    assert_true(draw_wires_is_determined(stall_m));
    assert_false(draw_wires_is_determined(row_m));
    assert_false(draw_wires_is_determined(wall_m));
    assert_false(draw_wires_is_determined(twins_m));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_wires_lengths_give_back_the_place),
        cmocka_unit_test(test_spools_that_hang_at_odd_heights_in_any_order_do_as_well),
        cmocka_unit_test(test_a_step_of_a_converter_moves_the_place_by_about_a_millimetre),
        cmocka_unit_test(test_what_is_no_place_is_refused_and_the_last_place_kept),
        cmocka_unit_test(test_spools_in_a_row_or_on_a_wall_cannot_tell),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
