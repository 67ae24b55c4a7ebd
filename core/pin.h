/* pin.h -- the operator's PIN in its stored form: salted and hashed.
 *
 * The setting SET_PIN has three forms:
 * - 0 means that no PIN is required.
 * - 1 .. 9999 is a PIN in plain digits, from the configuration file or from a database of an older
 * Kingyo.
 * - A negative value has bit 31 set, 11 bits of salt, and the first 20 bits of SHA-256 over salt
 * and PIN.
 *
 * Any hash of four digits can be guessed quickly, so the hash protects only against a casual
 * reader. File permissions and the lockout time protect against other readers. With a probability
 * of 1 % one of the other 9,998 PINs has the same hash, which does not help a guesser. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#define PIN_MAX 9999

/* Stored value that matches no PIN. PIN_WITHHELD replaces the stored PIN where the PIN must not
 * appear, such as in the replay of a score. */
#define PIN_WITHHELD INT32_MIN

/* Returns the stored form of `pin`, or 0 if `pin` is 0. Asserts that `pin` <= PIN_MAX. Only the
 * lowest 11 bits of `salt` are used. */
int32_t pin_hide(uint32_t pin, uint32_t salt);

/* Returns true if the stored value `kept` is a PIN in plain digits. */
bool pin_is_plain(int32_t kept);

/* Returns true if `pin` matches the stored value `kept`. */
bool pin_matches(int32_t kept, uint32_t pin);
