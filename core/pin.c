/* pin.c -- salted hash of a PIN, and the comparison with a typed PIN. */
#include "core/pin.h"

#include "core/base/panic.h"
#include "core/base/sha256.h"

#define SALT_BITS 11u
#define DIGEST_BITS 20u
#define SALT_MASK ((1u << SALT_BITS) - 1u)
#define HIDDEN (1u << (SALT_BITS + DIGEST_BITS))

/* The result is never PIN_WITHHELD, because a salt of 0 is replaced by 1. */
int32_t pin_hide(uint32_t pin, uint32_t salt)
{
    CORE_ASSERT(pin <= PIN_MAX);
    const uint32_t own = (salt & SALT_MASK) != 0 ? salt & SALT_MASK : 1u;
    const uint8_t message[] = { 'k',
                                'i',
                                'n',
                                'g',
                                'y',
                                'o',
                                (uint8_t)(own >> 8),
                                (uint8_t)own,
                                (uint8_t)(pin >> 8),
                                (uint8_t)pin };
    uint32_t digest[SHA256_WORDS];
    if (pin == 0) {
        return 0;
    }
    sha256_short(message, sizeof message, digest);
    return (int32_t)(HIDDEN | own << DIGEST_BITS | digest[0] >> (32u - DIGEST_BITS));
}

bool pin_is_plain(int32_t kept)
{
    return kept > 0 && kept <= PIN_MAX;
}

bool pin_matches(int32_t kept, uint32_t pin)
{
    CORE_ASSERT(pin <= PIN_MAX);
    if (kept == PIN_WITHHELD) {
        return false;
    }
    return kept == (kept >= 0 ? (int32_t)pin : pin_hide(pin, (uint32_t)kept >> DIGEST_BITS));
}
