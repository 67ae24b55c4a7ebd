/* test_replay.c -- recordings: what goes in comes out, and nothing false passes. */
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/replay/replay.h"
#include "platform/replay/replay_format.h"

#define FILE_MAX (1u << 20)

static char path[] = "/tmp/kingyo-replay-XXXXXX";
static struct replay_writer writer;
static struct replay_reader reader;
static const struct core_config config = { .seed = 7, .fish_count = 12, .round_s = 10 };

static int make_path(void **state)
{
    (void)state;
    const int fd = mkstemp(path);
    return fd < 0 ? -1 : close(fd);
}

static int remove_path(void **state)
{
    (void)state;
    return unlink(path);
}

/* Inputs that use every part of the format: still, moving, pressing, plugged and unplugged. */
static struct input input_of(uint32_t tick)
{
    const struct rng_key key = { 1, tick, 0, RNG_TEST };
    struct input input = { .held = (tick / 7u) & INPUT_BUTTON_ALL, .record_saved_id = tick / 50u };
    input.pressed = tick % 11u == 0 ? INPUT_START : 0;
    input.coin_count[0] = tick % 13u == 0 ? 2 : 0;
    for (uint32_t i = 0; i < 2; i++) {
        input.poi[i].link = (uint8_t)((tick / 40u + i) % 4u);
        input.poi[i].has_wrist = (tick / 60u) % 2u;
        input.poi[i].trembles = (tick / 70u) % 2u;
        input.poi[i].age_ticks = (uint16_t)(tick % 40u > 20u ? tick * 37u : 0u);
        input.poi[i].target.position_m.x = tick % 5u ? 0.25f : rng_range(key, -1.0f, 1.0f);
        input.poi[i].target.angles.roll_rad = tick % 9u ? -0.0f : 0.5f;
    }
    for (uint32_t i = 1; i < SHADE_MAX; i += 2) {
        input.shade[i].present = (uint8_t)((tick / 30u + i / 2u) % 2u);
        input.shade[i].x_m = tick % 6u ? 0.125f : rng_range(key, -0.5f, 0.5f);
        input.shade[i].z_m = tick % 8u ? -0.0f : 0.2f;
        input.shade[i].radius_m = tick / 90u % 2u ? 0.10f : 0.08f;
    }
    return input;
}

static void empty_path(void)
{
    assert_int_equal(truncate(path, 0), 0);
}

static void write_ticks(uint32_t count)
{
    struct replay_totals totals = { 0 };
    empty_path();
    assert_int_equal(replay_create(&writer, path, &config, 99), 0);
    for (uint32_t tick = 0; tick < count; tick++) {
        const struct input input = input_of(tick);
        totals.ticks++;
        totals.caught = tick / 100u;
        totals.fouls = tick / 200u;
        totals.modes = (uint16_t)(1u << tick / 300u);
        totals.players = (uint16_t)(tick / 100u | 8u);
        totals.hash = 1000u + tick;
        replay_add(&writer, &input, tick * 3u, &totals);
    }
    assert_int_equal(replay_finish(&writer, 1000u + count - 1u), 0);
}

static size_t read_file(uint8_t *bytes)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size = fread(bytes, 1, FILE_MAX, file);
    fclose(file);
    return size;
}

static void write_file(const uint8_t *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static int scan(struct replay_totals *totals)
{
    return replay_scan(&reader, path, totals);
}

/* ---- What goes in comes out ----------------------------------------------------------------- */

static void test_every_input_comes_back_to_the_bit(void **state)
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

static void test_a_recording_of_nothing_is_whole(void **state)
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

static void test_a_recording_in_progress_is_whole_up_to_its_last_second(void **state)
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

/* ---- Damage --------------------------------------------------------------------------------- */

static void test_cut_at_any_byte_it_is_refused(void **state)
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
    assert_non_null(strstr(reader.problem.text, "; 1 whole seconds before that are good"));
}

static void test_a_header_may_name_only_a_printable_program(void **state)
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

static void test_any_altered_byte_is_refused(void **state)
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

static void test_anything_behind_the_end_mark_is_refused(void **state)
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

/* Where the first second stands: behind the header, and the start with its sum. */
static size_t first_second(const uint8_t *bytes)
{
    return REPLAY_HEADER_SIZE + replay_get_u32(bytes + HEADER_START) + REPLAY_SUM_SIZE;
}

static void test_seconds_that_change_places_are_refused(void **state)
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
    /* ... and so is a file whose first second was taken out. */
    memcpy(swapped, bytes, first);
    memcpy(swapped + first, bytes + first + first_size, size - first - first_size);
    write_file(swapped, size - first_size);
    assert_int_equal(scan(&totals), -1);
}

static void test_what_is_no_recording_is_told_apart(void **state)
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

static void test_another_version_is_named(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_ticks(3);
    const size_t size = read_file(bytes);
    bytes[8] = 9;
    write_file(bytes, size);
    assert_int_equal(scan(&totals), -1);
    assert_non_null(strstr(reader.problem.text, "version 9"));
    for (uint8_t old = 1; old < REPLAY_VERSION_MIN; old++) { /* replay.h lists what each lacks. */
        char says[REPLAY_PROBLEM_SIZE];
        bytes[8] = old;
        write_file(bytes, size);
        snprintf(says, sizeof says, "format version %u; this program reads versions %u to %u", old,
                 REPLAY_VERSION_MIN, REPLAY_VERSION);
        assert_int_equal(scan(&totals), -1);
        assert_string_equal(reader.problem.text, says);
    }
}

static void test_a_huge_file_of_nothing_is_refused_at_its_first_second(void **state)
{
    (void)state;
    static uint8_t bytes[FILE_MAX];
    struct replay_totals totals;
    write_ticks(3);
    read_file(bytes);
    assert_int_equal(truncate(path, (off_t)first_second(bytes)), 0);
    assert_int_equal(truncate(path, (off_t)1 << 40), 0); /* Sparse: 1 TB of zeros. */
    assert_int_equal(scan(&totals), -1);
    assert_int_equal(reader.problem.offset, first_second(bytes));
    assert_int_equal(truncate(path, 0), 0);
}

/* ---- A disk that fills up ------------------------------------------------------------------- */

static void test_a_full_disk_stops_the_recording_and_leaves_it_whole(void **state)
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

static void test_a_recording_is_never_replaced(void **state)
{
    static uint8_t before[FILE_MAX], after[FILE_MAX];
    (void)state;
    write_ticks(130);
    const size_t size = read_file(before);
    assert_int_equal(replay_create(&writer, path, &config, 99), -EEXIST);
    assert_int_equal(read_file(after), size);
    assert_memory_equal(before, after, size);
}

static void test_a_path_that_cannot_be_written_is_told(void **state)
{
    (void)state;
    assert_int_equal(replay_create(&writer, "/nowhere/at/all", &config, 0), -ENOENT);
    assert_int_equal(replay_create(&writer, "/tmp", &config, 0), -EISDIR);
    assert_int_equal(replay_create(&writer, "/dev/full", &config, 0), -ENOTSUP);
}

/* ---- In memory ------------------------------------------------------------------------------ */

static uint8_t memory[FILE_MAX], copied[FILE_MAX];

static struct replay_totals totals_of(uint32_t ticks)
{
    return (struct replay_totals){ .ticks = ticks, .caught = ticks / 50u, .hash = 500u + ticks };
}

/* Records `count` ticks that begin with `start` into `size` bytes of memory. */
static void write_memory_from(const struct core_config *start, uint32_t count, size_t size)
{
    assert_int_equal(replay_create_in(&writer, memory, size, start, 99), 0);
    for (uint32_t tick = 0; tick < count; tick++) {
        const struct input input = input_of(tick);
        const struct replay_totals totals = totals_of(tick + 1u);
        assert_true(replay_wants_digest(&writer) == (tick % CORE_TICK_HZ == CORE_TICK_HZ - 1u));
        replay_add(&writer, &input, tick, &totals);
    }
}

static void write_memory(uint32_t count, size_t size)
{
    write_memory_from(&config, count, size);
}

static void test_a_copy_is_a_whole_recording_and_the_recording_goes_on(void **state)
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

/* The number of bytes that a step renews has no effect on the result. */
static void test_a_replaced_start_has_the_bytes_of_a_recording_with_that_start(void **state)
{
    static const size_t steps[] = { 1, 2000, sizeof copied };
    static uint8_t wanted[sizeof copied];
    (void)state;
    struct core_config other = config;
    other.persistent.ledger.boots = 12345678;
    write_memory_from(&other, 500, sizeof memory);
    const size_t size = replay_copy(&writer, 1, wanted, sizeof wanted);
    write_memory(500, sizeof memory);
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        struct replay_seal seal;
        uint32_t count = 1;
        const size_t old_size = replay_copy(&writer, 1, copied, sizeof copied);
        assert_int_equal(replay_replace_start(copied, old_size, size - 1u, &other, &seal), 0);
        assert_int_equal(replay_replace_start(copied, old_size, size, &other, &seal), size);
        while (!replay_seal_next(&seal, steps[i])) {
            count++;
        }
        assert_memory_equal(copied, wanted, size);
        assert_true(i == 0 ? count == 5 : i == 1 ? count > 1 : count == 1);
    }
}

static void test_memory_that_is_full_ends_the_recording_and_leaves_it_whole(void **state)
{
    (void)state;
    struct replay_totals totals;
    write_memory(500, sizeof memory);
    const size_t whole = (size_t)writer.offset + REPLAY_END_SIZE; /* Of four seconds. */
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

static void test_a_digest_each_second_comes_back(void **state)
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

static void test_memory_that_ends_early_is_refused(void **state)
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

/* ---- The core's own recordings -------------------------------------------------------------- */

static struct core core;
static struct recorder recorder;
static struct replayer replayer;

/* A fan that swings in after two seconds, is held, led aside and taken away again. */
static struct shade_input fan_at(uint32_t tick)
{
    const float t = (float)tick / (float)CORE_TICK_HZ;
    return (struct shade_input){
        .present = t > 2.0f && t < 7.0f,
        .x_m = 0.1f * f_smoothstep(5.0f, 6.0f, t),
        .z_m = 0.6f - 0.6f * f_smoothstep(2.0f, 2.5f, t),
        .radius_m = 0.1f,
    };
}

/* Plays `seconds` with the bot, START after one; from `lie_at` on the recorded digests are
 * wrong. */
static void play_and_record(uint32_t seconds, uint32_t lie_at)
{
    static struct output output;
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < seconds * CORE_TICK_HZ; tick++) {
        static struct core told;
        input.pressed = tick == CORE_TICK_HZ ? INPUT_START : 0;
        input.shade[0] = fan_at(tick);
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        told = core;
        told.game.tick += tick >= lie_at;
        tap.tick(tap.self, &input, &told);
    }
    assert_int_equal(recorder_end(&recorder), 0);
}

static void replay_all_as(uint8_t as_is)
{
    static struct output output;
    struct input input;
    struct core_config from_file;
    assert_int_equal(replayer_begin(&replayer, path, &from_file), 0);
    replayer.reader.as_is = as_is;
    assert_int_equal(core_init(&core, &from_file), CORE_OK);
    const struct kiosk_source source = replayer_source(&replayer);
    const struct kiosk_tap tap = replayer_tap(&replayer);
    while (source.next(source.self, &input)) {
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    replayer_end(&replayer);
}

static void replay_all(void)
{
    replay_all_as(0);
}

static void test_a_true_recording_is_found_true(void **state)
{
    (void)state;
    play_and_record(3, UINT32_MAX);
    const uint64_t hash = core_hash(&core);
    replay_all();
    assert_int_equal(replayer.damaged, 0);
    assert_int_equal(replayer.difference.found, 0);
    assert_int_equal(replayer.totals.ticks, 3 * CORE_TICK_HZ);
    assert_true(core_hash(&core) == hash);
}

/* Coins, the menu, controllers that come and go there, one that is learned, and back. */
static void test_a_visit_to_the_operators_menu_is_found_true(void **state)
{
    static struct output output;
    static const uint32_t presses[] = { INPUT_TEST, INPUT_TEST,    INPUT_TEST,  INPUT_TEST,
                                        INPUT_LEFT, INPUT_SERVICE, INPUT_RIGHT, INPUT_TEST,
                                        INPUT_OK,   INPUT_SERVICE, INPUT_START, INPUT_SERVICE };
    struct core_config paid = config;
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    (void)state;
    paid.credit_coins = 2;
    paid.ticket_fish = 3;
    assert_int_equal(core_init(&core, &paid), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    uint32_t menu_ticks = 0;
    for (uint32_t tick = 0; tick < 6u * CORE_TICK_HZ; tick++) {
        input.coin_count[0] = tick % 50u == 7u;
        input.pressed = tick % 30u == 29u ? presses[tick / 30u % 12u] : 0u;
        input.held = tick / 100u % 2u ? INPUT_DOOR : 0u;
        input.controllers.state[0] = CONTROLLER_FREE;
        input.controllers.state[1u + tick / 77u % 7u] =
            (uint8_t)(tick / 31u % CONTROLLER_STATE_COUNT);
        input.controllers.learn_step = (uint8_t)(tick / 120u);
        input.controllers.learn_progress = (uint8_t)tick;
        input.controllers.file_count = (uint8_t)(tick / 9u);
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        menu_ticks += core.game.phase == PHASE_MENU;
        tap.tick(tap.self, &input, &core);
    }
    assert_int_equal(recorder_end(&recorder), 0);
    const uint64_t hash = core_hash(&core);
    assert_true(menu_ticks > CORE_TICK_HZ && output.command_count > 0 && output.coins_counted > 0);
    replay_all();
    assert_int_equal(replayer.damaged, 0);
    assert_int_equal(replayer.difference.found, 0);
    assert_true(core_hash(&core) == hash);
}

/* Attract is nobody's; then the first player's festival. */
static void test_a_recording_knows_who_played_what(void **state)
{
    (void)state;
    play_and_record(3, UINT32_MAX);
    assert_int_equal(recorder.totals.rounds, 1);
    assert_int_equal(recorder.totals.modes, 0);
    assert_int_equal(recorder.totals.players, 0);
    play_and_record(5, UINT32_MAX);
    replay_all();
    assert_int_equal(replayer.difference.found, 0);
    assert_int_equal(replayer.reader.totals.modes, 1u << MODE_FESTIVAL);
    assert_int_equal(replayer.reader.totals.players, 1);
}

/* Each count that a foul or a catch raises is held against the file, whichever of its seconds. */
static void test_counts_rise_with_the_scores_and_begin_anew_with_a_round(void **state)
{
    static const uint32_t caught[] = { 0, 2, 2, 0, 1 }, fouls[] = { 1, 1, 3, 0, 1 };
    struct replay_totals totals = { 0 };
    struct recorder_tally tally = { 0 };
    (void)state;
    memset(&core, 0, sizeof core);
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++) {
        core.game.player[2].caught = caught[i];
        core.game.player[2].fouls = (uint8_t)fouls[i];
        recorder_count(&totals, &tally, &core);
    }
    assert_int_equal(totals.ticks, 5);
    assert_int_equal(totals.caught, 3);
    assert_int_equal(totals.fouls, 4);
}

static void test_the_first_tick_that_differs_is_named(void **state)
{
    (void)state;
    play_and_record(3, 200);
    replay_all();
    assert_int_equal(replayer.difference.found, 1);
    assert_int_equal(replayer.difference.tick, 200);
    assert_true(replayer.difference.recorded != replayer.difference.computed);
}

/* The tick that panics is in the file with its input, and the half-made state is not hashed. */
static void test_a_recording_that_a_panic_ends_leads_to_the_panic(void **state)
{
    static struct output output;
    struct replay_totals totals;
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    (void)state;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < 150; tick++) {
        tap.before(tap.self, &input);
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    input.pressed = INPUT_LANGUAGE;
    tap.before(tap.self, &input);
    memset(&core.game, 0xff, sizeof core.game); /* As if torn in the middle of the tick. */
    assert_int_equal(recorder_end_in_panic(&recorder), 0);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, 151);
    assert_int_equal(totals.rounds, 0);
    replay_all();
    assert_int_equal(core.game.tick, 151);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    assert_int_equal(replayer.difference.found, 1); /* This core survived it. */
    assert_int_equal(replayer.difference.tick, 150);
}

/* Records `count` ticks and the input of one more, in which a panic comes. */
static void record_into_a_tick(uint32_t count)
{
    static struct output output;
    const struct input input = { .poi[0].link = POI_SOURCE_BOT };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < count; tick++) {
        tap.before(tap.self, &input);
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    tap.before(tap.self, &input);
}

static void test_a_recording_that_a_signal_ends_within_a_tick_verifies(void **state)
{
    static const uint32_t counts[] = { 0, 150, 2u * CORE_TICK_HZ - 1u, 2u * CORE_TICK_HZ };
    (void)state;
    for (uint32_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        record_into_a_tick(counts[i]);
        assert_int_equal(recorder_end_in_panic(&recorder), 0);
        replay_all_as(1);
        assert_int_equal(core.game.tick, counts[i] + 1u);
        assert_int_equal(replayer.damaged, 0);
        assert_int_equal(replayer.difference.found, 0);
        assert_true(replayer_is_interrupted(&replayer));
    }
}

static void test_a_recording_whose_write_a_signal_interrupts_ends_with_a_whole_second(void **state)
{
    struct replay_totals totals;
    (void)state;
    record_into_a_tick(150);
    recorder.is_in_tick = 0;
    recorder.is_adding = 1; /* As within the tap's call after the tick. */
    assert_int_equal(recorder_end_in_panic(&recorder), -EINTR);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, CORE_TICK_HZ);
    recorder.is_adding = 0;
    recorder_end(&recorder);
}

static void test_a_panic_between_ticks_adds_none(void **state)
{
    struct replay_totals totals;
    (void)state;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    assert_int_equal(recorder_end_in_panic(&recorder), 0);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_input_comes_back_to_the_bit),
        cmocka_unit_test(test_a_recording_of_nothing_is_whole),
        cmocka_unit_test(test_a_recording_in_progress_is_whole_up_to_its_last_second),
        cmocka_unit_test(test_cut_at_any_byte_it_is_refused),
        cmocka_unit_test(test_a_header_may_name_only_a_printable_program),
        cmocka_unit_test(test_any_altered_byte_is_refused),
        cmocka_unit_test(test_anything_behind_the_end_mark_is_refused),
        cmocka_unit_test(test_seconds_that_change_places_are_refused),
        cmocka_unit_test(test_what_is_no_recording_is_told_apart),
        cmocka_unit_test(test_another_version_is_named),
        cmocka_unit_test(test_a_huge_file_of_nothing_is_refused_at_its_first_second),
        cmocka_unit_test(test_a_full_disk_stops_the_recording_and_leaves_it_whole),
        cmocka_unit_test(test_a_recording_is_never_replaced),
        cmocka_unit_test(test_a_path_that_cannot_be_written_is_told),
        cmocka_unit_test(test_a_copy_is_a_whole_recording_and_the_recording_goes_on),
        cmocka_unit_test(test_a_replaced_start_has_the_bytes_of_a_recording_with_that_start),
        cmocka_unit_test(test_memory_that_is_full_ends_the_recording_and_leaves_it_whole),
        cmocka_unit_test(test_a_digest_each_second_comes_back),
        cmocka_unit_test(test_memory_that_ends_early_is_refused),
        cmocka_unit_test(test_a_true_recording_is_found_true),
        cmocka_unit_test(test_a_visit_to_the_operators_menu_is_found_true),
        cmocka_unit_test(test_a_recording_knows_who_played_what),
        cmocka_unit_test(test_counts_rise_with_the_scores_and_begin_anew_with_a_round),
        cmocka_unit_test(test_the_first_tick_that_differs_is_named),
        cmocka_unit_test(test_a_recording_that_a_panic_ends_leads_to_the_panic),
        cmocka_unit_test(test_a_recording_that_a_signal_ends_within_a_tick_verifies),
        cmocka_unit_test(test_a_recording_whose_write_a_signal_interrupts_ends_with_a_whole_second),
        cmocka_unit_test(test_a_panic_between_ticks_adds_none),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
