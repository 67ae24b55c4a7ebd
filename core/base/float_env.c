/* float_env.c -- checks the float environment: computes eight sums of products, and compares their
 * bits with the required bits. The operands are volatile, so that the compiler cannot compute the
 * sums in advance. */
#include "core/base/float_env.h"

#include <stdint.h>

#include "core/base/panic.h"
#include "core/base/simd.h"

#define CASE_COUNT 8u

/* Bit patterns of floats for one test. The float x * y + z must have exactly the bits of `sum`. */
static const volatile struct {
    uint32_t x, y, z, sum;
} cases[CASE_COUNT] = {
    { 0x00000001, 0x4b800000, 0x00000000, 0x01000000 }, /* Operand x is the smallest denormal number
                                                           and must not be treated as 0. */
    { 0x00800000, 0x3f000000, 0x00000000, 0x00400000 }, /* The product x * y is a denormal number
                                                           and must not become 0. */
    /* The next two tests are the two tests above with negative numbers. */
    { 0x80000001, 0x4b800000, 0x80000000, 0x81000000 },
    { 0x80800000, 0x3f000000, 0x80000000, 0x80400000 },
    /* 1 plus half a unit in the last place. The sum is half way between two floats and must be
     * rounded to 1, whose last bit is 0. */
    { 0x3f800000, 0x3f800000, 0x33800000, 0x3f800000 },
    { 0x3f800000, 0x3f800000, 0x33c00000, 0x3f800001 }, /* 1 plus three quarters of a unit in the
                                                           last place must round up. */
    /* The last two tests are the two rounding tests above with negative numbers. */
    { 0xbf800000, 0x3f800000, 0xb3800000, 0xbf800000 },
    { 0xbf800000, 0x3f800000, 0xb3c00000, 0xbf800001 },
};

static float float_of(uint32_t bits)
{
    float value;
    MEM_COPY(&value, &bits, sizeof value);
    return value;
}

static uint32_t bits_of(float value)
{
    uint32_t bits;
    MEM_COPY(&bits, &value, sizeof bits);
    return bits;
}

/* Computes the test `first` and the next three tests as one vector of four floats. Returns true if
 * all four results have the required bits. */
static bool quad_is_standard(uint32_t first)
{
    fquad x, y, z;
    CORE_ASSERT(first + 4u <= CASE_COUNT);
    for (uint32_t i = 0; i < 4u; i++) {
        x[i] = float_of(cases[first + i].x);
        y[i] = float_of(cases[first + i].y);
        z[i] = float_of(cases[first + i].z);
    }
    const fquad sum = x * y + z;
    bool is_standard = true;
    for (uint32_t i = 0; i < 4u; i++) {
        is_standard &= bits_of(sum[i]) == cases[first + i].sum;
    }
    return is_standard;
}

bool float_env_is_standard(void)
{
    bool is_standard = true;
    for (uint32_t i = 0; i < CASE_COUNT; i++) {
        const float sum = float_of(cases[i].x) * float_of(cases[i].y) + float_of(cases[i].z);
        is_standard &= bits_of(sum) == cases[i].sum;
    }
    return is_standard && quad_is_standard(0) && quad_is_standard(4);
}
