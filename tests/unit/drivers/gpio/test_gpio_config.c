/* test_gpio_config.c -- Tests the parser of the GPIO wiring options and its error messages. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_config.h"

static char why[HAL_TEXT_SIZE];

static void test_a_named_button_line_is_active_low_with_a_pull_up(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(gpio_wire_read("start=BTN_START", wires, why));
    const struct gpio_wire *wire = &wires[GPIO_START];
    assert_int_equal(wire->wired, 1);
    assert_string_equal(wire->name, "BTN_START");
    assert_string_equal(wire->chip, "");
    assert_int_equal(wire->active_low, 1);
    assert_int_equal(wire->bias, GPIO_BIAS_UP);
    assert_int_equal(wire->debounce_us, 5000);
    assert_int_equal(gpio_config_count(wires), 1);
}

static void test_a_line_by_chip_and_offset_accepts_every_option(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(
        gpio_wire_read("Coin=pci:a:17,high,float,debounce=500us,window=20ms-1s", wires, why));
    const struct gpio_wire *wire = &wires[GPIO_COIN];
    assert_string_equal(wire->name, "");
    assert_string_equal(wire->chip, "pci:a");
    assert_int_equal(wire->offset, 17);
    assert_int_equal(wire->active_low, 0);
    assert_int_equal(wire->bias, GPIO_BIAS_OFF);
    assert_int_equal(wire->debounce_us, 500);
    assert_int_equal(wire->pulse_min_us, 20000);
    assert_int_equal(wire->pulse_max_us, 1000000);
}

static void test_an_output_is_active_high_and_keeps_its_bias(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(gpio_wire_read("COIN_COUNTER=METER,pulse=50ms/150ms", wires, why));
    const struct gpio_wire *wire = &wires[GPIO_COIN_COUNTER];
    assert_int_equal(wire->active_low, 0);
    assert_int_equal(wire->bias, GPIO_BIAS_AS_IS);
    assert_int_equal(wire->pulse_on_us, 50000);
    assert_int_equal(wire->pulse_off_us, 150000);
}

static void test_an_undriven_coin_lockout_blocks_coins(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(gpio_wire_read("coin-lockout=LOCK", wires, why));
    assert_int_equal(wires[GPIO_COIN_LOCKOUT].active_low, 1);
    assert_int_equal(wires[GPIO_COIN_LOCKOUT].bias, GPIO_BIAS_DOWN);
    assert_true(gpio_wire_read("coin-lockout=LOCK,high", wires, why));
    assert_int_equal(wires[GPIO_COIN_LOCKOUT].active_low, 0);
    assert_int_equal(wires[GPIO_COIN_LOCKOUT].bias, GPIO_BIAS_UP);
    assert_true(gpio_wire_read("coin-lockout=LOCK,float", wires, why));
    assert_int_equal(wires[GPIO_COIN_LOCKOUT].bias, GPIO_BIAS_OFF);
}

static void test_a_later_wire_replaces_an_earlier_one_of_the_same_role(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(gpio_wire_read("ok=A:3,debounce=9ms", wires, why));
    assert_true(gpio_wire_read("ok=B", wires, why));
    assert_string_equal(wires[GPIO_OK].name, "B");
    assert_string_equal(wires[GPIO_OK].chip, "");
    assert_int_equal(wires[GPIO_OK].offset, 0);
    assert_int_equal(wires[GPIO_OK].debounce_us, 5000);
}

static void test_an_invalid_wire_gives_a_message_and_changes_nothing(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reason;
    } wrong[] = {
        { "", "ROLE=LINE" },
        { "start", "ROLE=LINE" },
        { "star=A", "'star' is not a role" },
        { "startx=A", "'startx' is not a role" },
        { "=A", "'' is not a role" },
        { "start=", "start: a line's name" },
        { "start=:4", "start: a line's name" },
        { "start=12345678901234567890123456789012", "start: a line's name" },
        { "start=A,lo", "'lo' is none of" },
        { "start=A,,low", "'' is none of" },
        { "start=A,debounce=5", "'debounce=5': a time of 1us" },
        { "start=A,debounce=0ms", "'debounce=0ms': a time of 1us" },
        { "start=A,debounce=11s", "'debounce=11s': a time of 1us" },
        { "start=A,debounce=4294967297us", "a time of 1us to 10s is" },
        { "start=A,window=20ms-90ms", "'window=20ms-90ms' is none of" },
        { "start=A,pulse=1ms/1ms", "'pulse=1ms/1ms' is none of" },
        { "ticket=A,debounce=1ms", "'debounce=1ms' is none of" },
        { "coin=A,window=90ms-20ms", "'window=90ms-20ms': a window is" },
        { "coin=A,window=20ms-20ms", "'window=20ms-20ms': a window is" },
        { "coin=A,window=20ms", "'window=20ms': a window is" },
    };
    struct gpio_wire wires[GPIO_ROLE_COUNT], before[GPIO_ROLE_COUNT];
    memset(wires, 7, sizeof wires);
    memcpy(before, wires, sizeof before);
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        memset(why, 0, sizeof why);
        assert_false(gpio_wire_read(wrong[i].text, wires, why));
        if (!strstr(why, wrong[i].reason)) {
            fail_msg("'%s' gave '%s'", wrong[i].text, why);
        }
        assert_memory_equal(wires, before, sizeof before);
    }
}

static void test_a_name_with_a_colon_but_no_number_is_a_line_name(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(gpio_wire_read("door=SODIMM:X5", wires, why));
    assert_string_equal(wires[GPIO_DOOR].name, "SODIMM:X5");
    assert_int_equal(wires[GPIO_DOOR].offset, 0);
}

static void test_two_roles_on_one_line_are_reported(void **state)
{
    (void)state;
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    assert_true(gpio_wire_read("left=sim:4", wires, why));
    assert_true(gpio_wire_read("right=sim:5", wires, why));
    assert_true(gpio_config_agrees(wires, why));
    assert_true(gpio_wire_read("ticket=sim:5", wires, why));
    assert_false(gpio_config_agrees(wires, why));
    assert_string_equal(why, "right and ticket are both on sim:5: one line, one role");
}

static void test_every_role_is_found_by_its_name(void **state)
{
    (void)state;
    for (enum gpio_role role = 0; role < GPIO_ROLE_COUNT; role++) {
        const char *name = gpio_role_name(role);
        assert_true(strlen(name) > 0);
        assert_int_equal(gpio_role_find(name, strlen(name)), role);
        assert_int_not_equal(gpio_role_find(name, strlen(name) - 1u), role);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_named_button_line_is_active_low_with_a_pull_up),
        cmocka_unit_test(test_a_line_by_chip_and_offset_accepts_every_option),
        cmocka_unit_test(test_an_output_is_active_high_and_keeps_its_bias),
        cmocka_unit_test(test_an_undriven_coin_lockout_blocks_coins),
        cmocka_unit_test(test_a_later_wire_replaces_an_earlier_one_of_the_same_role),
        cmocka_unit_test(test_an_invalid_wire_gives_a_message_and_changes_nothing),
        cmocka_unit_test(test_a_name_with_a_colon_but_no_number_is_a_line_name),
        cmocka_unit_test(test_two_roles_on_one_line_are_reported),
        cmocka_unit_test(test_every_role_is_found_by_its_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
