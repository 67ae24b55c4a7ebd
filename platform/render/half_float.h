/* half_float.h -- converts 32-bit floats to the 16-bit floats of textures (IEEE 754 binary16). The
 * driver would convert each float of an upload with slower code. */
#pragma once

#include <stdint.h>
#include <string.h>

/* Returns the 16-bit float nearest to `value`. Returns 0 if the magnitude of `value` is below
 * 2^-14, the smallest normal 16-bit float. `value` must be below 65504 and finite. */
static inline uint16_t half_float(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    const uint32_t magnitude = bits & 0x7fffffffu;
    const uint32_t sign = bits >> 16u & 0x8000u;
    const uint32_t is_normal = magnitude >= 0x38800000u;
    /* The exponent of a 16-bit float has a bias of 15 in place of 127. */
    const uint32_t rounded = (magnitude - 0x38000000u + 0x1000u) >> 13u;
    return (uint16_t)(is_normal ? sign | rounded : 0u);
}
