/* test_hid_mapping_store.c -- tests that learned mappings survive a restart, an incomplete write
 * and storage errors. */
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

#include "drivers/hid/hid_mapping_store.h"
#include "drivers/hid/hid_mapping.h"
#include "tests/unit/support/hid_wire.h"

static struct clock_sim clock_now;
static struct hid_wire wire;
static struct hid_mapping_store store;
static char data[64];
static char error_line[2048];

static int make_folder(void **state)
{
    (void)state;
    snprintf(data, sizeof data, "/tmp/kingyo-store-XXXXXX");
    return mkdtemp(data) ? 0 : -1;
}

static int remove_folder(void **state)
{
    char command[192];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", data);
    return system(command);
}

static void log_error(void *self, const char *line)
{
    (void)self;
    snprintf(error_line, sizeof error_line, "%s", line);
}

static uint32_t open_book(void)
{
    error_line[0] = '\0';
    return hid_mapping_store_open(&store, data, log_error, NULL);
}

static struct hid_identity identity(uint16_t vendor, uint16_t product, const char *serial)
{
    struct hid_identity out = { .vendor = vendor, .product = product };
    snprintf(out.serial, sizeof out.serial, "%s", serial);
    return out;
}

/* Returns a valid mapping of a DualSense gamepad that differs from the built-in one. */
static struct hid_mapping learned(void)
{
    struct hid_mapping map;
    wire_load(&wire, &clock_now, "016-ci-dualsense");
    hid_mapping_choose(&map, &wire.face.identity, &wire.descriptor);
    assert_int_equal(map.source, HID_MAPPING_AUTO);
    map.source = HID_MAPPING_LEARNED;
    map.binding[0].full = 0;
    return map;
}

/* Stores a mapping. Retries while the store's thread is still busy with an earlier write. */
static int keep(const struct hid_identity *who, const struct hid_mapping *map)
{
    int result;
    for (uint32_t i = 0; i < 5000; i++) {
        if ((result = hid_mapping_store_put(&store, who, map)) != HAL_ERR_BUSY) {
            break;
        }
        usleep(1000);
    }
    return result;
}

static void write_file(const char *name, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/pois", data);
    mkdir(path, 0755);
    snprintf(path, sizeof path, "%s/pois/%s", data, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void test_a_stored_mapping_is_loaded_after_a_restart(void **state)
{
    const struct hid_identity who = identity(0x054c, 0x0ce6, "a/../b \xe9\x87\x91%");
    const struct hid_mapping map = learned();
    (void)state;
    assert_int_equal(open_book(), 0);
    assert_null(hid_mapping_store_find(&store, &who));
    assert_int_equal(keep(&who, &map), HAL_OK);
    /* The store must return the mapping even before the mapping is written to the file. */
    assert_non_null(hid_mapping_store_find(&store, &who));
    hid_mapping_store_close(&store);
    assert_int_equal(store.written_count, 1);
    assert_int_equal(open_book(), 0);
    const struct hid_mapping *back = hid_mapping_store_find(&store, &who);
    assert_non_null(back);
    assert_int_equal(back->count, map.count);
    assert_int_equal(back->binding[0].full, 0);
    hid_mapping_store_close(&store);
}

static void test_a_mapping_is_stored_by_vendor_product_and_serial_number(void **state)
{
    const struct hid_identity one = identity(1, 2, "A"), other = identity(1, 2, "B"),
                              third = identity(1, 3, "A");
    const struct hid_mapping map = learned();
    (void)state;
    open_book();
    assert_int_equal(keep(&one, &map), HAL_OK);
    assert_null(hid_mapping_store_find(&store, &other));
    assert_null(hid_mapping_store_find(&store, &third));
    hid_mapping_store_close(&store);
}

static void test_a_removed_mapping_stays_removed(void **state)
{
    const struct hid_identity one = identity(1, 2, "A"), other = identity(1, 2, "B");
    const struct hid_mapping map = learned();
    int result;
    (void)state;
    open_book();
    keep(&one, &map);
    keep(&other, &map);
    while ((result = hid_mapping_store_forget(&store, &one)) == HAL_ERR_BUSY) {
        usleep(1000);
    }
    assert_int_equal(result, HAL_OK);
    assert_null(hid_mapping_store_find(&store, &one));
    hid_mapping_store_close(&store);
    open_book();
    assert_null(hid_mapping_store_find(&store, &one));
    assert_non_null(hid_mapping_store_find(&store, &other));
    hid_mapping_store_close(&store);
}

static void test_a_mapping_is_used_only_if_it_matches_the_descriptor(void **state)
{
    struct hid_mapping map = learned(), chosen;
    struct hid_mapper mapper;
    (void)state;
    wire.face.identity = identity(0x054c, 0x0ce6, "");
    open_book();
    mapper = hid_mapping_store_mapper(&store);
    mapper.choose(mapper.self, &wire.face, &wire.descriptor, &chosen);
    assert_int_equal(chosen.source, HID_MAPPING_KNOWN);
    keep(&wire.face.identity, &map);
    mapper.choose(mapper.self, &wire.face, &wire.descriptor, &chosen);
    assert_int_equal(chosen.source, HID_MAPPING_LEARNED);
    /* Bit 100000 is beyond the end of the report. A stored mapping can become invalid in this way
     * when a firmware update changes the descriptor. */
    map.binding[0].bit_offset = 100000;
    keep(&wire.face.identity, &map);
    mapper.choose(mapper.self, &wire.face, &wire.descriptor, &chosen);
    assert_int_equal(chosen.source, HID_MAPPING_KNOWN);
    hid_mapping_store_close(&store);
}

static void test_an_invalid_file_gives_one_message_and_the_others_are_read(void **state)
{
    struct hid_mapping_store_entry entry = { .vendor = 7, .product = 8, .map = learned() };
    char text[HID_MAPPING_STORE_TEXT_SIZE];
    const struct hid_identity who = identity(7, 8, "");
    static const char *const bad[][2] = {
        { "", ":1: not \"kingyo poi 1\"" },
        { "kingyo poi 2\n", ":1: not \"kingyo poi 1\"" },
        { "kingyo poi 1\n12:34:x\n", ":2: must be vendor:product:serial" },
        { "kingyo poi 1\n0001:0002:%zz\nlearned fly\n", ":2: must be vendor:product:serial" },
        { "kingyo poi 1\n0001:0002:a\n", ":3: must be one line with a mapping" },
        { "kingyo poi 1\n0001:0002:a\nlearned fly", ":3: must be one line with a mapping" },
        { "kingyo poi 1\n0001:0002:a\nlearned hop\n", ":3: the second word is no style" },
        { "kingyo poi 1\n0001:0002:a\nlearned fly\nmore\n", ":3: must be one line with a mapping" },
    };
    (void)state;
    assert_int_equal(hid_mapping_store_write(&entry, text), 0);
    write_file("good.poi", text);
    write_file("notes.txt", "nobody reads this");
    for (uint32_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        write_file("bad.poi", bad[i][0]);
        assert_int_equal(open_book(), 1);
        if (!strstr(error_line, bad[i][1]) || !strstr(error_line, "/pois/bad.poi:")) {
            fail_msg("'%s' is complained of as '%s'", bad[i][0], error_line);
        }
        assert_non_null(hid_mapping_store_find(&store, &who));
        hid_mapping_store_close(&store);
    }
}

static void test_a_special_file_does_not_block_the_start(void **state)
{
    char path[128];
    (void)state;
    write_file("good.poi", "kingyo poi 1\n");
    snprintf(path, sizeof path, "%s/pois/pipe.poi", data);
    assert_int_equal(mkfifo(path, 0644), 0);
    snprintf(path, sizeof path, "%s/pois/folder.poi", data);
    assert_int_equal(mkdir(path, 0755), 0);
    snprintf(path, sizeof path, "%s/pois/long.poi", data);
    FILE *file = fopen(path, "w");
    for (uint32_t i = 0; i < 3u * HID_MAPPING_STORE_TEXT_SIZE; i++) {
        fputc('x', file);
    }
    fclose(file);
    assert_int_equal(open_book(), 4);
    hid_mapping_store_close(&store);
}

static void test_mappings_stay_in_memory_if_the_card_is_read_only(void **state)
{
    const struct hid_identity who = identity(1, 2, "A");
    const struct hid_mapping map = learned();
    char path[128];
    (void)state;
    snprintf(path, sizeof path, "%s/pois", data);
    /* Creates a regular file at the path of the folder, so that no mapping can be written. */
    FILE *file = fopen(path, "w");
    fclose(file);
    open_book();
    hid_mapping_store_set_error_sink(&store, log_error, NULL);
    assert_int_equal(keep(&who, &map), HAL_OK);
    assert_non_null(hid_mapping_store_find(&store, &who));
    while (hid_mapping_store_result(&store) == HAL_ERR_BUSY) {
        usleep(1000);
    }
    assert_int_equal(hid_mapping_store_result(&store), HAL_ERR_IO);
    hid_mapping_store_close(&store);
    assert_int_equal(store.failed_count, 1);
    assert_non_null(strstr(error_line, "/pois/0001-0002-A.poi: Not a directory; the change"));
}

/* A power cut during a write leaves only the temporary file, which must not be read. */
static void test_a_torn_write_keeps_the_previous_mapping(void **state)
{
    const struct hid_identity who = identity(1, 2, "A");
    const struct hid_mapping map = learned();
    (void)state;
    open_book();
    keep(&who, &map);
    hid_mapping_store_close(&store);
    write_file("0001-0002-A.poi.part", "kingyo poi 1\n0001:00");
    assert_int_equal(open_book(), 0);
    assert_non_null(hid_mapping_store_find(&store, &who));
    hid_mapping_store_close(&store);
}

static void test_a_full_store_rejects_a_mapping_with_a_message(void **state)
{
    const struct hid_mapping map = learned();
    (void)state;
    /* Without a folder, the store must work too. */
    hid_mapping_store_open(&store, NULL, NULL, NULL);
    for (uint32_t i = 0; i < HID_MAPPING_STORE_MAX; i++) {
        const struct hid_identity who = identity((uint16_t)(i + 1u), 1, "");
        assert_int_equal(hid_mapping_store_put(&store, &who, &map), HAL_OK);
    }
    const struct hid_identity more = identity(999, 1, ""), known = identity(1, 1, "");
    assert_int_equal(hid_mapping_store_put(&store, &more, &map), HAL_ERR_IO);
    assert_int_equal(hid_mapping_store_put(&store, &known, &map), HAL_OK);
    assert_int_equal(hid_mapping_store_forget(&store, &known), HAL_OK);
    assert_int_equal(hid_mapping_store_put(&store, &more, &map), HAL_OK);
    hid_mapping_store_close(&store);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_stored_mapping_is_loaded_after_a_restart,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(
            test_a_mapping_is_stored_by_vendor_product_and_serial_number, make_folder,
            remove_folder),
        cmocka_unit_test_setup_teardown(test_a_removed_mapping_stays_removed, make_folder,
                                        remove_folder),
        cmocka_unit_test_setup_teardown(test_a_mapping_is_used_only_if_it_matches_the_descriptor,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(
            test_an_invalid_file_gives_one_message_and_the_others_are_read, make_folder,
            remove_folder),
        cmocka_unit_test_setup_teardown(test_a_special_file_does_not_block_the_start, make_folder,
                                        remove_folder),
        cmocka_unit_test_setup_teardown(test_mappings_stay_in_memory_if_the_card_is_read_only,
                                        make_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_a_torn_write_keeps_the_previous_mapping, make_folder,
                                        remove_folder),
        cmocka_unit_test(test_a_full_store_rejects_a_mapping_with_a_message),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
