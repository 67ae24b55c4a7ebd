/* replay_fixture.h -- test fixture of a recording, which is written to a temporary file. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_REPLAY_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_REPLAY_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/rng.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/replay/replay.h"
#include "platform/replay/replay_format.h"

#define FILE_MAX (1u << 20)
static char path[] = "/tmp/kingyo-replay-XXXXXX";
static struct replay_writer writer;
static struct replay_reader reader;
static const struct core_config config = { .seed = 7, .fish_count = 12, .round_s = 10 };

/* Creates the temporary file; a cmocka setup function. */
static inline int make_path(void **state)
{
    (void)state;
    const int fd = mkstemp(path);
    return fd < 0 ? -1 : close(fd);
}

/* Removes the temporary file; a cmocka teardown function. */
static inline int remove_path(void **state)
{
    (void)state;
    return unlink(path);
}

/* Returns an input that depends only on `tick`. The inputs of many ticks use every part of the
 * format: motion, rest, presses, and plug and unplug events. */
static inline struct input input_of(uint32_t tick)
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

/* Truncates the file to 0 bytes, because the recorder never overwrites a file that has content. */
static inline void empty_path(void)
{
    assert_int_equal(truncate(path, 0), 0);
}

/* Records `count` ticks of input_of() into the file. */
static inline void write_ticks(uint32_t count)
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

/* Reads the file into `bytes`, which has room for FILE_MAX bytes. Returns the size of the file. */
static inline size_t read_file(uint8_t *bytes)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size = fread(bytes, 1, FILE_MAX, file);
    fclose(file);
    return size;
}

/* Replaces the content of the file. */
static inline void write_file(const uint8_t *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

/* Reads the whole recording from the file. Returns 0, or -1 if the recording is invalid. */
static inline int scan(struct replay_totals *totals)
{
    return replay_scan(&reader, path, totals);
}

#endif
