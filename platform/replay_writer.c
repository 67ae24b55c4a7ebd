/* replay_writer.c -- keeps a recording whole on disk at every moment. */
#include "platform/replay.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "platform/replay_format.h"

static int write_at(int fd, const uint8_t *bytes, size_t size, uint64_t offset)
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

static uint32_t who_played(const struct replay_totals *totals)
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
    replay_put_u32(out + END_WHO, who_played(totals));
    replay_put_u64(out + END_HASH, totals->hash);
    replay_put_u64(out + END_SUM, hash_bytes(sum, out, END_SUM));
}

/* Header and book. `*size` is theirs; returns the sum that the first chunk goes on from. */
static uint64_t put_header(uint8_t *out, const struct core_config *config, size_t *size)
{
    const uint32_t fields[] = { config->seed,     config->preset,  config->fish_count,
                                config->language, config->round_s, config->modes,
                                config->grade,    config->players, config->credit_coins,
                                config->ticket_fish, config->best_today[0],
                                config->best_today[1], config->best_today[2] };
    _Static_assert(MODE_COUNT == 3, "the header has a field for each mode's best");
    memset(out, 0, REPLAY_HEADER_SIZE);
    memcpy(out, REPLAY_MAGIC, 8);
    replay_put_u32(out + HEADER_VERSION, REPLAY_VERSION | REPLAY_HEADER_SIZE << 16);
    replay_put_u32(out + HEADER_TICK_HZ, CORE_TICK_HZ);
    memcpy(out + HEADER_PROGRAM, KINGYO_VERSION, sizeof KINGYO_VERSION);
    for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        replay_put_u32(out + HEADER_CONFIG + 4 * i, fields[i]);
    }
    uint8_t *book = out + REPLAY_HEADER_SIZE;
    const size_t book_size = replay_book_encode(&config->book, book);
    replay_put_u32(out + HEADER_BOOK, (uint32_t)book_size);
    uint64_t sum = hash_bytes(HASH_START, out, HEADER_SUM);
    replay_put_u64(out + HEADER_SUM, sum);
    *size = REPLAY_HEADER_SIZE;
    if (book_size > 0) {
        sum = hash_bytes(sum, book, book_size);
        replay_put_u64(book + book_size, sum);
        *size += book_size + REPLAY_SUM_SIZE;
    }
    return sum;
}
_Static_assert(sizeof KINGYO_VERSION <= REPLAY_PROGRAM_SIZE, "the version must fit the header");

static void give_up(struct replay_writer *writer, int error)
{
    close(writer->fd);
    writer->fd = -1;
    writer->error = -error;
}

/* A descriptor, or a negative errno. What was played once cannot be played again: a file that holds
 * anything is left as it is. */
static int open_empty(const char *path)
{
    struct stat status;
    const int fd = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0644);
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

int replay_create(struct replay_writer *writer, const char *path, const struct core_config *config,
                  uint64_t first_hash)
{
    uint8_t *bytes = writer->bytes;
    memset(writer, 0, sizeof *writer);
    writer->fd = open_empty(path);
    if (writer->fd < 0) {
        return writer->fd;
    }
    writer->totals.hash = first_hash;
    writer->saved = writer->totals;
    size_t size;
    writer->sum = put_header(bytes, config, &size);
    writer->offset = size;
    put_end(bytes + size, &writer->totals, writer->sum);
    const int error = write_at(writer->fd, bytes, size + REPLAY_END_SIZE, 0);
    if (error) {
        give_up(writer, error);
    }
    return error;
}

/* The old end mark goes back to its old place, which costs no new space on a full disk. */
static void restore(struct replay_writer *writer)
{
    uint8_t end[REPLAY_END_SIZE];
    put_end(end, &writer->saved, writer->sum);
    int error = write_at(writer->fd, end, sizeof end, writer->offset);
    if (error == 0 && ftruncate(writer->fd, (off_t)(writer->offset + sizeof end)) != 0) {
        error = -errno;
    }
    (void)error; /* The recording has already failed; this was the best that could be done. */
}

static void write_chunk(struct replay_writer *writer)
{
    uint8_t *head = writer->bytes;
    memcpy(head, REPLAY_CHUNK_TAG, 4);
    replay_put_u32(head + CHUNK_PAYLOAD_SIZE, (uint32_t)writer->payload_size);
    replay_put_u32(head + CHUNK_FIRST_TICK, writer->totals.ticks - writer->chunk_ticks);
    replay_put_u32(head + CHUNK_TICK_COUNT, writer->chunk_ticks);
    replay_put_u32(head + CHUNK_ROUNDS, writer->totals.rounds);
    replay_put_u32(head + CHUNK_CAUGHT, writer->totals.caught);
    replay_put_u32(head + CHUNK_FOULS, writer->totals.fouls);
    replay_put_u32(head + CHUNK_WHO, who_played(&writer->totals));
    replay_put_u64(head + CHUNK_HASH, writer->totals.hash);

    const size_t summed = REPLAY_CHUNK_HEAD_SIZE + writer->payload_size;
    const uint64_t sum = hash_bytes(writer->sum, head, summed);
    const size_t chunk_size = summed + REPLAY_SUM_SIZE;
    replay_put_u64(head + summed, sum);
    put_end(head + chunk_size, &writer->totals, sum);

    const int error = write_at(writer->fd, head, chunk_size + REPLAY_END_SIZE, writer->offset);
    if (error) {
        restore(writer);
        give_up(writer, error);
        return;
    }
    writer->offset += chunk_size;
    writer->sum = sum;
    writer->saved = writer->totals;
    writer->chunk_ticks = 0;
    writer->payload_size = 0;
}

int replay_wants_hash(const struct replay_writer *writer)
{
    return writer->fd >= 0 && writer->chunk_ticks + 1 == REPLAY_CHUNK_TICKS;
}

void replay_add(struct replay_writer *writer, const struct input *input, uint32_t digest,
                const struct replay_totals *totals)
{
    if (writer->fd < 0) {
        return;
    }
    CORE_ASSERT(totals->ticks == writer->totals.ticks + 1);
    uint8_t *out = writer->bytes + REPLAY_CHUNK_HEAD_SIZE + writer->payload_size;
    const size_t size = replay_encode_input(&writer->last, input, out);
    replay_put_u32(out + size, digest);
    writer->payload_size += size + 4;
    writer->chunk_ticks++;
    writer->last = *input;
    writer->totals = *totals;
    if (writer->chunk_ticks == REPLAY_CHUNK_TICKS) {
        write_chunk(writer);
    }
}

int replay_finish(struct replay_writer *writer, uint64_t hash)
{
    if (writer->fd >= 0 && writer->chunk_ticks > 0) {
        writer->totals.hash = hash;
        write_chunk(writer);
    }
    if (writer->fd >= 0) {
        const int error = close(writer->fd) == 0 ? 0 : errno;
        writer->fd = -1;
        writer->error = error;
    }
    return -writer->error;
}
