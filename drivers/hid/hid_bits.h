/* hid_bits.h -- reads bit fields at any bit offset of a report. */
#ifndef KINGYO_DRIVERS_HID_HID_BITS_H
#define KINGYO_DRIVERS_HID_HID_BITS_H

#include <stdint.h>

/* Returns the `size` bits (1 to 32) that start at bit `offset` of `bytes`, least significant bit
 * first. Reads only the bytes that contain the field, at most five. */
static inline uint32_t hid_bits_at(const uint8_t *bytes, uint32_t offset, uint32_t size)
{
    const uint32_t first = offset / 8u, last = (offset + size - 1u) / 8u;
    uint64_t word = 0;
    for (uint32_t i = first; i <= last; i++) {
        word |= (uint64_t)bytes[i] << (8u * (i - first));
    }
    return (uint32_t)(word >> offset % 8u & ((1ull << size) - 1u));
}

/* Returns the `size`-bit number `bits` as two's complement. */
static inline int64_t hid_signed_bits(uint32_t bits, uint32_t size)
{
    const int64_t half = (int64_t)1 << (size - 1u);
    return bits >= half ? (int64_t)bits - 2 * half : (int64_t)bits;
}

#endif
