/* hash.c -- 64-bit FNV-1a of bytes and of 64-bit numbers. */
#include "core/base/hash.h"

#include "core/base/panic.h"

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
    const uint8_t *byte = bytes;
    CORE_ASSERT(bytes || size == 0);
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ byte[i]) * HASH_FNV_PRIME;
    }
    return hash;
}

uint64_t hash_u64(uint64_t hash, uint64_t value)
{
    return hash_u32(hash_u32(hash, (uint32_t)value), (uint32_t)(value >> 32));
}
