/* test_pictures.c -- Tests contact sheets (images with several screenshots), PNG files and the
 * statistics of frame times. */
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/kiosk/demo.h"
#include "platform/kiosk/frame_pacer.h"
#include "platform/os/png.h"

/* Paints a picture whose left half is red and whose right half is green. */
static void paint(uint8_t *rgb, uint32_t width, uint32_t height)
{
    memset(rgb, 0, (size_t)width * height * 3);
    for (uint32_t i = 0; i < width * height; i++) {
        rgb[3 * i + (i % width < width / 2 ? 0 : 1)] = 200;
    }
}

static void test_a_contact_sheet_places_each_picture_with_its_aspect_ratio(void **state)
{
    static uint8_t picture[640 * 360 * 3];
    struct contact_sheet sheet;
    (void)state;
    const size_t size = demo_sheet_plan(&sheet, 640, 360);
    assert_int_equal(sheet.width, 4 * 480 + 5 * 16);
    assert_int_equal(sheet.height, 3 * 270 + 4 * 16);
    assert_int_equal(size, (size_t)sheet.width * sheet.height * 3);
    sheet.rgb = malloc(size);
    assert_non_null(sheet.rgb);
    demo_sheet_clear(&sheet);
    const uint8_t night = sheet.rgb[0];
    paint(picture, 640, 360);
    demo_sheet_put(&sheet, SHEET_PICTURES - 1, picture, 640, 360);
    const size_t left = 16 + 3 * (480 + 16);
    const size_t top = 16 + 2 * (270 + 16);
    const uint8_t *first = sheet.rgb + (top * sheet.width + left) * 3;
    const uint8_t *last = sheet.rgb + ((top + 269) * sheet.width + left + 479) * 3;
    assert_int_equal(first[0], 200);
    assert_int_equal(first[1], 0);
    assert_int_equal(last[0], 0);
    assert_int_equal(last[1], 200);
    assert_int_equal(first[-3], night);
    assert_int_equal(last[3], night);
    free(sheet.rgb);
}

static void test_pictures_of_any_size_are_scaled_to_their_cell(void **state)
{
    static const uint32_t sizes[][2] = {
        { 1, 1 }, { 3, 5 }, { 479, 271 }, { 1920, 1080 }, { 320, 2 },
    };
    static uint8_t picture[1920 * 1080 * 3];
    (void)state;
    memset(picture, 77, sizeof picture);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct contact_sheet sheet;
        sheet.rgb = malloc(demo_sheet_plan(&sheet, sizes[i][0], sizes[i][1]));
        assert_non_null(sheet.rgb);
        demo_sheet_clear(&sheet);
        demo_sheet_put(&sheet, 0, picture, sizes[i][0], sizes[i][1]);
        for (uint32_t y = 0; y < sheet.picture_height; y++) {
            for (uint32_t x = 0; x < SHEET_PICTURE_WIDTH; x++) {
                assert_int_equal(sheet.rgb[((16 + y) * sheet.width + 16 + x) * 3], 77);
            }
        }
        free(sheet.rgb);
    }
}

static void test_a_png_is_written_and_a_bad_path_is_an_error(void **state)
{
    static const uint8_t signature[] = { 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n' };
    static uint8_t picture[32 * 16 * 3];
    char path[] = "/tmp/kingyo-png-XXXXXX";
    uint8_t head[24];
    (void)state;
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    paint(picture, 32, 16);
    assert_int_equal(png_write(path, picture, 32, 16), 0);
    fd = open(path, O_RDONLY); /* The file was replaced by png_write(), so the test opens the path
                                  again. */
    assert_int_equal(read(fd, head, sizeof head), sizeof head);
    close(fd);
    unlink(path);
    assert_memory_equal(head, signature, sizeof signature);
    assert_int_equal(head[19], 32); /* The IHDR chunk has the width and the height, big-endian. */
    assert_int_equal(head[23], 16);
    assert_int_equal(png_write("/nowhere/at/all.png", picture, 32, 16), -ENOENT);
    assert_int_equal(png_write("/dev/full", picture, 32, 16), -ENOSPC);
}

static void test_quantiles_are_accurate_to_half_a_bin(void **state)
{
    static struct frame_timing timing;
    (void)state;
    assert_int_equal(frame_timing_quantile_ns(&timing, 0.5), 0);
    for (uint64_t i = 1; i <= 1000; i++) {
        /* The durations are 0.1 ms, 0.2 ms, and so on to 100 ms. */
        frame_timing_add(&timing, i * 100000);
    }
    assert_in_range(frame_timing_quantile_ns(&timing, 0.5), 49975000, 50050000);
    assert_in_range(frame_timing_quantile_ns(&timing, 0.99), 98975000, 99050000);
    assert_int_equal(timing.count, 1000);
    assert_int_equal(timing.max_ns, 100000000);
    frame_timing_add(&timing, UINT64_MAX / 4);
    /* A duration beyond the last bin of the histogram is still returned as the maximum. */
    assert_int_equal(frame_timing_quantile_ns(&timing, 1.0), UINT64_MAX / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_contact_sheet_places_each_picture_with_its_aspect_ratio),
        cmocka_unit_test(test_pictures_of_any_size_are_scaled_to_their_cell),
        cmocka_unit_test(test_a_png_is_written_and_a_bad_path_is_an_error),
        cmocka_unit_test(test_quantiles_are_accurate_to_half_a_bin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
