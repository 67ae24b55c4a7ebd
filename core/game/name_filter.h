/* name_filter.h -- which names do not hang on the stall's wall.
 *
 * The list is assets/words/refused.txt, baked into a table of folded words (name_fold.h). It is for
 * what a passer-by would mind at first sight; the operator's menu takes down the rest. */
#ifndef KINGYO_CORE_GAME_NAME_FILTER_H
#define KINGYO_CORE_GAME_NAME_FILTER_H

#include <stdint.h>

#define REFUSED_LETTERS_MAX 16u /* Of one word of the list, folded. */

struct refused_word {
    uint8_t is_whole; /* Only when it is the whole name: inside others it is harmless. */
    uint8_t count;
    uint16_t letters[REFUSED_LETTERS_MAX];
};

extern const struct refused_word refused_words[];
extern const uint32_t refused_word_count;

/* Whether a name (UTF-8) holds, or is, a word of the list. */
int name_is_refused(const char *utf8);

#endif
