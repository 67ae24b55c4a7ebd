/* sha256.c -- SHA-256 of one block as FIPS 180-4, section 6.2, defines it. */
#include "core/base/sha256.h"

#include "core/base/panic.h"

#define BLOCK_SIZE 64u
#define ROUNDS 64u

static const uint32_t constants[ROUNDS] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

static uint32_t rotate_right(uint32_t word, uint32_t bits)
{
    return word >> bits | word << (32u - bits);
}

/* Pads the message to one block and writes the 64 words of the message schedule to `w`. */
static void make_schedule(const uint8_t *message, size_t size, uint32_t w[ROUNDS])
{
    uint8_t block[BLOCK_SIZE] = { 0 };
    CORE_ASSERT(size < BLOCK_SIZE - 2u);
    for (size_t i = 0; i < size; i++) {
        block[i] = message[i];
    }
    block[size] = 0x80;
    block[BLOCK_SIZE - 2u] = (uint8_t)(size * 8u >> 8);
    block[BLOCK_SIZE - 1u] = (uint8_t)(size * 8u);
    for (uint32_t i = 0; i < 16u; i++) {
        w[i] = (uint32_t)block[4u * i] << 24 | (uint32_t)block[4u * i + 1u] << 16 |
               (uint32_t)block[4u * i + 2u] << 8 | block[4u * i + 3u];
    }
    for (uint32_t i = 16; i < ROUNDS; i++) {
        const uint32_t a = w[i - 15u], b = w[i - 2u];
        w[i] = w[i - 16u] + (rotate_right(a, 7) ^ rotate_right(a, 18) ^ a >> 3) + w[i - 7u] +
               (rotate_right(b, 17) ^ rotate_right(b, 19) ^ b >> 10);
    }
}

void sha256_short(const uint8_t *message, size_t size, uint32_t digest[SHA256_WORDS])
{
    static const uint32_t start[SHA256_WORDS] = { 0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                                  0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19 };
    uint32_t w[ROUNDS], s[SHA256_WORDS];
    CORE_ASSERT(message && size <= SHA256_MESSAGE_MAX);
    make_schedule(message, size, w);
    for (uint32_t i = 0; i < SHA256_WORDS; i++) {
        s[i] = start[i];
    }
    for (uint32_t i = 0; i < ROUNDS; i++) {
        const uint32_t one =
            s[7] + (rotate_right(s[4], 6) ^ rotate_right(s[4], 11) ^ rotate_right(s[4], 25)) +
            ((s[4] & s[5]) ^ (~s[4] & s[6])) + constants[i] + w[i];
        const uint32_t two =
            (rotate_right(s[0], 2) ^ rotate_right(s[0], 13) ^ rotate_right(s[0], 22)) +
            ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
        for (uint32_t k = SHA256_WORDS - 1u; k > 0; k--) {
            s[k] = s[k - 1u];
        }
        s[4] += one;
        s[0] = one + two;
    }
    for (uint32_t i = 0; i < SHA256_WORDS; i++) {
        digest[i] = start[i] + s[i];
    }
}
