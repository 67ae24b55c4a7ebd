/* test_setting_text.c -- Tests how settings are converted to text and back, as in kingyo.conf. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "platform/setting_text.h"

static bool is_for_files(uint32_t id)
{
    return setting_section(settings_entry(id)->group) != NULL;
}

static void test_every_valid_setting_value_is_unchanged_by_printing_and_parsing(void **state)
{
    char text[SETTING_TEXT_MAX];
    (void)state;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        for (int32_t value = settings_entry(id)->min;
             is_for_files(id) && value <= settings_entry(id)->max; value++) {
            int32_t read = -1;
            if (settings_allows(id, value)) {
                setting_print(id, value, text);
                assert_int_equal(setting_parse(id, text, &read), 1);
                assert_int_equal(read, value);
                assert_true(strlen(text) + 1u < sizeof text);
            }
        }
    }
}

static void check_refused(uint32_t id, const char *text)
{
    int32_t value = 77;
    assert_int_equal(setting_parse(id, text, &value), 0);
    assert_int_equal(value, 77);
}

static void test_an_invalid_setting_value_is_rejected_without_a_change(void **state)
{
    /* clang-format off */
    static const struct { uint32_t id; const char *text; } wrong[] = {
        { SET_PRICE, "" },           { SET_PRICE, "0" },          { SET_PRICE, "21" },
        { SET_PRICE, "-1" },         { SET_PRICE, "2x" },         { SET_PRICE, "4294967297" },
        { SET_PLAY, "Free" },        { SET_PLAY, "fre" },         { SET_PLAY, "0" },
        { SET_GRADE, "" },           { SET_GRADE, "3" },          { SET_GRADE, "0" },
        { SET_MODES, "" },           { SET_MODES, "festival," },  { SET_MODES, ",festival" },
        { SET_MODES, "festival lab" }, { SET_MODES, "festival,,lab" }, { SET_MODES, "all" },
        { SET_NIGHT_TO_MIN, "24:00" }, { SET_NIGHT_TO_MIN, "8:5" }, { SET_NIGHT_TO_MIN, "8:07" },
        { SET_NIGHT_TO_MIN, "008:00" }, { SET_NIGHT_TO_MIN, ":00" }, { SET_NIGHT_TO_MIN, "480" },
        { SET_VOLUME, "33" },        { SET_VOLUME, "105" },       { SET_ROTATION, "1" },
        { SET_PIN, "10000" },        { SET_LANGUAGE, "fr" },      { SET_CREDIT_EXPIRY_MIN, "7" },
    };
    /* clang-format on */
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        check_refused(wrong[i].id, wrong[i].text);
    }
}

static void test_modes_are_keywords_in_any_order(void **state)
{
    int32_t value;
    (void)state;
    assert_int_equal(setting_parse(SET_MODES, "lab ,\tfestival,festival", &value), 1);
    assert_int_equal(value, 1 << CHOICE_LAB | 1 << MODE_FESTIVAL);
}

static void test_every_setting_of_the_file_has_a_section_a_range_and_a_description(void **state)
{
    char range[SETTING_RANGE_MAX];
    (void)state;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        const char *name = settings_entry(id)->name;
        const size_t length = strlen(name);
        assert_int_equal(setting_find(name, length), is_for_files(id) ? id : SETTING_COUNT);
        assert_int_equal(setting_find(name, length - 1u), SETTING_COUNT);
        if (is_for_files(id)) {
            setting_range(id, range);
            assert_true(strlen(range) > 4 && strlen(range) + 1u < sizeof range);
            assert_true(strlen(setting_help(id)) > 10);
        } else {
            assert_string_equal(setting_help(id), "");
        }
    }
}

static void test_the_help_of_the_language_names_the_choice_of_a_visitor(void **state)
{
    (void)state;
    assert_non_null(strstr(setting_help(SET_LANGUAGE), "a visitor's choice returns"));
}

static void test_ranges_are_printed_as_readable_text(void **state)
{
    char range[SETTING_RANGE_MAX];
    (void)state;
    setting_range(SET_PLAY, range);
    assert_string_equal(range, "free, paid or event");
    setting_range(SET_GRADE, range);
    assert_string_equal(range, "own, 4, 5, 6 or 7");
    setting_range(SET_CREDIT_EXPIRY_MIN, range);
    assert_string_equal(range, "0 to 240 in steps of 5");
    setting_range(SET_MODES, range);
    assert_string_equal(range, "festival, championship, practice and lab, one or more, with commas "
                               "between them");
    setting_range(SET_NIGHT_TO_MIN, range);
    assert_string_equal(range, "00:00 to 23:45 in steps of 15 minutes");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_valid_setting_value_is_unchanged_by_printing_and_parsing),
        cmocka_unit_test(test_an_invalid_setting_value_is_rejected_without_a_change),
        cmocka_unit_test(test_modes_are_keywords_in_any_order),
        cmocka_unit_test(test_every_setting_of_the_file_has_a_section_a_range_and_a_description),
        cmocka_unit_test(test_the_help_of_the_language_names_the_choice_of_a_visitor),
        cmocka_unit_test(test_ranges_are_printed_as_readable_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
