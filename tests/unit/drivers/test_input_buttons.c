/* test_input_buttons.c -- tests the multiplexer that combines several button panels (keyboard,
 * GPIO) into one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/input_mux.h"
#include "drivers/null.h"

struct panel {
    struct button_sample sample;
    int result;
    const char *line;
    uint32_t asked;
};

static int panel_poll(void *self, struct button_sample *out)
{
    struct panel *panel = self;
    panel->asked++;
    *out = panel->sample;
    return panel->result;
}

static const char *panel_describe(void *self)
{
    const struct panel *panel = self;
    return panel->line;
}

static struct hal_buttons device_of(struct panel *panel)
{
    static const struct hal_buttons_ops ops = { .poll = panel_poll, .describe = panel_describe };
    return (struct hal_buttons){ .ops = &ops, .self = panel };
}

static int poll_join(struct input_buttons *join, struct button_sample *out)
{
    const struct hal_buttons device = input_buttons_device(join);
    return device.ops->poll(device.self, out);
}

static void test_input_of_any_panel_is_reported(void **state)
{
    (void)state;
    struct input_buttons join = { 0 };
    struct button_sample sum;
    struct panel keys = {
        .sample = { .held = INPUT_START,
                    .pressed = INPUT_START,
                    .raw = 1u << 2,
                    .missing = INPUT_TILT,
                    .quit = 1,
                    .coin_count[0] = 1 },
    };
    struct panel lines = {
        .sample = { .held = INPUT_LEFT,
                    .pressed = INPUT_OK,
                    .raw = 1u << 9,
                    .missing = HAL_MISSING_COIN,
                    .coin_count[0] = 2,
                    .faults = 3,
                    .full_screen = 1 },
    };
    input_buttons_add(&join, device_of(&keys));
    input_buttons_add(&join, device_of(&lines));
    assert_int_equal(poll_join(&join, &sum), HAL_OK);
    assert_int_equal(sum.held, INPUT_START | INPUT_LEFT);
    assert_int_equal(sum.pressed, INPUT_START | INPUT_OK);
    assert_int_equal(sum.raw, 1u << 2 | 1u << 9);
    assert_int_equal(sum.missing, INPUT_TILT | HAL_MISSING_COIN);
    assert_int_equal(sum.coin_count[0], 3);
    assert_int_equal(sum.faults, 3);
    assert_int_equal(sum.quit, 1);
    assert_int_equal(sum.full_screen, 1);
}

/* A button that is released on one panel may still be held on another. The button must then stay
 * held. */
static void test_a_button_is_held_while_any_panel_holds_it(void **state)
{
    (void)state;
    struct input_buttons join = { 0 };
    struct button_sample sum;
    struct panel left = { .sample.held = INPUT_OK };
    struct panel right = { .sample.held = INPUT_OK };
    input_buttons_add(&join, device_of(&left));
    input_buttons_add(&join, device_of(&right));
    left.sample.held = 0;
    poll_join(&join, &sum);
    assert_int_equal(sum.held, INPUT_OK);
    right.sample.held = 0;
    poll_join(&join, &sum);
    assert_int_equal(sum.held, 0);
}

static void test_an_absent_panel_is_no_fault(void **state)
{
    (void)state;
    struct input_buttons join = { 0 };
    struct button_sample sum;
    struct panel keys = { .sample.pressed = INPUT_TEST, .line = "keys" };
    assert_int_equal(poll_join(&join, &sum), HAL_ERR_ABSENT);
    input_buttons_add(&join, null_hal("no lines").buttons);
    assert_int_equal(poll_join(&join, &sum), HAL_ERR_ABSENT);
    input_buttons_add(&join, device_of(&keys));
    assert_int_equal(poll_join(&join, &sum), HAL_OK);
    assert_int_equal(sum.pressed, INPUT_TEST);
}

/* A panel that fails must not hide the events of the other panels, but its faults must be
 * reported. */
static void test_a_failed_panel_does_not_affect_the_others(void **state)
{
    (void)state;
    struct input_buttons join = { 0 };
    struct button_sample sum;
    struct panel broken = { .result = HAL_ERR_IO, .sample.faults = 1 };
    struct panel keys = { .sample.pressed = INPUT_TEST };
    input_buttons_add(&join, device_of(&broken));
    input_buttons_add(&join, device_of(&keys));
    assert_int_equal(poll_join(&join, &sum), HAL_OK);
    assert_int_equal(sum.pressed, INPUT_TEST);
    assert_int_equal(sum.faults, 1);
}

static void test_the_description_names_every_panel_and_is_truncated(void **state)
{
    (void)state;
    char long_line[HAL_TEXT_SIZE];
    struct input_buttons join = { 0 };
    struct panel keys = { .line = "keys" };
    struct panel silent = { .line = "" };
    struct panel lines = { .line = "5 lines" };
    struct panel talker = { .line = long_line };
    memset(long_line, 'x', sizeof long_line);
    long_line[sizeof long_line - 1] = '\0';
    const struct hal_buttons device = input_buttons_device(&join);
    input_buttons_add(&join, device_of(&keys));
    input_buttons_add(&join, device_of(&silent));
    input_buttons_add(&join, device_of(&lines));
    assert_string_equal(device.ops->describe(device.self), "keys; 5 lines");
    input_buttons_add(&join, device_of(&lines));
    /* Two consecutive panels have the same description, so the multiplexer lists this text only
     * once. */
    assert_string_equal(device.ops->describe(device.self), "keys; 5 lines");
    for (uint32_t i = 0; i < 4; i++) {
        input_buttons_add(&join, device_of(&talker));
        input_buttons_add(&join, device_of(&keys));
    }
    assert_int_equal(strlen(device.ops->describe(device.self)), sizeof join.text - 1);
}

static void test_a_panel_beyond_the_maximum_is_rejected_and_never_polled(void **state)
{
    (void)state;
    struct input_buttons join = { 0 };
    struct button_sample sum;
    struct panel panel = { .sample.coin_count[0] = 1 };
    for (uint32_t i = 0; i < INPUT_BUTTONS_MAX; i++) {
        assert_int_equal(input_buttons_add(&join, device_of(&panel)), 0);
    }
    assert_int_equal(input_buttons_add(&join, device_of(&panel)), -1);
    poll_join(&join, &sum);
    assert_int_equal(panel.asked, INPUT_BUTTONS_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_input_of_any_panel_is_reported),
        cmocka_unit_test(test_a_button_is_held_while_any_panel_holds_it),
        cmocka_unit_test(test_an_absent_panel_is_no_fault),
        cmocka_unit_test(test_a_failed_panel_does_not_affect_the_others),
        cmocka_unit_test(test_the_description_names_every_panel_and_is_truncated),
        cmocka_unit_test(test_a_panel_beyond_the_maximum_is_rejected_and_never_polled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
