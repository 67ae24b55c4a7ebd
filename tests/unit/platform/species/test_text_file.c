/* test_text_file.c -- files that others wrote: only regular ones of a bounded size, line by
 * line. */
#include <errno.h>
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

#include "platform/os/file.h"
#include "platform/species/text.h"

static char why[TEXT_FILE_WHY_SIZE];
static FILE *file;

static void test_a_device_a_pipe_and_a_folder_are_no_files(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "/tmp/kingyo-plain-%d", (int)getpid());
    assert_int_equal(mkfifo(path, 0600), 0);
    assert_int_equal(text_file_open(path, 1024, &file, why),
                     TEXT_FILE_NONE); /* Nobody writes there. */
    assert_string_equal(why, "is not a regular file");
    unlink(path);
    assert_int_equal(text_file_open("/dev/zero", 1024, &file, why), TEXT_FILE_NONE);
    assert_string_equal(why, "is not a regular file");
    assert_int_equal(text_file_open("/tmp", 1024, &file, why), TEXT_FILE_NONE);
    assert_string_equal(why, "Is a directory");
    assert_int_equal(text_file_open("/nowhere/x", 1024, &file, why), TEXT_FILE_NONE);
    assert_string_equal(why, "No such file or directory");
    assert_null(file);
}

static void test_a_byte_too_many_is_too_many(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-plain-XXXXXX";
    const int fd = mkstemp(path);
    assert_int_equal(ftruncate(fd, 2048), 0);
    assert_int_equal(text_file_open(path, 2048, &file, why), TEXT_FILE_OPEN);
    fclose(file);
    assert_int_equal(ftruncate(fd, 2049), 0);
    assert_int_equal(text_file_open(path, 2048, &file, why), TEXT_FILE_LARGE);
    assert_string_equal(why, "larger than 2 KiB");
    assert_int_equal(ftruncate(fd, (1 << 20) + 1), 0);
    assert_int_equal(text_file_open(path, 1u << 20, &file, why), TEXT_FILE_LARGE);
    assert_string_equal(why, "larger than 1 MiB");
    close(fd);
    unlink(path);
}

static void test_a_file_that_grows_while_it_is_read_ends_at_the_limit(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-plain-XXXXXX", bytes[64];
    const int fd = mkstemp(path);
    assert_int_equal(ftruncate(fd, 10), 0);
    file = file_open(path, 16);
    assert_non_null(file);
    assert_int_equal(ftruncate(fd, 16), 0);
    assert_int_equal(fread(bytes, 1, sizeof bytes, file), 16);
    assert_false(ferror(file));
    assert_int_equal(ftruncate(fd, 17), 0);
    clearerr(file);
    errno = 0;
    assert_int_equal(fread(bytes, 1, sizeof bytes, file), 0);
    assert_true(ferror(file));
    assert_int_equal(errno, EFBIG);
    assert_string_equal(file_error(errno), "is too large");
    assert_int_equal(fclose(file), 0);
    close(fd);
    unlink(path);
}

static enum text_file_line first_line(const char *bytes, size_t size, char text[8])
{
    FILE *in = fmemopen((void *)(uintptr_t)bytes, size, "r");
    assert_non_null(in);
    const enum text_file_line got = text_file_line(in, text, 8);
    fclose(in);
    return got;
}

static void test_lines_are_as_long_as_there_is_room_and_hold_no_zero(void **state)
{
    (void)state;
    char text[8];
    assert_int_equal(first_line("123456\nx", 8, text), TEXT_FILE_LINE);
    assert_string_equal(text, "123456");
    assert_int_equal(first_line("1234567\n", 8, text), TEXT_FILE_LONG);
    assert_int_equal(first_line("123456", 6, text), TEXT_FILE_LINE); /* The last needs no end. */
    assert_string_equal(text, "123456");
    assert_int_equal(first_line("12\0", 3, text), TEXT_FILE_ZERO);
    assert_int_equal(first_line("\n", 1, text), TEXT_FILE_LINE);
    assert_string_equal(text, "");
    FILE *in = fmemopen((void *)(uintptr_t)"a\nb", 3, "r");
    assert_int_equal(text_file_line(in, text, 8), TEXT_FILE_LINE);
    assert_int_equal(text_file_line(in, text, 8), TEXT_FILE_LINE);
    assert_string_equal(text, "b");
    assert_int_equal(text_file_line(in, text, 8), TEXT_FILE_END);
    fclose(in);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_device_a_pipe_and_a_folder_are_no_files),
        cmocka_unit_test(test_a_byte_too_many_is_too_many),
        cmocka_unit_test(test_a_file_that_grows_while_it_is_read_ends_at_the_limit),
        cmocka_unit_test(test_lines_are_as_long_as_there_is_room_and_hold_no_zero),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
