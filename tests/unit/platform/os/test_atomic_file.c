/* test_atomic_file.c -- Tests that a file is written completely or not at all. The same function
 * writes PNG files. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "platform/ctl/lib/canvas.h"
#include "platform/os/file.h"

static char folder[] = "/tmp/kingyo_out_XXXXXX";
static char path[64];

static int set_up(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "%s/file", mkdtemp(folder));
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

static int exists(const char *name)
{
    struct stat status;
    return stat(name, &status) == 0;
}

/* Limits the size of files to `size` bytes. A larger write fails with EFBIG, like a write to a full
 * disk. */
static void limit_files(rlim_t size)
{
    struct rlimit limit;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    limit.rlim_cur = size;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

static void write_much(FILE *file)
{
    static const char block[4096];
    for (uint32_t i = 0; i < 64; i++) {
        fwrite(block, 1, sizeof block, file);
    }
}

static void test_a_written_file_has_its_content(void **state)
{
    (void)state;
    struct atomic_file out;
    struct stat status;
    assert_int_equal(file_atomic_open(&out, path), 0);
    write_much(out.file);
    assert_int_equal(file_atomic_close(&out), 0);
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_size, 64 * 4096);
    unlink(path);
}

static void test_an_incomplete_file_is_removed(void **state)
{
    (void)state;
    struct atomic_file out;
    assert_int_equal(file_atomic_open(&out, path), 0);
    limit_files(10000);
    write_much(out.file);
    const int error = file_atomic_close(&out);
    limit_files(RLIM_INFINITY);
    assert_int_equal(error, -EFBIG);
    assert_false(exists(path));
}

/* The C library keeps the written byte in its buffer until the close. Only the close can therefore
 * report that the device is full. */
static void test_a_full_device_is_reported_and_not_removed(void **state)
{
    (void)state;
    struct atomic_file out;
    assert_int_equal(file_atomic_open(&out, "/dev/full"), 0);
    fputs("x", out.file);
    assert_int_equal(file_atomic_close(&out), -ENOSPC);
    assert_true(exists("/dev/full"));
}

static void test_a_file_that_cannot_be_opened_is_not_changed(void **state)
{
    (void)state;
    struct atomic_file out;
    char below[80];
    assert_int_equal(file_atomic_open(&out, folder), -EISDIR);
    assert_true(exists(folder));
    snprintf(below, sizeof below, "%s/no/file", folder);
    assert_int_equal(file_atomic_open(&out, below), -ENOENT);
}

static void test_an_incomplete_png_is_removed(void **state)
{
    (void)state;
    struct canvas canvas;
    assert_true(canvas_open(&canvas, 200, 200));
    for (uint32_t i = 0; i < 200 * 200; i++) { /* Random pixels do not compress, so the file exceeds
                                                  the limit below. */
        canvas.pixels[i].x = (float)(i * 2654435761u >> 8) / 16777216.0f;
    }
    limit_files(1000);
    assert_int_equal(canvas_write_png(&canvas, path), -EFBIG);
    limit_files(RLIM_INFINITY);
    assert_false(exists(path));
    assert_int_equal(canvas_write_png(&canvas, path), 0);
    assert_true(exists(path));
    canvas_close(&canvas);
}

/* ---- Tests of files that are not regular files ---------------------------------------------- */

static mode_t kind_of(const char *name)
{
    struct stat status;
    assert_int_equal(lstat(name, &status), 0);
    return status.st_mode & S_IFMT;
}

static void write_words(const char *name, const char *words)
{
    FILE *file = fopen(name, "w");
    assert_non_null(file);
    fputs(words, file);
    assert_int_equal(fclose(file), 0);
}

static void reads(const char *name, const char *words)
{
    char is[64] = "";
    FILE *file = fopen(name, "r");
    assert_non_null(file);
    assert_true(fread(is, 1, sizeof is - 1, file) == strlen(words));
    fclose(file);
    assert_string_equal(is, words);
}

static int write_new(int (*open_out)(struct atomic_file *, const char *), const char *name)
{
    struct atomic_file out;
    const int error = open_out(&out, name);
    if (error != 0) {
        return error;
    }
    fputs("new", out.file);
    return file_atomic_close(&out);
}

static void test_a_full_disk_keeps_the_existing_file(void **state)
{
    (void)state;
    struct atomic_file out;
    write_words(path, "old");
    assert_int_equal(chmod(path, 0640), 0);
    assert_int_equal(file_atomic_open(&out, path), 0);
    limit_files(10000);
    write_much(out.file);
    reads(path, "old");
    const int error = file_atomic_close(&out);
    limit_files(RLIM_INFINITY);
    assert_int_equal(error, -EFBIG);
    reads(path, "old");
    assert_int_equal(write_new(file_atomic_open, path), 0);
    reads(path, "new");
    struct stat status;
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
    unlink(path);
}

static void test_a_pipe_receives_the_data_and_is_not_replaced(void **state)
{
    (void)state;
    char is[8] = "";
    assert_int_equal(mkfifo(path, 0600), 0);
    /* The FIFO has no reader, so the open must fail at once instead of blocking. */
    assert_int_equal(write_new(file_atomic_open, path), -ENXIO);
    const int reader = open(path, O_RDONLY | O_NONBLOCK);
    assert_true(reader >= 0);
    assert_int_equal(write_new(file_atomic_open_durable, path), -ENOTSUP);
    assert_int_equal(write_new(file_atomic_open, path), 0);
    assert_int_equal(read(reader, is, sizeof is), 3);
    assert_string_equal(is, "new");
    close(reader);
    assert_int_equal(kind_of(path), S_IFIFO);
    unlink(path);
}

/* No kind of write may replace a device. Creating a device node needs a permission, without which
 * the test is skipped. */
static void test_a_device_is_never_replaced(void **state)
{
    (void)state;
    /* Creates a device node like /dev/full in the folder of the test. */
    if (mknod(path, S_IFCHR | 0600, makedev(1, 7)) != 0) {
        skip();
    }
    const int fd = open(path, O_WRONLY | O_CLOEXEC);
    /* The device cannot be opened if the file system has the mount option nodev. */
    const int opens = fd >= 0;
    if (opens) {
        close(fd);
    }
    assert_int_equal(write_new(file_atomic_open, path), opens ? -ENOSPC : -EACCES);
    assert_int_equal(write_new(file_atomic_open_durable, path), -ENOTSUP);
    assert_int_equal(kind_of(path), S_IFCHR);
    unlink(path);
    /* The path is now a block device, which must be rejected too. */
    if (mknod(path, S_IFBLK | 0600, makedev(7, 250)) == 0) {
        assert_int_equal(write_new(file_atomic_open, path), -ENOTSUP);
        assert_int_equal(kind_of(path), S_IFBLK);
        unlink(path);
    }
}

static void test_a_link_keeps_its_target(void **state)
{
    (void)state;
    char link[80], part[80];
    snprintf(link, sizeof link, "%s/link", folder);
    snprintf(part, sizeof part, "%s" FILE_ATOMIC_PART, path);
    assert_int_equal(symlink(path, link), 0);
    assert_int_equal(write_new(file_atomic_open, link), -ENOENT);
    assert_int_equal(write_new(file_atomic_open_durable, link), -ENOENT);
    assert_false(exists(path));
    write_words(path, "old");
    assert_int_equal(write_new(file_atomic_open, link), 0);
    assert_int_equal(kind_of(link), S_IFLNK);
    reads(path, "new");
    /* The path of the temporary file is a link. The target of the link must not be changed. */
    unlink(link);
    write_words(link, "theirs");
    assert_int_equal(symlink(link, part), 0);
    assert_int_equal(write_new(file_atomic_open_durable, path), 0);
    reads(link, "theirs");
    reads(path, "new");
    assert_false(exists(part));
    unlink(link);
    unlink(path);
}

static void test_a_rename_replaces_no_file(void **state)
{
    (void)state;
    char other[80];
    snprintf(other, sizeof other, "%s.other", path);
    assert_int_equal(file_replace(path, "new", 3, 0), 0);
    assert_int_equal(symlink("nowhere", other), 0);
    assert_int_equal(file_rename_new(path, other), -EEXIST);
    assert_true(exists(path));
    assert_int_equal(unlink(other), 0);
    assert_int_equal(file_rename_new(path, other), 0);
    assert_false(exists(path));
    assert_true(exists(other));
    assert_int_equal(file_rename_new(path, other), -ENOENT);
    unlink(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_written_file_has_its_content),
        cmocka_unit_test(test_an_incomplete_file_is_removed),
        cmocka_unit_test(test_a_full_device_is_reported_and_not_removed),
        cmocka_unit_test(test_a_file_that_cannot_be_opened_is_not_changed),
        cmocka_unit_test(test_an_incomplete_png_is_removed),
        cmocka_unit_test(test_a_full_disk_keeps_the_existing_file),
        cmocka_unit_test(test_a_pipe_receives_the_data_and_is_not_replaced),
        cmocka_unit_test(test_a_device_is_never_replaced),
        cmocka_unit_test(test_a_link_keeps_its_target),
        cmocka_unit_test(test_a_rename_replaces_no_file),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
