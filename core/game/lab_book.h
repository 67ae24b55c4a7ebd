/* lab_book.h -- what a stall knows of species beyond those built in: the makers' own, and the
 * graphs that were saved in the growth lab. Plain data, read from the data folder at start. */
#ifndef KINGYO_CORE_GAME_LAB_BOOK_H
#define KINGYO_CORE_GAME_LAB_BOOK_H

#include "core/game/lab_edit.h"

struct lab_book {
    uint8_t card_count;              /* Makers' species, after the built-in ones. */
    uint8_t refused;                 /* Files that were there and no species; for the operator. */
    uint8_t has_edit[SPECIES_MAX];   /* By species: the built-in ones, then the makers'. */
    struct species_card cards[SPECIES_EXTRA_MAX];
    struct lab_edit edits[SPECIES_MAX];
};

/* How many species there are to look at, and the card of one of them. */
uint32_t lab_book_count(const struct lab_book *book);
const struct species_card *lab_book_card(const struct lab_book *book, uint32_t species);

/* lab_vet.c: whether all of it can be worked with: every number of every maker's card is in the
 * range that packed species are held to, and every saved graph is one of its species. */
bool lab_book_is_good(const struct lab_book *book);

uint64_t lab_edit_hash(uint64_t hash, const struct lab_edit *edit);
uint64_t lab_book_hash(uint64_t hash, const struct lab_book *book);

#endif
