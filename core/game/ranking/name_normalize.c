/* name_normalize.c -- maps width, case, kana and similar characters to one form. */
#include "core/game/ranking/name_normalize.h"

#include "core/base/printable.h"

/* Offset from the code point of a hiragana to the code point of its katakana. */
#define KATAKANA_AFTER 0x60u

static uint16_t narrowed(uint16_t letter)
{
    static const uint16_t kana[] = /* Hiragana for U+FF66 .. U+FF9D. Small kana are replaced by
                                      normal kana. */
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
            return (uint16_t)(letter + 1u); /* The normal kana has the code point after the small
                                               kana. */
        }
    }
    return letter;
}

/* Returns the letter that a digit or sign represents, or the small letter of a capital. `l` is
 * mapped to `i` because `l` resembles `I`. */
static uint16_t stood_for(uint16_t letter)
{
    static const char signs[] = "0o1i2z3e4a5s6b7t8b9g@a$s!i|i+tli";
    if (letter >= 'A' && letter <= 'Z') {
        letter = (uint16_t)(letter | 0x20u);
    }
    for (uint32_t i = 0; signs[i] != 0; i += 2u) {
        if ((uint16_t)signs[i] == letter) {
            return (uint16_t)signs[i + 1u];
        }
    }
    return letter;
}

static int is_latin(uint16_t letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

static int is_kana(uint16_t letter)
{
    return letter >= 0x3041u && letter <= 0x3094u;
}

/* Applies a half-width voicing mark to the previous kana. Returns 1 if `letter` is a voicing mark,
 * otherwise 0. */
static int voices_last(uint16_t letter, uint16_t *out, uint32_t count)
{
    if ((letter != 0xff9eu && letter != 0xff9fu) || count == 0 || !is_kana(out[count - 1u])) {
        return 0;
    }
    out[count - 1u] = (uint16_t)(out[count - 1u] + letter - 0xff9du);
    return 1;
}

uint32_t name_normalize(const char *utf8, enum name_ends ends, uint16_t out[NAME_NORMALIZE_MAX])
{
    uint32_t count = 0, end = 0; /* Number of letters up to the last letter that is not
                                    decoration. */
    while (*utf8 != 0 && count < NAME_NORMALIZE_MAX) {
        const uint32_t point = printable_next(&utf8);
        /* Letters above U+FFFF are not distinguished, because none of them has another form. */
        const uint16_t raw = (uint16_t)(point <= 0xffffu ? point : PRINTABLE_MALFORMED);
        if (voices_last(raw, out, count)) {
            continue;
        }
        const uint16_t letter = hiragana(narrowed(raw));
        const int is_plain = is_latin(letter) || is_kana(letter);
        const uint16_t folded = is_kana(letter) ? letter : stood_for(letter);
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
