/* replay.h -- the file format of recordings: the inputs of a game and checksums of states.
 *
 * All numbers are little-endian. A file consists of one header, the start, the growth lab's catalog
 * if there is one, chunks of at most one second each, and one end mark:
 *
 *   header   magic 8, u16 version, u16 header size, u32 tick rate in Hz, program version 16 (text,
 *            zero-filled), u32 ticks per digest, u32 start size, u32 book size, u64 sum of the 44
 *            bytes before it
 *   start    start size bytes (replay_initial_state.h), u64 sum
 *   book     book size bytes, the catalog (replay_catalog.h), u64 sum; absent if the size is 0
 *   chunk    "SECS", u32 payload size, u32 first tick, u32 tick count, u32 rounds begun, u32 fish
 *            caught, u32 fouls, u16 modes played, u16 players, u64 core_hash after the last tick,
 *            payload, u64 sum
 *   end      "ENDS", u32 tick count, u32 rounds begun, u32 fish caught, u32 fouls, u16 modes
 *            played, u16 players, u64 core_hash, u64 sum
 *   payload  each tick in order: the input as the difference from the previous input
 *            (replay_codec.c); after each interval of the header's ticks per digest also the low
 *            32 bits of core_hash_quick
 *
 * A sum is an FNV-1a checksum over the preceding bytes of its part. Its initial value is the sum of
 * the previous part, so that every changed, exchanged or missing part is detected.
 *
 * The end mark is written together with each chunk, in one write that overwrites the previous end
 * mark. A recording in progress is therefore complete up to its last second, and a killed process
 * loses at most one second. The frame loop's thread writes without a sync. A power cut may lose
 * data that the system had not written yet, and a card that hangs blocks the frame loop. A
 * truncated file is rejected with a message that states how many of its seconds are valid. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_H

#include <stddef.h>
#include <stdint.h>

#include "core/core.h"
#include "core/input.h"
#include "platform/replay/replay_catalog.h"
#include "platform/replay/replay_initial_state.h"
#include "platform/replay/replay_pose_delta.h"

/* Version that is written. Version 8 added the rules of tickets and refunds. */
#define REPLAY_VERSION 8u
/* Oldest version that is read; its recordings run under the rules of that version. Older
 * versions are rejected: 1 lacks shadows, 2 modes, 3 the growth lab, 4 credits and the
 * operator's controllers, 5 the ledger, 6 wrong PINs. */
#define REPLAY_VERSION_MIN 7u
#define REPLAY_HEADER_SIZE 52u
#define REPLAY_CHUNK_HEAD_SIZE 40u
#define REPLAY_END_SIZE 40u
#define REPLAY_SUM_SIZE 8u
#define REPLAY_CHUNK_TICKS CORE_TICK_HZ /* One second. */
#define REPLAY_PROGRAM_SIZE 16u

#define REPLAY_DESK_BYTES (CONTROLLER_MAX + 4u)

/* Bytes of the machine's state: a mask, two saved ids, levels, day and minute, dropped ticks,
 * faults and ended tickets. */
#define REPLAY_MACHINE_BYTES (1u + 2u * 4u + 1u + 2u * 2u + 3u * 4u)

/* Largest size of one tick: mask, buttons, edges, coins of each line, the machine's state, the
 * controllers' mask and bytes, the poses and the digest. */
#define REPLAY_TICK_SIZE_MAX                                                                       \
    (1u + (2u + COIN_LINE_COUNT) * 4u + REPLAY_MACHINE_BYTES + 2u + REPLAY_DESK_BYTES +            \
     REPLAY_POSE_DELTA_BYTES + 4u)
#define REPLAY_PAYLOAD_MAX (REPLAY_CHUNK_TICKS * REPLAY_TICK_SIZE_MAX)

/* Buffer for the largest chunk, or for the header with the largest start and book; plus an end
 * mark. */
#define REPLAY_HEADER_MAX                                                                          \
    (REPLAY_HEADER_SIZE + REPLAY_INITIAL_STATE_MAX + REPLAY_CATALOG_MAX + 2u * REPLAY_SUM_SIZE)
#define REPLAY_BUFFER_SIZE                                                                         \
    (REPLAY_HEADER_MAX + REPLAY_PAYLOAD_MAX + REPLAY_SUM_SIZE + REPLAY_END_SIZE)

/* Parsed content of the header and the start. */
struct replay_header {
    struct core_config config;
    uint32_t version;                  /* REPLAY_VERSION_MIN .. REPLAY_VERSION */
    char program[REPLAY_PROGRAM_SIZE]; /* KINGYO_VERSION of the recorder; zero-terminated. */
};

/* Stands for the hash after a tick that a panic interrupted, because there is no complete state.
 * Only a reader with `as_is` set interprets the value in this way. */
#define REPLAY_HASH_NONE 0u

/* Totals at the end of a part, counted from the start of the recording. */
struct replay_totals {
    uint32_t ticks, rounds, caught, fouls;
    uint16_t modes;   /* Modes of the rounds, one bit (1 << enum game_mode) each. */
    uint16_t players; /* Players who took part in a round, one bit each. */
    uint64_t hash;    /* core_hash after the last tick. */
};

/* ---- Codec (replay_codec.c), pure ---- */

/* Encodes `input` as the difference from `before`, at most REPLAY_TICK_SIZE_MAX - 4 bytes. Returns
 * the number of bytes. */
size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out);

/* Decodes one input into `input`, which must hold the previous tick. Returns the bytes used.
 * Returns 0 and leaves `input` unchanged if the bytes are incomplete or contain values that no
 * recorder writes. */
size_t replay_decode_input(struct input *input, const uint8_t *bytes, size_t size);

/* Decodes as replay_decode_input(). With `as_is`, also accepts fans with non-finite numbers, for
 * which the core panics. */
size_t replay_decode_as_is(struct input *input, const uint8_t *bytes, size_t size, int as_is);

/* Returns 1 if the totals are equal in everything except ticks and hash. */
int replay_totals_agree(const struct replay_totals *a, const struct replay_totals *b);

/* ---- Writer (replay_writer.c) ---- */

struct replay_writer {
    int fd;          /* -1: no file. */
    uint8_t *memory; /* Destination of `memory_size` bytes in place of a file; else null. */
    size_t memory_size;
    int error;       /* errno of the failure that ended the recording, or 0. */
    uint64_t offset; /* Offset of the end mark in bytes. */
    uint64_t sum;    /* Checksum of the last complete chunk. */
    struct input last;
    struct replay_totals totals, saved; /* Totals of all ticks so far, and of the ticks on disk. */
    uint32_t digest_ticks;
    uint32_t chunk_ticks;
    size_t payload_size;
    uint8_t bytes[REPLAY_BUFFER_SIZE];
};

/* Starts a recording in a file at `path`, with a digest of each tick. An existing file must be
 * empty, else the result is -EEXIST. `first_hash` is core_hash of the new core. Returns 0, or a
 * negative errno with no file open. */
int replay_create(struct replay_writer *writer, const char *path, const struct core_config *config,
                  uint64_t first_hash);

/* Starts a recording in the caller's memory, with a digest each second. The memory must outlive the
 * recording. Returns -ENOSPC if the header does not fit. If the memory is full later, the recording
 * ends as on a full disk. */
int replay_create_in(struct replay_writer *writer, uint8_t *memory, size_t size,
                     const struct core_config *config, uint64_t first_hash);

/* Returns 1 while ticks are accepted. */
int replay_is_open(const struct replay_writer *writer);

/* Adds a tick. The last tick of a second writes the chunk. `digest` is used only if
 * replay_wants_digest() returns 1, and `totals->hash` only if replay_wants_hash() does. A write
 * that fails ends the recording and leaves the file complete up to the last second; `error` is
 * set. */
void replay_add(struct replay_writer *writer, const struct input *input, uint32_t digest,
                const struct replay_totals *totals);

/* Return 1 if the next replay_add() uses `digest`, or the hash in `totals`. */
int replay_wants_digest(const struct replay_writer *writer);
int replay_wants_hash(const struct replay_writer *writer);

/* Writes the rest of the last second and closes the file. `hash` is core_hash now. Returns 0 or the
 * negative errno that ended the recording. */
int replay_finish(struct replay_writer *writer, uint64_t hash);

/* Writes a recording in memory to `fd` as if it had ended with the newest tick. `memory` must be
 * the buffer of replay_create_in(), because a full recording has cleared its own pointer. `hash` is
 * core_hash now. With `is_torn`, a change of the writer was interrupted and only complete seconds
 * are written. The writer cannot be used afterwards. Async-signal-safe. Returns 0 or a negative
 * errno, -ENODATA if nothing was ever recorded. */
int replay_dump(struct replay_writer *writer, const uint8_t *memory, uint64_t hash, int is_torn,
                int fd);

/* Copies a recording in memory to `out` as if it had ended with the newest tick. The recording
 * continues. `hash` is core_hash now. Returns the size, or 0 if the recording is not open or `size`
 * is too small. */
size_t replay_copy(const struct replay_writer *writer, uint64_t hash, uint8_t *out, size_t size);

/* Progress of updating the checksums of a recording in memory. */
struct replay_seal {
    uint8_t *part; /* Next chunk of the recording, or its end. */
    uint64_t sum;  /* Checksum of all parts before `part`. */
};

/* Replaces the start of a complete recording in memory, as replay_copy() makes it. The checksums of
 * its chunks and its end are wrong until replay_seal_next() has returned 1. Returns the new size.
 * Returns 0 and changes nothing if the new size is more than `size_max`. */
size_t replay_replace_start(uint8_t *recording, size_t size, size_t size_max,
                            const struct core_config *config, struct replay_seal *seal);

/* Updates the checksums of the next chunks until `size` bytes or more are done. Returns 1 when the
 * whole recording is done, else 0. */
int replay_seal_next(struct replay_seal *seal, size_t size);

/* ---- Reader (replay_reader.c) ---- */

#define REPLAY_PROBLEM_SIZE 120u

/* Reason why a file cannot be used. `is_io` is 1 if the file could not be read (exit 74), and 0 if
 * its bytes are not a complete recording (exit 65). */
struct replay_problem {
    int is_io;
    uint64_t offset;
    char text[REPLAY_PROBLEM_SIZE];
};

struct replay_reader {
    int fd;                /* -1: no file. */
    const uint8_t *memory; /* Source of `memory_size` bytes in place of a file; else null. */
    size_t memory_size;
    uint64_t offset; /* Offset of the next part in bytes. */
    uint64_t sum;
    struct replay_header header;
    struct replay_totals totals; /* Totals of the current chunk, or of the end. */
    struct input input;
    uint32_t digest_ticks;
    uint8_t has_digest; /* 1: the last tick of replay_next() has a digest. */
    uint32_t digest;
    uint32_t tick;       /* Ticks returned by replay_next() so far. */
    uint32_t chunk_left; /* Ticks of the chunk that are not yet returned. */
    size_t payload_size, payload_used;
    uint8_t ended;
    uint8_t as_is; /* 1: decode with replay_decode_as_is(). Set after replay_open(), only by a
                      caller that tolerates a panic. */
    struct replay_problem problem;
    uint8_t bytes[REPLAY_BUFFER_SIZE];
};

/* Opens a recording. Returns 0, or -1 with `problem` filled and no file open. */
int replay_open(struct replay_reader *reader, const char *path);

/* Opens a recording in the caller's memory, which must outlive the reader. */
int replay_open_in(struct replay_reader *reader, const uint8_t *memory, size_t size);

/* Reads the next tick. Returns 1 with `input` filled, and `digest` if has_digest is 1. Returns 0 at
 * the end mark, or -1 with `problem` filled. When chunk_left is 0 after a tick, `totals` apply to
 * the core after that tick. */
int replay_next(struct replay_reader *reader, struct input *input);

/* Closes the recording without further checks. */
void replay_close(struct replay_reader *reader);

/* Read a whole file, or the rest of the open recording, and validate every byte. Return 0 with
 * `totals` of the whole recording, or -1 with `reader->problem`. `reader` is closed afterwards; its
 * header remains valid. */
int replay_scan(struct replay_reader *reader, const char *path, struct replay_totals *totals);
int replay_scan_on(struct replay_reader *reader, struct replay_totals *totals);

#endif
