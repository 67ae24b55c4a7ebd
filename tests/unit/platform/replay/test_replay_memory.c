/* test_replay_memory.c -- Tests recordings that are written into memory instead of a file. */
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

static uint8_t memory[FILE_MAX], copied[FILE_MAX];

static struct replay_totals totals_of(uint32_t ticks)
{
    return (struct replay_totals){ .ticks = ticks, .caught = ticks / 50u, .hash = 500u + ticks };
}

/* Records `count` ticks into `size` bytes of memory. */
static void write_memory(uint32_t count, size_t size)
{
    assert_int_equal(replay_create_in(&writer, memory, size, &config, 99), 0);
    for (uint32_t tick = 0; tick < count; tick++) {
        const struct input input = input_of(tick);
        const struct replay_totals totals = totals_of(tick + 1u);
        assert_true(replay_needs_digest(&writer) == (tick % CORE_TICK_HZ == CORE_TICK_HZ - 1u));
        replay_add(&writer, &input, tick, &totals);
    }
}

static void test_a_copy_is_a_complete_recording_and_the_recording_continues(void **state)
{
    static const uint32_t counts[] = { 0, 1, 119, 120, 121, 500 };
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        write_memory(counts[i], sizeof memory);
        const uint64_t hash = counts[i] > 0 ? 500u + counts[i] : 99u;
        const size_t size = replay_copy(&writer, hash, copied, sizeof copied);
        struct replay_totals totals;
        assert_int_equal(replay_open_in(&reader, copied, size), 0);
        assert_int_equal(replay_scan_on(&reader, &totals), 0);
        assert_int_equal(totals.ticks, counts[i]);
        assert_true(totals.hash == hash);
        assert_int_equal(replay_copy(&writer, hash, copied, size - 1u), 0);
        assert_int_equal(replay_copy(&writer, hash, copied, size), size);

        const struct input input = input_of(counts[i]);
        const struct replay_totals more = totals_of(counts[i] + 1u);
        replay_add(&writer, &input, 1, &more);
        const size_t longer = replay_copy(&writer, more.hash, copied, sizeof copied);
        assert_int_equal(replay_open_in(&reader, copied, longer), 0);
        assert_int_equal(replay_scan_on(&reader, &totals), 0);
        assert_int_equal(totals.ticks, counts[i] + 1u);
    }
}

static void test_full_memory_ends_a_recording_that_stays_complete(void **state)
{
    (void)state;
    struct replay_totals totals;
    write_memory(500, sizeof memory);
    /* `whole` is the exact size of the recording of 500 ticks. With one byte less, the recording
     * must end early. */
    const size_t whole = (size_t)writer.offset + REPLAY_END_SIZE;
    write_memory(500, whole);
    assert_true(replay_is_open(&writer));
    write_memory(500, whole - 1u);
    assert_false(replay_is_open(&writer));
    assert_int_equal(writer.error, ENOSPC);
    assert_int_equal(writer.saved.ticks, 3u * CORE_TICK_HZ);
    assert_int_equal(replay_copy(&writer, 0, copied, sizeof copied), 0);
    assert_int_equal(replay_open_in(&reader, memory, (size_t)writer.offset + REPLAY_END_SIZE), 0);
    assert_int_equal(replay_scan_on(&reader, &totals), 0);
    assert_int_equal(totals.ticks, 3u * CORE_TICK_HZ);
    assert_int_equal(replay_create_in(&writer, memory, 60, &config, 99), -ENOSPC);
    assert_false(replay_is_open(&writer));
}

static void test_the_digest_of_each_second_is_restored(void **state)
{
    (void)state;
    write_memory(250, sizeof memory);
    const size_t size = replay_copy(&writer, 1, copied, sizeof copied);
    assert_int_equal(replay_open_in(&reader, copied, size), 0);
    for (uint32_t tick = 0; tick < 250; tick++) {
        struct input input;
        assert_int_equal(replay_next(&reader, &input), 1);
        assert_int_equal(reader.has_digest, tick % CORE_TICK_HZ == CORE_TICK_HZ - 1u);
        assert_true(!reader.has_digest || reader.digest == tick);
        assert_int_equal(input.held, input_of(tick).held);
    }
}

static void test_a_truncated_recording_in_memory_is_rejected(void **state)
{
    (void)state;
    struct replay_totals totals;
    write_memory(130, sizeof memory);
    const size_t size = replay_copy(&writer, 1, copied, sizeof copied);
    for (size_t cut = 0; cut < size; cut++) {
        assert_true(replay_open_in(&reader, copied, cut) != 0 ||
                    replay_scan_on(&reader, &totals) != 0);
        assert_int_equal(reader.problem.is_io, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_copy_is_a_complete_recording_and_the_recording_continues),
        cmocka_unit_test(test_full_memory_ends_a_recording_that_stays_complete),
        cmocka_unit_test(test_the_digest_of_each_second_is_restored),
        cmocka_unit_test(test_a_truncated_recording_in_memory_is_rejected),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
