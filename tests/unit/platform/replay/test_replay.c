/* test_replay.c -- Tests the files of recordings. All inputs must be restored, and damaged or
 * altered recordings must be rejected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "platform/replay/replay.h"
#include "tests/unit/support/replay_fixture.h"

/* ---- Recorded inputs are restored ----------------------------------------------------------- */

static void test_every_input_is_restored_bit_for_bit(void **state)
{
    (void)state;
    write_ticks(500);
    assert_int_equal(replay_open(&reader, path), 0);
    assert_int_equal(reader.header.config.seed, 7);
    assert_int_equal(reader.header.config.fish_count, 12);
    assert_string_equal(reader.header.program, KINGYO_VERSION);
    for (uint32_t tick = 0; tick < 500; tick++) {
        struct input input;
        const struct input expected = input_of(tick);
        assert_int_equal(replay_next(&reader, &input), 1);
        assert_int_equal(reader.digest, tick * 3u);
        assert_int_equal(input.held, expected.held);
        assert_int_equal(input.pressed, expected.pressed);
        assert_int_equal(input.coin_count[0], expected.coin_count[0]);
        assert_int_equal(input.record_saved_id, expected.record_saved_id);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            assert_int_equal(input.poi[i].link, expected.poi[i].link);
            assert_int_equal(input.poi[i].has_wrist, expected.poi[i].has_wrist);
            assert_int_equal(input.poi[i].trembles, expected.poi[i].trembles);
            assert_int_equal(input.poi[i].age_ticks, expected.poi[i].age_ticks);
            assert_memory_equal(&input.poi[i].target, &expected.poi[i].target,
                                sizeof(struct poi_target));
        }
        for (uint32_t i = 0; i < SHADE_MAX; i++) {
            const struct shade_input *shade = &input.shade[i], *meant = &expected.shade[i];
            assert_int_equal(shade->present, meant->present);
            assert_memory_equal(&shade->x_m, &meant->x_m, sizeof(float));
            assert_memory_equal(&shade->z_m, &meant->z_m, sizeof(float));
            assert_memory_equal(&shade->radius_m, &meant->radius_m, sizeof(float));
        }
    }
    struct input none;
    assert_int_equal(replay_next(&reader, &none), 0);
    assert_int_equal(reader.totals.ticks, 500);
    assert_int_equal(reader.totals.caught, 4);
    assert_int_equal(reader.totals.fouls, 2);
    assert_int_equal(reader.totals.modes, 1u << MODE_CHAMPIONSHIP);
    assert_int_equal(reader.totals.players, 12);
    assert_int_equal(reader.totals.hash, 1499);
    replay_close(&reader);
}

static void test_an_empty_recording_is_complete(void **state)
{
    (void)state;
    struct replay_totals totals;
    empty_path();
    assert_int_equal(replay_create(&writer, path, &config, 99), 0);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(replay_finish(&writer, 99), 0);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, 0);
    assert_int_equal(totals.hash, 99);
}

static void test_a_recording_in_progress_is_complete_up_to_its_last_second(void **state)
{
    (void)state;
    struct replay_totals totals = { 0 };
    struct replay_totals found;
    empty_path();
    assert_int_equal(replay_create(&writer, path, &config, 99), 0);
    for (uint32_t tick = 0; tick < 3 * CORE_TICK_HZ + 7; tick++) {
        const struct input input = input_of(tick);
        totals.ticks++;
        replay_add(&writer, &input, tick, &totals);
        if (tick % 17u == 0) {
            assert_int_equal(scan(&found), 0);
            assert_int_equal(found.ticks, totals.ticks / CORE_TICK_HZ * CORE_TICK_HZ);
        }
    }
    assert_int_equal(replay_finish(&writer, 0), 0);
}

/* ---- Tests of damaged recordings ------------------------------------------------------------ */

static void test_a_recording_truncated_at_any_byte_is_rejected(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_ticks(130);
    const size_t size = read_file(bytes);
    for (size_t cut = 0; cut < size; cut++) {
        write_file(bytes, cut);
        assert_int_equal(scan(&totals), -1);
        assert_int_equal(reader.problem.is_io, 0);
        assert_in_range(reader.problem.offset, 0, cut);
        assert_true(reader.problem.text[0] != '\0');
    }
    assert_non_null(strstr(reader.problem.text, "; the first 1 seconds are valid"));
}

static void test_a_header_with_an_unprintable_program_name_is_rejected(void **state)
{
    static const char *const wrong[] = { "0.1\"", "0.1\\", "0.1\x1b[2J",
                                         "0.1\n", "\xff",  "0123456789abcdef" };
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    (void)state;
    write_ticks(0);
    const size_t size = read_file(bytes);
    assert_int_equal(scan(&totals), 0);
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        memset(bytes + HEADER_PROGRAM, 0, REPLAY_PROGRAM_SIZE);
        memcpy(bytes + HEADER_PROGRAM, wrong[i], strlen(wrong[i]));
        replay_put_u64(bytes + HEADER_SUM, hash_bytes(HASH_START, bytes, HEADER_SUM));
        write_file(bytes, size);
        assert_int_equal(scan(&totals), -1);
        assert_non_null(strstr(reader.problem.text, "never writes"));
    }
}

static void test_a_recording_with_any_altered_byte_is_rejected(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    static const uint8_t flips[] = { 0x01, 0x80, 0xff };
    struct replay_totals totals;
    write_ticks(130);
    const size_t size = read_file(bytes);
    for (size_t at = 0; at < size; at++) {
        for (size_t i = 0; i < sizeof flips; i++) {
            bytes[at] ^= flips[i];
            write_file(bytes, size);
            assert_int_equal(scan(&totals), -1);
            assert_true(reader.problem.text[0] != '\0');
            bytes[at] ^= flips[i];
        }
    }
    write_file(bytes, size);
    assert_int_equal(scan(&totals), 0);
}

static void test_data_after_the_end_mark_are_rejected(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_ticks(130);
    const size_t size = read_file(bytes);
    bytes[size] = 0;
    write_file(bytes, size + 1);
    assert_int_equal(scan(&totals), -1);
    assert_int_equal(reader.problem.offset, size);
}

/* Returns the offset of the first second of recorded inputs. The header, the initial state and a
 * checksum precede it. */
static size_t first_second(const uint8_t *bytes)
{
    return REPLAY_HEADER_SIZE + replay_get_u32(bytes + HEADER_START) + REPLAY_SUM_SIZE;
}

static void test_swapped_seconds_are_rejected(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    static uint8_t swapped[FILE_MAX];
    struct replay_totals totals;
    write_ticks(2 * CORE_TICK_HZ);
    const size_t size = read_file(bytes);
    const size_t first = first_second(bytes);
    const size_t first_size =
        REPLAY_CHUNK_HEAD_SIZE + replay_get_u32(bytes + first + 4) + REPLAY_SUM_SIZE;
    const size_t second_size = size - REPLAY_END_SIZE - first - first_size;
    memcpy(swapped, bytes, size);
    memcpy(swapped + first, bytes + first + first_size, second_size);
    memcpy(swapped + first + second_size, bytes + first, first_size);
    write_file(swapped, size);
    assert_int_equal(scan(&totals), -1);
    /* The file has lost its first second, so it must be rejected again. */
    memcpy(swapped, bytes, first);
    memcpy(swapped + first, bytes + first + first_size, size - first - first_size);
    write_file(swapped, size - first_size);
    assert_int_equal(scan(&totals), -1);
}

static void test_a_file_that_is_not_a_recording_has_its_own_error(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_file(bytes, 0);
    assert_int_equal(scan(&totals), -1);
    assert_string_equal(reader.problem.text, "the file is empty");
    memset(bytes, 'x', 1000);
    write_file(bytes, 1000);
    assert_int_equal(scan(&totals), -1);
    assert_string_equal(reader.problem.text, "not a recording of Kingyo");
    assert_int_equal(replay_scan(&reader, "/tmp", &totals), -1);
    assert_non_null(strstr(reader.problem.text, "folder"));
    assert_int_equal(reader.problem.is_io, 1);
    assert_int_equal(replay_scan(&reader, "/dev/zero", &totals), -1);
    assert_int_equal(reader.problem.is_io, 1);
    assert_int_equal(replay_scan(&reader, "/nowhere/at/all", &totals), -1);
    assert_int_equal(reader.problem.is_io, 1);
}

static void test_a_recording_of_a_different_version_is_reported(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_ticks(3);
    const size_t size = read_file(bytes);
    bytes[8] = REPLAY_VERSION + 1u;
    write_file(bytes, size);
    assert_int_equal(scan(&totals), -1);
    assert_non_null(strstr(reader.problem.text, "version 13"));
    /* For each old version that this program cannot read, the message must name the version. */
    for (uint8_t old = 1; old < REPLAY_VERSION_MIN; old++) {
        char expected[REPLAY_PROBLEM_SIZE];
        bytes[8] = old;
        write_file(bytes, size);
        snprintf(expected, sizeof expected,
                 "format version %u; this program reads versions %u to %u", old, REPLAY_VERSION_MIN,
                 REPLAY_VERSION);
        assert_int_equal(scan(&totals), -1);
        assert_string_equal(reader.problem.text, expected);
    }
}

static void test_a_huge_file_of_zeros_is_rejected_at_its_first_second(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_ticks(3);
    read_file(bytes);
    assert_int_equal(truncate(path, (off_t)first_second(bytes)), 0);
    /* Extends the file to 1 TB of zeros. The file is sparse and uses no disk space. */
    assert_int_equal(truncate(path, (off_t)1 << 40), 0);
    assert_int_equal(scan(&totals), -1);
    assert_int_equal(reader.problem.offset, first_second(bytes));
    assert_int_equal(truncate(path, 0), 0);
}

/* ---- Tests of a full disk ------------------------------------------------------------------- */

static void test_a_full_disk_stops_a_recording_that_stays_complete(void **state)
{
    (void)state;
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_IGN);
    for (rlim_t limit = 2000; limit < 3000; limit += 37) {
        struct replay_totals totals = { 0 };
        struct replay_totals found;
        const struct rlimit small = { .rlim_cur = limit, .rlim_max = before.rlim_max };
        empty_path();
        assert_int_equal(replay_create(&writer, path, &config, 99), 0);
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
        for (uint32_t tick = 0; tick < 10 * CORE_TICK_HZ; tick++) {
            const struct input input = input_of(tick);
            totals.ticks++;
            replay_add(&writer, &input, tick, &totals);
        }
        const int result = replay_finish(&writer, 0);
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
        assert_int_equal(result, -EFBIG);
        assert_int_equal(scan(&found), 0);
        assert_int_equal(found.ticks, writer.saved.ticks);
        assert_int_equal(found.ticks % CORE_TICK_HZ, 0);
    }
}

static void test_an_existing_recording_is_never_replaced(void **state)
{
    static uint8_t before[FILE_MAX], after[FILE_MAX];
    (void)state;
    write_ticks(130);
    const size_t size = read_file(before);
    assert_int_equal(replay_create(&writer, path, &config, 99), -EEXIST);
    assert_int_equal(read_file(after), size);
    assert_memory_equal(before, after, size);
}

static void test_an_unwritable_recording_path_is_an_error(void **state)
{
    (void)state;
    assert_int_equal(replay_create(&writer, "/nowhere/at/all", &config, 0), -ENOENT);
    assert_int_equal(replay_create(&writer, "/tmp", &config, 0), -EISDIR);
    assert_int_equal(replay_create(&writer, "/dev/full", &config, 0), -ENOTSUP);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_input_is_restored_bit_for_bit),
        cmocka_unit_test(test_an_empty_recording_is_complete),
        cmocka_unit_test(test_a_recording_in_progress_is_complete_up_to_its_last_second),
        cmocka_unit_test(test_a_recording_truncated_at_any_byte_is_rejected),
        cmocka_unit_test(test_a_header_with_an_unprintable_program_name_is_rejected),
        cmocka_unit_test(test_a_recording_with_any_altered_byte_is_rejected),
        cmocka_unit_test(test_data_after_the_end_mark_are_rejected),
        cmocka_unit_test(test_swapped_seconds_are_rejected),
        cmocka_unit_test(test_a_file_that_is_not_a_recording_has_its_own_error),
        cmocka_unit_test(test_a_recording_of_a_different_version_is_reported),
        cmocka_unit_test(test_a_huge_file_of_zeros_is_rejected_at_its_first_second),
        cmocka_unit_test(test_a_full_disk_stops_a_recording_that_stays_complete),
        cmocka_unit_test(test_an_existing_recording_is_never_replaced),
        cmocka_unit_test(test_an_unwritable_recording_path_is_an_error),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
