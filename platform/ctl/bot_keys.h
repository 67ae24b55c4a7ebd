/* bot_keys.h -- the keys of a bot FILE: each a field of struct technique, what is right for it, and
 * what it means. */
#ifndef KINGYO_PLATFORM_CTL_BOT_KEYS_H
#define KINGYO_PLATFORM_CTL_BOT_KEYS_H

#include <stdint.h>

#include "core/game/technique.h"

#define BOT_KEY_COUNT 20u
#define BOT_KEY_RANGE_MAX 64u

/* The name of a key < BOT_KEY_COUNT, else these assert; and the key of a name, or BOT_KEY_COUNT. */
const char *bot_key_name(uint32_t key);
uint32_t bot_key_named(const char *name);

/* Sets a key's field to what `text` says: 0; or -1 and nothing is changed. */
int bot_key_set(uint32_t key, const char *text, struct technique *technique);

/* What is right for a key: "0 to 1", "over 0 to 2", "any|head|tail". */
void bot_key_range(uint32_t key, char out[BOT_KEY_RANGE_MAX]);

/* Whether two techniques are one: no key of theirs differs. */
int bot_keys_same(const struct technique *a, const struct technique *b);

/* Prints a table of all keys: what is right for each, what novice and expert do, what it means. */
void bot_keys_print(void);

#endif
