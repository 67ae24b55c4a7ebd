/* test_doctor_gpio.c -- what the doctor says of a wired line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_config.h"
#include "platform/ctl/doctor/doctor_gpio.h"

static struct doctor doctor;
static struct gpio_census census;

static const struct doctor_finding *ask(const char *text)
{
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE] = "";
    assert_true(gpio_wire_read(text, wires, why));
    doctor.count = 0;
    for (uint32_t role = 0; role < GPIO_ROLE_COUNT; role++) {
        if (wires[role].wired) {
            doctor_gpio_wire(&doctor, (enum gpio_role)role, &wires[role], &census);
        }
    }
    assert_int_equal(doctor.count, 1);
    return &doctor.finding[0];
}

static int two_chips(void **state)
{
    (void)state;
    census = (struct gpio_census){
        .count = 4,
        .line = {
            { .chip = "pinctrl-bcm2711", .name = "BTN_START", .offset = 17 },
            { .chip = "pinctrl-bcm2711", .name = "COIN", .offset = 27, .is_used = true,
              .consumer = "gpio-keys" },
            { .chip = "gpio-sim.0", .name = "LAMP", .offset = 3, .is_used = true,
              .consumer = "kingyo" },
            { .chip = "gpio-sim.0", .name = "BTN_START", .offset = 4 },
        },
    };
    return 0;
}

static void test_a_free_line_is_fine_and_found_on_its_chip(void **state)
{
    (void)state;
    const struct doctor_finding *finding = ask("ok=pinctrl-bcm2711:17");
    assert_int_equal(finding->level, DOCTOR_FINE);
    assert_string_equal(finding->state, "on pinctrl-bcm2711, line 17, free");
    assert_string_equal(finding->todo, "");
}

static void test_a_line_that_a_driver_holds_is_wrong_and_says_who(void **state)
{
    (void)state;
    const struct doctor_finding *finding = ask("coin=COIN");
    assert_int_equal(finding->level, DOCTOR_WRONG);
    assert_string_equal(finding->what, "coin on COIN");
    assert_string_equal(finding->state, "held by 'gpio-keys'");
    assert_non_null(strstr(finding->todo, "remove the overlay"));
}

static void test_a_line_that_the_kiosk_itself_holds_is_fine(void **state)
{
    (void)state;
    assert_int_equal(ask("start-lamp=LAMP")->level, DOCTOR_FINE);
    assert_non_null(strstr(doctor.finding[0].state, "held by the running kiosk"));
}

static void test_a_name_on_two_lines_is_wrong_and_the_chip_is_offered(void **state)
{
    (void)state;
    const struct doctor_finding *finding = ask("start=BTN_START");
    assert_int_equal(finding->level, DOCTOR_WRONG);
    assert_string_equal(finding->state, "2 lines are called so");
    assert_string_equal(finding->todo, "name it by its chip: pinctrl-bcm2711:17");
}

static void test_two_chips_of_one_label_are_told_apart_by_names_alone(void **state)
{
    (void)state;
    memcpy(census.line[2].chip, "pinctrl-bcm2711", sizeof "pinctrl-bcm2711");
    census.line[2].offset = 17;
    const struct doctor_finding *finding = ask("ok=pinctrl-bcm2711:17");
    assert_int_equal(finding->level, DOCTOR_WRONG);
    assert_string_equal(finding->state, "2 chips have that label");
    assert_non_null(strstr(finding->todo, "by its line's name"));
}

static void test_a_line_that_no_chip_has_is_wrong(void **state)
{
    (void)state;
    assert_int_equal(ask("door=DOOR")->level, DOCTOR_WRONG);
    assert_int_equal(ask("door=pinctrl-bcm2711:18")->level, DOCTOR_WRONG);
    assert_int_equal(ask("door=gpio-sim.1:4")->level, DOCTOR_WRONG);
}

static void test_findings_beyond_the_room_are_counted_and_change_nothing(void **state)
{
    (void)state;
    doctor.count = DOCTOR_FINDINGS_MAX - 1u;
    doctor.more = 0;
    doctor_state(doctor_find(&doctor, "usb", DOCTOR_FINE, "the last"), "there");
    doctor_state(doctor_find(&doctor, "usb", DOCTOR_WRONG, "one more"), "not there");
    assert_int_equal(doctor.count, DOCTOR_FINDINGS_MAX);
    assert_int_equal(doctor.more, 1);
    assert_string_equal(doctor.finding[DOCTOR_FINDINGS_MAX - 1u].what, "the last");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_a_free_line_is_fine_and_found_on_its_chip, two_chips),
        cmocka_unit_test_setup(test_a_line_that_a_driver_holds_is_wrong_and_says_who, two_chips),
        cmocka_unit_test_setup(test_a_line_that_the_kiosk_itself_holds_is_fine, two_chips),
        cmocka_unit_test_setup(test_two_chips_of_one_label_are_told_apart_by_names_alone,
                               two_chips),
        cmocka_unit_test_setup(test_a_name_on_two_lines_is_wrong_and_the_chip_is_offered,
                               two_chips),
        cmocka_unit_test_setup(test_a_line_that_no_chip_has_is_wrong, two_chips),
        cmocka_unit_test_setup(test_findings_beyond_the_room_are_counted_and_change_nothing,
                               two_chips),
    };
    return cmocka_run_group_tests_name("doctor_gpio", tests, NULL, NULL);
}
