/* bot_keys.h -- the keys of a bot file.
 *
 * Each key names a field of struct technique, which describes how a bot (a simulated player) plays.
 * A key has an allowed range and a description. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_BOT_KEYS_H
#define KINGYO_PLATFORM_CTL_PLAY_BOT_KEYS_H

#include <stdint.h>

#include "core/game/bot/technique.h"

/* Number of keys. Keys are numbered from 0. */
#define BOT_KEY_COUNT 20u

/* Size in bytes of the buffer for bot_key_range(). */
#define BOT_KEY_RANGE_MAX 64u

/* Returns the name of a key. Asserts that `key` is below BOT_KEY_COUNT. */
const char *bot_key_name(uint32_t key);

/* Returns the number of the key called `name`, or BOT_KEY_COUNT if there is no such key. */
uint32_t bot_key_named(const char *name);

/* Parses `text` and stores the value in the field of `technique` that `key` names. Returns 0. If
 * the text is invalid, leaves `technique` unchanged and returns -1. */
int bot_key_set(uint32_t key, const char *text, struct technique *technique);

/* Writes the allowed values of a key to `out`, for example "0 to 1", "over 0 to 2" or
 * "any|head|tail". */
void bot_key_range(uint32_t key, char out[BOT_KEY_RANGE_MAX]);

/* Returns 1 if two techniques have the same value for every key, otherwise 0. */
int bot_keys_same(const struct technique *a, const struct technique *b);

/* Prints a table of all keys on standard output, with the allowed values, the values of the novice
 * and the expert, and the descriptions. */
void bot_keys_print(void);

#endif
