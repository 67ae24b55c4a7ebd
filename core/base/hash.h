/* hash.h -- hashes that show whether two states or two files are equal.
 *
 * Bytes use plain FNV-1a. A 32-bit word or a float is hashed in one step and a rotation, which is
 * four times as fast as byte by byte. States are hashed field by field, so padding and byte order
 * have no influence. */
#ifndef KINGYO_CORE_BASE_HASH_H
#define KINGYO_CORE_BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

#include "core/base/vec.h"

#define HASH_START 0xcbf29ce484222325ull

uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size);
uint64_t hash_u32(uint64_t hash, uint32_t value);
uint64_t hash_u64(uint64_t hash, uint64_t value);
/* Hashes a field that older recordings lack. A `value` of 0 leaves `hash` unchanged, so that older
 * recordings keep their hash. `tag` identifies the field and must be unique among the fields of a
 * struct that are hashed by hash_later(). */
uint64_t hash_later(uint64_t hash, uint32_t tag, uint32_t value);
uint64_t hash_float(uint64_t hash, float value); /* Hashes the bits, so -0 and 0 give different
                                                    hashes. */
uint64_t hash_vec3(uint64_t hash, vec3 value);
uint64_t hash_floats(uint64_t hash, const float *values, size_t count);

#endif
