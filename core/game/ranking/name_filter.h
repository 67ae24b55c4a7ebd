/* name_filter.h -- the filter for names that must not appear on the leaderboard.
 *
 * The list of words is assets/words/refused.txt. The build converts the list to a table of
 * normalized words (name_normalize()). The list covers words that are obviously offensive. The
 * operator's menu can remove any other name. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#define REFUSED_LETTERS_MAX 16u /* Length of the longest normalized word of the list. */

struct refused_word {
    /* 1 if the word is rejected only as the whole name, because it is harmless inside other words;
     * otherwise 0. */
    uint8_t is_whole;
    uint8_t count;
    uint16_t letters[REFUSED_LETTERS_MAX];
};

extern const struct refused_word refused_words[];
extern const uint32_t refused_word_count;

/* Returns true if the UTF-8 name must be rejected. A name is rejected if it contains a word of the
 * list, or equals a word with `is_whole` 1. */
bool name_is_refused(const char *utf8);

/* ---- Normalization of names ------------------------------------------------------------------ */

/* Name normalization: maps spellings with similar appearance or sound to one form.
 *
 * Several characters are mapped to one form: full-width and half-width letters, capitals,
 * katakana, small kana, and digits or signs used as letters. Spaces, dots and long-vowel marks are
 * removed. The filter compares normalized names, and the build normalizes its word list with the
 * same function. */

/* Largest number of letters in a normalized name; further letters are ignored. */
#define NAME_NORMALIZE_MAX 32u

enum name_ends {
    NAME_ENDS_KEPT = 0,
    /* Digits and signs at both ends of the name are removed, because they are decoration. */
    NAME_ENDS_TRIMMED,
};

/* Writes the normalized letters of `utf8` to `out` and returns their number. Malformed bytes are
 * skipped. */
uint32_t name_normalize(const char *utf8, enum name_ends ends, uint16_t out[NAME_NORMALIZE_MAX]);

/* Shortens each series of equal letters to one letter, in place. Returns the number of letters
 * left. */
uint32_t name_normalize_spaces(uint16_t *letters, uint32_t count);
