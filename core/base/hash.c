/* hash.c -- 64-bit FNV-1a. A 32-bit word costs one multiplication, where plain FNV-1a needs one for
 * each byte. */
#include "core/base/hash.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

#define FNV_PRIME 0x100000001b3ull

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
    const uint8_t *byte = bytes;
    CORE_ASSERT(bytes || size == 0);
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ byte[i]) * FNV_PRIME;
    }
    return hash;
}

/* Rotates the hash after the multiplication. Without the rotation, the high bits of a word would
 * never affect the low bits of the hash. */
uint64_t hash_u32(uint64_t hash, uint32_t value)
{
    hash = (hash ^ value) * FNV_PRIME;
    return (hash << 29) | (hash >> 35);
}

uint64_t hash_later(uint64_t hash, uint32_t tag, uint32_t value)
{
    return value != 0 ? hash_u32(hash_u32(hash, tag), value) : hash;
}

uint64_t hash_u64(uint64_t hash, uint64_t value)
{
    return hash_u32(hash_u32(hash, (uint32_t)value), (uint32_t)(value >> 32));
}

uint64_t hash_float(uint64_t hash, float value)
{
    uint32_t bits;
    MEM_COPY(&bits, &value, sizeof bits);
    return hash_u32(hash, bits);
}

uint64_t hash_vec3(uint64_t hash, vec3 value)
{
    return hash_float(hash_float(hash_float(hash, value.x), value.y), value.z);
}

uint64_t hash_floats(uint64_t hash, const float *values, size_t count)
{
    CORE_ASSERT(values || count == 0);
    for (size_t i = 0; i < count; i++) {
        hash = hash_float(hash, values[i]);
    }
    return hash;
}
