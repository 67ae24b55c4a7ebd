/* hash.h -- hashes that show whether two states or two files are equal.
 *
 * Bytes use plain FNV-1a. A 32-bit word is hashed as a whole, by one step of FNV-1a and a rotation,
 * which takes a quarter of the time of hashing its four bytes. States are hashed field by field
 * (core/base/field.h), so padding and byte order have no influence. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#define HASH_START 0xcbf29ce484222325ull
#define HASH_FNV_PRIME 0x100000001b3ull

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size);
uint64_t hash_u64(uint64_t hash, uint64_t value);

/* Returns `hash` extended by a 32-bit word. The function rotates the hash after the multiplication.
 * Without the rotation, the high bits of a word would never affect the low bits of the hash. */
static inline uint64_t hash_u32(uint64_t hash, uint32_t value)
{
    hash = (hash ^ value) * HASH_FNV_PRIME;
    return (hash << 29) | (hash >> 35);
}
