/* test_controller_manager.c -- the operator's desk: choosing, learning, keeping, over seats of
 * memory. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "drivers/hid/controller_manager.h"
#include "drivers/sim/hid_sim.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/pointer.h"

static struct clock_sim clock_now;
static struct hid_wire wire[2]; /* A DualSense, and a pen tablet. */
static struct hid_port_sim port[2];
static struct hid_device_list_sim device_list;
static struct hid_mapping_store book;
static struct poi_hid seat[2];
static struct controller_manager desk;

static int set_up(void **state)
{
    struct hid_port_sim *ports[POI_MAX] = { &port[0], &port[1] };
    struct poi_hid *seats[POI_MAX] = { &seat[0], &seat[1] };
    (void)state;
    clock_now.now_ns = 1000000000ull;
    wire_load(&wire[0], &clock_now, "016-ci-dualsense");
    wire[0].face.identity = (struct hid_identity){
        .vendor = 0x054c, .product = 0x0ce6, .name = "Wireless Controller", .port = "3-1"
    };
    wire_load(&wire[1], &clock_now, "137-dg-huion-h610-if0");
    wire[1].face.identity =
        (struct hid_identity){ .vendor = 0x256c, .product = 0x006e, .port = "3-2" };
    hid_mapping_store_open(&book, NULL, NULL, NULL);
    for (uint32_t i = 0; i < 2; i++) {
        hid_port_sim_init(&port[i], sim_clock_device(&clock_now), &wire[0].face);
        port[i].absent = 1;
        poi_hid_init(&seat[i], hid_port_sim_port(&port[i]), sim_clock_device(&clock_now),
                     hid_mapping_store_mapper(&book), stall_view());
    }
    hid_device_list_sim_init(&device_list, ports);
    hid_device_list_sim_plug(&device_list, 0, &wire[0].face);
    hid_device_list_sim_plug(&device_list, 3, &wire[1].face);
    controller_manager_init(&desk, hid_device_list_sim_device(&device_list), &book, seats);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    hid_mapping_store_close(&book);
    return 0;
}

/* A frame: seats are looked at, then the desk. */
static struct controller_status frame(void)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    struct controller_status out;
    const struct hal_controllers device = controller_manager_device(&desk);
    clock_now.now_ns += 16666667ull;
    for (uint32_t i = 0; i < 2; i++) {
        const struct hal_poi poi = poi_hid_device(&seat[i]);
        if (!seat[i].is_open) {
            poi.ops->open(poi.self);
        }
        poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
    }
    assert_int_equal(device.ops->poll(device.self, &out), HAL_OK);
    return out;
}

static int order(enum controller_command_kind kind, uint8_t row)
{
    const struct controller_command wanted = { .kind = (uint8_t)kind, .row = row };
    const struct hal_controllers device = controller_manager_device(&desk);
    return device.ops->command(device.self, &wanted);
}

static const char *name(uint32_t row)
{
    const struct hal_controllers device = controller_manager_device(&desk);
    return device.ops->name(device.self, row);
}

/* Whoever holds the pad pushes its right stick instead of its left one, and squeezes L1. */
static void push(uint32_t at, int64_t across, int64_t along, int64_t squeezed)
{
    struct hid_wire *pad = &wire[0];
    wire_put(pad, 1, USAGE_X, 128);
    wire_put(pad, 1, USAGE_Y, 128);
    wire_put(pad, 1, USAGE_HAT, 8);
    wire_put(pad, 1, USAGE_Z, across);
    wire_put(pad, 1, USAGE_RZ, along);
    wire_put(pad, 1, USAGE_BUTTON + 5u, squeezed);
    uint8_t bytes[64] = { 1 };
    memcpy(bytes + 1, pad->payload[1], 63);
    hid_port_sim_report(&port[at], bytes, sizeof bytes);
}

static struct controller_status step(int64_t across, int64_t along, int64_t squeezed)
{
    struct controller_status out = { 0 };
    for (uint32_t i = 0; i < 80; i++) {
        push(0, i > 10 ? across : 128, i > 10 ? along : 128, i > 10 ? squeezed : 0);
        out = frame();
    }
    push(0, 128, 128, 0);
    frame();
    return out;
}

static void teach(void)
{
    assert_int_equal(order(COMMAND_LEARN, 0), HAL_OK);
    assert_int_equal(frame().learn_step, LEARN_REST);
    frame();
    assert_int_equal(step(128, 128, 0).learn_progress, 255);
    order(COMMAND_LEARN_NEXT, 0);
    assert_true(step(0, 128, 0).learn_progress > 200);
    order(COMMAND_LEARN_NEXT, 0);
    step(255, 128, 0);
    order(COMMAND_LEARN_NEXT, 0);
    step(128, 0, 0);
    order(COMMAND_LEARN_NEXT, 0);
    step(128, 255, 0);
    order(COMMAND_LEARN_NEXT, 0);
    assert_int_equal(step(128, 128, 1).learn_step, LEARN_DIP);
    order(COMMAND_LEARN_NEXT, 0);
}

static void test_rows_are_what_is_plugged_in(void **state)
{
    (void)state;
    const struct controller_status out = frame();
    assert_int_equal(out.state[0], CONTROLLER_FREE);
    assert_int_equal(out.state[1], CONTROLLER_NONE);
    assert_int_equal(out.state[3], CONTROLLER_FREE);
    assert_string_equal(name(0), "054c:0ce6 Wireless Controller, 3-1");
    assert_string_equal(name(1), "");
    assert_string_equal(name(CONTROLLER_MAX), "");
}

static void test_a_long_name_is_cut_between_its_letters(void **state)
{
    (void)state;
    snprintf(wire[0].face.identity.name, HID_TEXT_SIZE, "%s",
             "\xe9\x87\x91\xe9\xad\x9a\xe6\x8e\xac\xe3\x81\x84\xe3\x81\xae\xe5\x8f\xb0"
             "\xe3\x81\xae\xe6\x9f\x84\xe3\x81\xa7\xe3\x81\x99"); /* Ten of three bytes. */
    frame();
    assert_int_equal(strlen(name(0)), 10 + 24 + 2 + 3);
    assert_true(strlen(name(0)) < HAL_CONTROLLER_TEXT);
}

static void test_who_is_chosen_plays_and_who_is_released_does_not(void **state)
{
    (void)state;
    frame();
    assert_int_equal(order(COMMAND_CHOOSE, 0), HAL_OK);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    frame();
    assert_true(seat[0].plays);
    assert_int_equal(order(COMMAND_RELEASE, 0), HAL_OK);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    assert_false(seat[0].is_open);
    assert_int_equal(order(COMMAND_CHOOSE, 1), HAL_ERR_ABSENT); /* An empty row. */
    assert_int_equal(order(COMMAND_CHOOSE, CONTROLLER_MAX), HAL_ERR_ABSENT);
}

static void test_a_pad_is_learned_tried_and_kept(void **state)
{
    (void)state;
    frame();
    teach();
    const struct controller_status tried = frame();
    assert_int_equal(tried.learn_step, LEARN_TRY);
    assert_int_equal(tried.learn_row, 0);
    assert_true(seat[0].plays);
    assert_int_equal(seat[0].hand.map.source, HID_MAPPING_LEARNED);
    assert_int_equal(seat[0].hand.map.binding[0].bit_offset, 16); /* The right stick. */
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_OK);
    assert_int_equal(frame().learn_step, LEARN_NONE);
    assert_non_null(hid_mapping_store_find(&book, &wire[0].face.identity));
    assert_int_equal(seat[0].hand.map.source, HID_MAPPING_LEARNED); /* It plays on. */
}

static void test_what_is_not_kept_is_forgotten(void **state)
{
    (void)state;
    frame();
    order(COMMAND_CHOOSE, 0);
    frame();
    teach();
    frame();
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().learn_step, LEARN_NONE);
    assert_null(hid_mapping_store_find(&book, &wire[0].face.identity));
    assert_int_equal(seat[0].hand.map.source, HID_MAPPING_KNOWN);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE); /* As it did before. */
}

static void test_who_was_free_is_so_again_where_nothing_was_kept(void **state)
{
    (void)state;
    frame();
    order(COMMAND_LEARN, 0); /* Ended before it sits, ... */
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    teach(); /* ... while it is tried, also the second time, ... */
    order(COMMAND_LEARN, 0);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    order(COMMAND_LEARN, 0); /* ... by the next that is learned, ... */
    frame();
    order(COMMAND_LEARN, 3);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    assert_int_equal(frame().state[3], CONTROLLER_ACTIVE);
    order(COMMAND_LEARN_END, 3);
    order(COMMAND_LEARN, 0); /* ... and while it is away. */
    frame();
    frame();
    hid_device_list_sim_plug(&device_list, 0, NULL);
    frame();
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_NONE);
    assert_int_equal(device_list.release_count, 5);
}

static void test_who_was_kept_plays_on(void **state)
{
    (void)state;
    frame();
    teach();
    order(COMMAND_LEARN_KEEP, 0);
    frame();
    order(COMMAND_LEARN, 0);
    frame();
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    assert_int_equal(device_list.release_count, 0);
}

static atomic_uint told_count;

static void count_line(void *self, const char *line)
{
    assert_non_null(strstr(line, self));
    told_count++;
}

/* The thread writes when it may: some frames are patience. */
static struct controller_status written(void)
{
    struct controller_status out = frame();
    for (uint32_t i = 0; i < 5000 && out.learn_step == LEARN_TRY; i++) {
        usleep(1000);
        out = frame();
    }
    return out;
}

static void test_what_cannot_be_written_is_told_and_plays_on(void **state)
{
    char data[] = "/tmp/kingyo-desk-XXXXXX", pois[64], line[] = "/pois/054c-0ce6-.poi: ";
    (void)state;
    assert_non_null(mkdtemp(data));
    snprintf(pois, sizeof pois, "%s/pois", data);
    assert_int_equal(close(open(pois, O_CREAT | O_WRONLY, 0644)), 0); /* No folder can be here. */
    hid_mapping_store_close(&book);
    hid_mapping_store_open(&book, data, NULL, NULL);
    hid_mapping_store_set_error_sink(&book, count_line, line);
    told_count = 0;
    frame();
    teach();
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_OK);
    assert_int_equal(written().learn_step, LEARN_NOT_SAVED);
    assert_int_equal(told_count, 1);
    assert_true(seat[0].plays);
    assert_int_equal(unlink(pois), 0); /* Somebody saw to it. */
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_OK);
    assert_int_equal(written().learn_step, LEARN_NONE);
    assert_int_equal(book.written_count, 1);
    assert_int_equal(seat[0].hand.map.source, HID_MAPPING_LEARNED);
    hid_mapping_store_close(&book);
    snprintf(pois, sizeof pois, "rm -rf %s", data);
    assert_int_equal(system(pois), 0);
    hid_mapping_store_open(&book, NULL, NULL, NULL);
}

static void test_who_lives_with_what_is_not_kept_plays_on(void **state)
{
    (void)state;
    snprintf(book.folder, sizeof book.folder, "/nowhere/pois"); /* A book without its thread. */
    frame();
    teach();
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_ERR_IO);
    assert_int_equal(frame().learn_step, LEARN_NOT_SAVED);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().learn_step, LEARN_NONE);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    assert_int_equal(seat[0].hand.map.source, HID_MAPPING_LEARNED);
}

static void test_a_released_controller_is_forgotten(void **state)
{
    (void)state;
    frame();
    teach();
    order(COMMAND_LEARN_KEEP, 0);
    frame();
    order(COMMAND_RELEASE, 0);
    frame();
    assert_null(hid_mapping_store_find(&book, &wire[0].face.identity));
}

static void test_one_that_is_pulled_out_while_it_is_learned_fails(void **state)
{
    (void)state;
    frame();
    order(COMMAND_LEARN, 0);
    frame();
    frame();
    step(128, 128, 0);
    order(COMMAND_LEARN_NEXT, 0);
    hid_device_list_sim_plug(&device_list, 0, NULL);
    frame();
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    order(COMMAND_LEARN_NEXT, 0); /* Nobody is there to go on with. */
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    hid_device_list_sim_plug(&device_list, 0, &wire[0].face);
    frame();
    teach(); /* Begun again it goes well. */
    assert_int_equal(frame().learn_step, LEARN_TRY);
}

static void test_one_that_may_not_be_opened_cannot_be_learned(void **state)
{
    (void)state;
    device_list.denied[3] = 1;
    frame();
    order(COMMAND_LEARN, 3);
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    order(COMMAND_LEARN_END, 3);
    device_list.barred[0] = 1;
    assert_int_equal(order(COMMAND_LEARN, 0), HAL_ERR_ABSENT);
    assert_int_equal(frame().learn_step, LEARN_FAILED);
}

static void test_who_cannot_be_shown_is_told_so(void **state)
{
    (void)state;
    frame();
    order(COMMAND_LEARN, 0);
    for (uint32_t i = LEARN_REST; i <= LEARN_DIP; i++) {
        frame();
        step(128, 128, 0); /* Nobody moves it. */
        order(COMMAND_LEARN_NEXT, 0);
    }
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    assert_true(seat[0].plays); /* By what it played by before. */
    assert_int_equal(seat[0].hand.map.source, HID_MAPPING_KNOWN);
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_ERR_IO);
}

static void test_orders_that_do_not_fit_harm_nothing(void **state)
{
    (void)state;
    frame();
    order(COMMAND_LEARN_NEXT, 0);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_ERR_IO);
    order(COMMAND_NONE, 0);
    order((enum controller_command_kind)250, 0);
    order(COMMAND_RELEASE, 5);
    assert_int_equal(frame().learn_step, LEARN_NONE);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_rows_are_what_is_plugged_in),
        TEST(test_a_long_name_is_cut_between_its_letters),
        TEST(test_who_is_chosen_plays_and_who_is_released_does_not),
        TEST(test_a_pad_is_learned_tried_and_kept),
        TEST(test_what_is_not_kept_is_forgotten),
        TEST(test_who_was_free_is_so_again_where_nothing_was_kept),
        TEST(test_who_was_kept_plays_on),
        TEST(test_what_cannot_be_written_is_told_and_plays_on),
        TEST(test_who_lives_with_what_is_not_kept_plays_on),
        TEST(test_a_released_controller_is_forgotten),
        TEST(test_one_that_is_pulled_out_while_it_is_learned_fails),
        TEST(test_one_that_may_not_be_opened_cannot_be_learned),
        TEST(test_who_cannot_be_shown_is_told_so),
        TEST(test_orders_that_do_not_fit_harm_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
