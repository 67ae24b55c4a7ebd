/* test_name_filter.c -- checks which names are accepted for the leaderboard and which are
 * rejected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/printable.h"
#include "core/game/ranking/name_filter.h"

static void expect_all(const char *const *names, size_t count, int refused)
{
    for (size_t i = 0; i < count; i++) {
        if (name_is_refused(names[i]) != refused) {
            fail_msg("\"%s\" is %srefused", names[i], refused ? "not " : "");
        }
    }
}
#define EXPECT(names, refused) expect_all(names, sizeof names / sizeof *names, refused)

static void test_a_bad_word_is_rejected_in_every_spelling(void **state)
{
    (void)state;
    static const char *const names[] = {
        "fuck",   "FUCK",     "Fuck",     "f.u.c.k", "F-U-C-K", "fuuuck", "FUCKYOU",
        "xfuckx", "ｆｕｃｋ", "ＦＵＣＫ", "fuck1",   "1fuck",   "B1TCH",  "b!tch",
        "n1gger", "N1GGA",    "CUNT",     "whore",   "wh0re",   "H1TLER", "a55hole",
    };
    EXPECT(names, 1);
}

static void test_kana_are_compared_by_sound(void **state)
{
    (void)state;
    static const char *const names[] = {
        "ちんこ",   "チンコ",  "ちンこ", "ち・ん・こ", "ちーんこ",   "ちんんこ",   "ﾁﾝｺ",
        "ちんこ1",  "ちんこ!", "うんこ", "ウンコ!",    "ばか",       "バカ",       "バーカ",
        "ばーか!!", "しね",    "シネ",   "4ね",        "ぶっころす", "ヒットラー", "ﾊﾞｶ",
    };
    EXPECT(names, 1);
}

static void test_real_names_that_resemble_bad_words_are_accepted(void **state)
{
    (void)state;
    static const char *const names[] = {
        "YOSHITAKA", "TAKESHITA", "Cassandra", "Dickens", "Essex",    "Junko",      "JUNKO",
        "Shinei",    "コロスケ",  "ばかぼん",  "しねま",  "ぶすじま", "あほうどり", "うんこう",
        "えろいか",  "くそん",    "きんぎょ",  "たろう",  "さくら",   "MARI",       "Bob",
        "K1NGYO",    "A-1",       "88",        "!?",      "・・・",   "ー",         "Basset",
        "Assam",     "Hancock",   "Coxswain",  "Kitson",  "あっち",   "でぶら",
    };
    EXPECT(names, 0);
}

static void test_an_empty_name_is_accepted_and_invalid_bytes_hide_no_word(void **state)
{
    (void)state;
    assert_false(name_is_refused(""));
    assert_false(name_is_refused("\xff\xfe\x80"));
    assert_true(name_is_refused("fu\xff"
                                "ck"));
    /* These texts end in the middle of a letter, whose remaining bytes are missing. */
    assert_false(name_is_refused("\xe3\x81"));
    assert_true(name_is_refused("fuck\xe3"));
}

static void test_every_word_of_the_list_is_rejected(void **state)
{
    (void)state;
    assert_in_range(refused_word_count, 50, 1000);
    for (uint32_t i = 0; i < refused_word_count; i++) {
        char name[3 * REFUSED_LETTERS_MAX + 1] = "";
        char *end = name;
        for (uint32_t k = 0; k < refused_words[i].count; k++) {
            end = printable_put(end, refused_words[i].letters[k]);
        }
        assert_true(name_is_refused(name));
    }
}

static void test_a_long_name_is_normalized_within_its_buffer(void **state)
{
    (void)state;
    uint16_t letters[NAME_NORMALIZE_MAX];
    char name[200];
    memset(name, 'a', sizeof name);
    name[199] = 0;
    assert_int_equal(name_normalize(name, NAME_ENDS_KEPT, letters), NAME_NORMALIZE_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bad_word_is_rejected_in_every_spelling),
        cmocka_unit_test(test_kana_are_compared_by_sound),
        cmocka_unit_test(test_real_names_that_resemble_bad_words_are_accepted),
        cmocka_unit_test(test_an_empty_name_is_accepted_and_invalid_bytes_hide_no_word),
        cmocka_unit_test(test_every_word_of_the_list_is_rejected),
        cmocka_unit_test(test_a_long_name_is_normalized_within_its_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
