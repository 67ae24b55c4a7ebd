/* replay.h -- a play on disk: the inputs, and what the core made of them.
 *
 * All numbers are little-endian. A file is one header, the start, a book where the growth lab has
 * one, then chunks of at most one second, then one end mark, and nothing after it:
 *
 *   header   magic 8, u16 version, u16 header size, u32 tick rate in Hz, program version 16 (text,
 *            zero-filled), u32 ticks to a digest, u32 start size, u32 book size, u64 sum of the 44
 *            bytes before it
 *   start    as many bytes (replay_start.h), u64 sum
 *   book     as many bytes (replay_book.h), u64 sum; nothing where the size is 0
 *   chunk    "SECS", u32 payload size, u32 first tick, u32 tick count, u32 rounds begun, u32 fish
 *            caught, u32 fouls, u16 modes played, u16 players, u64 core_hash after the last tick,
 *            payload, u64 sum
 *   end      "ENDS", u32 tick count, u32 rounds begun, u32 fish caught, u32 fouls, u16 modes
 *            played, u16 players, u64 core_hash, u64 sum
 *   payload  a tick after the other: the input as what changed since the one before
 *            (replay_codec.c); then, after each so many ticks as the header says, the low 32 bits
 *            of core_hash_quick
 *
 * A sum is FNV-1a over the bytes before it in its part, started from the sum of the part before,
 * so that no part can be altered, swapped or left out unseen. The end mark is written with each
 * chunk, in one write over the last end mark: a recording in progress is whole up to its last
 * second, and a killed process loses at most that. Nothing is synced, and the frame's thread
 * writes: pulling the plug may lose what the system had not yet put on the disk, and a card that
 * hangs holds the frame. A file cut so is refused, and the refusal says how many of its seconds
 * are good. */
#ifndef KINGYO_PLATFORM_REPLAY_H
#define KINGYO_PLATFORM_REPLAY_H

#include <stddef.h>
#include <stdint.h>

#include "core/core.h"
#include "core/input.h"
#include "platform/replay_book.h"
#include "platform/replay_hands.h"
#include "platform/replay_start.h"

#define REPLAY_VERSION 8u /* Written. Version 8 adds the rules of tickets and refunds. */
#define REPLAY_VERSION_MIN 7u /* The oldest that is read, played by the rules of its time. Refused:
                                 1 has no shadows, 2 no modes, 3 no growth lab, 4 neither credits
                                 nor the operator's desk, 5 no ledger, 6 no wrong PINs. */
#define REPLAY_HEADER_SIZE 52u
#define REPLAY_CHUNK_HEAD_SIZE 40u
#define REPLAY_END_SIZE 40u
#define REPLAY_SUM_SIZE 8u
#define REPLAY_CHUNK_TICKS CORE_TICK_HZ /* One second. */
#define REPLAY_PROGRAM_SIZE 16u

#define REPLAY_DESK_BYTES (CONTROLLER_MAX + 4u)

/* What the machine says: a mask, two saved ids, levels, day and minute, dropped ticks, faults and
 * ended tickets. */
#define REPLAY_MACHINE_BYTES (1u + 2u * 4u + 1u + 2u * 2u + 3u * 4u)

/* One tick at most: mask, buttons, edges, coins of each line, the machine, a mask of the desk and
 * the desk, hands and the digest. */
#define REPLAY_TICK_SIZE_MAX                                                                       \
    (1u + (2u + COIN_LINE_COUNT) * 4u + REPLAY_MACHINE_BYTES + 2u + REPLAY_DESK_BYTES +            \
     REPLAY_HANDS_BYTES + 4u)
#define REPLAY_PAYLOAD_MAX (REPLAY_CHUNK_TICKS * REPLAY_TICK_SIZE_MAX)

/* The largest chunk, or the header with the largest start and book; with an end mark behind. */
#define REPLAY_HEADER_MAX                                                                          \
    (REPLAY_HEADER_SIZE + REPLAY_START_MAX + REPLAY_BOOK_MAX + 2u * REPLAY_SUM_SIZE)
#define REPLAY_BUFFER_SIZE                                                                         \
    (REPLAY_HEADER_MAX + REPLAY_PAYLOAD_MAX + REPLAY_SUM_SIZE + REPLAY_END_SIZE)

/* What the header says. */
struct replay_header {
    struct core_config config;
    uint32_t version; /* REPLAY_VERSION_MIN .. REPLAY_VERSION */
    char program[REPLAY_PROGRAM_SIZE]; /* KINGYO_VERSION of the recorder; zero-terminated. */
};

/* In place of a hash after a tick that a panic interrupted: there is no state to compare. Only a
 * reader that reads as is takes it for that. */
#define REPLAY_HASH_NONE 0u

/* What a part's end says of everything up to there. */
struct replay_totals {
    uint32_t ticks, rounds, caught, fouls;
    uint16_t modes;   /* Of rounds, a bit (1 << enum game_mode) each. */
    uint16_t players; /* Who took part in one, a bit each. */
    uint64_t hash; /* core_hash */
};

/* ---- Codec (replay_codec.c), pure ---- */

/* Writes `input` as what changed since `before`, at most REPLAY_TICK_SIZE_MAX - 4 bytes; returns
 * how many. */
size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out);

/* Reads one input into `input`, which holds the tick before. Returns the bytes used, or 0 when
 * they end early or say what no recorder writes: then `input` is as it was. */
size_t replay_decode_input(struct input *input, const uint8_t *bytes, size_t size);

/* The same, and with `as_is` also shades that are no finite numbers, for which the core panics. */
size_t replay_decode_as_is(struct input *input, const uint8_t *bytes, size_t size, int as_is);

/* Whether two agree in everything but ticks and hash. */
int replay_totals_agree(const struct replay_totals *a, const struct replay_totals *b);

/* ---- Writer (replay_writer.c) ---- */

struct replay_writer {
    int fd;                  /* -1: none. */
    uint8_t *memory;         /* Written to in place of a file, `memory_size` bytes; else null. */
    size_t memory_size;
    int error;               /* errno of what made it give up, or 0. */
    uint64_t offset;         /* Of the end mark. */
    uint64_t sum;            /* Of the last whole chunk. */
    struct input last;
    struct replay_totals totals, saved; /* Of the ticks so far; of those on disk. */
    uint32_t digest_ticks;
    uint32_t chunk_ticks;
    size_t payload_size;
    uint8_t bytes[REPLAY_BUFFER_SIZE];
};

/* Begins a file at `path`, with a digest of each tick; one that is there must be empty, else
 * -EEXIST. `first_hash` is core_hash of the fresh core. 0, or a negative errno and nothing is
 * open. */
int replay_create(struct replay_writer *writer, const char *path, const struct core_config *config,
                  uint64_t first_hash);

/* The same in the caller's memory, which outlives the recording, with a digest each second. -ENOSPC
 * when not even its head has room; memory that is full later ends the recording as a full disk
 * does. */
int replay_create_in(struct replay_writer *writer, uint8_t *memory, size_t size,
                     const struct core_config *config, uint64_t first_hash);

/* Whether ticks are still taken. */
int replay_is_open(const struct replay_writer *writer);

/* Adds a tick; with the last of a second, writes. `digest` is asked for only when
 * replay_wants_digest(), `totals->hash` only when replay_wants_hash(). A write that fails leaves
 * the file whole as it was and stops the recording: `error` says why. */
void replay_add(struct replay_writer *writer, const struct input *input, uint32_t digest,
                const struct replay_totals *totals);
int replay_wants_digest(const struct replay_writer *writer);
int replay_wants_hash(const struct replay_writer *writer);

/* Writes what is left of the last second. `hash` is core_hash now. 0 or the negative errno that the
 * recording ended with. */
int replay_finish(struct replay_writer *writer, uint64_t hash);

/* Writes a recording in memory to `fd` as if it had ended with the newest tick. `memory` is that of
 * replay_create_in(), because a recording that is full has given it up. `hash` is core_hash now;
 * `is_torn`: a change of the writer was interrupted, so that only its whole seconds are written.
 * The writer is of no use afterwards. Async-signal-safe. Returns 0 or a negative errno, -ENODATA if
 * nothing was ever recorded. */
int replay_dump(struct replay_writer *writer, const uint8_t *memory, uint64_t hash, int is_torn,
                int fd);

/* A recording in memory as if it had ended with the newest tick, while it goes on. `hash` is
 * core_hash now. Returns its size in `out`, or 0 when it is not open or `size` is too small. */
size_t replay_copy(const struct replay_writer *writer, uint64_t hash, uint8_t *out, size_t size);

/* Progress of renewing the checksums of a recording in memory. */
struct replay_seal {
    uint8_t *part; /* The next chunk of the recording, or its end. */
    uint64_t sum;  /* Of all parts before it. */
};

/* Replaces the start of a complete recording in memory, as replay_copy() makes it. The checksums of
 * its chunks and its end are wrong until replay_seal_next() has returned 1. Returns the new size,
 * or 0 if that is more than `size_max`: then nothing has changed. */
size_t replay_replace_start(uint8_t *recording, size_t size, size_t size_max,
                            const struct core_config *config, struct replay_seal *seal);

/* Renews the checksums of the next chunks until `size` bytes or more are done. Returns 1 when the
 * whole recording is done, else 0. */
int replay_seal_next(struct replay_seal *seal, size_t size);

/* ---- Reader (replay_reader.c) ---- */

#define REPLAY_PROBLEM_SIZE 120u

/* Why a file cannot be used. `is_io`: it could not be read at all (exit 74); else its bytes are
 * not a whole recording (exit 65). */
struct replay_problem {
    int is_io;
    uint64_t offset;
    char text[REPLAY_PROBLEM_SIZE];
};

struct replay_reader {
    int fd;                  /* -1: none. */
    const uint8_t *memory;   /* Read in place of a file, `memory_size` bytes; else null. */
    size_t memory_size;
    uint64_t offset;         /* Of the next part. */
    uint64_t sum;
    struct replay_header header;
    struct replay_totals totals; /* Said by the chunk that is being read, or by the end. */
    struct input input;
    uint32_t digest_ticks;
    uint8_t has_digest;      /* The tick that replay_next gave last has one: ... */
    uint32_t digest;
    uint32_t tick;           /* How many replay_next gave. */
    uint32_t chunk_left;     /* Ticks of the chunk still to give. */
    size_t payload_size, payload_used;
    uint8_t ended;
    uint8_t as_is; /* Set behind replay_open(): ticks are read by replay_decode_as_is(). Only
                      for a caller that bears a panic. */
    struct replay_problem problem;
    uint8_t bytes[REPLAY_BUFFER_SIZE];
};

/* 0, or -1 with `problem` filled and nothing open. */
int replay_open(struct replay_reader *reader, const char *path);

/* The same of a recording in the caller's memory, which outlives the reading. */
int replay_open_in(struct replay_reader *reader, const uint8_t *memory, size_t size);

/* The next tick: 1 with `input` filled, and `digest` where it has one, 0 at the end mark, -1 with
 * `problem` filled. When chunk_left is 0 after a tick, `totals` hold for the core after it. */
int replay_next(struct replay_reader *reader, struct input *input);

void replay_close(struct replay_reader *reader);

/* Reads a whole file, or what is left of the recording that is open, and checks every byte. 0 with
 * `totals` of all, or -1 with `reader->problem`. `reader` is closed afterwards; its header
 * remains. */
int replay_scan(struct replay_reader *reader, const char *path, struct replay_totals *totals);
int replay_scan_on(struct replay_reader *reader, struct replay_totals *totals);

#endif
