/* name_filter.c -- compares a normalized name with each word of the list of refused words. */
#include "core/game/ranking/name_filter.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

struct spelling {
    uint32_t count;
    uint16_t letters[NAME_NORMALIZE_MAX];
};

static bool begins(const struct spelling *name, uint32_t at, const struct refused_word *word)
{
    CORE_ASSERT(at <= name->count && name->count <= NAME_NORMALIZE_MAX);
    return name->count - at >= word->count &&
           memcmp(name->letters + at, word->letters, word->count * sizeof word->letters[0]) == 0;
}

static bool is_inside(const struct spelling *name, const struct refused_word *word)
{
    for (uint32_t at = 0; at + word->count <= name->count; at++) {
        if (begins(name, at, word)) {
            return true;
        }
    }
    return false;
}

bool name_is_refused(const char *utf8)
{
    struct spelling whole, bare, squeezed;
    whole.count = name_normalize(utf8, NAME_ENDS_KEPT, whole.letters);
    bare.count = name_normalize(utf8, NAME_ENDS_TRIMMED, bare.letters);
    squeezed = whole;
    squeezed.count = name_normalize_spaces(squeezed.letters, squeezed.count);
    for (uint32_t i = 0; i < refused_word_count; i++) {
        const struct refused_word *word = &refused_words[i];
        struct refused_word thin = *word;
        CORE_ASSERT(word->count > 0 && word->count <= REFUSED_LETTERS_MAX);
        thin.count = (uint8_t)name_normalize_spaces(thin.letters, thin.count);
        const bool is_found =
            word->is_whole
                ? (whole.count == word->count && begins(&whole, 0, word)) ||
                      (bare.count == word->count && begins(&bare, 0, word))
                : is_inside(&whole, word) || (thin.count >= 3u && is_inside(&squeezed, &thin));
        if (is_found) {
            return true;
        }
    }
    return false;
}
