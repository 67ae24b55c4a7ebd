/* hid_wire.h -- a simulated controller with a real HID report descriptor, for tests of the decoder
 * and the game. A test selects the fields of a report by their usages, and not by their bit
 * positions. Reports are always sent with their full length. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_HID_WIRE_H
#define KINGYO_TESTS_UNIT_SUPPORT_HID_WIRE_H

#include <stdio.h>
#include <string.h>

#include "drivers/hid/hid_mapping_auto.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/hid_sim.h"

#define CORPUS "tests/hid/good/descriptors/"
#define KNOWN "../../known/"

struct hid_wire {
    struct hid_device_info face;
    struct hid_descriptor descriptor;
    struct hid_port_sim port;
    uint8_t payload[256][HID_REPORT_MAX]; /* Payload of each report, indexed by report id. */
};

/* Initializes a controller with the report descriptor `bytes`. Fails the test if the descriptor is
 * invalid. */
static inline void wire_begin(struct hid_wire *wire, struct clock_sim *clock, const uint8_t *bytes,
                              uint32_t size)
{
    memset(wire, 0, sizeof *wire);
    assert_true(size > 0 && size <= HID_DESCRIPTOR_MAX);
    memcpy(wire->face.descriptor, bytes, size);
    wire->face.descriptor_size = size;
    assert_int_equal(hid_descriptor_read(&wire->descriptor, bytes, size), HID_OK);
    hid_port_sim_init(&wire->port, sim_clock_device(clock), &wire->face);
}

/* Initializes a controller with the report descriptor in file NAME.hid of the corpus. `name` is the
 * file name without the suffix, for example "016-ci-dualsense". */
static inline void wire_load(struct hid_wire *wire, struct clock_sim *clock, const char *name)
{
    char path[256];
    uint8_t bytes[HID_DESCRIPTOR_MAX];
    uint32_t size = 0;
    unsigned byte;
    snprintf(path, sizeof path, CORPUS "%s.hid", name);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (size < sizeof bytes && fscanf(file, "%2x", &byte) == 1) {
        bytes[size++] = (uint8_t)byte;
    }
    fclose(file);
    wire_begin(wire, clock, bytes, size);
}

/* Writes the lowest `size` bits of `value` at the bit `offset` of report `id`. */
static inline void wire_put_bits(struct hid_wire *wire, uint8_t id, uint32_t offset, uint32_t size,
                                 int64_t value)
{
    for (uint32_t i = 0; i < size; i++) {
        uint8_t *byte = &wire->payload[id][(offset + i) / 8u];
        const uint8_t bit = (uint8_t)(1u << (offset + i) % 8u);
        *byte = (uint8_t)((uint64_t)value >> i & 1u ? *byte | bit : *byte & ~bit);
    }
}

/* Writes `value` to the first field with the usage `usage` in report `id`. An `id` of -1 means any
 * report. Returns the id of the report that contains the field. */
static inline uint8_t wire_put(struct hid_wire *wire, int id, hid_usage usage, int64_t value)
{
    const struct hid_field_location spot =
        hid_mapping_auto_find(&wire->descriptor, 0, id, id >= 0, usage);
    assert_non_null(spot.group);
    wire_put_bits(wire, spot.group->report_id,
                  spot.group->bit_offset + spot.index * spot.group->bit_size, spot.group->bit_size,
                  value);
    return spot.group->report_id;
}

/* Sends report `id` with its current payload. */
static inline void wire_send(struct hid_wire *wire, uint8_t id)
{
    const uint32_t with_id = wire->descriptor.has_report_ids;
    const uint32_t size = (wire->descriptor.report_bits[id] + 7u) / 8u + with_id;
    uint8_t bytes[HID_REPORT_MAX + 1u] = { id };
    assert_in_range(size, 1, HID_REPORT_MAX);
    memcpy(bytes + with_id, wire->payload[id], size - with_id);
    hid_port_sim_report(&wire->port, bytes, size);
}

/* Returns the value at the fraction `share` of the field's logical range: 0 gives the minimum, and
 * 1 gives the maximum. */
static inline int64_t wire_share(const struct hid_wire *wire, int id, hid_usage usage, float share)
{
    const struct hid_field_location spot =
        hid_mapping_auto_find(&wire->descriptor, 0, id, id >= 0, usage);
    assert_non_null(spot.group);
    const float low = (float)spot.group->logical_min, high = (float)spot.group->logical_max;
    return (int64_t)(low + share * (high - low) + 0.5f);
}

#endif
