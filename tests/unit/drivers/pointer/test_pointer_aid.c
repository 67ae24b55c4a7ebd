/* test_pointer_aid.c -- checks the options for players who cannot hold a button or reach high. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "drivers/pointer/pointer_poi.h"
#include "tests/unit/support/pointer.h"

/* Returns true if the ring is down after a report with the dip button pressed or released. */
static bool is_down(struct pointer_aid *aid, bool scoops, bool pressed)
{
    struct pointer_report seen = report(10, 640.0f, 360.0f, POINTER_LEVEL);
    seen.buttons |= pressed ? (uint32_t)POINTER_DIP : 0u;
    pointer_aid_apply(aid, scoops, &seen);
    assert_true(seen.buttons & POINTER_LEVEL); /* The other buttons are unchanged. */
    return (seen.buttons & POINTER_DIP) != 0;
}

static void test_without_options_a_report_is_unchanged(void **state)
{
    (void)state;
    struct pointer_aid aid = { 0 };
    struct pointer_report seen = report(10, 100.0f, 50.0f, 0);
    pointer_aid_apply(&aid, true, &seen);
    assert_float_equal(seen.y_px, 50.0f, 0.0f);
    assert_true(is_down(&aid, true, true));
    assert_false(is_down(&aid, true, false));
}

static void test_one_click_dips_and_the_next_lifts(void **state)
{
    (void)state;
    struct pointer_aid aid = { .clicks = true };
    assert_true(is_down(&aid, true, true));
    assert_true(is_down(&aid, true, true)); /* The button is held, which changes nothing. */
    assert_true(is_down(&aid, true, false));
    assert_false(is_down(&aid, true, true));
    assert_false(is_down(&aid, true, false));
    assert_true(is_down(&aid, true, true));
}

static void test_a_page_with_buttons_is_pressed_as_long_as_the_button(void **state)
{
    (void)state;
    struct pointer_aid aid = { .clicks = true };
    assert_true(is_down(&aid, true, true));
    assert_true(is_down(&aid, true, false));
    assert_false(is_down(&aid, false, false)); /* The page lifts the ring. */
    assert_true(is_down(&aid, false, true));
    assert_false(is_down(&aid, false, false));
    assert_true(is_down(&aid, true, true)); /* The first click of a round dips. */
}

static void test_a_press_on_a_page_does_not_lower_the_ring_in_the_round(void **state)
{
    (void)state;
    struct pointer_aid aid = { .clicks = true };
    assert_true(is_down(&aid, false, true)); /* The press chooses a tag, and the page closes. */
    pointer_aid_raise(&aid);
    assert_false(is_down(&aid, true, true)); /* The button is still held. */
    assert_false(is_down(&aid, true, false));
    assert_true(is_down(&aid, true, true)); /* The first click of the round dips. */
}

static void test_the_lower_part_of_the_picture_reaches_the_whole_picture(void **state)
{
    (void)state;
    struct pointer_aid aid = { .reach_percent = 50u };
    static const float from[] = { 1.0f, 0.75f, 0.5f, 0.25f };
    static const float to[] = { 1.0f, 0.5f, 0.0f, -0.5f }; /* The decoder limits the last one. */
    for (uint32_t i = 0; i < 4u; i++) {
        struct pointer_report seen = report(10, 100.0f, from[i] * (float)HEIGHT, 0);
        pointer_aid_apply(&aid, true, &seen);
        assert_float_equal(seen.y_px, to[i] * (float)HEIGHT, 1e-3f);
        assert_float_equal(seen.x_px, 100.0f, 0.0f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_without_options_a_report_is_unchanged),
        cmocka_unit_test(test_one_click_dips_and_the_next_lifts),
        cmocka_unit_test(test_a_page_with_buttons_is_pressed_as_long_as_the_button),
        cmocka_unit_test(test_a_press_on_a_page_does_not_lower_the_ring_in_the_round),
        cmocka_unit_test(test_the_lower_part_of_the_picture_reaches_the_whole_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
