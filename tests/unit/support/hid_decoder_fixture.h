/* hid_decoder_fixture.h -- test fixture of a pose decoder for a controller with a real HID report
 * descriptor. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_HID_DECODER_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_HID_DECODER_FIXTURE_H

#include <string.h>

#include "drivers/hid/poi_hid.h"
#include "tests/unit/support/hid_wire.h"
#include "tests/unit/support/pointer.h"

static struct clock_sim clock_now;
static struct hid_wire wire;
static struct hid_pose_decoder decoder;
static uint64_t now_ms;

/* Initializes a decoder for a controller. The report descriptor is in the file `name`.hid of the
 * corpus. The decoder uses the given USB ids and the automatic mapping. */
static inline void connect(const char *name, uint16_t vendor, uint16_t product)
{
    struct hid_mapping map;
    wire_load(&wire, &clock_now, name);
    wire.face.identity.vendor = vendor;
    wire.face.identity.product = product;
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(hid_pose_decoder_init(&decoder, &wire.face, &map, festival_view()), 0);
    now_ms = 1000;
}

/* Returns a report of `size` bytes with the current time. Copies at most HID_REPORT_MAX bytes. */
static inline struct hid_raw raw_of(const uint8_t *bytes, uint32_t size)
{
    struct hid_raw raw = { .time_ns = now_ms * MS, .size = size };
    memcpy(raw.bytes, bytes, size < HID_REPORT_MAX ? size : HID_REPORT_MAX);
    return raw;
}

/* Decodes report `id` with its current payload, then advances the time by 4 ms. Returns 1 if the
 * decoder accepts the report, otherwise 0. */
static inline int send(uint8_t id)
{
    const uint32_t with_id = wire.descriptor.has_report_ids;
    const uint32_t size = (wire.descriptor.report_bits[id] + 7u) / 8u + with_id;
    uint8_t bytes[HID_REPORT_MAX + 1u] = { id };
    memcpy(bytes + with_id, wire.payload[id], size - with_id);
    const struct hid_raw raw = raw_of(bytes, size);
    now_ms += 4;
    return hid_pose_decoder_report(&decoder, &raw);
}

/* Returns the sample after `ms` milliseconds. If there is no sample, the test fails. */
static inline struct poi_sample sample_after(uint64_t ms)
{
    struct poi_sample sample;
    now_ms += ms;
    assert_true(hid_pose_decoder_sample(&decoder, now_ms * MS, &sample));
    return sample;
}

/* Returns the buttons that were pressed since the previous call. */
static inline uint32_t pressed(void)
{
    struct button_sample buttons = { 0 };
    hid_pose_decoder_buttons(&decoder, &buttons);
    return buttons.pressed;
}

#endif
