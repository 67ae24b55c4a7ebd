/* test_log.c -- a line on standard error, and its priority where a journal listens. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/os/log.h"

static char place[] = "/tmp/kingyo-say-XXXXXX";
static char said[2u * LOG_LINE_MAX];

/* Says a warning with standard error led into a file; what $JOURNAL_STREAM is then, by `shift` off
 * the file's own inode. */
static void say_into_file(int shift, const char *words)
{
    char journal[64];
    struct stat about;
    strcpy(place + sizeof place - 7, "XXXXXX");
    const int file = mkstemp(place), before = dup(STDERR_FILENO);
    assert_true(file >= 0);
    assert_int_equal(fstat(file, &about), 0);
    snprintf(journal, sizeof journal, "%llu:%llu", (unsigned long long)about.st_dev,
             (unsigned long long)about.st_ino + (unsigned long long)shift);
    setenv("JOURNAL_STREAM", journal, 1);
    fflush(stderr);
    dup2(file, STDERR_FILENO);
    log_open();
    log_print(LOG_LEVEL_WARNING, "%s", words);
    fflush(stderr);
    dup2(before, STDERR_FILENO);
    close(before);
    memset(said, 0, sizeof said);
    assert_true(pread(file, said, sizeof said - 1u, 0) > 0);
    close(file);
    unlink(place);
    unsetenv("JOURNAL_STREAM");
    log_open();
}

static void test_a_journal_gets_the_priority(void **state)
{
    (void)state;
    say_into_file(0, "a.conf:3: unknown key");
    assert_string_equal(said, "<4>kingyo: a.conf:3: unknown key\n");
}

/* Standard error that was led elsewhere, as in `kingyo 2>log` within a service. */
static void test_a_file_that_is_no_journal_gets_words_alone(void **state)
{
    (void)state;
    say_into_file(1, "a.conf:3: unknown key");
    assert_string_equal(said, "kingyo: a.conf:3: unknown key\n");
}

static void test_a_line_holds_no_control_character(void **state)
{
    (void)state;
    say_into_file(1, "pad '\033[2J\xC2\x9B\xE2\x80\xAE\x9B\nkingyo: forged' is gone");
    assert_string_equal(said, "kingyo: pad '?[2J????kingyo: forged' is gone\n");
}

static void test_a_long_line_is_cut_and_ends(void **state)
{
    static char words[2u * LOG_LINE_MAX];
    (void)state;
    memset(words, 'x', sizeof words - 1u);
    say_into_file(0, words);
    assert_in_range(strlen(said), LOG_LINE_MAX - 64u, LOG_LINE_MAX - 1u);
    assert_int_equal(said[strlen(said) - 1u], '\n');
}

static void test_no_variable_no_journal(void **state)
{
    (void)state;
    assert_int_equal(log_is_journal(NULL, STDERR_FILENO), 0);
    assert_int_equal(log_is_journal("", STDERR_FILENO), 0);
    assert_int_equal(log_is_journal("8:12345", -1), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_journal_gets_the_priority),
        cmocka_unit_test(test_a_file_that_is_no_journal_gets_words_alone),
        cmocka_unit_test(test_a_line_holds_no_control_character),
        cmocka_unit_test(test_a_long_line_is_cut_and_ends),
        cmocka_unit_test(test_no_variable_no_journal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
