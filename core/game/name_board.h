/* name_board.h -- what a guest writes a name with: fifty letters of one alphabet and four keys.
 *
 * A letter is a code point below U+10000. */
#ifndef KINGYO_CORE_GAME_NAME_BOARD_H
#define KINGYO_CORE_GAME_NAME_BOARD_H

#include <stdint.h>

#include "core/game/overlay.h"
#include "core/ledger.h"

#define NAME_LETTERS_MAX 8u /* As many as are read from across the street on one row of ten. */
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

/* Behind the cells, in the order in which buttons go through them. */
enum name_key {
    NAME_ALPHABET = NAME_CELLS, /* The next alphabet. */
    NAME_CHANGE,                /* The last letter's next form: voiced, small, a capital. */
    NAME_ERASE,
    NAME_DONE,
    NAME_KEY_COUNT,
};

/* The letter in a cell, row by row; 0: none is there. `alphabet` < ALPHABET_COUNT and
 * `cell` < NAME_CELLS, else it asserts. */
uint16_t name_letter(uint8_t alphabet, uint32_t cell);

/* The next of a letter's forms, round and round; itself where it has no other. */
uint16_t name_changed(uint16_t letter);

/* Where a key or cell is on the canvas (overlay.h); empty where a cell has no letter. */
struct overlay_box name_box(int upright, uint8_t alphabet, uint32_t key);

/* The letters as UTF-8, zero-filled. `count` <= NAME_LETTERS_MAX, else it asserts. */
void name_spell(const uint16_t *letters, uint32_t count, char out[LEDGER_NAME_SIZE]);

#endif
