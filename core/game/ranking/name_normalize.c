/* name_normalize.c -- maps width, case, kana and similar characters to one form. */
#include "core/game/ranking/name_filter.h"

#include "core/base/printable.h"

/* Offset from the code point of a hiragana to the code point of its katakana. */
#define KATAKANA_AFTER 0x60u

static uint16_t narrowed(uint16_t letter)
{
    static const uint16_t kana[] = /* Hiragana for the half-width katakana U+FF66 .. U+FF9D.
                                      Small kana are replaced by normal kana. */
        u"をあいうえおやゆよつーあいうえおかきくけこさしすせそ"
        u"たちつてとなにぬねのはひふへほまみむめもやゆよらりるれろわん";
    if (letter >= 0xff01u && letter <= 0xff5eu) {
        return (uint16_t)(letter - 0xfee0u);
    }
    return letter >= 0xff66u && letter <= 0xff9du ? kana[letter - 0xff66u] : letter;
}

static uint16_t hiragana(uint16_t letter)
{
    static const uint16_t small[] = u"ぁぃぅぇぉっゃゅょゎ";
    if (letter >= 0x30a1u && letter <= 0x30f4u) {
        letter = (uint16_t)(letter - KATAKANA_AFTER);
    }
    for (uint32_t i = 0; small[i] != 0; i++) {
        if (small[i] == letter) {
            /* Replace a small kana by the normal kana, which has the next code point. */
            return (uint16_t)(letter + 1u);
        }
    }
    return letter;
}

static bool is_latin(uint16_t letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

static bool is_kana(uint16_t letter)
{
    return letter >= 0x3041u && letter <= 0x3094u;
}

uint32_t name_normalize(const char *utf8, enum name_ends ends, uint16_t out[NAME_NORMALIZE_MAX])
{
    /* Pairs of a digit, a sign or `l`, and the letter that it resembles. `l` is mapped to `i`
     * because `l` resembles `I`. */
    static const char signs[] = "0o1i2z3e4a5s6b7t8b9g@a$s!i|i+tli";
    /* `count` is the number of letters so far. `end` is the same number without decoration (digits
     * and signs) at the end of the name. */
    uint32_t count = 0, end = 0;
    while (*utf8 != 0 && count < NAME_NORMALIZE_MAX) {
        const uint32_t point = printable_next(&utf8);
        /* Characters above U+FFFF do not fit into 16 bits and become PRINTABLE_MALFORMED. The loop
         * skips this value, because it keeps only Latin letters and kana. */
        const uint16_t raw = (uint16_t)(point <= 0xffffu ? point : PRINTABLE_MALFORMED);
        /* True for a half-width voicing mark. */
        const bool is_voicing = raw == 0xff9eu || raw == 0xff9fu;
        if (is_voicing && count > 0 && is_kana(out[count - 1u])) {
            out[count - 1u] = (uint16_t)(out[count - 1u] + raw - 0xff9du);
            continue;
        }
        const uint16_t letter = hiragana(narrowed(raw));
        const bool is_plain = is_latin(letter) || is_kana(letter);
        uint16_t folded = letter >= 'A' && letter <= 'Z' ? (uint16_t)(letter | 0x20u) : letter;
        for (uint32_t i = 0; signs[i] != 0; i += 2u) {
            if ((uint16_t)signs[i] == folded) {
                folded = (uint16_t)signs[i + 1u];
                break;
            }
        }
        if ((is_latin(folded) || is_kana(folded)) &&
            (is_plain || count > 0 || ends == NAME_ENDS_KEPT)) {
            out[count++] = folded;
        }
        end = is_plain ? count : end;
    }
    return ends == NAME_ENDS_TRIMMED ? end : count;
}

uint32_t name_normalize_spaces(uint16_t *letters, uint32_t count)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (kept == 0 || letters[kept - 1u] != letters[i]) {
            letters[kept++] = letters[i];
        }
    }
    return kept;
}
