/* test_panic_count.c -- Tests the count of panics, which decides whether the next start leaves out
 * stored data. A count file with any content must be handled. */
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
#include <sys/syscall.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/panics.h"

#define BOOT 77u

static char dir[] = "/tmp/kingyo-panics-XXXXXX";
static int folder;

static int open_folder(void **state)
{
    (void)state;
    assert_non_null(mkdtemp(dir));
    folder = open(dir, O_RDONLY | O_DIRECTORY);
    return folder < 0;
}

static int close_folder(void **state)
{
    (void)state;
    unlinkat(folder, PANICS_FILE, 0);
    unlinkat(folder, "other", 0);
    close(folder);
    return rmdir(dir);
}

static void test_three_panics_within_ten_minutes_omit_data_and_two_do_not(void **state)
{
    (void)state;
    struct panics panics = { 0 };
    assert_false(panics_is_due(&panics));
    panics_add(&panics, BOOT, 100, 50, 1);
    panics_add(&panics, BOOT, 300, 50, 1);
    assert_false(panics_is_due(&panics));
    panics_add(&panics, BOOT, 700, 50, 1);
    assert_true(panics_is_due(&panics));
    assert_int_equal(panics.total, 3);
}

static void test_three_panics_in_more_than_ten_minutes_omit_nothing(void **state)
{
    (void)state;
    struct panics panics = { 0 };
    panics_add(&panics, BOOT, 100, 50, 1);
    panics_add(&panics, BOOT, 300, 50, 1);
    panics_add(&panics, BOOT, 701, 50, 1);
    assert_false(panics_is_due(&panics));
    panics_add(&panics, BOOT, 702, 50, 1);
    /* The three panics at 300, 701 and 702 s are within ten minutes. */
    assert_true(panics_is_due(&panics));
}

static void test_panics_of_an_earlier_boot_omit_nothing(void **state)
{
    (void)state;
    struct panics panics = { 0 };
    panics_add(&panics, BOOT, 100, 50, 1);
    panics_add(&panics, BOOT, 101, 50, 1);
    panics_add(&panics, BOOT + 1u, 102, 50, 1);
    assert_false(panics_is_due(&panics));
}

static void test_one_panic_before_the_first_frame_omits_data(void **state)
{
    (void)state;
    struct panics panics = { 0 };
    panics_add(&panics, BOOT, 100, 1, 0);
    assert_true(panics_is_due(&panics));
}

static void test_each_recovery_start_omits_one_more_part_and_resets_the_count(void **state)
{
    (void)state;
    static const enum panics_left order[] = { LEFT_SETTINGS, LEFT_REPLAYS, LEFT_NAMES, LEFT_NAMES };
    struct panics panics = { 0 };
    for (unsigned i = 0; i < 4; i++) {
        panics_add(&panics, BOOT, 100 + i, 1, 0);
        assert_true(panics_is_due(&panics));
        assert_int_equal(panics_try(&panics), order[i]);
        panics_set_left_out(&panics, BOOT);
        assert_int_equal(panics.left, order[i]);
        assert_false(panics_is_due(&panics));
    }
    assert_int_equal(panics.total, 4);
    assert_string_equal(panics_left_name(panics.left), "settings, replays and names");
}

static void test_a_run_of_ten_minutes_restarts_the_omission_with_the_settings(void **state)
{
    (void)state;
    struct panics panics = { 0 };
    panics_add(&panics, BOOT, 100, 1, 0);
    panics_try(&panics);
    panics_set_left_out(&panics, BOOT);
    panics_add(&panics, BOOT, 800, PANICS_WITHIN_S, 1);
    assert_int_equal(panics.left, LEFT_NOTHING);
    panics_try(&panics);
    panics_set_left_out(&panics, BOOT);
    panics_add(&panics, BOOT, 900, PANICS_WITHIN_S - 1u, 1);
    assert_int_equal(panics.left, LEFT_SETTINGS);
    panics_add(&panics, BOOT + 1u, 20, 10, 1);
    assert_int_equal(panics.left, LEFT_NOTHING);
}

static void test_a_panic_count_is_restored_from_its_private_file(void **state)
{
    (void)state;
    struct panics panics = { 0 }, read;
    struct stat about;
    panics_add(&panics, BOOT, 100, 50, 1);
    panics_add(&panics, BOOT, 200, 50, 0);
    panics_try(&panics);
    assert_int_equal(panics_write(&panics, folder), 0);
    assert_int_equal(panics_read(&read, folder), 0);
    assert_memory_equal(&read, &panics, sizeof read);
    assert_int_equal(fstatat(folder, PANICS_FILE, &about, 0), 0);
    assert_int_equal(about.st_mode & 0777, 0600);
    assert_int_equal(about.st_size, PANICS_SIZE);
}

static void test_a_missing_count_file_means_no_panic(void **state)
{
    (void)state;
    struct panics read = { .total = 9 };
    unlinkat(folder, PANICS_FILE, 0);
    assert_int_equal(panics_read(&read, folder), 0);
    assert_int_equal(read.total, 0);
}

static void test_a_count_file_with_any_wrong_byte_or_size_is_rejected(void **state)
{
    (void)state;
    struct panics panics = { 0 }, read;
    panics_add(&panics, BOOT, 100, 50, 0);
    for (unsigned i = 0; i < PANICS_SIZE; i++) {
        uint8_t byte;
        assert_int_equal(panics_write(&panics, folder), 0);
        const int file = openat(folder, PANICS_FILE, O_RDWR);
        assert_int_equal(pread(file, &byte, 1, i), 1);
        byte ^= 0x10;
        assert_int_equal(pwrite(file, &byte, 1, i), 1);
        assert_int_equal(panics_read(&read, folder), -EBADMSG);
        assert_int_equal(read.total, 0);
        byte ^= 0x10;
        assert_int_equal(pwrite(file, &byte, 1, i), 1);
        assert_int_equal(ftruncate(file, i), 0);
        assert_int_equal(panics_read(&read, folder), -EBADMSG);
        close(file);
    }
    const int file = openat(folder, PANICS_FILE, O_WRONLY);
    assert_int_equal(ftruncate(file, PANICS_SIZE + 1), 0);
    close(file);
    assert_int_equal(panics_read(&read, folder), -EBADMSG);
    assert_int_equal(panics_write(&panics, folder), 0);
    assert_int_equal(panics_read(&read, folder), 0);
}

static int rename_error; /* errno that each call of renameat() sets, or 0 if renameat()
                            succeeds. */

int renameat(int from, const char *name, int to, const char *other)
{
    if (rename_error) {
        errno = rename_error;
        return -1;
    }
    return (int)syscall(SYS_renameat2, from, name, to, other, 0);
}

static void is_set_aside(const char *name)
{
    struct panics panics = { .total = 1 }, read = { .total = 9 };
    struct stat about;
    assert_true(panics_write(&panics, folder) < 0);
    assert_int_equal(panics_read(&read, folder), 0);
    assert_int_equal(read.total, 0);
    assert_int_not_equal(fstatat(folder, "other", &about, 0), 0);
    assert_int_equal(fstatat(folder, name, &about, AT_SYMLINK_NOFOLLOW), 0);
    assert_false(S_ISREG(about.st_mode));
    assert_int_equal(panics_write(&panics, folder), 0);
    assert_int_equal(panics_read(&read, folder), 0);
    assert_int_equal(read.total, 1);
    unlinkat(folder, PANICS_FILE, 0);
}

static void test_a_link_a_fifo_and_a_folder_in_place_of_the_count_are_quarantined(void **state)
{
    (void)state;
    unlinkat(folder, PANICS_FILE, 0);
    assert_int_equal(symlinkat("other", folder, PANICS_FILE), 0);
    is_set_aside(PANICS_FILE ".other-1");
    assert_int_equal(mkfifoat(folder, PANICS_FILE, 0600), 0);
    is_set_aside(PANICS_FILE ".other-2");
    assert_int_equal(mkdirat(folder, PANICS_FILE, 0700), 0);
    is_set_aside(PANICS_FILE ".other-3");
    unlinkat(folder, PANICS_FILE ".other-1", 0);
    unlinkat(folder, PANICS_FILE ".other-2", 0);
    unlinkat(folder, PANICS_FILE ".other-3", AT_REMOVEDIR);
}

static void test_an_unremovable_object_on_a_read_only_card_is_reported(void **state)
{
    (void)state;
    struct panics panics = { .total = 1 };
    unlinkat(folder, PANICS_FILE, 0);
    rename_error = EROFS;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(i == 0   ? mkfifoat(folder, PANICS_FILE, 0600)
                         : i == 1 ? symlinkat("other", folder, PANICS_FILE)
                                  : mkdirat(folder, PANICS_FILE, 0700),
                         0);
        assert_int_equal(panics_read(&panics, folder), -ENOTSUP);
        assert_int_equal(panics_write(&panics, folder), -ENOTSUP);
        assert_string_equal(panics_error(-ENOTSUP), "is not a regular file, and cannot be renamed");
        unlinkat(folder, PANICS_FILE, i == 2 ? AT_REMOVEDIR : 0);
    }
    rename_error = 0;
    assert_string_equal(panics_error(-EBADMSG), "is not a count of panics");
    assert_string_equal(panics_error(-EACCES), "Permission denied");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_three_panics_within_ten_minutes_omit_data_and_two_do_not),
        cmocka_unit_test(test_three_panics_in_more_than_ten_minutes_omit_nothing),
        cmocka_unit_test(test_panics_of_an_earlier_boot_omit_nothing),
        cmocka_unit_test(test_one_panic_before_the_first_frame_omits_data),
        cmocka_unit_test(test_each_recovery_start_omits_one_more_part_and_resets_the_count),
        cmocka_unit_test(test_a_run_of_ten_minutes_restarts_the_omission_with_the_settings),
        cmocka_unit_test(test_a_panic_count_is_restored_from_its_private_file),
        cmocka_unit_test(test_a_missing_count_file_means_no_panic),
        cmocka_unit_test(test_a_count_file_with_any_wrong_byte_or_size_is_rejected),
        cmocka_unit_test(test_a_link_a_fifo_and_a_folder_in_place_of_the_count_are_quarantined),
        cmocka_unit_test(test_an_unremovable_object_on_a_read_only_card_is_reported),
    };
    return cmocka_run_group_tests(tests, open_folder, close_folder);
}
