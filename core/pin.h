/* pin.h -- the operator's PIN as the settings keep it: salted and hashed.
 *
 * The value of SET_PIN is 0 (no PIN is asked for), 1 to 9999 (a PIN in plain digits, from the
 * configuration file or from a database of an older Kingyo), or negative: bit 31, 11 bits of salt,
 * and the first 20 bits of SHA-256 over salt and PIN. Four digits are soon guessed from any hash.
 * The hash keeps the PIN from a casual reader; file modes and the waiting time protect it. Of the
 * 9,999 PINs another one opens the menu as well with a chance of 1 %, which no guesser can use. */
#ifndef KINGYO_CORE_PIN_H
#define KINGYO_CORE_PIN_H

#include <stdint.h>

#define PIN_MAX 9999

/* A kept value that matches no PIN: stands for a PIN where the true value must not be, such as in
 * the replay of a score. */
#define PIN_WITHHELD INT32_MIN

/* Returns the value that is kept for `pin`, at most PIN_MAX (else it asserts); 0 for 0. Any `salt`;
 * its lowest 11 bits count. */
int32_t pin_hide(uint32_t pin, uint32_t salt);

/* Whether a kept value is a PIN in plain digits. */
int pin_is_plain(int32_t kept);

/* Whether `pin` opens what `kept` closes. */
int pin_matches(int32_t kept, uint32_t pin);

#endif
