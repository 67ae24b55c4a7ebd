/* lab_book.h -- the species data of a kiosk: custom species, and the graphs saved in the growth
 * lab. Plain data, loaded from the data folder at startup. */
#ifndef KINGYO_CORE_GAME_LAB_LAB_BOOK_H
#define KINGYO_CORE_GAME_LAB_LAB_BOOK_H

#include "core/game/lab/lab_edit.h"

struct lab_book {
    uint8_t card_count;            /* Number of custom species, which follow the built-in ones. */
    uint8_t refused;               /* Number of rejected species files, for the operator. */
    uint8_t has_edit[SPECIES_MAX]; /* 1 for each species with a saved edit: the built-in ones,
                                      then the custom ones. */
    struct species_card cards[SPECIES_EXTRA_MAX];
    struct lab_edit edits[SPECIES_MAX];
};

/* Return the number of species, and the card of species `species`, which must be below that
 * number. */
uint32_t lab_book_count(const struct lab_book *book);
const struct species_card *lab_book_card(const struct lab_book *book, uint32_t species);

/* Returns true if all data is valid (lab_validate.c). Every number of each custom card must be
 * within the range of packed species files, and every saved graph must match its species. */
bool lab_book_is_valid(const struct lab_book *book);

uint64_t lab_edit_hash(uint64_t hash, const struct lab_edit *edit);
uint64_t lab_book_hash(uint64_t hash, const struct lab_book *book);

#endif
