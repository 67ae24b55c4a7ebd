/* name_keyboard.h -- the on-screen keyboard of the name entry, with fifty letters of one alphabet
 * and four function keys.
 *
 * A letter is a Unicode code point below U+10000. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/pointer_mapping.h"
#include "core/ledger.h"

/* Largest number of letters of a name. On a leaderboard with ten rows, eight letters are readable
 * from across the street. */
#define NAME_LETTERS_MAX 8u
_Static_assert(3u * NAME_LETTERS_MAX < LEDGER_NAME_SIZE, "three bytes a letter, and the zero");

enum name_alphabet {
    ALPHABET_HIRAGANA = 0,
    ALPHABET_KATAKANA,
    ALPHABET_LATIN,
    ALPHABET_COUNT,
};

#define NAME_COLUMNS 10u
#define NAME_ROWS 5u
#define NAME_CELLS (NAME_COLUMNS * NAME_ROWS)

/* Function keys of the keyboard. The numbers of the function keys follow the numbers of the letter
 * cells. LEFT and RIGHT move from key to key in the order of the numbers. */
enum name_key {
    NAME_ALPHABET = NAME_CELLS, /* Switches to the next alphabet. */
    /* Changes the last letter to its next form: a voiced or small kana, or a capital letter. */
    NAME_CHANGE,
    NAME_ERASE,
    NAME_DONE,
    NAME_KEY_COUNT,
};

/* Returns the letter in cell `cell`, counted row by row; 0 means an empty cell. Asserts that
 * `alphabet` < ALPHABET_COUNT and `cell` < NAME_CELLS. */
uint16_t name_letter(uint8_t alphabet, uint32_t cell);

/* Returns the next form of a letter; the first form follows the last form. A letter with one form
 * is returned unchanged. */
uint16_t name_changed(uint16_t letter);

/* Returns the box of key `key` (the index of a cell, or an enum name_key) on the canvas
 * (pointer_mapping.h). The box of an empty cell is empty. */
struct layout_box name_box(bool upright, uint8_t alphabet, uint32_t key);

/* Writes the letters as UTF-8, padded with zeros. Asserts that `count` <= NAME_LETTERS_MAX. */
void name_spell(const uint16_t *letters, uint32_t count, char out[LEDGER_NAME_SIZE]);
