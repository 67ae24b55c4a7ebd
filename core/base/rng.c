/* rng.c -- a counter-based random generator: hashes the four words of a key into one number. */
#include "core/base/rng.h"

/* Mixes the bits of a 32-bit word, so that every input bit affects every output bit. The function
 * is the final step of an integer hash with low bias. */
static uint32_t mix(uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

uint32_t rng_u32(struct rng_key key)
{
    uint32_t x = mix(key.seed + 0x9e3779b9u);
    x = mix(x ^ (key.tick + 0x85ebca6bu));
    x = mix(x ^ (key.who * 0xc2b2ae35u + 0x27d4eb2fu));
    return mix(x ^ (key.purpose * 0x165667b1u + 0x9e3779b9u));
}

float rng_unit(struct rng_key key)
{
    return (float)(rng_u32(key) >> 8) * (1.0f / 16777216.0f);
}

float rng_range(struct rng_key key, float low, float high)
{
    return low + (high - low) * rng_unit(key);
}

/* Returns the sum of twelve uniform numbers minus 6 (Irwin-Hall distribution). The sum is nearly
 * normal, needs no logarithm and is limited to six standard deviations. */
float rng_normal(struct rng_key key)
{
    float sum = -6.0f;
    for (uint32_t i = 0; i < 12; i++) {
        const struct rng_key part = { key.seed, key.tick, key.who, key.purpose + 256u * (i + 1u) };
        sum += rng_unit(part);
    }
    return sum;
}
