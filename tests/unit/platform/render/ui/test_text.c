/* test_text.c -- Tests the texts of the kiosk: decoding of UTF-8, insertion of numbers, and a glyph
 * in the fonts for every character. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "assets.h"
#include "platform/render/gl_util.h"
#include "platform/render/ui/text.h"

static uint32_t first(const char *bytes)
{
    return printable_next(&bytes);
}

static void test_utf8_of_every_length_is_decoded(void **state)
{
    (void)state;
    /* The text consists of A, é, the Japanese character for gold, and the fish emoji. These
     * characters have one, two, three and four bytes. */
    const char *at = "A\xc3\xa9\xe9\x87\x91\xf0\x9f\x90\x9f";
    assert_int_equal(printable_next(&at), 'A');
    assert_int_equal(printable_next(&at), 0xe9);
    assert_int_equal(printable_next(&at), 0x91d1);
    assert_int_equal(printable_next(&at), 0x1f41f);
    assert_int_equal(printable_next(&at), 0);
    /* A second call at the end of the text returns 0 again. */
    assert_int_equal(printable_next(&at), 0);
}

static void test_malformed_bytes_are_replaced_one_by_one(void **state)
{
    (void)state;
    static const char *const malformed[] = {
        "\x80",             /* A continuation byte without a first byte. */
        "\xc0\xaf",         /* A slash that is encoded in two bytes. This overlong form is
                               invalid. */
        "\xe0\x80\xaf",     /* A slash that is encoded in three bytes, which is invalid too. */
        "\xf0\x80\x80\xaf", /* A slash that is encoded in four bytes, which is invalid too. */
        "\xed\xa0\x80",     /* Half of a surrogate pair, which is no character. */
        "\xf4\x90\x80\x80", /* A code point above U+10FFFF. */
        "\xff",
        "\xe9\x87", /* The first two bytes of a character of three bytes. */
        "\xe9\x41", /* The first byte of a character of three bytes, then the letter A. */
    };
    for (size_t i = 0; i < sizeof malformed / sizeof *malformed; i++) {
        assert_int_equal(first(malformed[i]), PRINTABLE_MALFORMED);
    }
    const char *at = "\xe9"
                     "A";
    assert_int_equal(printable_next(&at), PRINTABLE_MALFORMED);
    assert_int_equal(printable_next(&at), 'A');
}

static void test_decoding_of_any_bytes_terminates(void **state)
{
    (void)state;
    uint32_t random = 1;
    for (uint32_t round = 0; round < 20000; round++) {
        char bytes[12];
        for (size_t i = 0; i + 1 < sizeof bytes; i++) {
            random = random * 1664525u + 1013904223u;
            bytes[i] = (char)(random >> 24);
        }
        bytes[sizeof bytes - 1] = 0;
        const char *at = bytes;
        while (printable_next(&at) != 0) {
            assert_true(at <= bytes + sizeof bytes - 1);
        }
        assert_ptr_equal(at, bytes + strlen(bytes));
    }
}

static void test_every_word_has_its_glyphs_in_the_font_for_small_text(void **state)
{
    (void)state;
    for (uint8_t language = 0; language < LANGUAGE_COUNT; language++) {
        for (uint32_t key = 0; key < TEXT_COUNT; key++) {
            const char *at = text_words(language, (enum text_key)key);
            assert_true(*at != 0);
            for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
                assert_int_not_equal(code, PRINTABLE_MALFORMED);
                assert_non_null(text_glyph(FONT_BODY, code));
            }
        }
    }
}

static bool has_japanese(const char *words)
{
    for (uint32_t code = printable_next(&words); code != 0; code = printable_next(&words)) {
        if ((code >= 0x3041u && code <= 0x30ffu) || (code >= 0x4e00u && code <= 0x9fffu)) {
            return true;
        }
    }
    return false;
}

/* Signs such as `90°` and names such as `USB` are the same in both languages, and short. */
static void test_every_text_is_translated(void **state)
{
    (void)state;
    for (uint32_t key = 0; key < TEXT_COUNT; key++) {
        const char *const ja = text_words(LANGUAGE_JA, (enum text_key)key);
        const char *const en = text_words(LANGUAGE_EN, (enum text_key)key);
        const bool is_sign = strcmp(ja, en) == 0 && strlen(ja) < 12u;
        if (!has_japanese(ja) && !is_sign) {
            fail_msg("the Japanese text '%s' is not translated from '%s'", ja, en);
        }
        /* The line of keys names the other language in this language. */
        if (has_japanese(en) && !is_sign && key != TEXT_KEYS) {
            fail_msg("the English text '%s' is not translated from '%s'", en, ja);
        }
    }
    assert_true(has_japanese("A\xe9\x87\x91") && !has_japanese("English"));
}

static void test_the_title_has_its_glyphs_in_the_brush_font(void **state)
{
    (void)state;
    const char *at = text_words(LANGUAGE_JA, TEXT_TITLE);
    for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
        assert_non_null(text_glyph(FONT_BRUSH, code));
    }
}

static void test_every_glyph_page_fits_the_smallest_texture_limit(void **state)
{
    (void)state;
    assert_in_range(ASSET_FONT_WIDTH, 1, GL_TEXTURE_SURE);
    assert_in_range(ASSET_FONT_ROWS, 1, GL_TEXTURE_SURE);
    assert_in_range(ASSET_FONT_PAGES, 1, GL_LAYERS_SURE);
}

static void test_glyphs_are_sorted_and_each_lies_on_one_page(void **state)
{
    (void)state;
    for (uint32_t font = 0; font < FONT_COUNT; font++) {
        const struct font *face = &asset_fonts[font];
        for (uint32_t i = 0; i < face->glyph_count; i++) {
            const struct font_glyph *glyph = &face->glyphs[i];
            assert_true(i == 0 || face->glyphs[i - 1].code < glyph->code);
            assert_true(glyph->x + glyph->width <= ASSET_FONT_WIDTH);
            assert_true(glyph->y % ASSET_FONT_ROWS + glyph->height <= ASSET_FONT_ROWS);
            assert_true(glyph->y / ASSET_FONT_ROWS < ASSET_FONT_PAGES);
            assert_ptr_equal(text_glyph((enum font_id)font, glyph->code), glyph);
        }
    }
}

static void test_a_missing_character_is_shown_as_a_question_mark(void **state)
{
    (void)state;
    const uint32_t cuneiform = 0x12000;
    assert_null(text_glyph(FONT_BODY, cuneiform));
    assert_ptr_equal(text_glyph_or_mark(FONT_BODY, cuneiform), text_glyph(FONT_BODY, '?'));
    assert_float_equal(text_width_em(FONT_BODY, "\xf0\x92\x80\x80", 0.0f),
                       text_width_em(FONT_BODY, "?", 0.0f), 1e-6f);
}

static void test_letter_spacing_is_added_only_between_letters(void **state)
{
    (void)state;
    const float one = text_width_em(FONT_BODY, "A", 0.5f);
    const float plain = text_width_em(FONT_BODY, "A", 0.0f);
    assert_float_equal(one, plain, 1e-6f);
    assert_float_equal(text_width_em(FONT_BODY, "AAA", 0.5f), 3.0f * plain + 1.0f, 1e-5f);
    assert_float_equal(text_width_em(FONT_BODY, "", 0.5f), 0.0f, 1e-6f);
}

static void test_a_number_replaces_the_braces(void **state)
{
    (void)state;
    char out[32];
    text_number(out, sizeof out, "best {} fish", 12);
    assert_string_equal(out, "best 12 fish");
    text_number(out, sizeof out, "{}", 0);
    assert_string_equal(out, "0");
    text_number(out, sizeof out, "{}", 4294967295u);
    assert_string_equal(out, "4294967295");
    text_number(out, sizeof out, "none", 7);
    assert_string_equal(out, "none");
    text_number(out, sizeof out, "{}{}", 7);
    assert_string_equal(out, "7{}");
}

static void test_a_too_long_line_is_truncated_at_a_whole_character(void **state)
{
    (void)state;
    char out[6];
    memset(out, 'x', sizeof out);
    /* The buffer has room for five bytes and the terminating zero. Each of the two characters has
     * three bytes, so only the first one fits. */
    text_number(out, sizeof out, "\xe9\x87\x91\xe9\xad\x9a", 0);
    assert_string_equal(out, "\xe9\x87\x91");
    text_number(out, 3, "{}", 123);
    /* No digit is kept, because a truncated number would be a different number. */
    assert_string_equal(out, "");
}

static void test_an_unknown_language_falls_back_to_japanese(void **state)
{
    (void)state;
    assert_string_equal(text_words(200, TEXT_TITLE), text_words(LANGUAGE_JA, TEXT_TITLE));
    assert_string_not_equal(text_words(LANGUAGE_EN, TEXT_TITLE),
                            text_words(LANGUAGE_JA, TEXT_TITLE));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_utf8_of_every_length_is_decoded),
        cmocka_unit_test(test_malformed_bytes_are_replaced_one_by_one),
        cmocka_unit_test(test_decoding_of_any_bytes_terminates),
        cmocka_unit_test(test_every_word_has_its_glyphs_in_the_font_for_small_text),
        cmocka_unit_test(test_every_text_is_translated),
        cmocka_unit_test(test_the_title_has_its_glyphs_in_the_brush_font),
        cmocka_unit_test(test_every_glyph_page_fits_the_smallest_texture_limit),
        cmocka_unit_test(test_glyphs_are_sorted_and_each_lies_on_one_page),
        cmocka_unit_test(test_a_missing_character_is_shown_as_a_question_mark),
        cmocka_unit_test(test_letter_spacing_is_added_only_between_letters),
        cmocka_unit_test(test_a_number_replaces_the_braces),
        cmocka_unit_test(test_a_too_long_line_is_truncated_at_a_whole_character),
        cmocka_unit_test(test_an_unknown_language_falls_back_to_japanese),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
