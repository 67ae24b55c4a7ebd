/* name_filter.c -- compares a normalized name with each word of the list of refused words. */
#include "core/game/ranking/name_filter.h"

#include "core/base/mem.h"
#include "core/game/ranking/name_normalize.h"

struct spelling {
    uint32_t count;
    uint16_t letters[NAME_NORMALIZE_MAX];
};

static int begins(const struct spelling *name, uint32_t at, const struct refused_word *word)
{
    return name->count - at >= word->count &&
           memcmp(name->letters + at, word->letters, word->count * sizeof word->letters[0]) == 0;
}

static int matches_whole_word(const struct spelling *name, const struct refused_word *word)
{
    return name->count == word->count && begins(name, 0, word);
}

static int is_inside(const struct spelling *name, const struct refused_word *word)
{
    for (uint32_t at = 0; at + word->count <= name->count; at++) {
        if (begins(name, at, word)) {
            return 1;
        }
    }
    return 0;
}

static struct spelling spelt(const char *utf8, enum name_ends ends)
{
    struct spelling name;
    name.count = name_normalize(utf8, ends, name.letters);
    return name;
}

static struct refused_word squeezed_word(const struct refused_word *word)
{
    struct refused_word out = *word;
    out.count = (uint8_t)name_normalize_spaces(out.letters, out.count);
    return out;
}

int name_is_refused(const char *utf8)
{
    const struct spelling whole = spelt(utf8, NAME_ENDS_KEPT);
    const struct spelling bare = spelt(utf8, NAME_ENDS_TRIMMED);
    struct spelling squeezed = whole;
    squeezed.count = name_normalize_spaces(squeezed.letters, squeezed.count);
    for (uint32_t i = 0; i < refused_word_count; i++) {
        const struct refused_word *word = &refused_words[i];
        if (word->is_whole ? matches_whole_word(&whole, word) || matches_whole_word(&bare, word)
                           : is_inside(&whole, word)) {
            return 1;
        }
        const struct refused_word thin = squeezed_word(word);
        if (!word->is_whole && thin.count >= 3u && is_inside(&squeezed, &thin)) {
            return 1;
        }
    }
    return 0;
}
