/* test_out_file.c -- a file is whole or not there, a PNG too. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/ctl/canvas.h"
#include "platform/out_file.h"

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

/* A disk that is full after so many bytes. */
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

static void test_what_was_written_is_there(void **state)
{
    (void)state;
    struct out_file out;
    struct stat status;
    assert_int_equal(out_open(&out, path), 0);
    write_much(out.file);
    assert_int_equal(out_close(&out), 0);
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_size, 64 * 4096);
}

static void test_half_a_file_is_removed(void **state)
{
    (void)state;
    struct out_file out;
    assert_int_equal(out_open(&out, path), 0);
    limit_files(10000);
    write_much(out.file);
    const int error = out_close(&out);
    limit_files(RLIM_INFINITY);
    assert_int_equal(error, -EFBIG);
    assert_false(exists(path));
}

/* All fits into the buffer: only closing finds out. */
static void test_a_full_device_is_told_and_stays(void **state)
{
    (void)state;
    struct out_file out;
    assert_int_equal(out_open(&out, "/dev/full"), 0);
    fputs("x", out.file);
    assert_int_equal(out_close(&out), -ENOSPC);
    assert_true(exists("/dev/full"));
}

static void test_a_file_that_cannot_be_opened_is_left_alone(void **state)
{
    (void)state;
    struct out_file out;
    char below[80];
    assert_int_equal(out_open(&out, folder), -EISDIR);
    assert_true(exists(folder));
    snprintf(below, sizeof below, "%s/no/file", folder);
    assert_int_equal(out_open(&out, below), -ENOENT);
}

static void test_half_a_picture_is_removed(void **state)
{
    (void)state;
    struct canvas canvas;
    assert_true(canvas_open(&canvas, 200, 200));
    for (uint32_t i = 0; i < 200 * 200; i++) { /* Nothing that packs well. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_what_was_written_is_there),
        cmocka_unit_test(test_half_a_file_is_removed),
        cmocka_unit_test(test_a_full_device_is_told_and_stays),
        cmocka_unit_test(test_a_file_that_cannot_be_opened_is_left_alone),
        cmocka_unit_test(test_half_a_picture_is_removed),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
