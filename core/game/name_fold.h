/* name_fold.h -- a name as it sounds and looks, whatever it is written with.
 *
 * Wide and narrow letters, capitals, katakana, small kana, digits and signs that stand for letters
 * are all one; spaces, dots and long marks are nothing. What is refused (name_filter.h) is compared
 * so, and the list of it is folded by the same function when it is baked. */
#ifndef KINGYO_CORE_GAME_NAME_FOLD_H
#define KINGYO_CORE_GAME_NAME_FOLD_H

#include <stdint.h>

#define NAME_FOLD_MAX 32u /* Letters; what is behind them is not looked at. */

enum name_ends {
    NAME_ENDS_KEPT = 0,
    NAME_ENDS_TRIMMED, /* Digits and signs at both ends are an ornament. */
};

/* Fills `out` and returns how many letters it has. Malformed bytes are nothing. */
uint32_t name_fold(const char *utf8, enum name_ends ends, uint16_t out[NAME_FOLD_MAX]);

/* Takes repeated letters out; returns how many are left. */
uint32_t name_squeeze(uint16_t *letters, uint32_t count);

#endif
