/* test_file_give.c -- Tests the function that changes the owner and the mode of a file. Only a
 * regular file may be changed that belongs to the caller and has no second name (hard link). */
#include <errno.h>
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

#include "platform/os/file.h"

#define OTHER_USER 65534

static char folder[] = "/tmp/kingyo-give-XXXXXX";
static char foreign[64], path[64];

static int set_up(void **state)
{
    (void)state;
    strcpy(folder + sizeof folder - 7, "XXXXXX");
    assert_non_null(mkdtemp(folder));
    snprintf(foreign, sizeof foreign, "%s/foreign", folder);
    snprintf(path, sizeof path, "%s/given", folder);
    const int handle = open(foreign, O_CREAT | O_WRONLY, 0600);
    assert_true(handle >= 0);
    close(handle);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    unlink(foreign);
    unlink(path);
    return rmdir(folder);
}

/* Tries to change the owner and the mode of `path`. Asserts that the call fails with `error`, and
 * that the file `foreign` is unchanged. */
static void check_refused(int error)
{
    struct stat before, after;
    assert_int_equal(stat(foreign, &before), 0);
    errno = 0;
    assert_int_equal(file_give_at(AT_FDCWD, path, geteuid(), getegid(), 0660), -1);
    assert_int_equal(errno, error);
    assert_int_equal(stat(foreign, &after), 0);
    assert_int_equal(after.st_mode, before.st_mode);
    assert_int_equal(after.st_uid, before.st_uid);
}

static void test_a_regular_file_gets_the_mode(void **state)
{
    (void)state;
    struct stat about;
    assert_int_equal(file_give_at(AT_FDCWD, foreign, geteuid(), getegid(), 0640), 0);
    assert_int_equal(stat(foreign, &about), 0);
    assert_int_equal(about.st_mode & 07777, 0640);
}

static void test_a_symbolic_link_is_not_followed(void **state)
{
    (void)state;
    assert_int_equal(symlink(foreign, path), 0);
    check_refused(ELOOP);
}

static void test_a_second_name_of_a_file_is_refused(void **state)
{
    (void)state;
    assert_int_equal(link(foreign, path), 0);
    check_refused(EPERM);
}

static void test_a_fifo_is_refused(void **state)
{
    (void)state;
    assert_int_equal(mkfifo(path, 0600), 0);
    check_refused(ENOTSUP);
}

static void test_a_file_of_another_user_is_refused(void **state)
{
    (void)state;
    if (geteuid() != 0) {
        skip(); /* The test needs root, because only root can create a file of another user. */
    }
    const int handle = open(path, O_CREAT | O_WRONLY, 0600);
    assert_true(handle >= 0);
    assert_int_equal(fchown(handle, OTHER_USER, OTHER_USER), 0);
    close(handle);
    check_refused(EPERM);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_regular_file_gets_the_mode, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_symbolic_link_is_not_followed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_second_name_of_a_file_is_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_fifo_is_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_file_of_another_user_is_refused, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
