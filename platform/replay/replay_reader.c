/* replay_reader.c -- reads recordings and validates every byte before its use. */
#include "platform/replay/replay.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/replay/replay_format.h"

/* Minimum size in bytes of a recorded tick. A tick without any change consists of one mask byte. */
#define TICK_SIZE_MIN 1u

/* Sets `problem`, closes the file and returns -1. */
__attribute__((format(printf, 4, 5))) static int replay_reader_error(struct replay_reader *reader,
                                                                     bool is_io, uint64_t offset,
                                                                     const char *format, ...)
{
    va_list arguments;
    reader->problem = (struct replay_problem){ .is_io = is_io, .offset = offset };
    va_start(arguments, format);
    vsnprintf(reader->problem.text, sizeof reader->problem.text, format, arguments);
    va_end(arguments);
    replay_close(reader);
    return -1;
}

/* Reads from the recording's file or memory, with the same results as pread(). */
static ssize_t read_some(const struct replay_reader *reader, uint8_t *out, size_t size,
                         uint64_t offset)
{
    if (reader->memory == NULL) {
        return pread(reader->fd, out, size, (off_t)offset);
    }
    const size_t left = offset < reader->memory_size ? reader->memory_size - (size_t)offset : 0;
    const size_t count = size < left ? size : left;
    memcpy(out, reader->memory + (count > 0 ? offset : 0), count);
    return (ssize_t)count;
}

/* Reads exactly `size` bytes at reader->offset + `ahead`. Returns 0, or -1 and sets `problem`. */
static int read_bytes(struct replay_reader *reader, uint8_t *out, size_t size, uint64_t ahead,
                      const char *what)
{
    CORE_ASSERT(out && what);
    const uint64_t begin = reader->offset + ahead;
    size_t done = 0;
    while (done < size) {
        const ssize_t got = read_some(reader, out + done, size - done, begin + done);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return replay_reader_error(reader, 1, begin + done, "cannot read: %s", strerror(errno));
        }
        if (got == 0) {
            return replay_reader_error(reader, 0, begin + done,
                                       "the file ends in the middle of %s; "
                                       "the first %u seconds are valid",
                                       what, reader->tick / CORE_TICK_HZ);
        }
        done += (size_t)got;
    }
    return 0;
}

/* Returns true if `bytes` is a valid program version. The text must be printable, must not contain
 * a character that would end a JSON string, and must be padded with zeros. */
static bool is_program_name(const uint8_t *bytes)
{
    size_t length = 0;
    while (length < REPLAY_PROGRAM_SIZE && bytes[length] >= ' ' && bytes[length] <= '~' &&
           bytes[length] != '"' && bytes[length] != '\\') {
        length++;
    }
    size_t zeros = 0;
    while (length + zeros < REPLAY_PROGRAM_SIZE && bytes[length + zeros] == 0) {
        zeros++;
    }
    return zeros > 0 && length + zeros == REPLAY_PROGRAM_SIZE;
}

/* Reads the initial state or the catalog, with its checksum, into reader->bytes. Returns 0, or -1
 * if the bytes cannot be read or the checksum is wrong. */
static int read_part_of_header(struct replay_reader *reader, size_t size, const char *what)
{
    CORE_ASSERT(size + REPLAY_SUM_SIZE <= sizeof reader->bytes);
    if (read_bytes(reader, reader->bytes, size + REPLAY_SUM_SIZE, 0, what)) {
        return -1;
    }
    reader->sum = hash_bytes(reader->sum, reader->bytes, size);
    if (reader->sum != replay_get_u64(reader->bytes + size)) {
        return replay_reader_error(reader, 0, reader->offset, "%s was altered", what);
    }
    return 0;
}

static int read_start(struct replay_reader *reader, size_t size)
{
    if (read_part_of_header(reader, size, "its start")) {
        return -1;
    }
    if (!replay_initial_state_decode(&reader->header.config, reader->bytes, size,
                                     reader->header.version)) {
        return replay_reader_error(reader, 0, reader->offset,
                                   "the start has a value that this program never writes");
    }
    reader->offset += size + REPLAY_SUM_SIZE;
    return 0;
}

/* Reads the growth lab's catalog. Returns 0, or -1 if the catalog is invalid or contains species
 * that this program does not have. */
static int read_book(struct replay_reader *reader, size_t size)
{
    if (size == 0) {
        return 0;
    }
    if (read_part_of_header(reader, size, "its book of species")) {
        return -1;
    }
    if (!replay_catalog_decode(&reader->header.config.book, reader->bytes, size)) {
        return replay_reader_error(reader, 0, reader->offset, "its species are not this program's");
    }
    reader->offset += size + REPLAY_SUM_SIZE;
    return 0;
}

/* Returns true if all values in the header are values that a recorder can write. */
static bool is_possible(const uint8_t *header)
{
    const uint32_t digest_ticks = replay_get_u32(header + HEADER_DIGEST_TICKS);
    return replay_get_u32(header + HEADER_VERSION) >> 16 == REPLAY_HEADER_SIZE &&
           replay_get_u32(header + HEADER_TICK_HZ) == CORE_TICK_HZ &&
           is_program_name(header + HEADER_PROGRAM) && digest_ticks >= 1 &&
           digest_ticks <= REPLAY_CHUNK_TICKS &&
           replay_get_u32(header + HEADER_START) <= REPLAY_INITIAL_STATE_MAX &&
           replay_get_u32(header + HEADER_BOOK) <= REPLAY_CATALOG_MAX;
}

static int read_header(struct replay_reader *reader)
{
    uint8_t *bytes = reader->bytes;
    if (read_bytes(reader, bytes, REPLAY_HEADER_SIZE, 0, "its header")) {
        return -1;
    }
    if (memcmp(bytes, REPLAY_MAGIC, 8) != 0) {
        return replay_reader_error(reader, 0, 0, "not a recording of Kingyo");
    }
    const uint32_t version = replay_get_u32(bytes + HEADER_VERSION) & 0xffffu;
    reader->header.version = version;
    if (version < REPLAY_VERSION_MIN || version > REPLAY_VERSION) {
        return replay_reader_error(reader, 0, HEADER_VERSION,
                                   "format version %u; this program reads versions %u to %u",
                                   version, REPLAY_VERSION_MIN, REPLAY_VERSION);
    }
    reader->sum = hash_bytes(HASH_START, bytes, HEADER_SUM);
    if (reader->sum != replay_get_u64(bytes + HEADER_SUM)) {
        return replay_reader_error(reader, 0, HEADER_SUM, "the header was altered");
    }
    reader->offset = REPLAY_HEADER_SIZE;
    if (!is_possible(bytes)) {
        return replay_reader_error(reader, 0, HEADER_SIZE_FIELD,
                                   "the header has a value that this program never writes");
    }
    const uint32_t book_size = replay_get_u32(bytes + HEADER_BOOK);
    reader->digest_ticks = replay_get_u32(bytes + HEADER_DIGEST_TICKS);
    memcpy(reader->header.program, bytes + HEADER_PROGRAM, REPLAY_PROGRAM_SIZE);
    return read_start(reader, replay_get_u32(bytes + HEADER_START)) ? -1
                                                                    : read_book(reader, book_size);
}

int replay_open(struct replay_reader *reader, const char *path)
{
    CORE_ASSERT(path);
    struct stat status;
    memset(reader, 0, sizeof *reader);
    reader->fd = file_user_handle(path, O_RDONLY, 0);
    if (reader->fd < 0 && (errno == EISDIR || errno == ENOTSUP)) {
        return replay_reader_error(reader, 1, 0, "not a recording of Kingyo but a %s",
                                   errno == EISDIR ? "folder" : "device or pipe");
    }
    if (reader->fd < 0) {
        return replay_reader_error(reader, 1, 0, "cannot open: %s", strerror(errno));
    }
    if (fstat(reader->fd, &status) != 0) {
        return replay_reader_error(reader, 1, 0, "cannot read: %s", strerror(errno));
    }
    if (status.st_size == 0) {
        return replay_reader_error(reader, 0, 0, "the file is empty");
    }
    return read_header(reader);
}

int replay_open_in(struct replay_reader *reader, const uint8_t *memory, size_t size)
{
    CORE_ASSERT(memory || size == 0);
    memset(reader, 0, sizeof *reader);
    reader->fd = -1;
    reader->memory = memory;
    reader->memory_size = size;
    return read_header(reader);
}

static int read_end(struct replay_reader *reader)
{
    uint8_t *end = reader->bytes;
    uint8_t beyond;
    if (read_bytes(reader, end, REPLAY_END_SIZE, 0, "its end mark")) {
        return -1;
    }
    if (hash_bytes(reader->sum, end, END_SUM) != replay_get_u64(end + END_SUM)) {
        return replay_reader_error(reader, 0, reader->offset, "the end mark was altered");
    }
    const struct replay_totals totals = {
        .ticks = replay_get_u32(end + END_TICKS),
        .rounds = replay_get_u32(end + END_ROUNDS),
        .caught = replay_get_u32(end + END_CAUGHT),
        .fouls = replay_get_u32(end + END_FOULS),
        .modes = (uint16_t)replay_get_u32(end + END_WHO),
        .players = (uint16_t)(replay_get_u32(end + END_WHO) >> 16),
        .hash = replay_get_u64(end + END_HASH),
    };
    if (!replay_totals_agree(&totals, &reader->totals) || totals.ticks != reader->tick ||
        (reader->tick != 0 && totals.hash != reader->totals.hash)) {
        return replay_reader_error(reader, 0, reader->offset,
                                   "the end mark does not agree with the "
                                   "last second");
    }
    const uint64_t size = reader->offset + REPLAY_END_SIZE;
    if (read_some(reader, &beyond, 1, size) != 0) {
        return replay_reader_error(reader, 0, size, "there is more after the end mark");
    }
    reader->totals = totals;
    reader->ended = true;
    return 0;
}

static bool chunk_head_is_possible(const struct replay_reader *reader, uint32_t tick_count)
{
    return tick_count > 0 && tick_count <= REPLAY_CHUNK_TICKS &&
           replay_get_u32(reader->bytes + CHUNK_FIRST_TICK) == reader->tick &&
           reader->payload_size >= (size_t)tick_count * TICK_SIZE_MIN &&
           reader->payload_size <= (size_t)tick_count * REPLAY_TICK_SIZE_MAX;
}

static int read_chunk(struct replay_reader *reader)
{
    uint8_t *head = reader->bytes;
    if (read_bytes(reader, head, REPLAY_CHUNK_HEAD_SIZE, 0, "a second's head")) {
        return -1;
    }
    const uint32_t tick_count = replay_get_u32(head + CHUNK_TICK_COUNT);
    reader->payload_size = replay_get_u32(head + CHUNK_PAYLOAD_SIZE);
    if (!chunk_head_is_possible(reader, tick_count)) {
        return replay_reader_error(reader, 0, reader->offset, "the head of second %u was altered",
                                   reader->tick / CORE_TICK_HZ);
    }
    const size_t summed = REPLAY_CHUNK_HEAD_SIZE + reader->payload_size;
    if (read_bytes(reader, head + REPLAY_CHUNK_HEAD_SIZE, reader->payload_size + REPLAY_SUM_SIZE,
                   REPLAY_CHUNK_HEAD_SIZE, "a second")) {
        return -1;
    }
    reader->sum = hash_bytes(reader->sum, head, summed);
    if (reader->sum != replay_get_u64(head + summed)) {
        return replay_reader_error(reader, 0, reader->offset, "second %u was altered",
                                   reader->tick / CORE_TICK_HZ);
    }
    reader->totals = (struct replay_totals){
        .ticks = reader->tick + tick_count,
        .rounds = replay_get_u32(head + CHUNK_ROUNDS),
        .caught = replay_get_u32(head + CHUNK_CAUGHT),
        .fouls = replay_get_u32(head + CHUNK_FOULS),
        .modes = (uint16_t)replay_get_u32(head + CHUNK_WHO),
        .players = (uint16_t)(replay_get_u32(head + CHUNK_WHO) >> 16),
        .hash = replay_get_u64(head + CHUNK_HASH),
    };
    reader->chunk_left = tick_count;
    reader->payload_used = 0;
    return 0;
}

/* Reads the next chunk, or the end mark, and validates it. Returns 0, or -1 and sets
 * reader->problem. */
static int read_part(struct replay_reader *reader)
{
    uint8_t tag[4];
    if (read_bytes(reader, tag, sizeof tag, 0, "itself: no end mark")) {
        return -1;
    }
    if (memcmp(tag, REPLAY_END_TAG, sizeof tag) == 0) {
        return read_end(reader);
    }
    if (memcmp(tag, REPLAY_CHUNK_TAG, sizeof tag) == 0) {
        return read_chunk(reader);
    }
    return replay_reader_error(reader, 0, reader->offset,
                               "neither a chunk nor the end mark begins here");
}

int replay_next(struct replay_reader *reader, struct input *input)
{
    CORE_ASSERT(input);
    if (reader->fd < 0 && reader->memory == NULL) {
        return -1;
    }
    if (reader->chunk_left == 0 && !reader->ended && read_part(reader)) {
        return -1;
    }
    if (reader->ended) {
        return 0;
    }
    const uint8_t *payload = reader->bytes + REPLAY_CHUNK_HEAD_SIZE;
    const size_t left = reader->payload_size - reader->payload_used;
    const size_t used =
        replay_decode_input(&reader->input, payload + reader->payload_used, left, reader->as_is);
    const size_t digest_size = (reader->tick + 1u) % reader->digest_ticks == 0 ? 4 : 0;
    const uint64_t at = reader->offset + REPLAY_CHUNK_HEAD_SIZE + reader->payload_used;
    if (used == 0 || left - used < digest_size) {
        return replay_reader_error(reader, 0, at, "tick %u has a value that no recorder writes",
                                   reader->tick);
    }
    reader->has_digest = digest_size > 0;
    if (reader->has_digest) {
        reader->digest = replay_get_u32(payload + reader->payload_used + used);
    }
    reader->payload_used += used + digest_size;
    reader->tick++;
    reader->chunk_left--;
    if (reader->chunk_left == 0) {
        if (reader->payload_used != reader->payload_size) {
            return replay_reader_error(reader, 0, at, "second %u holds more than its ticks",
                                       (reader->tick - 1) / CORE_TICK_HZ);
        }
        reader->offset += REPLAY_CHUNK_HEAD_SIZE + reader->payload_size + REPLAY_SUM_SIZE;
    }
    *input = reader->input;
    return 1;
}

void replay_close(struct replay_reader *reader)
{
    if (reader->fd >= 0) {
        close(reader->fd);
    }
    reader->fd = -1;
    reader->memory = NULL;
}

int replay_scan_on(struct replay_reader *reader, struct replay_totals *totals)
{
    struct input input;
    int more;
    do {
        more = replay_next(reader, &input);
    } while (more == 1);
    if (more == 0) {
        *totals = reader->totals;
        replay_close(reader);
    }
    return more;
}

int replay_scan(struct replay_reader *reader, const char *path, struct replay_totals *totals)
{
    return replay_open(reader, path) ? -1 : replay_scan_on(reader, totals);
}
