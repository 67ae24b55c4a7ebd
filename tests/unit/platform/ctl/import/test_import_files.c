/* test_import_files.c -- Tests the reader of files for the import: only regular files of a limited
 * size, read line by line. */
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

#include "platform/ctl/import/import.h"
#include "platform/os/file.h"

static char why[IMPORT_WHY_SIZE];
static FILE *file;

/* Returns the error message without the path before its first colon. */
static const char *reason(void)
{
    const char *colon = strstr(why, ": ");
    assert_non_null(colon);
    return colon + 2;
}

static void test_a_device_a_pipe_and_a_folder_are_rejected(void **state)
{
    (void)state;
    char path[64];
    snprintf(path, sizeof path, "/tmp/kingyo-plain-%d", (int)getpid());
    assert_int_equal(mkfifo(path, 0600), 0);
    /* A pipe without a writer would block a normal open(). */
    assert_int_equal(import_open(path, 1024, &file, why), EXIT_IO);
    assert_string_equal(reason(), "is not a regular file");
    unlink(path);
    assert_int_equal(import_open("/dev/zero", 1024, &file, why), EXIT_IO);
    assert_string_equal(reason(), "is not a regular file");
    assert_int_equal(import_open("/tmp", 1024, &file, why), EXIT_IO);
    assert_string_equal(reason(), "Is a directory");
    assert_int_equal(import_open("/nowhere/x", 1024, &file, why), EXIT_IO);
    assert_string_equal(reason(), "No such file or directory");
    assert_null(file);
}

static void test_a_file_of_one_byte_over_the_limit_is_rejected(void **state)
{
    (void)state;
    char path[] = "/tmp/kingyo-plain-XXXXXX";
    const int fd = mkstemp(path);
    assert_int_equal(ftruncate(fd, 2048), 0);
    assert_int_equal(import_open(path, 2048, &file, why), EXIT_OK);
    fclose(file);
    assert_int_equal(ftruncate(fd, 2049), 0);
    assert_int_equal(import_open(path, 2048, &file, why), EXIT_BAD_DATA);
    assert_string_equal(reason(), "larger than 2 KiB");
    assert_int_equal(ftruncate(fd, (1 << 20) + 1), 0);
    assert_int_equal(import_open(path, 1u << 20, &file, why), EXIT_BAD_DATA);
    assert_string_equal(reason(), "larger than 1 MiB");
    close(fd);
    unlink(path);
}

static void test_a_growing_file_is_read_up_to_the_limit(void **state)
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

static enum file_line first_line(const char *bytes, size_t size, char text[8])
{
    FILE *in = fmemopen((void *)(uintptr_t)bytes, size, "r");
    assert_non_null(in);
    const enum file_line got = file_read_line(in, text, 8);
    fclose(in);
    return got;
}

static void test_too_long_lines_and_zero_bytes_are_rejected(void **state)
{
    (void)state;
    char text[8];
    assert_int_equal(first_line("1234567\nx", 8, text), FILE_LINE_READ);
    assert_string_equal(text, "1234567");
    assert_int_equal(first_line("12345678\n", 8, text), FILE_LINE_BAD);
    assert_int_equal(first_line("123456", 6, text), FILE_LINE_READ); /* The last line needs no
                                                                        newline. */
    assert_string_equal(text, "123456");
    assert_int_equal(first_line("12\0", 3, text), FILE_LINE_BAD);
    assert_int_equal(first_line("\n", 1, text), FILE_LINE_READ);
    assert_string_equal(text, "");
    FILE *in = fmemopen((void *)(uintptr_t)"a\nb", 3, "r");
    assert_int_equal(file_read_line(in, text, 8), FILE_LINE_READ);
    assert_int_equal(file_read_line(in, text, 8), FILE_LINE_READ);
    assert_string_equal(text, "b");
    assert_int_equal(file_read_line(in, text, 8), FILE_LINE_END);
    fclose(in);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_device_a_pipe_and_a_folder_are_rejected),
        cmocka_unit_test(test_a_file_of_one_byte_over_the_limit_is_rejected),
        cmocka_unit_test(test_a_growing_file_is_read_up_to_the_limit),
        cmocka_unit_test(test_too_long_lines_and_zero_bytes_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
