/* test_gpio_backend.c -- tests the GPIO backend that is linked (gpio_lines1.c or gpio_lines2.c)
 * with a simulated libgpiod. The tests find, request, read, lose and reopen lines. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_config.h"
#include "tests/gpio/fake_board.h"

#define MS 1000000ull

/* Returns true if the backend uses libgpiod 2.x, which numbers the edges and lets the kernel
 * debounce. */
static bool is_second(const struct gpio_lines *lines)
{
    return strstr(lines->ops->describe(lines->self), "libgpiod 2") != NULL;
}

static struct gpio_wire wires[GPIO_ROLE_COUNT];
static char why[GPIO_ROLE_COUNT][HAL_TEXT_SIZE];

static struct gpio_lines fresh(void)
{
    fake_board_reset();
    memset(wires, 0, sizeof wires);
    memset(why, 'x', sizeof why);
    return gpio_lines_device();
}

static void wire(const char *text)
{
    char problem[HAL_TEXT_SIZE];
    assert_true(gpio_wire_read(text, wires, problem));
}

static int request(const struct gpio_lines *lines)
{
    return lines->ops->open(lines->self, wires, why);
}

/* Closes the lines and checks that no handle to a chip stays open. */
static void end(const struct gpio_lines *lines)
{
    lines->ops->close(lines->self);
    for (uint32_t i = 0; i < FAKE_CHIPS; i++) {
        assert_int_equal(fake_chips[i].opened, 0);
        for (uint32_t j = 0; j < FAKE_LINES; j++) {
            assert_false(fake_chips[i].lines[j].requested);
        }
    }
}

static int wait(const struct gpio_lines *lines, struct gpio_edge *edges)
{
    return lines->ops->wait(lines->self, edges, GPIO_EDGES_MAX, 0);
}

static void test_lines_are_found_by_name_or_label_and_requested_as_wired(void **state)
{
    (void)state;
    const struct gpio_lines lines = fresh();
    wire("start=BTN_START,debounce=9ms");
    wire("coin=panel:2,high,float,debounce=7ms");
    wire("start-lamp=LAMP,low");
    assert_int_equal(request(&lines), 1 << GPIO_START | 1 << GPIO_COIN | 1 << GPIO_START_LAMP);
    const struct fake_line *start = &fake_chips[1].lines[0], *coin = &fake_chips[1].lines[2];
    const struct fake_line *lamp = &fake_chips[1].lines[3];
    assert_true(start->requested && coin->requested && lamp->requested);
    assert_true(start->active_low && !coin->active_low && lamp->active_low);
    assert_int_equal(start->bias, GPIO_BIAS_UP);
    assert_int_equal(coin->bias, GPIO_BIAS_OFF);
    assert_true(lamp->is_output && lamp->value == 0);
    assert_int_equal(start->debounce_us, is_second(&lines) ? 9000 : 0);
    assert_int_equal(coin->debounce_us, 0); /* The kernel must not debounce the coin line, because
                                               the driver needs every edge. */
    assert_int_equal(coin->queue_size, is_second(&lines) ? GPIO_EDGES_MAX : 0);
    assert_int_equal(lines.ops->debounces(lines.self, GPIO_START), is_second(&lines));
    assert_int_equal(lines.ops->debounces(lines.self, GPIO_COIN), 0);
    for (uint32_t i = 0; i < GPIO_ROLE_COUNT; i++) {
        assert_string_equal(why[i], "");
    }
    end(&lines);
}

static void test_the_coin_lockout_is_locked_from_its_request_to_its_release(void **state)
{
    (void)state;
    const struct gpio_lines lines = fresh();
    wire("coin-lockout=LAMP");
    wire("ticket=panel:4");
    assert_int_equal(request(&lines), 1 << GPIO_COIN_LOCKOUT | 1 << GPIO_TICKET);
    const struct fake_line *lock = &fake_chips[1].lines[3];
    assert_true(lock->is_output && lock->active_low);
    assert_int_equal(lock->value, 1);
    assert_int_equal(lock->bias, GPIO_BIAS_DOWN);
    assert_int_equal(fake_chips[1].lines[4].value, 0);
    end(&lines);
}

static void test_a_line_cannot_be_selected_by_chip_number(void **state)
{
    (void)state;
    const struct gpio_lines lines = fresh();
    wire("start=gpiochip4:0");
    wire("ok=panel:6"); /* The simulated board has no line 6. */
    assert_int_equal(request(&lines), 0);
    assert_string_equal(why[GPIO_START],
                        "gpiochip4:0: no chip has that line; kingyoctl lines list shows them");
    assert_string_equal(why[GPIO_OK],
                        "panel:6: no chip has that line; kingyoctl lines list shows them");
    end(&lines);
}

static void test_the_cause_of_a_failed_request_is_reported(void **state)
{
    (void)state;
    const struct gpio_lines lines = fresh();
    wire("start=BTN_START");
    wire("coin=COIN");
    wire("door=DOOR");
    wire("ok=soc:0");
    fake_chips[1].lines[0].consumer = "gpio-keys";
    fake_chips[1].lines[2].refuses = EPERM;
    fake_chips[0].lines[0].refuses = ENXIO;
    fake_chips[2].denied = true;
    assert_int_equal(request(&lines), 0);
    assert_string_equal(why[GPIO_START],
                        "BTN_START is in use by 'gpio-keys': stop that program or driver");
    assert_string_equal(why[GPIO_COIN],
                        "COIN may not be used: put the kiosk's user into its group");
    assert_string_equal(why[GPIO_DOOR], "DOOR: /dev/gpiochip11: access denied: put the "
                                        "kiosk's user into its group");
    assert_string_equal(why[GPIO_OK], "soc:0: No such device or address");
    end(&lines);
}

static void test_without_a_chip_the_open_returns_absent(void **state)
{
    (void)state;
    const struct gpio_lines lines = fresh();
    wire("start=BTN_START");
    for (uint32_t i = 0; i < FAKE_CHIPS; i++) {
        fake_chips[i].gone = true;
    }
    assert_int_equal(request(&lines), HAL_ERR_ABSENT);
    assert_string_equal(why[GPIO_START], "BTN_START: there is no GPIO chip in /dev");
    end(&lines);
}

static void test_edges_have_time_stamps_and_are_in_order_for_each_line(void **state)
{
    (void)state;
    struct gpio_edge edges[GPIO_EDGES_MAX];
    const struct gpio_lines lines = fresh();
    wire("start=BTN_START");
    wire("coin=COIN");
    request(&lines);
    assert_int_equal(wait(&lines, edges), 0);
    fake_line_edge(&fake_chips[1].lines[2], 5000000007ull, true, 0);
    fake_line_edge(&fake_chips[1].lines[0], 5100 * MS, true, 0);
    fake_line_edge(&fake_chips[1].lines[2], 5200 * MS, false, 0);
    assert_int_equal(wait(&lines, edges), 3);
    assert_int_equal(edges[0].role, GPIO_START);
    assert_int_equal(edges[0].time_ns, 5100 * MS);
    assert_int_equal(edges[1].role, GPIO_COIN);
    assert_int_equal(edges[1].time_ns, 5000000007ull);
    assert_int_equal(edges[1].active, 1);
    assert_int_equal(edges[2].time_ns, 5200 * MS);
    assert_int_equal(edges[2].active, 0);
    assert_int_equal(edges[0].lost_before + edges[1].lost_before + edges[2].lost_before, 0);
    assert_int_equal(lines.ops->level(lines.self, GPIO_START), 1);
    assert_int_equal(lines.ops->level(lines.self, GPIO_COIN), 0);
    assert_int_equal(wait(&lines, edges), 0);
    end(&lines);
}

static void test_edges_that_the_queue_dropped_are_counted_or_inferred(void **state)
{
    (void)state;
    struct gpio_edge edges[GPIO_EDGES_MAX];
    const struct gpio_lines lines = fresh();
    struct fake_line *start = &fake_chips[1].lines[0];
    wire("start=BTN_START");
    request(&lines);
    /* These 16 edges fill the queue of libgpiod 1.6 completely. The level after the last edge is
     * inactive. */
    for (uint32_t i = 0; i < 16; i++) {
        fake_line_edge(start, (100 + i) * MS, i % 2 == 0, 0);
    }
    assert_int_equal(wait(&lines, edges), 16);
    fake_line_edge(start, 200 * MS, false, 3);
    assert_int_equal(wait(&lines, edges), 1);
    assert_int_equal(edges[0].lost_before, is_second(&lines) ? 3 : 1);
    /* This edge leads to the same level as the edge before it. The backend must not report a lost
     * edge, because such a pair of edges also occurs when the kernel reads the level too late. */
    fake_line_edge(start, 300 * MS, false, 0);
    assert_int_equal(wait(&lines, edges), 1);
    assert_int_equal(edges[0].lost_before, 0);
    end(&lines);
}

static void test_edges_beyond_the_buffer_stay_queued(void **state)
{
    (void)state;
    struct gpio_edge edges[GPIO_EDGES_MAX];
    const struct gpio_lines lines = fresh();
    wire("start=BTN_START");
    wire("coin=COIN");
    request(&lines);
    for (uint32_t i = 0; i < 12; i++) {
        fake_line_edge(&fake_chips[1].lines[0], (100 + i) * MS, i % 2 == 0, 0);
        fake_line_edge(&fake_chips[1].lines[2], (100 + i) * MS, i % 2 == 0, 0);
    }
    uint32_t count = 0;
    for (uint32_t i = 0; i < 6; i++) {
        const int taken = lines.ops->wait(lines.self, edges, 5, 0);
        assert_in_range(taken, 0, 5);
        count += (uint32_t)taken;
    }
    assert_int_equal(count, 24);
    end(&lines);
}

static void test_a_line_without_interrupts_is_polled(void **state)
{
    (void)state;
    struct gpio_edge edges[GPIO_EDGES_MAX];
    const struct gpio_lines lines = fresh();
    struct fake_line *door = &fake_chips[2].lines[5];
    door->has_no_edges = true;
    /* The door is open, which is level 1. */
    door->value = 1;
    wire("door=DOOR");
    wire("start=BTN_START");
    assert_int_equal(request(&lines), 1 << GPIO_DOOR | 1 << GPIO_START);
    assert_string_equal(why[GPIO_DOOR], "");
    assert_int_equal(lines.ops->debounces(lines.self, GPIO_DOOR), 0);
    assert_int_equal(wait(&lines, edges), 0);
    door->value = 0;
    assert_int_equal(wait(&lines, edges), 1);
    assert_int_equal(edges[0].role, GPIO_DOOR);
    assert_int_equal(edges[0].active, 0);
    assert_true(edges[0].time_ns > 0);
    assert_int_equal(wait(&lines, edges), 0);
    fake_chip_pull(&fake_chips[2]);
    assert_int_equal(wait(&lines, edges), HAL_ERR_GONE);
    assert_int_equal(lines.ops->level(lines.self, GPIO_DOOR), HAL_ERR_GONE);
    end(&lines);
}

static void test_a_removed_chip_is_reported_after_the_edges_of_the_others(void **state)
{
    (void)state;
    struct gpio_edge edges[GPIO_EDGES_MAX];
    const struct gpio_lines lines = fresh();
    wire("start=BTN_START");
    wire("door=DOOR");
    request(&lines);
    fake_chip_pull(&fake_chips[1]);
    fake_line_edge(&fake_chips[2].lines[5], 100 * MS, true, 0);
    assert_int_equal(wait(&lines, edges), 1);
    assert_int_equal(edges[0].role, GPIO_DOOR);
    assert_int_equal(wait(&lines, edges), HAL_ERR_GONE);
    assert_int_equal(lines.ops->level(lines.self, GPIO_START), HAL_ERR_GONE);
    assert_int_equal(lines.ops->level(lines.self, GPIO_DOOR), 1);
    assert_int_equal(request(&lines), 1 << GPIO_DOOR);
    fake_chips[1].gone = false;
    assert_int_equal(request(&lines), 1 << GPIO_START | 1 << GPIO_DOOR);
    fake_line_edge(&fake_chips[1].lines[0], 900 * MS, true, 0);
    assert_int_equal(wait(&lines, edges), 1);
    assert_int_equal(edges[0].role, GPIO_START);
    assert_int_equal(edges[0].lost_before, 0);
    end(&lines);
}

static void test_the_loss_of_a_chip_with_only_outputs_is_reported_by_a_write(void **state)
{
    (void)state;
    const struct gpio_lines lines = fresh();
    wire("start-lamp=LAMP");
    request(&lines);
    assert_int_equal(lines.ops->set(lines.self, GPIO_START_LAMP, 1), HAL_OK);
    assert_int_equal(fake_chips[1].lines[3].value, 1);
    assert_int_equal(lines.ops->level(lines.self, GPIO_START_LAMP), 1);
    fake_chip_pull(&fake_chips[1]);
    assert_int_equal(lines.ops->set(lines.self, GPIO_START_LAMP, 0), HAL_ERR_GONE);
    assert_int_equal(lines.ops->level(lines.self, GPIO_START_LAMP), HAL_ERR_GONE);
    end(&lines);
}

static uint64_t now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000u * MS + (uint64_t)now.tv_nsec;
}

/* The limit of 0 open files (RLIMIT_NOFILE) makes poll() fail. The wait must still last for its
 * timeout, so that the GPIO thread does not loop without a pause. */
static void test_a_failed_wait_pauses_and_levels_are_still_read(void **state)
{
    (void)state;
    struct gpio_edge edges[GPIO_EDGES_MAX];
    struct rlimit before;
    const struct gpio_lines lines = fresh();
    wire("coin=COIN");
    request(&lines);
    assert_int_equal(getrlimit(RLIMIT_NOFILE, &before), 0);
    const struct rlimit none = { .rlim_cur = 0, .rlim_max = before.rlim_max };
    fake_line_edge(&fake_chips[1].lines[2], 5000 * MS, true, 0);
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
    const uint64_t begin_ns = now_ns();
    const int count = lines.ops->wait(lines.self, edges, GPIO_EDGES_MAX, 20);
    const uint64_t waited_ns = now_ns() - begin_ns;
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &before), 0);
    assert_int_equal(count, 0);
    assert_true(waited_ns >= 20 * MS);
    assert_int_equal(lines.ops->level(lines.self, GPIO_COIN), 1);
    /* The edge stayed in the queue while poll() failed. */
    assert_int_equal(wait(&lines, edges), 1);
    end(&lines);
}

struct listed {
    uint32_t count;
    char text[512];
};

static void note(void *context, const struct gpio_line_info *line)
{
    struct listed *listed = context;
    listed->count++;
    if (line->name[0]) {
        const size_t length = strlen(listed->text);
        snprintf(listed->text + length, sizeof listed->text - length, "%s/%s:%u=%s(%s)%s ",
                 line->device, line->chip, line->offset, line->name, line->consumer,
                 line->used ? "*" : "");
    }
}

static void test_all_lines_of_accessible_chips_are_listed(void **state)
{
    (void)state;
    struct listed listed = { 0 };
    const struct gpio_lines lines = fresh();
    fake_chips[1].lines[2].consumer = "gpio-keys";
    fake_chips[2].denied = true;
    assert_int_equal(lines.ops->list(lines.self, note, &listed), 2 * FAKE_LINES);
    assert_int_equal(listed.count, 2 * FAKE_LINES);
    assert_string_equal(listed.text, "gpiochip0/soc:1=HDMI_HPD() "
                                     "gpiochip4/panel:0=BTN_START() "
                                     "gpiochip4/panel:2=COIN(gpio-keys)* "
                                     "gpiochip4/panel:3=LAMP() ");
    end(&lines);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines_are_found_by_name_or_label_and_requested_as_wired),
        cmocka_unit_test(test_the_coin_lockout_is_locked_from_its_request_to_its_release),
        cmocka_unit_test(test_a_line_cannot_be_selected_by_chip_number),
        cmocka_unit_test(test_the_cause_of_a_failed_request_is_reported),
        cmocka_unit_test(test_without_a_chip_the_open_returns_absent),
        cmocka_unit_test(test_edges_have_time_stamps_and_are_in_order_for_each_line),
        cmocka_unit_test(test_edges_that_the_queue_dropped_are_counted_or_inferred),
        cmocka_unit_test(test_edges_beyond_the_buffer_stay_queued),
        cmocka_unit_test(test_a_line_without_interrupts_is_polled),
        cmocka_unit_test(test_a_removed_chip_is_reported_after_the_edges_of_the_others),
        cmocka_unit_test(test_the_loss_of_a_chip_with_only_outputs_is_reported_by_a_write),
        cmocka_unit_test(test_a_failed_wait_pauses_and_levels_are_still_read),
        cmocka_unit_test(test_all_lines_of_accessible_chips_are_listed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
