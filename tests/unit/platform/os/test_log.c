/* test_log.c -- Tests log lines on standard error. If standard error is the journal of systemd,
 * each line begins with a priority. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdbool.h>
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
static char printed[2u * LOG_LINE_MAX];
static bool has_variable = true;

/* Logs a warning while standard error is a file. $JOURNAL_STREAM names the device and the inode of
 * the journal. If `shift` is 0, the variable names this file, so the file counts as the journal. */
static void log_into_file(int shift, const char *words)
{
    char journal[64];
    struct stat about;
    strcpy(place + sizeof place - 7, "XXXXXX");
    const int file = mkstemp(place), before = dup(STDERR_FILENO);
    assert_true(file >= 0);
    assert_int_equal(fstat(file, &about), 0);
    snprintf(journal, sizeof journal, "%llu:%llu", (unsigned long long)about.st_dev,
             (unsigned long long)about.st_ino + (unsigned long long)shift);
    if (has_variable) {
        setenv("JOURNAL_STREAM", journal, 1);
    }
    fflush(stderr);
    dup2(file, STDERR_FILENO);
    log_open();
    log_print(LOG_LEVEL_WARNING, "%s", words);
    fflush(stderr);
    dup2(before, STDERR_FILENO);
    close(before);
    memset(printed, 0, sizeof printed);
    assert_true(pread(file, printed, sizeof printed - 1u, 0) > 0);
    close(file);
    unlink(place);
    unsetenv("JOURNAL_STREAM");
    log_open();
}

static void test_a_log_line_to_the_journal_has_a_priority(void **state)
{
    (void)state;
    log_into_file(0, "a.conf:3: unknown key");
    assert_string_equal(printed, "<4>kingyo: a.conf:3: unknown key\n");
}

/* In a service that runs `kingyo 2>log`, standard error is not the journal. */
static void test_a_log_line_to_a_file_has_no_priority(void **state)
{
    (void)state;
    log_into_file(1, "a.conf:3: unknown key");
    assert_string_equal(printed, "kingyo: a.conf:3: unknown key\n");
}

static void test_a_log_line_contains_no_control_character(void **state)
{
    (void)state;
    log_into_file(1, "pad '\033[2J\xC2\x9B\xE2\x80\xAE\x9B\nkingyo: forged' is gone");
    assert_string_equal(printed, "kingyo: pad '?[2J????kingyo: forged' is gone\n");
}

static void test_a_long_log_line_is_truncated_and_terminated(void **state)
{
    static char words[2u * LOG_LINE_MAX];
    (void)state;
    memset(words, 'x', sizeof words - 1u);
    log_into_file(0, words);
    assert_in_range(strlen(printed), LOG_LINE_MAX - 64u, LOG_LINE_MAX - 1u);
    assert_int_equal(printed[strlen(printed) - 1u], '\n');
}

static void test_without_the_environment_variable_there_is_no_journal(void **state)
{
    (void)state;
    has_variable = false;
    log_into_file(0, "a");
    assert_string_equal(printed, "kingyo: a\n");
    has_variable = true;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_log_line_to_the_journal_has_a_priority),
        cmocka_unit_test(test_a_log_line_to_a_file_has_no_priority),
        cmocka_unit_test(test_a_log_line_contains_no_control_character),
        cmocka_unit_test(test_a_long_log_line_is_truncated_and_terminated),
        cmocka_unit_test(test_without_the_environment_variable_there_is_no_journal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
