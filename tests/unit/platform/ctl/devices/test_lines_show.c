/* test_lines_show.c -- Tests the output of the command `kingyoctl lines` with simulated GPIO
 * lines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_config.h"
#include "drivers/sim/gpio_lines_sim.h"
#include "platform/ctl/devices/lines.h"

#define MS 1000000ull
#define LEVEL(ms, which, level) { .time_ns = (ms) * MS, .role = (which), .active = (level) }

static struct gpio_lines_sim sim;
static struct gpio_thread gpio;

/* Simulates the GPIO lines until `time_ms`. Returns the output of the command `kingyoctl lines`,
 * which the caller must free. */
static char *shown(const struct gpio_sim_event *events, uint32_t count, uint64_t time_ms)
{
    struct gpio_sim_events script = { .events = events, .count = count };
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE], *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_true(gpio_wire_read("start=S", wires, why));
    assert_true(gpio_wire_read("coin=C", wires, why));
    gpio_lines_sim_init(&sim, gpio_lines_sim_events_script(&script), 1);
    gpio_thread_open(&gpio, gpio_lines_sim_device(&sim), wires, gpio_lines_sim_clock(&sim));
    struct lines_show show = lines_show_begin(&gpio);
    while (sim.now_ns < time_ms * MS) {
        gpio_thread_step(&gpio);
        lines_show_rows(&show, out);
    }
    gpio_thread_close(&gpio);
    fclose(out);
    return text;
}

static void test_each_accepted_press_and_coin_has_a_row(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_START, 1), LEVEL(300, GPIO_START, 0), LEVEL(400, GPIO_COIN, 1),
        LEVEL(448, GPIO_COIN, 0),  LEVEL(600, GPIO_COIN, 1),  LEVEL(608, GPIO_COIN, 0),
    };
    char *text = shown(events, 6, 900);
    assert_string_equal(text, "0.105\tstart\tpressed\n"
                              "0.305\tstart\treleased\n"
                              "0.458\tcoin\tcoin 1, its pulse 48.0 ms\n"
                              "0.618\tcoin\tpulses too short for a coin: 1 so far\n");
    free(text);
}

static void test_jams_and_removed_chips_are_reported(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(900, GPIO_COIN, 0),
        LEVEL(1000, GPIO_COIN, 1),
        { .time_ns = 1030 * MS, .what = GPIO_SIM_GONE },
    };
    char *text = shown(events, 4, 1500);
    assert_string_equal(text, "0.351\tcoin\tcoins stuck in the slot: 1 so far\n"
                              "1.030\tcoin\tpulses cut off because the line was removed: 1 so far\n"
                              "1.030\t-\tchips removed: 1 so far\n");
    free(text);
}

static void test_a_coin_has_its_own_width_although_the_next_one_has_begun(void **state)
{
    (void)state;
    static const struct gpio_sim_event events[] = {
        LEVEL(100, GPIO_COIN, 1),
        LEVEL(148, GPIO_COIN, 0),
        LEVEL(180, GPIO_COIN, 1),
        LEVEL(205, GPIO_COIN, 0),
    };
    struct gpio_sim_events script = { .events = events, .count = 4 };
    struct gpio_wire wires[GPIO_ROLE_COUNT] = { 0 };
    char why[HAL_TEXT_SIZE], *text = NULL;
    size_t size = 0;
    assert_true(gpio_wire_read("coin=C", wires, why));
    gpio_lines_sim_init(&sim, gpio_lines_sim_events_script(&script), 1);
    gpio_thread_open(&gpio, gpio_lines_sim_device(&sim), wires, gpio_lines_sim_clock(&sim));
    struct lines_show show = lines_show_begin(&gpio);
    gpio_lines_sim_pass(&sim, 190 * MS);
    gpio_thread_step(&gpio);
    FILE *out = open_memstream(&text, &size);
    lines_show_rows(&show, out);
    fclose(out);
    assert_string_equal(text, "0.190\tcoin\tcoin 1, its pulse 48.0 ms\n");
    gpio_thread_close(&gpio);
    free(text);
}

static void test_every_line_has_a_row_with_its_consumer(void **state)
{
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    gpio_lines_sim_init(&sim, (struct gpio_sim_script){ 0 }, 1);
    sim.held_by_others = 1u << GPIO_OK;
    assert_int_equal(lines_list(gpio_lines_sim_device(&sim), out), EXIT_OK);
    fclose(out);
    assert_non_null(strstr(text, "device\tchip\toffset\tname\tdirection\tactive\theld_by\n"));
    assert_non_null(strstr(text, "gpiochip0\tmemory\t3\t-\tin\thigh\tanother\n"));
    assert_non_null(strstr(text, "gpiochip0\tmemory\t12\t-\tout\thigh\t-\n"));
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_accepted_press_and_coin_has_a_row),
        cmocka_unit_test(test_jams_and_removed_chips_are_reported),
        cmocka_unit_test(test_a_coin_has_its_own_width_although_the_next_one_has_begun),
        cmocka_unit_test(test_every_line_has_a_row_with_its_consumer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
