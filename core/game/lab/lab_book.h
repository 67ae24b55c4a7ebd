/* lab_book.h -- the lab book: the species data of a kiosk, consisting of custom species and of the
 * graphs saved in the growth lab. The lab book is plain data, loaded from the data folder at
 * startup. */
#ifndef KINGYO_CORE_GAME_LAB_LAB_BOOK_H
#define KINGYO_CORE_GAME_LAB_LAB_BOOK_H

#include "core/game/lab/lab_edit.h"

struct lab_book {
    uint8_t card_count;            /* Number of custom species. The custom species have the indices
                                      after the built-in species. */
    uint8_t refused;               /* Number of rejected species files, displayed to the
                                      operator. */
    uint8_t has_edit[SPECIES_MAX]; /* 1 for each species with a saved edit, otherwise 0. The
                                      built-in species come first, then the custom species. */
    struct species_card cards[SPECIES_EXTRA_MAX];
    struct lab_edit edits[SPECIES_MAX];
};

/* Return the number of species, and the card of species `species`, which must be below that
 * number. */
uint32_t lab_book_count(const struct lab_book *book);
const struct species_card *lab_book_card(const struct lab_book *book, uint32_t species);

/* Returns true if all data is valid (lab_validate.c). Each number of a custom card must be in the
 * range that packed species files permit. Each saved graph must match its species. */
bool lab_book_is_valid(const struct lab_book *book);

uint64_t lab_edit_hash(uint64_t hash, const struct lab_edit *edit);
uint64_t lab_book_hash(uint64_t hash, const struct lab_book *book);

#endif
