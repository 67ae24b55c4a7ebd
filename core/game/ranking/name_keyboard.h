/* name_keyboard.h -- the on-screen keyboard of the name entry: fifty letters of one alphabet and
 * four function keys.
 *
 * A letter is a code point below U+10000. */
#ifndef KINGYO_CORE_GAME_RANKING_NAME_KEYBOARD_H
#define KINGYO_CORE_GAME_RANKING_NAME_KEYBOARD_H

#include <stdint.h>

#include "core/game/pointer_mapping.h"
#include "core/ledger.h"

/* Number of letters that remain readable on a row of ten from across the street. */
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

/* Function keys, after the cells, in the order in which the buttons step. */
enum name_key {
    NAME_ALPHABET = NAME_CELLS, /* Switches to the next alphabet. */
    NAME_CHANGE,                /* Changes the last letter to its next form: voiced, small, or
                                   capital. */
    NAME_ERASE,
    NAME_DONE,
    NAME_KEY_COUNT,
};

/* Returns the letter in a cell, row by row; 0: empty cell. `alphabet` must be < ALPHABET_COUNT and
 * `cell` < NAME_CELLS, else the function asserts. */
uint16_t name_letter(uint8_t alphabet, uint32_t cell);

/* Returns the next form of a letter, wrapping around; the letter itself if it has one form. */
uint16_t name_changed(uint16_t letter);

/* Returns the box of a key or cell on the canvas (pointer_mapping.h); an empty box for an empty
 * cell. */
struct layout_box name_box(int upright, uint8_t alphabet, uint32_t key);

/* Writes the letters as UTF-8, padded with zeros. `count` must be <= NAME_LETTERS_MAX, else the
 * function asserts. */
void name_spell(const uint16_t *letters, uint32_t count, char out[LEDGER_NAME_SIZE]);

#endif
