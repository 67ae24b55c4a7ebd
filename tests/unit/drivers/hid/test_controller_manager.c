/* test_controller_manager.c -- tests how the operator chooses controllers in the menu, teaches
 * their mappings and stores them. The devices are simulated. */
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
/* The two simulated controllers: a DualSense gamepad and a pen tablet. */
static struct hid_wire wire[2];
static struct hid_port_sim port[2];
static struct hid_device_list_sim device_list;
static struct hid_mapping_store store;
static struct poi_hid slot[2];
static struct controller_manager manager;
static struct hal_controllers device;

static int set_up(void **state)
{
    struct hid_port_sim *ports[POI_MAX] = { &port[0], &port[1] };
    struct poi_hid *slots[POI_MAX] = { &slot[0], &slot[1] };
    (void)state;
    clock_now.now_ns = 1000000000ull;
    wire_load(&wire[0], &clock_now, "016-ci-dualsense");
    wire[0].face.identity = (struct hid_identity){
        .vendor = 0x054c, .product = 0x0ce6, .name = "Wireless Controller", .port = "3-1"
    };
    wire_load(&wire[1], &clock_now, "137-dg-huion-h610-if0");
    wire[1].face.identity =
        (struct hid_identity){ .vendor = 0x256c, .product = 0x006e, .port = "3-2" };
    hid_mapping_store_open(&store, NULL, NULL, NULL);
    for (uint32_t i = 0; i < 2; i++) {
        hid_port_sim_init(&port[i], sim_clock_device(&clock_now), NULL);
        poi_hid_init(&slot[i], &port[i].port, sim_clock_device(&clock_now),
                     hid_mapping_store_mapper(&store), festival_view());
    }
    hid_device_list_sim_init(&device_list, ports);
    hid_device_list_sim_plug(&device_list, 0, &wire[0].face);
    hid_device_list_sim_plug(&device_list, 3, &wire[1].face);
    device =
        controller_manager_init(&manager, hid_device_list_sim_device(&device_list), &store, slots);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    hid_mapping_store_close(&store);
    return 0;
}

/* Runs one frame: first the pois are polled, then the controller manager. Returns its status. */
static struct controller_status frame(void)
{
    struct poi_sample samples[HAL_POI_SAMPLES_MAX];
    struct controller_status out;
    clock_now.now_ns += 16666667ull;
    for (uint32_t i = 0; i < 2; i++) {
        const struct hal_poi poi = poi_hid_devices(&slot[i]).poi;
        if (!slot[i].is_open) {
            poi.ops->open(poi.self);
        }
        poi.ops->poll(poi.self, samples, HAL_POI_SAMPLES_MAX);
    }
    assert_int_equal(device.ops->poll(device.self, &out), HAL_OK);
    return out;
}

static int order(enum controller_command_kind kind, uint8_t row)
{
    const struct controller_command expected = { .kind = (uint8_t)kind, .row = row };
    return device.ops->command(device.self, &expected);
}

static const char *name(uint32_t row)
{
    return device.ops->name(device.self, row);
}

/* Sends a report of the gamepad with the position (`across`, `along`) of the right stick. If
 * `squeezed` is 1, button L1 is pressed. The left stick is centred. */
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

static void test_rows_list_the_connected_devices(void **state)
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

static void test_a_long_name_is_truncated_between_two_characters(void **state)
{
    (void)state;
    /* A name of ten characters, each of which has three bytes. */
    snprintf(wire[0].face.identity.name, HID_TEXT_SIZE, "%s",
             "\xe9\x87\x91\xe9\xad\x9a\xe6\x8e\xac\xe3\x81\x84\xe3\x81\xae\xe5\x8f\xb0"
             "\xe3\x81\xae\xe6\x9f\x84\xe3\x81\xa7\xe3\x81\x99");
    frame();
    assert_int_equal(strlen(name(0)), 10 + 24 + 2 + 3);
    assert_true(strlen(name(0)) < HAL_CONTROLLER_TEXT);
}

static void test_a_device_is_active_while_it_is_chosen(void **state)
{
    (void)state;
    frame();
    assert_int_equal(order(COMMAND_CHOOSE, 0), HAL_OK);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    frame();
    assert_true(slot[0].plays);
    assert_int_equal(order(COMMAND_RELEASE, 0), HAL_OK);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    assert_false(slot[0].is_open);
    /* Row 1 is empty, so there is no device to choose. */
    assert_int_equal(order(COMMAND_CHOOSE, 1), HAL_ERR_ABSENT);
    assert_int_equal(order(COMMAND_CHOOSE, CONTROLLER_MAX), HAL_ERR_ABSENT);
}

static void test_a_mapping_is_learned_tried_and_stored(void **state)
{
    (void)state;
    frame();
    teach();
    const struct controller_status tried = frame();
    assert_int_equal(tried.learn_step, LEARN_TRY);
    assert_int_equal(tried.learn_row, 0);
    assert_true(slot[0].plays);
    assert_int_equal(slot[0].decoder.map.source, HID_MAPPING_LEARNED);
    /* Bit 16 belongs to the right stick, which the operator has moved. */
    assert_int_equal(slot[0].decoder.map.binding[0].bit_offset, 16);
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_OK);
    assert_int_equal(frame().learn_step, LEARN_NONE);
    assert_non_null(hid_mapping_store_find(&store, &wire[0].face.identity));
    /* The learned mapping is still used after it was stored. */
    assert_int_equal(slot[0].decoder.map.source, HID_MAPPING_LEARNED);
}

static void test_a_mapping_that_is_not_stored_is_discarded(void **state)
{
    (void)state;
    frame();
    order(COMMAND_CHOOSE, 0);
    frame();
    teach();
    frame();
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().learn_step, LEARN_NONE);
    assert_null(hid_mapping_store_find(&store, &wire[0].face.identity));
    assert_int_equal(slot[0].decoder.map.source, HID_MAPPING_KNOWN);
    /* The controller was used for play before the learning, so it is used again afterwards. */
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
}

static void test_an_unused_device_is_free_again_after_a_discarded_mapping(void **state)
{
    (void)state;
    frame();
    /* Starts to learn a gamepad that has no slot, and cancels the learning. */
    order(COMMAND_LEARN, 0);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    /* Completes the learning, so that the operator can try the mapping. Before the mapping is
     * stored, a second learning begins and is cancelled. */
    teach();
    order(COMMAND_LEARN, 0);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    /* Learns a device that has a slot. The learning of this device must end when the learning of
     * another device begins. */
    order(COMMAND_LEARN, 0);
    frame();
    order(COMMAND_LEARN, 3);
    assert_int_equal(frame().state[0], CONTROLLER_FREE);
    assert_int_equal(frame().state[3], CONTROLLER_ACTIVE);
    order(COMMAND_LEARN_END, 3);
    /* The gamepad is unplugged while it is learned. */
    order(COMMAND_LEARN, 0);
    frame();
    frame();
    hid_device_list_sim_plug(&device_list, 0, NULL);
    frame();
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().state[0], CONTROLLER_NONE);
    assert_int_equal(device_list.release_count, 5);
}

static void test_a_device_with_a_stored_mapping_stays_active(void **state)
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

static atomic_uint call_count;

static void count_line(void *self, const char *line)
{
    assert_non_null(strstr(line, self));
    call_count++;
}

/* Runs frames until the store's thread has written the mapping. Returns the last status. */
static struct controller_status written(void)
{
    struct controller_status out = frame();
    for (uint32_t i = 0; i < 5000 && out.learn_step == LEARN_TRY; i++) {
        usleep(1000);
        out = frame();
    }
    return out;
}

static void test_an_unwritable_mapping_is_reported_and_stays_in_use(void **state)
{
    char data[] = "/tmp/kingyo-manager-XXXXXX", pois[64], line[] = "/pois/054c-0ce6-.poi: ";
    (void)state;
    assert_non_null(mkdtemp(data));
    snprintf(pois, sizeof pois, "%s/pois", data);
    /* Creates a regular file with the name of the folder for mappings, so that storing fails. */
    assert_int_equal(close(open(pois, O_CREAT | O_WRONLY, 0644)), 0);
    hid_mapping_store_close(&store);
    hid_mapping_store_open(&store, data, NULL, NULL);
    hid_mapping_store_set_error_sink(&store, count_line, line);
    call_count = 0;
    frame();
    teach();
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_OK);
    assert_int_equal(written().learn_step, LEARN_NOT_SAVED);
    assert_int_equal(call_count, 1);
    assert_true(slot[0].plays);
    /* The operator removes the regular file, so that the folder can be created. */
    assert_int_equal(unlink(pois), 0);
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_OK);
    assert_int_equal(written().learn_step, LEARN_NONE);
    assert_int_equal(store.written_count, 1);
    assert_int_equal(slot[0].decoder.map.source, HID_MAPPING_LEARNED);
    hid_mapping_store_close(&store);
    snprintf(pois, sizeof pois, "rm -rf %s", data);
    assert_int_equal(system(pois), 0);
    hid_mapping_store_open(&store, NULL, NULL, NULL);
}

static void test_a_device_with_an_accepted_unwritable_mapping_stays_active(void **state)
{
    (void)state;
    /* The folder does not exist, and the store has no thread in this test, so each write fails at
     * once. */
    snprintf(store.folder, sizeof store.folder, "/nowhere/pois");
    frame();
    teach();
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_ERR_IO);
    assert_int_equal(frame().learn_step, LEARN_NOT_SAVED);
    order(COMMAND_LEARN_END, 0);
    assert_int_equal(frame().learn_step, LEARN_NONE);
    assert_int_equal(frame().state[0], CONTROLLER_ACTIVE);
    assert_int_equal(slot[0].decoder.map.source, HID_MAPPING_LEARNED);
}

static void test_the_mapping_of_a_released_device_is_removed(void **state)
{
    (void)state;
    frame();
    teach();
    order(COMMAND_LEARN_KEEP, 0);
    frame();
    order(COMMAND_RELEASE, 0);
    frame();
    assert_null(hid_mapping_store_find(&store, &wire[0].face.identity));
}

static void test_learning_fails_if_the_device_is_unplugged(void **state)
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
    /* The learning has failed, so this request for the next step has no effect. */
    order(COMMAND_LEARN_NEXT, 0);
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    hid_device_list_sim_plug(&device_list, 0, &wire[0].face);
    frame();
    teach(); /* A second attempt succeeds. */
    assert_int_equal(frame().learn_step, LEARN_TRY);
}

static void test_a_device_that_cannot_be_opened_cannot_be_learned(void **state)
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

static void test_an_unsuccessful_learning_is_reported(void **state)
{
    (void)state;
    frame();
    order(COMMAND_LEARN, 0);
    for (uint32_t i = LEARN_REST; i <= LEARN_DIP; i++) {
        frame();
        /* The stick rests in every step, so no axis can be learned. */
        step(128, 128, 0);
        order(COMMAND_LEARN_NEXT, 0);
    }
    assert_int_equal(frame().learn_step, LEARN_FAILED);
    /* The gamepad is still used for play, with its former mapping. */
    assert_true(slot[0].plays);
    assert_int_equal(slot[0].decoder.map.source, HID_MAPPING_KNOWN);
    assert_int_equal(order(COMMAND_LEARN_KEEP, 0), HAL_ERR_IO);
}

static void test_invalid_commands_change_nothing(void **state)
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
        TEST(test_rows_list_the_connected_devices),
        TEST(test_a_long_name_is_truncated_between_two_characters),
        TEST(test_a_device_is_active_while_it_is_chosen),
        TEST(test_a_mapping_is_learned_tried_and_stored),
        TEST(test_a_mapping_that_is_not_stored_is_discarded),
        TEST(test_an_unused_device_is_free_again_after_a_discarded_mapping),
        TEST(test_a_device_with_a_stored_mapping_stays_active),
        TEST(test_an_unwritable_mapping_is_reported_and_stays_in_use),
        TEST(test_a_device_with_an_accepted_unwritable_mapping_stays_active),
        TEST(test_the_mapping_of_a_released_device_is_removed),
        TEST(test_learning_fails_if_the_device_is_unplugged),
        TEST(test_a_device_that_cannot_be_opened_cannot_be_learned),
        TEST(test_an_unsuccessful_learning_is_reported),
        TEST(test_invalid_commands_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
