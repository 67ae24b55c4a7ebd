/* name_filter.h -- filter for names that must not appear on the leaderboard.
 *
 * The list is assets/words/refused.txt, built into a table of normalized words (name_normalize.h).
 * The list covers words that offend at first sight; the operator's menu can remove any other
 * name. */
#ifndef KINGYO_CORE_GAME_RANKING_NAME_FILTER_H
#define KINGYO_CORE_GAME_RANKING_NAME_FILTER_H

#include <stdint.h>

#define REFUSED_LETTERS_MAX 16u /* Longest normalized word of the list. */

struct refused_word {
    uint8_t is_whole; /* 1: rejected only as the whole name, because the word is harmless inside
                         other words. */
    uint8_t count;
    uint16_t letters[REFUSED_LETTERS_MAX];
};

extern const struct refused_word refused_words[];
extern const uint32_t refused_word_count;

/* Returns 1 if a name (UTF-8) contains, or equals, a word of the list. */
int name_is_refused(const char *utf8);

#endif
