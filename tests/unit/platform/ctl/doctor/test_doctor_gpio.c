/* test_doctor_gpio.c -- Tests what `kingyoctl doctor` reports about a configured GPIO line. This
 * command checks the installation of a kiosk. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_config.h"
#include "platform/ctl/doctor/doctor.h"

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

static void test_a_free_line_is_ok_and_found_on_its_chip(void **state)
{
    (void)state;
    const struct doctor_finding *finding = ask("ok=pinctrl-bcm2711:17");
    assert_int_equal(finding->level, DOCTOR_FINE);
    assert_string_equal(finding->state, "on pinctrl-bcm2711, line 17, free");
    assert_string_equal(finding->todo, "");
}

static void test_a_line_used_by_a_driver_is_an_error_that_names_the_driver(void **state)
{
    (void)state;
    const struct doctor_finding *finding = ask("coin=COIN");
    assert_int_equal(finding->level, DOCTOR_WRONG);
    assert_string_equal(finding->what, "coin on COIN");
    assert_string_equal(finding->state, "held by 'gpio-keys'");
    assert_non_null(strstr(finding->todo, "remove the overlay"));
}

static void test_a_line_used_by_the_kiosk_is_ok(void **state)
{
    (void)state;
    assert_int_equal(ask("start-lamp=LAMP")->level, DOCTOR_FINE);
    assert_non_null(strstr(doctor.finding[0].state, "held by the running kiosk"));
}

static void test_an_ambiguous_line_name_is_an_error_that_suggests_the_chip(void **state)
{
    (void)state;
    const struct doctor_finding *finding = ask("start=BTN_START");
    assert_int_equal(finding->level, DOCTOR_WRONG);
    assert_string_equal(finding->state, "2 lines have this name");
    assert_string_equal(finding->todo, "use the chip and the offset: pinctrl-bcm2711:17");
}

static void test_chips_with_equal_labels_are_distinguished_by_name(void **state)
{
    (void)state;
    memcpy(census.line[2].chip, "pinctrl-bcm2711", sizeof "pinctrl-bcm2711");
    census.line[2].offset = 17;
    const struct doctor_finding *finding = ask("ok=pinctrl-bcm2711:17");
    assert_int_equal(finding->level, DOCTOR_WRONG);
    assert_string_equal(finding->state, "2 chips have this label");
    assert_non_null(strstr(finding->todo, "the name of the line"));
}

static void test_a_line_on_no_chip_is_an_error(void **state)
{
    (void)state;
    assert_int_equal(ask("door=DOOR")->level, DOCTOR_WRONG);
    assert_int_equal(ask("door=pinctrl-bcm2711:18")->level, DOCTOR_WRONG);
    assert_int_equal(ask("door=gpio-sim.1:4")->level, DOCTOR_WRONG);
}

static void test_findings_beyond_the_buffer_are_counted_only(void **state)
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
        cmocka_unit_test_setup(test_a_free_line_is_ok_and_found_on_its_chip, two_chips),
        cmocka_unit_test_setup(test_a_line_used_by_a_driver_is_an_error_that_names_the_driver,
                               two_chips),
        cmocka_unit_test_setup(test_a_line_used_by_the_kiosk_is_ok, two_chips),
        cmocka_unit_test_setup(test_chips_with_equal_labels_are_distinguished_by_name, two_chips),
        cmocka_unit_test_setup(test_an_ambiguous_line_name_is_an_error_that_suggests_the_chip,
                               two_chips),
        cmocka_unit_test_setup(test_a_line_on_no_chip_is_an_error, two_chips),
        cmocka_unit_test_setup(test_findings_beyond_the_buffer_are_counted_only, two_chips),
    };
    return cmocka_run_group_tests_name("doctor_gpio", tests, NULL, NULL);
}
