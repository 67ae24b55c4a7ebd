/* replay_writer.c -- writes a recording. After each second, the file is a complete recording. */
#include "platform/replay/replay.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/replay/replay_format.h"

static int write_file(int fd, const uint8_t *bytes, size_t size, uint64_t offset)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t written = pwrite(fd, bytes + done, size - done, (off_t)(offset + done));
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return written < 0 ? -errno : -EIO;
        }
        done += (size_t)written;
    }
    return 0;
}

static int write_at(const struct replay_writer *writer, const uint8_t *bytes, size_t size,
                    uint64_t offset)
{
    CORE_ASSERT((writer->memory == NULL) != (writer->fd < 0));
    if (writer->memory == NULL) {
        return write_file(writer->fd, bytes, size, offset);
    }
    if (offset + size > writer->memory_size) {
        return -ENOSPC;
    }
    memcpy(writer->memory + offset, bytes, size);
    return 0;
}

static uint32_t modes_and_players(const struct replay_totals *totals)
{
    return (uint32_t)totals->modes | (uint32_t)totals->players << 16;
}

static void put_end(uint8_t *out, const struct replay_totals *totals, uint64_t sum)
{
    memcpy(out, REPLAY_END_TAG, 4);
    replay_put_u32(out + END_TICKS, totals->ticks);
    replay_put_u32(out + END_ROUNDS, totals->rounds);
    replay_put_u32(out + END_CAUGHT, totals->caught);
    replay_put_u32(out + END_FOULS, totals->fouls);
    replay_put_u32(out + END_WHO, modes_and_players(totals));
    replay_put_u64(out + END_HASH, totals->hash);
    replay_put_u64(out + END_SUM, hash_bytes(sum, out, END_SUM));
}

/* Appends the checksum of a part of the recording to the part, and stores the checksum in `*sum` as
 * the initial value for the next part. Writes nothing if the part is empty. Returns the size of the
 * part with its checksum. */
static size_t put_sum(uint8_t *part, size_t size, uint64_t *sum)
{
    CORE_ASSERT(size + REPLAY_SUM_SIZE <= REPLAY_HEADER_MAX);
    if (size == 0) {
        return 0;
    }
    *sum = hash_bytes(*sum, part, size);
    replay_put_u64(part + size, *sum);
    return size + REPLAY_SUM_SIZE;
}

/* Writes the header, the initial state and the catalog to writer->bytes. Returns their total size.
 * Sets writer->sum to the initial value of the first chunk's checksum. */
static size_t put_header(struct replay_writer *writer, const struct core_config *config)
{
    uint8_t *out = writer->bytes;
    memset(out, 0, REPLAY_HEADER_SIZE);
    memcpy(out, REPLAY_MAGIC, 8);
    replay_put_u32(out + HEADER_VERSION, REPLAY_VERSION | REPLAY_HEADER_SIZE << 16);
    replay_put_u32(out + HEADER_TICK_HZ, CORE_TICK_HZ);
    memcpy(out + HEADER_PROGRAM, KINGYO_VERSION, sizeof KINGYO_VERSION);
    replay_put_u32(out + HEADER_DIGEST_TICKS, writer->digest_ticks);

    uint8_t *start = out + REPLAY_HEADER_SIZE;
    const size_t start_size = replay_initial_state_encode(config, start);
    uint8_t *book = start + start_size + REPLAY_SUM_SIZE;
    const size_t book_size = replay_catalog_encode(&config->book, book);
    replay_put_u32(out + HEADER_START, (uint32_t)start_size);
    replay_put_u32(out + HEADER_BOOK, (uint32_t)book_size);

    writer->sum = HASH_START;
    size_t size = put_sum(out, HEADER_SUM, &writer->sum);
    size += put_sum(start, start_size, &writer->sum);
    return size + put_sum(book, book_size, &writer->sum);
}
_Static_assert(HEADER_SUM + REPLAY_SUM_SIZE == REPLAY_HEADER_SIZE, "the start follows the sum");
_Static_assert(sizeof KINGYO_VERSION <= REPLAY_PROGRAM_SIZE, "the version must fit the header");

static void give_up(struct replay_writer *writer, int error)
{
    CORE_ASSERT(error < 0);
    if (writer->fd >= 0) {
        close(writer->fd);
    }
    writer->fd = -1;
    writer->memory = NULL;
    writer->error = -error;
}

/* Opens a new or empty file. Returns a descriptor or a negative errno. Only the owner may read a
 * recording, because its initial state contains the operator's settings and takings. A file with
 * content is never overwritten, because its recording cannot be produced a second time. */
static int open_empty(const char *path)
{
    struct stat status;
    const int fd = file_user_handle(path, O_RDWR | O_CREAT, 0600);
    if (fd < 0) {
        return -errno;
    }
    const int error = fstat(fd, &status) != 0 ? errno : status.st_size > 0 ? EEXIST : 0;
    if (error) {
        close(fd);
        return -error;
    }
    return fd;
}

bool replay_is_open(const struct replay_writer *writer)
{
    return writer->fd >= 0 || writer->memory != NULL;
}

/* Starts a recording. The caller has set the destination and digest_ticks of `writer`. */
static int replay_writer_begin(struct replay_writer *writer, const struct core_config *config,
                               uint64_t first_hash)
{
    writer->totals.hash = first_hash;
    writer->saved = writer->totals;
    const size_t size = put_header(writer, config);
    writer->offset = size;
    put_end(writer->bytes + size, &writer->totals, writer->sum);
    const int error = write_at(writer, writer->bytes, size + REPLAY_END_SIZE, 0);
    if (error) {
        give_up(writer, error);
    }
    return error;
}

int replay_create(struct replay_writer *writer, const char *path, const struct core_config *config,
                  uint64_t first_hash)
{
    CORE_ASSERT(path && config);
    memset(writer, 0, sizeof *writer);
    writer->digest_ticks = 1;
    writer->fd = open_empty(path);
    return writer->fd < 0 ? writer->fd : replay_writer_begin(writer, config, first_hash);
}

int replay_create_in(struct replay_writer *writer, uint8_t *memory, size_t size,
                     const struct core_config *config, uint64_t first_hash)
{
    CORE_ASSERT(memory && config);
    memset(writer, 0, sizeof *writer);
    writer->digest_ticks = REPLAY_CHUNK_TICKS;
    writer->fd = -1;
    writer->memory = memory;
    writer->memory_size = size;
    return replay_writer_begin(writer, config, first_hash);
}

/* After a failed write, writes the end mark that follows the last complete chunk again, so that the
 * recording is complete up to this chunk. This write needs no new disk space. A recording in memory
 * always keeps its end mark, because a chunk that does not fit is not written. */
static void restore(struct replay_writer *writer)
{
    uint8_t end[REPLAY_END_SIZE];
    put_end(end, &writer->saved, writer->sum);
    int error = write_at(writer, end, sizeof end, writer->offset);
    if (error == 0 && writer->fd >= 0 &&
        ftruncate(writer->fd, (off_t)(writer->offset + sizeof end)) != 0) {
        error = -errno;
    }
    /* An error of this function is ignored because the recording has already failed. */
    (void)error;
}

/* Completes the current chunk: writes the head of `chunk`, the checksum and an end mark. The caller
 * has already written the payload after the head of `chunk`. Returns the size of the chunk without
 * the end mark. Sets `*sum` to the chunk's checksum. */
static size_t close_chunk(uint8_t *chunk, size_t payload_size, uint32_t ticks,
                          const struct replay_totals *totals, uint64_t *sum)
{
    CORE_ASSERT(ticks > 0 && ticks <= REPLAY_CHUNK_TICKS && payload_size <= REPLAY_PAYLOAD_MAX);
    memcpy(chunk, REPLAY_CHUNK_TAG, 4);
    replay_put_u32(chunk + CHUNK_PAYLOAD_SIZE, (uint32_t)payload_size);
    replay_put_u32(chunk + CHUNK_FIRST_TICK, totals->ticks - ticks);
    replay_put_u32(chunk + CHUNK_TICK_COUNT, ticks);
    replay_put_u32(chunk + CHUNK_ROUNDS, totals->rounds);
    replay_put_u32(chunk + CHUNK_CAUGHT, totals->caught);
    replay_put_u32(chunk + CHUNK_FOULS, totals->fouls);
    replay_put_u32(chunk + CHUNK_WHO, modes_and_players(totals));
    replay_put_u64(chunk + CHUNK_HASH, totals->hash);
    const size_t size = put_sum(chunk, REPLAY_CHUNK_HEAD_SIZE + payload_size, sum);
    put_end(chunk + size, totals, *sum);
    return size;
}

static void write_chunk(struct replay_writer *writer)
{
    CORE_ASSERT(writer->chunk_ticks > 0 && writer->chunk_ticks <= REPLAY_CHUNK_TICKS);
    uint64_t sum = writer->sum;
    const size_t size = close_chunk(writer->bytes, writer->payload_size, writer->chunk_ticks,
                                    &writer->totals, &sum);
    const int error = write_at(writer, writer->bytes, size + REPLAY_END_SIZE, writer->offset);
    if (error) {
        restore(writer);
        give_up(writer, error);
        return;
    }
    writer->offset += size;
    writer->sum = sum;
    writer->saved = writer->totals;
    writer->chunk_ticks = 0;
    writer->payload_size = 0;
}

bool replay_needs_hash(const struct replay_writer *writer)
{
    return replay_is_open(writer) && writer->chunk_ticks + 1 == REPLAY_CHUNK_TICKS;
}

bool replay_needs_digest(const struct replay_writer *writer)
{
    return replay_is_open(writer) && (writer->totals.ticks + 1u) % writer->digest_ticks == 0;
}

void replay_add(struct replay_writer *writer, const struct input *input, uint32_t digest,
                const struct replay_totals *totals)
{
    CORE_ASSERT(input);
    if (!replay_is_open(writer)) {
        return;
    }
    CORE_ASSERT(totals->ticks == writer->totals.ticks + 1);
    uint8_t *out = writer->bytes + REPLAY_CHUNK_HEAD_SIZE + writer->payload_size;
    size_t size = replay_encode_input(&writer->last, input, out);
    if (replay_needs_digest(writer)) {
        replay_put_u32(out + size, digest);
        size += 4;
    }
    writer->payload_size += size;
    writer->chunk_ticks++;
    writer->last = *input;
    writer->totals = *totals;
    if (writer->chunk_ticks == REPLAY_CHUNK_TICKS) {
        write_chunk(writer);
    }
}

int replay_finish(struct replay_writer *writer, uint64_t hash)
{
    if (replay_is_open(writer) && writer->chunk_ticks > 0) {
        writer->totals.hash = hash;
        write_chunk(writer);
    }
    if (writer->fd >= 0) {
        const int error = close(writer->fd) == 0 ? 0 : errno;
        writer->fd = -1;
        writer->error = error;
    }
    writer->memory = NULL;
    return -writer->error;
}

int replay_dump(struct replay_writer *writer, const uint8_t *memory, uint64_t hash, bool is_torn,
                int fd)
{
    uint8_t end[REPLAY_END_SIZE];
    if (writer->offset == 0) {
        return -ENODATA;
    }
    const int error = file_write(fd, memory, (size_t)writer->offset);
    if (error) {
        return error;
    }
    if (is_torn || writer->memory == NULL || writer->chunk_ticks == 0) {
        put_end(end, &writer->saved, writer->sum);
        return file_write(fd, end, sizeof end);
    }
    writer->totals.hash = hash;
    const size_t size = close_chunk(writer->bytes, writer->payload_size, writer->chunk_ticks,
                                    &writer->totals, &writer->sum);
    return file_write(fd, writer->bytes, size + REPLAY_END_SIZE);
}

size_t replay_copy(const struct replay_writer *writer, uint64_t hash, uint8_t *out, size_t size)
{
    struct replay_totals totals = writer->totals;
    uint64_t sum = writer->sum;
    const size_t begun =
        writer->chunk_ticks > 0 ? REPLAY_CHUNK_HEAD_SIZE + writer->payload_size : 0;
    const size_t whole = (size_t)writer->offset + REPLAY_END_SIZE;
    if (writer->memory == NULL || size < whole + (begun > 0 ? begun + REPLAY_SUM_SIZE : 0)) {
        return 0;
    }
    memcpy(out, writer->memory, whole);
    if (begun == 0) {
        return whole;
    }
    totals.hash = hash;
    uint8_t *chunk = out + writer->offset;
    memcpy(chunk, writer->bytes, begun);
    return whole + close_chunk(chunk, writer->payload_size, writer->chunk_ticks, &totals, &sum);
}
