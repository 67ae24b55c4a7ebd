/* file_replay.c -- fuzz target: arbitrary bytes as a recording. The checksums, the first tick of
 * each chunk and the end mark are corrected, so that the reader does not reject changed bytes
 * because of them. The reader must either reject the recording with a message of one line, or
 * decode inputs that stay equal after they are encoded and decoded again. The core then plays these
 * inputs. */
#include <string.h>

#include "core/base/hash.h"
#include "platform/replay/replay.h"
#include "platform/replay/replay_format.h"
#include "tests/fuzz/try_game.h"
#include "tests/fuzz/trap.h"

#define FILE_MAX 16384u
/* Largest number of ticks that are played. More ticks would take longer and would hardly execute
 * other code. */
#define PLAYED_TICKS_MAX 240u

static uint8_t file[FILE_MAX];
static size_t file_size;

/* Writes the checksum of the `size` bytes at `at` directly after these bytes. Returns the position
 * after the checksum, or 0 if the file is too short. */
static size_t put_sum(size_t at, size_t size, uint64_t *sum)
{
    if (size > file_size || at + size + REPLAY_SUM_SIZE > file_size) {
        return 0;
    }
    *sum = hash_bytes(*sum, file + at, size);
    replay_put_u64(file + at + size, *sum);
    return at + size + REPLAY_SUM_SIZE;
}

/* Corrects the end mark of the recording, which is at `at`, so that it agrees with the last
 * chunk. */
static void repair_end(size_t at, const uint8_t *last, uint32_t tick, uint64_t sum)
{
    replay_put_u32(file + at + END_TICKS, tick);
    if (last) {
        memcpy(file + at + END_ROUNDS, last + CHUNK_ROUNDS, END_SUM - END_ROUNDS);
    }
    put_sum(at, END_SUM, &sum);
}

static void repair_parts(size_t at, uint64_t sum)
{
    const uint8_t *last = NULL;
    uint32_t tick = 0;
    while (at > 0 && at + REPLAY_END_SIZE <= file_size) {
        if (memcmp(file + at, REPLAY_END_TAG, 4) == 0) {
            repair_end(at, last, tick, sum);
            return;
        }
        const uint32_t payload = replay_get_u32(file + at + CHUNK_PAYLOAD_SIZE);
        if (payload > FILE_MAX) {
            return;
        }
        replay_put_u32(file + at + CHUNK_FIRST_TICK, tick);
        tick += replay_get_u32(file + at + CHUNK_TICK_COUNT);
        last = file + at;
        at = put_sum(at, REPLAY_CHUNK_HEAD_SIZE + payload, &sum);
    }
}

static void repair(void)
{
    uint64_t sum = HASH_START;
    if (file_size < REPLAY_HEADER_SIZE) {
        return;
    }
    memcpy(file, REPLAY_MAGIC, 8);
    size_t at = put_sum(0, HEADER_SUM, &sum);
    at = at > 0 ? put_sum(at, replay_get_u32(file + HEADER_START), &sum) : 0;
    const uint32_t book_size = replay_get_u32(file + HEADER_BOOK);
    at = at > 0 && book_size > 0 ? put_sum(at, book_size, &sum) : at;
    repair_parts(at, sum);
}

static void hold_problem(const struct replay_problem *problem)
{
    const size_t length = strnlen(problem->text, sizeof problem->text);
    HOLD(length > 0 && length < sizeof problem->text);
    for (size_t i = 0; i < length; i++) {
        HOLD(problem->text[i] >= ' ' && problem->text[i] <= '~');
    }
    HOLD(!problem->is_io && problem->offset <= file_size);
}

/* Checks that every decoded input can be encoded and decoded again without a change. */
static void hold_input(const struct input *before, const struct input *input)
{
    uint8_t bytes[REPLAY_TICK_SIZE_MAX], again[REPLAY_TICK_SIZE_MAX];
    struct input read = *before;
    const size_t size = replay_encode_input(before, input, bytes);
    HOLD(size > 0 && size <= sizeof bytes - 4u);
    HOLD(replay_decode_input(&read, bytes, size, false) == size);
    HOLD(replay_encode_input(before, &read, again) == size && memcmp(bytes, again, size) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct replay_reader reader;
    static struct output output;
    struct input input = { 0 }, before = { 0 };
    file_size = size < FILE_MAX ? size : FILE_MAX;
    memcpy(file, bytes, file_size);
    repair();
    if (replay_open_in(&reader, file, file_size)) {
        hold_problem(&reader.problem);
        return 0;
    }
    const int plays = try_game(&reader.header.config, 0);
    int more;
    while ((more = replay_next(&reader, &input)) == 1) {
        hold_input(&before, &input);
        if (plays && reader.tick <= PLAYED_TICKS_MAX) {
            output.sound_count = 0;
            core_tick(&try_game_core, &input, &output);
        }
        before = input;
    }
    if (more < 0) {
        hold_problem(&reader.problem);
    }
    replay_close(&reader);
    return 0;
}
