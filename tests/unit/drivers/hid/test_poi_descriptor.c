/* test_poi_descriptor.c -- tests that the report descriptor of the Kingyo poi describes its reports
 * correctly. Every field is located by the descriptor alone. Its value in physical units must equal
 * the value that poi_report.h has encoded. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/fmath.h"
#include "core/base/rng.h"
#include "drivers/hid/hid_descriptor.h"
#include "drivers/hid/poi_report.h"

#define GENERIC(usage) (0x00010000u | (usage))
#define BUTTON(number) (0x00090000u | (number))
#define OURS(usage) ((hid_usage)POI_PAGE << 16 | (hid_usage)(usage))

/* Units as defined in HID 1.11, section 6.2.2.7. System 1 uses cm, g and s, and system 4
 * degrees. */
#define UNIT_CM 0x11u
#define UNIT_DEGREE 0x14u
#define UNIT_G_CM_S2 0xe111u
#define UNIT_G_CM2_S2 0xe121u

static struct hid_descriptor inputs, outputs;

/* Changes the Output items of a copied descriptor to Input items. The parser ignores output fields,
 * so only this change makes them readable. */
static void read_outputs_as_inputs(uint8_t bytes[POI_DESCRIPTOR_SIZE])
{
    for (uint32_t i = 0; i < POI_DESCRIPTOR_SIZE;) {
        const uint32_t size = bytes[i] & 3u;
        if ((bytes[i] & 0xfcu) == 0x90u) {
            bytes[i] = (uint8_t)(0x80u | size);
        } else if ((bytes[i] & 0xfcu) == 0x80u) {
            bytes[i] = (uint8_t)(0x90u | size);
        }
        i += 1u + (size == 3u ? 4u : size);
    }
}

static int read_both(void **state)
{
    (void)state;
    uint8_t swapped[POI_DESCRIPTOR_SIZE];
    memcpy(swapped, poi_descriptor, sizeof swapped);
    read_outputs_as_inputs(swapped);
    assert_int_equal(hid_descriptor_read(&inputs, poi_descriptor, sizeof poi_descriptor), HID_OK);
    assert_int_equal(hid_descriptor_read(&outputs, swapped, sizeof swapped), HID_OK);
    return 0;
}

/* Returns the field with a usage. Fails the test unless exactly one field has this usage. */
static const struct hid_group *group_of(const struct hid_descriptor *descriptor, hid_usage usage,
                                        uint32_t *index)
{
    const struct hid_group *found = NULL;
    for (uint32_t g = 0; g < descriptor->group_count; g++) {
        for (uint32_t i = 0; i < descriptor->group[g].count; i++) {
            if (hid_usage_at(descriptor, &descriptor->group[g], i) == usage) {
                assert_null(found);
                found = &descriptor->group[g];
                *index = i;
            }
        }
    }
    assert_non_null(found);
    return found;
}

/* Returns the value of a field in units of `unit`, computed by the rules of HID 1.11, section
 * 6.2.2.7. */
static double physical(const struct hid_descriptor *descriptor, hid_usage usage, uint32_t unit,
                       const uint8_t *bytes, size_t size)
{
    uint32_t index = 0;
    const struct hid_group *group = group_of(descriptor, usage, &index);
    assert_int_equal(group->unit, unit);
    const struct hid_report report = { bytes, size };
    assert_true(hid_report_is_whole(descriptor, report));
    assert_int_equal(hid_report_id(descriptor, report), group->report_id);
    const double value = (double)hid_field_value(descriptor, group, index, report);
    if (group->physical_min == 0 && group->physical_max == 0) {
        return value;
    }
    const double logical = (double)(group->logical_max - group->logical_min);
    double scaled = (value - (double)group->logical_min) / logical *
                        (double)(group->physical_max - group->physical_min) +
                    (double)group->physical_min;
    for (int32_t e = group->unit_exponent; e != 0; e += e < 0 ? 1 : -1) {
        scaled = e < 0 ? scaled / 10.0 : scaled * 10.0;
    }
    return scaled;
}

static void test_each_report_has_the_declared_length_and_fields(void **state)
{
    (void)state;
    assert_int_equal(inputs.report_bits[POI_REPORT_ID], 8 * (POI_REPORT_SIZE - 1));
    assert_int_equal(outputs.report_bits[POI_FORCE_ID], 8 * (POI_FORCE_SIZE - 1));
    for (uint32_t id = 0; id < 256; id++) {
        assert_true(id == POI_REPORT_ID || inputs.report_bits[id] == 0);
        assert_true(id == POI_FORCE_ID || outputs.report_bits[id] == 0);
    }
    assert_int_equal(inputs.field_count, 1 + 6 + 8);
    assert_int_equal(outputs.field_count, 1 + 6 + 3);
}

static void test_a_pose_can_be_read_by_the_descriptor_alone(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2000; i++) {
        float drawn[6];
        for (uint32_t k = 0; k < 6; k++) {
            drawn[k] = rng_range((struct rng_key){ 3, i, k, RNG_TEST }, -1.0f, 1.0f);
        }
        const struct poi_report sent = {
            .target = { .position_m = { drawn[0], drawn[1], drawn[2] },
                        .angles = { .pitch_rad = drawn[3] * F_PI,
                                    .yaw_rad = drawn[4] * F_PI,
                                    .roll_rad = drawn[5] * F_PI } },
            .sequence = (uint8_t)i,
            .buttons = (uint8_t)(i * 7u),
        };
        uint8_t bytes[POI_REPORT_SIZE];
        poi_report_encode(&sent, bytes);
        for (uint32_t k = 0; k < 3; k++) {
            const double place_cm =
                physical(&inputs, GENERIC(0x30u + k), UNIT_CM, bytes, sizeof bytes);
            const double turn_deg =
                physical(&inputs, GENERIC(0x33u + k), UNIT_DEGREE, bytes, sizeof bytes);
            /* The tolerance of 0.0016 cm is about half a step of the encoding (15 um). */
            assert_float_equal(place_cm, 100.0f * drawn[k], 0.0016);
            assert_float_equal(turn_deg, 180.0f * drawn[3 + k], 0.0028);
        }
        assert_int_equal(physical(&inputs, OURS(POI_USAGE_SEQUENCE), 0, bytes, sizeof bytes),
                         sent.sequence);
        for (uint32_t b = 0; b < 8; b++) {
            assert_int_equal(physical(&inputs, BUTTON(1u + b), 0, bytes, sizeof bytes),
                             sent.buttons >> b & 1);
        }
    }
}

static void test_an_unknown_position_is_the_null_value(void **state)
{
    (void)state;
    const struct poi_report lost = { .target.position_m.x = __builtin_nanf("") };
    uint8_t bytes[POI_REPORT_SIZE];
    poi_report_encode(&lost, bytes);
    uint32_t index = 0;
    const struct hid_group *group = group_of(&inputs, GENERIC(0x30u), &index);
    const struct hid_report report = { bytes, sizeof bytes };
    assert_true(group->flags & HID_NULL_STATE);
    assert_true(hid_field_value(&inputs, group, index, report) < group->logical_min);
    assert_int_equal(hid_field_value(&inputs, group, 1, report), 0);
}

static void test_a_force_can_be_read_by_the_descriptor_alone(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 2000; i++) {
        float drawn[9];
        for (uint32_t k = 0; k < 9; k++) {
            drawn[k] = rng_range((struct rng_key){ 4, i, k, RNG_TEST }, k < 6 ? -1.0f : 0.0f, 1.0f);
        }
        const struct poi_force sent = {
            .force_n = v3_scale(v3(drawn[0], drawn[1], drawn[2]), POI_FORCE_N_MAX),
            .torque_n_m = v3_scale(v3(drawn[3], drawn[4], drawn[5]), POI_TORQUE_N_M_MAX),
            .drag = drawn[6],
            .slap = drawn[7],
            .tear = drawn[8],
        };
        uint8_t bytes[POI_FORCE_SIZE];
        poi_force_encode(&sent, (uint8_t)i, bytes);
        for (uint32_t k = 0; k < 3; k++) {
            /* One newton is 10^5 g cm/s^2, and one newton metre is 10^7 g cm^2/s^2. */
            const double force_n = 1e-5 * physical(&outputs, OURS(POI_USAGE_FORCE_X + k),
                                                   UNIT_G_CM_S2, bytes, sizeof bytes);
            const double torque_n_m = 1e-7 * physical(&outputs, OURS(POI_USAGE_TORQUE_X + k),
                                                      UNIT_G_CM2_S2, bytes, sizeof bytes);
            assert_float_equal(force_n, POI_FORCE_N_MAX * drawn[k], 0.00032);
            assert_float_equal(torque_n_m, POI_TORQUE_N_M_MAX * drawn[3 + k], 0.000064);
            assert_float_equal(physical(&outputs, OURS(POI_USAGE_DRAG + k), 0, bytes, sizeof bytes),
                               drawn[6 + k], 0.00197);
        }
        assert_int_equal(physical(&outputs, OURS(POI_USAGE_SEQUENCE), 0, bytes, sizeof bytes),
                         (uint8_t)i);
    }
}

static void test_only_the_complete_descriptor_is_recognized(void **state)
{
    (void)state;
    uint8_t bytes[POI_DESCRIPTOR_SIZE + 1] = { 0 };
    memcpy(bytes, poi_descriptor, sizeof poi_descriptor);
    assert_true(poi_descriptor_is(bytes, POI_DESCRIPTOR_SIZE));
    assert_false(poi_descriptor_is(bytes, POI_DESCRIPTOR_SIZE - 1));
    assert_false(poi_descriptor_is(bytes, POI_DESCRIPTOR_SIZE + 1));
    for (uint32_t i = 0; i < POI_DESCRIPTOR_SIZE; i++) {
        bytes[i] ^= 1u;
        assert_false(poi_descriptor_is(bytes, POI_DESCRIPTOR_SIZE));
        bytes[i] ^= 1u;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_report_has_the_declared_length_and_fields),
        cmocka_unit_test(test_a_pose_can_be_read_by_the_descriptor_alone),
        cmocka_unit_test(test_an_unknown_position_is_the_null_value),
        cmocka_unit_test(test_a_force_can_be_read_by_the_descriptor_alone),
        cmocka_unit_test(test_only_the_complete_descriptor_is_recognized),
    };
    return cmocka_run_group_tests(tests, read_both, NULL);
}
