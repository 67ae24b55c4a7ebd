/* test_printable.c -- checks that untrusted text becomes safe to print on a terminal. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/printable.h"

static void expect(const char *from, const char *to)
{
    char text[64];
    snprintf(text, sizeof text, "%s", from);
    assert_ptr_equal(printable(text), text);
    assert_string_equal(text, to);
}

static void test_plain_text_of_any_script_is_kept(void **state)
{
    (void)state;
    expect("", "");
    expect("Kingyo ~!", "Kingyo ~!");
    /* The text contains Kanji, an e with an acute accent and a fish emoji. */
    expect("\xE9\x87\x91\xE9\xAD\x9A \xC3\xA9 \xF0\x9F\x90\x9F",
           "\xE9\x87\x91\xE9\xAD\x9A \xC3\xA9 \xF0\x9F\x90\x9F");
    /* The text contains the first and the last character of each permitted range of code points. */
    expect("\xC2\xA0\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF",
           "\xC2\xA0\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF");
}

static void test_each_control_character_becomes_one_question_mark(void **state)
{
    (void)state;
    expect("a\033[31mb\r\n\tc\x7F", "a?[31mb???c?");
    /* The text contains C1 control characters, which start with the byte 0xC2. One of them is
     * U+009B, which starts a terminal control sequence. */
    expect("\xC2\x80\xC2\x85\xC2\x9B"
           "1m\xC2\x9F",
           "???1m?");
    expect("\xE2\x80\xA8\xE2\x80\xA9", "??"); /* U+2028 and U+2029, two line separators. */
}

static void test_every_c0_and_c1_character_is_replaced(void **state)
{
    (void)state;
    for (unsigned point = 1; point < 0xA0; point++) {
        char text[3] = { 0 };
        if (point < 0x80) {
            text[0] = (char)point;
        } else {
            text[0] = (char)0xC2;
            text[1] = (char)point;
        }
        assert_int_equal(printable_code_point(text), point);
        assert_int_equal(printable_size(text) == 0, point < 0x20 || point >= 0x7F);
    }
}

static void test_bidirectional_controls_are_replaced(void **state)
{
    (void)state;
    expect("\xD8\x9C\xE2\x80\x8E\xE2\x80\x8F", "???"); /* U+061C, U+200E and U+200F are direction
                                                          marks. */
    expect("\xE2\x80\xAA\xE2\x80\xAE", "??");          /* U+202A, U+202E */
    expect("\xE2\x81\xA6\xE2\x81\xA9", "??");          /* U+2066, U+2069 */
    /* The code points just beside the replaced ranges are permitted. */
    expect("\xE2\x80\x8D\xE2\x80\xAF\xE2\x81\xA5\xE2\x81\xAA",
           "\xE2\x80\x8D\xE2\x80\xAF\xE2\x81\xA5\xE2\x81\xAA");
}

static void test_each_byte_that_is_not_utf8_becomes_one_question_mark(void **state)
{
    (void)state;
    /* In Latin 1, the byte 0x9B is a C1 control character. In UTF-8, the byte alone is invalid. */
    expect("a\x9B"
           "b",
           "a?b");
    /* The overlong encoding of '/' has two bytes, although this character needs only one. */
    expect("\xC0\xAF", "??");
    expect("\xE0\x80\xAF", "???");
    /* Surrogate U+D800. Surrogates are not valid in UTF-8. */
    expect("\xED\xA0\x80", "???");
    /* U+110000, which is beyond the last code point U+10FFFF. */
    expect("\xF4\x90\x80\x80", "????");
    expect("\xF8\x88\x80\x80\x80", "?????");
    /* First two bytes of a three-byte character, whose third byte is missing. */
    expect("a\xE9\x87", "a??");
    expect("\xE9\x87\033", "???");
    expect("\xC3", "?");
}

static void test_no_text_of_two_bytes_leaves_a_control_character(void **state)
{
    (void)state;
    for (unsigned bytes = 0x0101; bytes <= 0xFFFF; bytes++) {
        const unsigned second = (bytes & 0xFFu) == 0 ? 1u : bytes;
        char text[4] = { (char)(bytes >> 8), (char)second, 'z', '\0' };
        printable(text);
        assert_int_equal(text[strlen(text) - 1u], 'z');
        for (const char *c = text; *c; c += printable_size(c)) {
            assert_int_not_equal(printable_size(c), 0);
        }
    }
}

static void test_each_code_point_is_encoded_so_that_it_is_decoded(void **state)
{
    (void)state;
    for (uint32_t point = 1; point <= 0x10FFFF; point++) {
        if (point < 0xD800 || point > 0xDFFF) {
            char text[5] = "";
            const char *end = printable_put(text, point), *at = text;
            assert_int_equal(printable_next(&at), point);
            assert_ptr_equal(at, end);
        }
    }
    char fish[4];
    assert_ptr_equal(printable_put(fish, 0x1F41F), fish + 4);
    assert_memory_equal(fish, "\xF0\x9F\x90\x9F", 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_plain_text_of_any_script_is_kept),
        cmocka_unit_test(test_each_control_character_becomes_one_question_mark),
        cmocka_unit_test(test_every_c0_and_c1_character_is_replaced),
        cmocka_unit_test(test_bidirectional_controls_are_replaced),
        cmocka_unit_test(test_each_byte_that_is_not_utf8_becomes_one_question_mark),
        cmocka_unit_test(test_no_text_of_two_bytes_leaves_a_control_character),
        cmocka_unit_test(test_each_code_point_is_encoded_so_that_it_is_decoded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
