/* test_replay_codec.c -- Tests how the inputs of a recording are encoded as differences from the
 * previous tick. Decoding must restore every bit, and the encoding must be as short as possible. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "platform/replay/replay.h"

static void test_an_unchanged_tick_takes_one_byte_besides_its_digest(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    const struct input next = { .held = INPUT_OK, .record_saved_id = 3 };
    const struct input still = next;
    assert_int_equal(replay_encode_input(&next, &still, bytes), 1);
    assert_int_equal(bytes[0], 0);
}

static void test_the_largest_difference_fits_the_bound(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    const struct input before = { 0 };
    struct input all = { .held = 1,
                         .pressed = 2,
                         .coin_count[0] = 3,
                         .record_saved_id = 4,
                         .edit_saved_id = 5,
                         .edit_refused = 1,
                         .upright = 1,
                         .is_turned = 1,
                         .day = 6,
                         .minute = 7,
                         .dropped_ticks = 8,
                         .device_faults = 9,
                         .tickets_done = 10 };
    memset(&all.controllers, 1, sizeof all.controllers);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        all.poi[i] = (struct poi_input){
            .link = POI_SOURCE_LIVE,
            .has_wrist = 1,
            .trembles = 1,
            .has_gap = 1,
            .age_ticks = 300,
            .target = { .position_m = { 1.0f, 2.0f, 3.0f }, .angles = { 4.0f, 5.0f, 6.0f } },
        };
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        all.shade[i] = (struct shade_input){ 1, 7.0f, 8.0f, 9.0f };
    }
    assert_int_equal(replay_encode_input(&before, &all, bytes), REPLAY_TICK_SIZE_MAX - 4u);
}

/* The seven bytes are three masks and a float. The masks name the changed groups of fields, the
 * changed pois and fans, and the changed fields of the fan. */
static void test_a_moving_fan_takes_seven_bytes_per_tick(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    struct input before = { .shade[3] = { 1, 0.1f, 0.2f, 0.1f } };
    struct input after = before;
    after.shade[3].x_m = 0.101f;
    assert_int_equal(replay_encode_input(&before, &after, bytes), 7);
    assert_int_equal(replay_decode_input(&before, bytes, 7, false), 7);
    assert_memory_equal(&before.shade[3].x_m, &after.shade[3].x_m, sizeof(float));
    for (size_t cut = 0; cut < 7; cut++) {
        assert_int_equal(replay_decode_input(&before, bytes, cut, false), 0);
    }
}

static void test_an_invalid_fan_encoding_is_rejected(void **state)
{
    (void)state;
    enum { HANDS = 1 << 4, SHADE_0 = 1 << 4, BYTE = 1, X = 2, NO_SUCH = 16 };
    static const uint8_t inf[4] = { 0, 0, 0x80, 0x7f };
    const uint8_t refused[][8] = {
        { HANDS, 0 },          /* Invalid: the mask of groups names the pois and fans, but their own
                                  mask names none of them. */
        { HANDS, SHADE_0, 0 }, /* Invalid: the mask names the first fan, but the mask of its fields
                                  is empty. */
        /* Invalid: a fan has three floats, and the bit NO_SUCH in the mask of its fields names a
         * fourth one. */
        { HANDS, SHADE_0, NO_SUCH },
        { HANDS, SHADE_0, BYTE, 2 }, /* Invalid: `present` may only be 0 or 1, not 2. */
        { HANDS, SHADE_0, X, inf[0], inf[1], inf[2], inf[3] },
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        struct input input = { 0 };
        assert_int_equal(replay_decode_input(&input, refused[i], sizeof refused[i], false), 0);
        assert_int_equal(input.shade[0].present, 0);
    }
    const uint8_t good[8] = { HANDS, SHADE_0, BYTE, 1 };
    struct input input = { 0 };
    assert_int_equal(replay_decode_input(&input, good, sizeof good, false), 4);
    assert_int_equal(input.shade[0].present, 1);
}

static void test_a_screen_rotation_takes_two_bytes_and_is_restored(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    const struct input lies = { .edit_saved_id = 2 }, stands = { .edit_saved_id = 2, .upright = 1 };
    struct input decoded = lies;
    assert_int_equal(replay_encode_input(&lies, &stands, bytes), 3);
    assert_int_equal(replay_decode_input(&decoded, bytes, 3, false), 3);
    assert_int_equal(decoded.upright, 1);
    assert_int_equal(decoded.edit_saved_id, 2);
    assert_int_equal(replay_encode_input(&stands, &lies, bytes), 3);
    assert_int_equal(replay_decode_input(&decoded, bytes, 3, false), 3);
    assert_int_equal(decoded.upright, 0);
}

static void test_a_graph_store_failure_takes_two_bytes_and_is_restored(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    const struct input keeps = { .upright = 1 }, refuses = { .upright = 1, .edit_refused = 1 };
    struct input decoded = keeps;
    for (uint32_t i = 0; i < 2; i++) {
        const struct input *from = i == 0 ? &keeps : &refuses, *to = i == 0 ? &refuses : &keeps;
        assert_int_equal(replay_encode_input(from, to, bytes), 3);
        assert_int_equal(replay_decode_input(&decoded, bytes, 3, false), 3);
        assert_int_equal(decoded.edit_refused, to->edit_refused);
        assert_int_equal(decoded.upright, 1);
    }
}

static void test_an_invalid_system_health_encoding_is_rejected(void **state)
{
    (void)state;
    enum { MACHINE = 1 << 3, BEYOND = 1 << 6, LEVELS = 1 << 2, MINUTE = 1 << 4, NO_SUCH = 1 << 7 };
    const uint8_t refused[][4] = {
        { MACHINE, 0, 0, 0 },         /* Invalid: the mask names the group of machine values, but
                                         the mask of its fields is empty. */
        { MACHINE, NO_SUCH, 1, 0 },   /* Invalid: the group of machine values has no field for this
                                         bit. */
        { BEYOND, 1, 0, 0 },          /* Invalid: an input has no group for this bit. */
        { MACHINE, LEVELS, 16, 0 },   /* Invalid: the levels have only the bits 0 to 3, so 16 (bit
                                         4) is no level. */
        { MACHINE, LEVELS, 0, 0 },    /* Invalid: the mask names the levels as changed, but their
                                         value is the old one. */
        { MACHINE, MINUTE, 0xa0, 5 }, /* Invalid: 0x5a0 is minute 1440, but the last minute of a day
                                         is 1439. */
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        struct input input = { 0 };
        assert_int_equal(replay_decode_input(&input, refused[i], 4, false), 0);
    }
    const uint8_t good[4] = { MACHINE, MINUTE, 0x9f, 5 };
    struct input input = { 0 };
    assert_int_equal(replay_decode_input(&input, good, 4, false), 4);
    assert_int_equal(input.minute, 1439);
}

static void test_the_system_health_is_restored(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    const struct input all = { .record_saved_id = 0x01020304,
                               .edit_saved_id = 0xfffffffeu,
                               .edit_refused = 1,
                               .store_well = 1,
                               .upright = 1,
                               .is_turned = 1,
                               .day = 9821,
                               .minute = 1439,
                               .dropped_ticks = 70000,
                               .device_faults = 80000,
                               .tickets_done = 90000 };
    for (uint32_t i = 0; i < 2; i++) {
        const struct input none = { 0 };
        const struct input *from = i == 0 ? &none : &all, *to = i == 0 ? &all : &none;
        struct input decoded = *from;
        const size_t size = replay_encode_input(from, to, bytes);
        assert_int_equal(size, 1u + REPLAY_MACHINE_BYTES);
        for (size_t cut = 0; cut < size; cut++) {
            assert_int_equal(replay_decode_input(&decoded, bytes, cut, false), 0);
        }
        assert_int_equal(replay_decode_input(&decoded, bytes, size, false), size);
        assert_int_equal(decoded.record_saved_id, to->record_saved_id);
        assert_int_equal(decoded.edit_saved_id, to->edit_saved_id);
        assert_int_equal(decoded.edit_refused, to->edit_refused);
        assert_int_equal(decoded.store_well, to->store_well);
        assert_int_equal(decoded.upright, to->upright);
        assert_int_equal(decoded.is_turned, to->is_turned);
        assert_int_equal(decoded.tickets_done, to->tickets_done);
        assert_int_equal(decoded.day, to->day);
        assert_int_equal(decoded.minute, to->minute);
        assert_int_equal(decoded.dropped_ticks, to->dropped_ticks);
        assert_int_equal(decoded.device_faults, to->device_faults);
    }
}

static void test_a_new_controller_takes_three_bytes_besides_the_mask(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    struct input before = { .controllers = { .state = { CONTROLLER_ACTIVE } } };
    struct input after = before;
    after.controllers.state[7] = CONTROLLER_FREE;
    assert_int_equal(replay_encode_input(&before, &after, bytes), 4);
    for (size_t cut = 0; cut < 4; cut++) {
        struct input untouched = before;
        assert_int_equal(replay_decode_input(&untouched, bytes, cut, false), 0);
        assert_memory_equal(&untouched.controllers, &before.controllers, sizeof before.controllers);
    }
    assert_int_equal(replay_decode_input(&before, bytes, 4, false), 4);
    assert_memory_equal(&before.controllers, &after.controllers, sizeof after.controllers);
}

static void test_an_invalid_controller_list_encoding_is_rejected(void **state)
{
    (void)state;
    enum { CONTROLLERS = 1 << 5, STEP = 1, ROW = 2, UPDATE = 16, BEYOND = 32 };
    const uint8_t refused[][4] = {
        /* Invalid: the mask names the controller list, but the mask of its fields is empty. */
        { CONTROLLERS, 0, 0, 0 },
        /* Invalid: CONTROLLER_STATE_COUNT is one more than the last state of a controller. */
        { CONTROLLERS, 1, 0, CONTROLLER_STATE_COUNT },
        /* Invalid: LEARN_STEP_COUNT is one more than the last step of the learning. */
        { CONTROLLERS, 0, STEP, LEARN_STEP_COUNT },
        /* Invalid: CONTROLLER_MAX is one more than the last row. */
        { CONTROLLERS, 0, ROW, CONTROLLER_MAX },
        /* Invalid: UPDATE_STATE_COUNT is one more than the last state of an update. */
        { CONTROLLERS, 0, UPDATE, UPDATE_STATE_COUNT },
        /* Invalid: the controller list has no field for this bit. */
        { CONTROLLERS, 0, BEYOND, 1 },
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        struct input input = { 0 };
        assert_int_equal(replay_decode_input(&input, refused[i], 4, false), 0);
    }
    const uint8_t good[4] = { CONTROLLERS, 0, ROW, CONTROLLER_MAX - 1 };
    struct input input = { 0 };
    assert_int_equal(replay_decode_input(&input, good, 4, false), 4);
    assert_int_equal(input.controllers.learn_row, CONTROLLER_MAX - 1);
}

static uint32_t draw(uint32_t tick, uint32_t what)
{
    return rng_u32((struct rng_key){ 5, tick, what, RNG_TEST });
}

/* A faulty sensor may report any bit pattern, for example NaN. The core has validated exactly this
 * pattern, so a replay must restore it. */
static void test_any_bit_pattern_of_a_pose_is_restored(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    struct input before = { 0 }, decoded = { 0 };
    for (uint32_t tick = 0; tick < 20000; tick++) {
        struct input input = before;
        struct poi_input *poi = &input.poi[draw(tick, 0) % POI_MAX];
        uint32_t bits[6];
        for (uint32_t i = 0; i < 6; i++) {
            /* In half of the ticks, the exponent of each float is that of NaN or infinity. */
            bits[i] = draw(tick, i + 1u) | (draw(tick, 9) % 2u ? 0x7f800000u : 0u);
        }
        memcpy(&poi->target, bits, sizeof poi->target);
        poi->link = draw(tick, 10) % 4u;
        poi->has_wrist = draw(tick, 11) % 2u;
        poi->trembles = draw(tick, 12) % 2u;
        poi->age_ticks = (uint16_t)draw(tick, 13);
        const size_t size = replay_encode_input(&before, &input, bytes);
        assert_true(size <= REPLAY_TICK_SIZE_MAX - 4u);
        assert_int_equal(replay_decode_input(&decoded, bytes, size, false), size);
        assert_memory_equal(decoded.poi, input.poi, sizeof input.poi);
        before = input;
    }
}

static void test_a_change_of_only_the_pose_age_takes_five_bytes(void **state)
{
    (void)state;
    uint8_t bytes[REPLAY_TICK_SIZE_MAX];
    struct input before = { .poi[2] = { .link = POI_SOURCE_LIVE, .age_ticks = 254 } };
    struct input after = before;
    for (after.poi[2].age_ticks = 255; after.poi[2].age_ticks < 258; after.poi[2].age_ticks++) {
        assert_int_equal(replay_encode_input(&before, &after, bytes), 5);
        assert_int_equal(replay_decode_input(&before, bytes, 5, false), 5);
        assert_int_equal(before.poi[2].age_ticks, after.poi[2].age_ticks);
        for (size_t cut = 0; cut < 5; cut++) {
            assert_int_equal(replay_decode_input(&before, bytes, cut, false), 0);
        }
    }
}

static void test_an_invalid_poi_encoding_is_rejected(void **state)
{
    (void)state;
    enum { HANDS = 1 << 4, POI_0 = 1, BYTE = 1, TREMBLES = 8, GAP = 16 };
    const uint8_t refused[][8] = {
        { HANDS, POI_0, 0 }, /* Invalid: the mask names the first poi, but the mask of its fields is
                                empty. */
        /* Invalid: the status byte of a poi has only the bits 0 to 4, and 32 is bit 5. */
        { HANDS, POI_0, BYTE, 32 },
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        struct input input = { 0 };
        assert_int_equal(replay_decode_input(&input, refused[i], sizeof refused[i], false), 0);
    }
    const uint8_t good[8] = { HANDS, POI_0, BYTE, GAP | TREMBLES | POI_SOURCE_LIVE };
    struct input input = { 0 };
    assert_int_equal(replay_decode_input(&input, good, sizeof good, false), 4);
    assert_int_equal(input.poi[0].trembles, 1);
    assert_int_equal(input.poi[0].has_gap, 1);
    assert_int_equal(input.poi[0].has_wrist, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_unchanged_tick_takes_one_byte_besides_its_digest),
        cmocka_unit_test(test_the_largest_difference_fits_the_bound),
        cmocka_unit_test(test_a_moving_fan_takes_seven_bytes_per_tick),
        cmocka_unit_test(test_an_invalid_fan_encoding_is_rejected),
        cmocka_unit_test(test_a_screen_rotation_takes_two_bytes_and_is_restored),
        cmocka_unit_test(test_a_graph_store_failure_takes_two_bytes_and_is_restored),
        cmocka_unit_test(test_an_invalid_system_health_encoding_is_rejected),
        cmocka_unit_test(test_the_system_health_is_restored),
        cmocka_unit_test(test_a_new_controller_takes_three_bytes_besides_the_mask),
        cmocka_unit_test(test_an_invalid_controller_list_encoding_is_rejected),
        cmocka_unit_test(test_any_bit_pattern_of_a_pose_is_restored),
        cmocka_unit_test(test_a_change_of_only_the_pose_age_takes_five_bytes),
        cmocka_unit_test(test_an_invalid_poi_encoding_is_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
