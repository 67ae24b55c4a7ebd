/* name_normalize.h -- name normalization: maps spellings with similar appearance or sound to one
 * form.
 *
 * Several characters are mapped to one form: full-width and half-width letters, capitals, katakana,
 * small kana, and digits or signs used as letters. Spaces, dots and long-vowel marks are removed.
 * The filter (name_filter.h) compares normalized names, and the build normalizes its word list with
 * the same function. */
#ifndef KINGYO_CORE_GAME_RANKING_NAME_NORMALIZE_H
#define KINGYO_CORE_GAME_RANKING_NAME_NORMALIZE_H

#include <stdint.h>

/* Largest number of letters in a normalized name; further letters are ignored. */
#define NAME_NORMALIZE_MAX 32u

enum name_ends {
    NAME_ENDS_KEPT = 0,
    NAME_ENDS_TRIMMED, /* Digits and signs at both ends are removed as decoration. */
};

/* Writes the normalized letters of `utf8` to `out` and returns their number. Malformed bytes are
 * skipped. */
uint32_t name_normalize(const char *utf8, enum name_ends ends, uint16_t out[NAME_NORMALIZE_MAX]);

/* Replaces successive equal letters by one letter, in place. Returns the number of letters left. */
uint32_t name_normalize_spaces(uint16_t *letters, uint32_t count);

#endif
