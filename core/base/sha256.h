/* sha256.h -- SHA-256 of a short message, as FIPS 180-4 defines it. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Largest message in bytes. A block has 64 bytes, and the padding takes 9 of them. */
#define SHA256_MESSAGE_MAX 55u
#define SHA256_WORDS 8u

/* Writes the SHA-256 digest of `size` bytes at `message` as big-endian words: the first word holds
 * the first four bytes of the digest. Asserts that `size` is at most SHA256_MESSAGE_MAX. */
void sha256_short(const uint8_t *message, size_t size, uint32_t digest[SHA256_WORDS]);
