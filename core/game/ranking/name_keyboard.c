/* name_keyboard.c -- the letters of the on-screen keyboard, their forms and their positions. */
#include "core/game/ranking/name_keyboard.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/printable.h"

#define HOLE 0x3000u /* Full-width space, which marks an empty cell in the tables. */
/* Offset from the code point of a hiragana to the code point of its katakana. */
#define KATAKANA_AFTER 0x60u
#define KATAKANA_FIRST 0x30a1u
#define KATAKANA_LAST 0x30f3u

/* Letters of each alphabet, in the order that is usual in kana tables and in arcade games. */
static const uint16_t letters[ALPHABET_COUNT][NAME_CELLS + 1u] = {
    [ALPHABET_HIRAGANA] = u"あいうえおはひふへほ"
                          u"かきくけこまみむめも"
                          u"さしすせそや　ゆ　よ"
                          u"たちつてとらりるれろ"
                          u"なにぬねのわをんー・",
    [ALPHABET_KATAKANA] = u"アイウエオハヒフヘホ"
                          u"カキクケコマミムメモ"
                          u"サシスセソヤ　ユ　ヨ"
                          u"タチツテトラリルレロ"
                          u"ナニヌネノワヲンー・",
    [ALPHABET_LATIN] = u"ABCDEFGHIJ"
                       u"KLMNOPQRST"
                       u"UVWXYZ-.!?"
                       u"0123456789"
                       u"　　　　　　　　　　",
};

/* Different forms of the same letter, such as voiced and small kana. The forms of one letter are a
 * group, and spaces separate the groups. */
static const uint16_t forms[] = u"あぁ いぃ うぅ えぇ おぉ やゃ ゆゅ よょ わゎ "
                                u"かが きぎ くぐ けげ こご さざ しじ すず せぜ そぞ "
                                u"ただ ちぢ つっづ てで とど はばぱ ひびぴ ふぶぷ へべぺ ほぼぽ";

uint16_t name_letter(uint8_t alphabet, uint32_t cell)
{
    CORE_ASSERT(alphabet < ALPHABET_COUNT);
    CORE_ASSERT(cell < NAME_CELLS);
    const uint16_t letter = letters[alphabet][cell];
    return letter == HOLE ? 0u : letter;
}

static uint16_t changed_kana(uint16_t letter)
{
    uint32_t first = 0; /* Index in `forms` of the first form in the letter's group. */
    for (uint32_t i = 0; forms[i] != 0; i++) {
        if (forms[i] == ' ') {
            first = i + 1u;
        } else if (forms[i] == letter) {
            const uint16_t next = forms[i + 1u];
            return next == ' ' || next == 0 ? forms[first] : next;
        }
    }
    return letter;
}

uint16_t name_changed(uint16_t letter)
{
    if ((letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z')) {
        return letter ^ 0x20u;
    }
    if (letter >= KATAKANA_FIRST && letter <= KATAKANA_LAST) {
        return (uint16_t)(changed_kana((uint16_t)(letter - KATAKANA_AFTER)) + KATAKANA_AFTER);
    }
    return changed_kana(letter);
}

/* Boxes and distances of the keyboard's keys that differ between the wide and the portrait
 * canvas. */
struct measures {
    struct layout_box cell; /* Box of the first letter. */
    /* Distance between two neighbouring letters in a row (x) and in a column (y). */
    struct layout_point pitch;
    struct layout_box key; /* Box of the first function key. */
    float key_pitch;       /* Distance between two neighbouring function keys. */
};

static const struct measures wide = {
    .cell = { 163.0f, 200.0f, 90.0f, 70.0f },
    .pitch = { 96.0f, 76.0f },
    .key = { 162.0f, 598.0f, 224.0f, 70.0f },
    .key_pitch = 244.0f,
};
static const struct measures upright_measures = {
    .cell = { 30.0f, 470.0f, 74.0f, 96.0f },
    .pitch = { 80.0f, 104.0f },
    .key = { 31.0f, 1030.0f, 186.0f, 110.0f },
    .key_pitch = 202.0f,
};

struct layout_box name_box(bool upright, uint8_t alphabet, uint32_t key)
{
    const struct measures *m = upright ? &upright_measures : &wide;
    CORE_ASSERT(key < NAME_KEY_COUNT);
    if (key >= NAME_CELLS) {
        struct layout_box box = m->key;
        box.x += (float)(key - NAME_CELLS) * m->key_pitch;
        return box;
    }
    if (name_letter(alphabet, key) == 0) {
        return (struct layout_box){ 0.0f, 0.0f, 0.0f, 0.0f };
    }
    struct layout_box box = m->cell;
    box.x += (float)(key % NAME_COLUMNS) * m->pitch.x;
    box.y += (float)(key / NAME_COLUMNS) * m->pitch.y;
    return box;
}

void name_spell(const uint16_t *spelt, uint32_t count, char out[LEDGER_NAME_SIZE])
{
    CORE_ASSERT(count <= NAME_LETTERS_MAX);
    memset(out, 0, LEDGER_NAME_SIZE);
    for (uint32_t i = 0; i < count; i++) {
        out = printable_put(out, spelt[i]);
    }
}
