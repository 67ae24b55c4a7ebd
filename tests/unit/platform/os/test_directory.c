/* test_directory.c -- Tests that folders are created, or that the reason is reported if a folder
 * cannot be created. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "platform/os/file.h"

static char root[] = "/tmp/kingyo-folder-XXXXXX";

static int make_root(void **state)
{
    (void)state;
    return mkdtemp(root) ? 0 : -1;
}

static int remove_root(void **state)
{
    char command[64];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", root);
    return system(command);
}

static int make_below(const char *name)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", root, name);
    return file_make_folder(path);
}

static void test_all_missing_parent_folders_are_created_and_existing_ones_accepted(void **state)
{
    char path[128];
    struct stat status;
    (void)state;
    assert_int_equal(make_below("a/b/c"), 0);
    assert_int_equal(make_below("a/b/c/"), 0);
    snprintf(path, sizeof path, "%s/a/b/c", root);
    assert_int_equal(stat(path, &status), 0);
    assert_true(S_ISDIR(status.st_mode));
}

static void test_a_file_in_place_of_a_folder_is_reported(void **state)
{
    char path[128];
    (void)state;
    snprintf(path, sizeof path, "%s/file", root);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fclose(file);
    assert_int_equal(make_below("file"), -ENOTDIR);
    assert_int_equal(make_below("file/below"), -ENOTDIR);
}

static void test_an_empty_or_too_long_path_is_rejected(void **state)
{
    static char path[FILE_FOLDER_MAX + 1];
    (void)state;
    assert_int_equal(file_make_folder(""), -ENOENT);
    memset(path, 'a', FILE_FOLDER_MAX);
    assert_int_equal(file_make_folder(path), -ENAMETOOLONG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_missing_parent_folders_are_created_and_existing_ones_accepted),
        cmocka_unit_test(test_a_file_in_place_of_a_folder_is_reported),
        cmocka_unit_test(test_an_empty_or_too_long_path_is_rejected),
    };
    return cmocka_run_group_tests(tests, make_root, remove_root);
}
