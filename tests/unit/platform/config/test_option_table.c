/* test_option_table.c -- Tests the parser of command-line options that all programs of Kingyo
 * share. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "platform/config/option_table.h"

struct target {
    uint8_t flag, choice;
    const char *text, *word;
    char path[OPTIONS_PATH_MAX];
    uint32_t whole;
    double decimal;
};

#define AT(member) .offset = offsetof(struct target, member)

static const char *const choices[] = { "red", "green", "blue", NULL };

static const struct option base_options[] = {
    { "flag", NULL, "a flag", OPTION_FLAG, AT(flag) },
};
static const struct option_table base = { base_options, 1, NULL };
static const struct option options[] = {
    { .help = "A heading" },
    { "text", "T", "a text", OPTION_TEXT, AT(text) },
    { "o", "T", "a text of group 2", OPTION_TEXT, AT(text), .groups = 2 },
    { "path", "FILE", "a path", OPTION_PATH, AT(path) },
    { "whole", "N", "a whole number", OPTION_WHOLE, AT(whole), 1, 9, .initial = "3" },
    { "decimal", "N", "a number", OPTION_DECIMAL, AT(decimal), -1, 1 },
    { "choice", "C", "a colour", OPTION_CHOICE, AT(choice), .choices = choices },
    { NULL, "WORD", "a word", OPTION_ARGUMENT, AT(word) },
};
static const struct option_table table = OPTION_TABLE(options, &base);

static struct target target;
static char error[OPTIONS_ERROR_MAX];

/* Parses a command line of up to four arguments. A null pointer ends the list. */
static int parse(uint32_t groups, const char *const words[4])
{
    int argc = 0;
    while (argc < 4 && words[argc]) {
        argc++;
    }
    memset(&target, 0, sizeof target);
    memset(error, 0, sizeof error);
    return option_table_parse(&table, groups, &target, argc, words, error);
}

#define PARSE(groups, ...) parse(groups, (const char *const[4]){ __VA_ARGS__ })

static void test_each_type_of_option_is_stored_in_its_target(void **state)
{
    (void)state;
    assert_int_equal(PARSE(0, "--flag", "--text=a", "word", "--whole=9"), 0);
    assert_int_equal(target.flag, 1);
    assert_string_equal(target.text, "a");
    assert_string_equal(target.word, "word");
    assert_int_equal(target.whole, 9);
    assert_int_equal(PARSE(0, "--decimal", "-0.5", "--choice", "blue"), 0);
    assert_true(target.decimal == -0.5);
    assert_int_equal(target.choice, 2);
    assert_int_equal(target.whole, 3); /* --whole is absent, so its default of 3 applies. */
    assert_int_equal(PARSE(2, "--path", "p", "-o", "b"), 0);
    assert_string_equal(target.path, "p");
    assert_string_equal(target.text, "b");
}

static void test_each_parse_error_has_its_own_message(void **state)
{
    static const struct {
        const char *words[4], *error;
    } wrong[] = {
        { { "--none" }, "unknown option '--none'; --help lists them" },
        { { "-o", "b" }, "unknown option '-o'; --help lists them" },
        { { "--o", "b" }, "unknown option '--o'; --help lists them" },
        { { "-text", "b" }, "unknown option '-text'; --help lists them" },
        { { "--flag=1" }, "--flag takes no value" },
        { { "--whole" }, "--whole needs a value: a whole number from 1 to 9" },
        { { "--whole", "--flag" }, "--whole needs a value: a whole number from 1 to 9" },
        { { "--whole", "1.5" }, "--whole: '1.5' is wrong; expected a whole number from 1 to 9" },
        { { "--whole", "5.0" }, "--whole: '5.0' is wrong; expected a whole number from 1 to 9" },
        { { "--whole", "10" }, "--whole: '10' is wrong; expected a whole number from 1 to 9" },
        { { "--decimal", "nan" }, "--decimal: 'nan' is wrong; expected a number from -1 to 1" },
        { { "--choice", "pink" }, "--choice: 'pink' is wrong; expected red, green or blue" },
        { { "--text", "" }, "--text: '' is wrong; expected a path" },
        { { "--path=" }, "--path: '' is wrong; expected a path" },
        { { "one", "two" }, "'two' is not understood; --help lists the arguments" },
    };
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_int_equal(parse(1, wrong[i].words), -1);
        assert_string_equal(error, wrong[i].error);
    }
}

static void test_an_option_of_the_base_table_is_found(void **state)
{
    (void)state;
    assert_ptr_equal(option_table_find(&table, "flag=1", 4), &base_options[0]);
    assert_ptr_equal(option_table_find(&table, "choice", 6), &options[6]);
    assert_null(option_table_find(&table, "choices", 7));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_type_of_option_is_stored_in_its_target),
        cmocka_unit_test(test_each_parse_error_has_its_own_message),
        cmocka_unit_test(test_an_option_of_the_base_table_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
