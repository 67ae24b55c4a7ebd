/* pin.h -- the operator's PIN as the settings store it: salted and hashed.
 *
 * SET_PIN has three forms. 0: no PIN is required. 1 .. 9999: a PIN in plain digits, from the
 * configuration file or from a database of an older Kingyo. Negative: bit 31, 11 bits of salt, and
 * the first 20 bits of SHA-256 over salt and PIN. Four digits can be guessed quickly from any hash,
 * so the hash protects only against a casual reader. File modes and the lockout time protect
 * against the rest. With a probability of 1 % one of the other 9,998 PINs has the same hash, which
 * does not help a guesser. */
#ifndef KINGYO_CORE_PIN_H
#define KINGYO_CORE_PIN_H

#include <stdint.h>

#define PIN_MAX 9999

/* A stored value that matches no PIN. PIN_WITHHELD replaces the true value where it must not
 * appear, such as in the replay of a score. */
#define PIN_WITHHELD INT32_MIN

/* Returns the stored form of `pin`; 0 for `pin` 0. `pin` must be <= PIN_MAX, else the function
 * asserts. Only the lowest 11 bits of `salt` are used. */
int32_t pin_hide(uint32_t pin, uint32_t salt);

/* Returns 1 if the stored value is a PIN in plain digits, else 0. */
int pin_is_plain(int32_t kept);

/* Returns 1 if `pin` matches the stored value `kept`, else 0. */
int pin_matches(int32_t kept, uint32_t pin);

#endif
