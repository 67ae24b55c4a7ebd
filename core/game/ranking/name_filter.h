/* name_filter.h -- the filter for names that must not appear on the leaderboard.
 *
 * The list of words is assets/words/refused.txt. The build converts the list to a table of
 * normalized words (name_normalize.h). The list covers words that are obviously offensive. The
 * operator's menu can remove any other name. */
#ifndef KINGYO_CORE_GAME_RANKING_NAME_FILTER_H
#define KINGYO_CORE_GAME_RANKING_NAME_FILTER_H

#include <stdint.h>

#define REFUSED_LETTERS_MAX 16u /* Length of the longest normalized word of the list. */

struct refused_word {
    uint8_t is_whole; /* 1 if the word is rejected only as the whole name, because it is harmless
                         inside other words; otherwise 0. */
    uint8_t count;
    uint16_t letters[REFUSED_LETTERS_MAX];
};

extern const struct refused_word refused_words[];
extern const uint32_t refused_word_count;

/* Returns 1 if the UTF-8 name must be rejected, otherwise 0. A name is rejected if it contains a
 * word of the list, or equals a word with `is_whole` 1. */
int name_is_refused(const char *utf8);

#endif
