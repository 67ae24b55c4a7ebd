/* replay.h -- the file format of recordings, which contain the inputs of a game and checksums of
 * the core's states.
 *
 * All numbers are little-endian. A file consists of one header, the initial state ("start"), the
 * growth lab's catalog ("book"), chunks of at most one second each, and one end mark. The catalog
 * is absent if it is empty. The table lists the fields of each part in their order in the file:
 *
 *   header   magic 8, u16 version, u16 header size, u32 tick rate in Hz, program version 16 (text,
 *            zero-filled), u32 ticks per digest, u32 start size, u32 book size, u64 sum of the 44
 *            bytes before it
 *   start    start size bytes (replay_initial_state.c), u64 sum
 *   book     book size bytes, the catalog (replay_initial_state.c), u64 sum; absent if the size is
 *            0
 *   chunk    "SECS", u32 payload size, u32 first tick, u32 tick count, u32 rounds begun, u32 fish
 *            caught, u32 fouls, u16 modes played, u16 players, u64 core_hash after the last tick,
 *            payload, u64 sum
 *   end      "ENDS", u32 tick count, u32 rounds begun, u32 fish caught, u32 fouls, u16 modes
 *            played, u16 players, u64 core_hash, u64 sum
 *   payload  each tick in order: the input as the difference from the previous input
 *            (replay_codec.c); after each interval of the header's ticks per digest also the low
 *            32 bits of core_hash_quick
 *
 * A sum is an FNV-1a checksum of the preceding bytes of its part. Its initial value is the sum of
 * the previous part, so that every changed, exchanged or missing part is detected.
 *
 * Each chunk is written together with a new end mark, in one write that overwrites the previous end
 * mark. A recording in progress is therefore complete up to its last second, and a killed process
 * loses at most one second. The frame loop's thread writes the file and does not sync it. A power
 * cut may lose data that the operating system had not written yet. A card that does not respond
 * blocks the frame loop. The reader rejects a truncated file with a message that states how many
 * seconds are valid. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/core.h"
#include "core/input.h"
#include "core/game/lab/lab_edit.h"

/* Maximum size of the serialized initial state in bytes. Full leaderboards with all audits (the
 * operator's counters) take two thirds of this size. */
#define REPLAY_INITIAL_STATE_MAX (16u * 1024u)

/* Maximum size of a catalog in bytes. Eight species and fifteen graphs take 25 KB. */
#define REPLAY_CATALOG_MAX (32u * 1024u)

/* Format version that the writer writes. Version 8 added the rules of tickets and refunds,
 * version 9 the levels and the presents, version 10 the side of the bowl, the settings for
 * the bodies of the players, the end of a session between two games, and the blocking of credits
 * that may not be on disk, version 11 the settings of the sound and of the light, and version 12
 * the settings of the camera and of the look of the bowls, and the place of the bowl on a portrait
 * screen. */
#define REPLAY_VERSION 12u
/* Oldest format version that the reader accepts. A recording of an older version is simulated under
 * the rules of that version (config_has_rules() in core/config.h). Versions below 7 are rejected
 * because their recordings lack data: the shadows (version 1), the game modes (up to version 2),
 * the growth lab (up to version 3), the credits and the operator's controllers (up to version 4),
 * the ledger (up to version 5), and the wrong PINs (up to version 6). */
#define REPLAY_VERSION_MIN 7u

/* Sizes in bytes of the header, the head of a chunk, the end mark and a checksum. */
#define REPLAY_HEADER_SIZE 52u
#define REPLAY_CHUNK_HEAD_SIZE 40u
#define REPLAY_END_SIZE 40u
#define REPLAY_SUM_SIZE 8u
/* Number of ticks in a complete chunk, which lasts one second. */
#define REPLAY_CHUNK_TICKS CORE_TICK_HZ
#define REPLAY_PROGRAM_SIZE 16u

#define REPLAY_CONTROLLERS_BYTES (CONTROLLER_MAX + 5u)

/* Maximum size in bytes of the machine state in the input of one tick: a mask byte, two ids of
 * saved data, a byte of flags, the day, the minute, and the numbers of dropped ticks, faults and
 * completed tickets. */
#define REPLAY_MACHINE_BYTES (1u + 2u * 4u + 1u + 2u * 2u + 3u * 4u)

/* Maximum size in bytes of the poses of one tick. The first byte is a mask with one bit for each
 * poi and fan. Each poi has a mask byte, a status byte, six floats and an age of two bytes. Each
 * fan has a mask byte, a status byte and three floats. */
#define REPLAY_POSE_BYTES                                                                          \
    (1u + POI_MAX * (1u + 1u + 6u * 4u + 2u) + SHADE_MAX * (1u + 1u + 3u * 4u))
/* Maximum size in bytes of the input of one tick: a mask byte, held and pressed buttons, coins of
 * each line, the machine state, the controllers' mask and bytes, the poses and the digest (a
 * checksum of the core's state). */
#define REPLAY_TICK_SIZE_MAX                                                                       \
    (1u + (2u + COIN_LINE_COUNT) * 4u + REPLAY_MACHINE_BYTES + 2u + REPLAY_CONTROLLERS_BYTES +     \
     REPLAY_POSE_BYTES + 4u)
/* Maximum size in bytes of a chunk's payload. */
#define REPLAY_PAYLOAD_MAX (REPLAY_CHUNK_TICKS * REPLAY_TICK_SIZE_MAX)

/* Maximum size in bytes of the header with the initial state and the catalog. */
#define REPLAY_HEADER_MAX                                                                          \
    (REPLAY_HEADER_SIZE + REPLAY_INITIAL_STATE_MAX + REPLAY_CATALOG_MAX + 2u * REPLAY_SUM_SIZE)
/* Size in bytes of a buffer that is large enough for the header with an end mark, and for any chunk
 * with an end mark. */
#define REPLAY_BUFFER_SIZE                                                                         \
    (REPLAY_HEADER_MAX + REPLAY_PAYLOAD_MAX + REPLAY_SUM_SIZE + REPLAY_END_SIZE)

/* Parsed content of the header and the initial state. */
struct replay_header {
    struct core_config config;
    /* Format version of the file: REPLAY_VERSION_MIN .. REPLAY_VERSION. If the reader has rejected
     * the file because of its version, `version` is the rejected version. 0 means that the file is
     * not a recording. */
    uint32_t version;
    /* KINGYO_VERSION of the program that wrote the recording. Zero-terminated. */
    char program[REPLAY_PROGRAM_SIZE];
};

/* Value that a recording contains in place of core_hash() for a tick that a panic interrupted. Such
 * a tick has no complete state, so core_hash() cannot be computed. Only a reader whose field
 * `as_is` is true gives this meaning to 0. */
#define REPLAY_HASH_NONE 0u

/* Totals of a recording, counted from its start to the end of a chunk or to the end of the
 * recording. */
struct replay_totals {
    uint32_t ticks, rounds, caught, fouls;
    /* Set of the game modes that were played so far. Game mode m is the bit 1 << m (enum
     * game_mode). */
    uint16_t modes;
    /* Set of the players who took part in a round so far. Player p is the bit 1 << p. */
    uint16_t players;
    /* Result of core_hash() after the last tick of the chunk or of the recording. */
    uint64_t hash;
};

/* ---- Initial state (replay_initial_state.c), pure functions -----------------------------------
 *
 * The initial state is the core's configuration and the loaded persistent state. The growth lab's
 * catalog (installed species and saved graphs) is a separate part. Without the catalog, a game that
 * used the growth lab could not be replayed. Most bytes of the initial state are zero, and a run of
 * zeros takes one byte. */

/* Writes the initial state to `out`. Returns the number of bytes, which is never 0. */
size_t replay_initial_state_encode(const struct core_config *config,
                                   uint8_t out[REPLAY_INITIAL_STATE_MAX]);

/* Parses exactly `size` bytes, which may have any content, in format `version` (REPLAY_VERSION_MIN
 * .. REPLAY_VERSION). Leaves the catalog (config->book) and the number of SIMD lanes
 * (config->lanes) unchanged. Sets fields that the format lacks to 0. For an older format, sets
 * config->rules to the rules of that format. Returns true on success. If no recorder could have
 * written these bytes, returns false, and `config` is invalid. */
bool replay_initial_state_decode(struct core_config *config, const uint8_t *bytes, size_t size,
                                 uint32_t version);

/* Writes the catalog to `out`. Returns the number of bytes. Returns 0 for an empty catalog. */
size_t replay_catalog_encode(const struct lab_book *book, uint8_t out[REPLAY_CATALOG_MAX]);

/* Parses exactly `size` bytes, which may have any content. Returns true on success. If the bytes
 * are not a valid catalog for the species of this program, empties `book` and returns false. */
bool replay_catalog_decode(struct lab_book *book, const uint8_t *bytes, size_t size);

/* ---- Codec (replay_codec.c), pure functions ------------------------------------------------ */

/* Encodes `input` as the difference from `before`. Writes at most REPLAY_TICK_SIZE_MAX - 4 bytes.
 * Returns the number of bytes. */
size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out);

/* Decodes one input. `input` must contain the input of the previous tick and is updated. Returns
 * the number of bytes that were read. Returns 0 and leaves `input` unchanged if the bytes are
 * incomplete or contain values that no recorder writes. If `as_is` is true, also accepts hand-held
 * fans whose poses are NaN or infinite, although the core panics for these values. */
size_t replay_decode_input(struct input *input, const uint8_t *bytes, size_t size, bool as_is);

/* Returns true if the totals `a` and `b` are equal in all fields except `ticks` and `hash`. */
bool replay_totals_agree(const struct replay_totals *a, const struct replay_totals *b);

/* ---- Writer (replay_writer.c) -------------------------------------------------------------- */

struct replay_writer {
    int fd; /* Descriptor of the file. -1 means no file. */
    /* Buffer of `memory_size` bytes that receives the recording in place of a file. Null if the
     * recording goes to a file. */
    uint8_t *memory;
    size_t memory_size;
    /* The errno value of the failure that ended the recording. 0 means no failure. */
    int error;
    uint64_t offset; /* Offset of the end mark from the start of the recording, in bytes. */
    uint64_t sum;    /* Checksum at the end of the last complete chunk. */
    struct input last;
    /* `totals` has the totals of all recorded ticks. `saved` has the totals of the ticks in the
     * written chunks. */
    struct replay_totals totals, saved;
    uint32_t digest_ticks;
    uint32_t chunk_ticks;
    size_t payload_size;
    uint8_t bytes[REPLAY_BUFFER_SIZE];
};

/* Starts a recording in the file `path`, with a digest (a checksum of the core's state) in each
 * tick. `first_hash` is core_hash() of the new core. Returns 0 on success. Returns -EEXIST if the
 * file exists and is not empty, or another negative errno after an error. After an error, no file
 * is open. */
int replay_create(struct replay_writer *writer, const char *path, const struct core_config *config,
                  uint64_t first_hash);

/* Starts a recording in the caller's memory, with a digest (a checksum of the core's state) in each
 * second. `memory` must outlive the recording. Returns 0, or -ENOSPC if the header does not fit. If
 * the memory is full later, the recording ends as on a full disk. */
int replay_create_in(struct replay_writer *writer, uint8_t *memory, size_t size,
                     const struct core_config *config, uint64_t first_hash);

/* Returns true while the writer accepts ticks. */
bool replay_is_open(const struct replay_writer *writer);

/* Adds one tick. If the tick is the last of a second, writes a chunk to the file. `digest` is used
 * only if replay_needs_digest() returns true, and `totals->hash` only if replay_needs_hash()
 * returns true. A failed write ends the recording and sets `error`. The file then ends with the
 * last complete second. */
void replay_add(struct replay_writer *writer, const struct input *input, uint32_t digest,
                const struct replay_totals *totals);

/* replay_needs_digest() returns true if the next replay_add() uses `digest`. replay_needs_hash()
 * returns true if the next replay_add() uses `totals->hash`. */
bool replay_needs_digest(const struct replay_writer *writer);
bool replay_needs_hash(const struct replay_writer *writer);

/* Writes the last, incomplete second and closes the file. `hash` is core_hash() of the current
 * state. Returns 0, or the negative errno of the failure that ended the recording. */
int replay_finish(struct replay_writer *writer, uint64_t hash);

/* Writes a recording in memory to the descriptor `fd` as if the recording had ended with the newest
 * tick. `memory` must be the buffer that was passed to replay_create_in(). (writer->memory is null
 * after the buffer became full.) `hash` is core_hash() of the current state. Pass true as `is_torn`
 * if a signal interrupted a function of the writer. Then only complete seconds are written. The
 * writer cannot be used afterwards. Async-signal-safe. Returns 0 on success, -ENODATA if nothing
 * was recorded, or another negative errno. */
int replay_dump(struct replay_writer *writer, const uint8_t *memory, uint64_t hash, bool is_torn,
                int fd);

/* Copies a recording in memory to `out` as if the recording had ended with the newest tick. The
 * recording continues. `hash` is core_hash() of the current state. Returns the size in bytes.
 * Returns 0 if the recording is not open or `size` is too small. */
size_t replay_copy(const struct replay_writer *writer, uint64_t hash, uint8_t *out, size_t size);

/* ---- Reader (replay_reader.c) -------------------------------------------------------------- */

#define REPLAY_PROBLEM_SIZE 120u

/* Reason why a recording cannot be used. `is_io` is true if the file could not be read (exit code
 * 74), and false if its bytes are not a complete recording (exit code 65). */
struct replay_problem {
    bool is_io;
    uint64_t offset;
    char text[REPLAY_PROBLEM_SIZE];
};

struct replay_reader {
    int fd; /* Descriptor of the file. -1 means no file. */
    /* Buffer of `memory_size` bytes that contains the recording in place of a file. Null if the
     * recording comes from a file. */
    const uint8_t *memory;
    size_t memory_size;
    /* Offset of the next part of the recording from its start, in bytes. After a failure of
     * replay_open() or replay_open_in(), the offset shows what is invalid. 0 means that the
     * header's checksum was not verified. REPLAY_HEADER_SIZE means that this checksum is correct,
     * but the header or the initial state is invalid. A larger value means that only the catalog is
     * invalid. */
    uint64_t offset;
    uint64_t sum;
    struct replay_header header;
    /* Totals from the start of the recording to the end of the current chunk or to the end mark. */
    struct replay_totals totals;
    struct input input;
    uint32_t digest_ticks;
    bool has_digest; /* True if the tick that replay_next() returned last has a digest. */
    uint32_t digest;
    uint32_t tick; /* Number of ticks that replay_next() has returned so far. */
    /* Number of ticks in the current chunk that replay_next() has not returned yet. */
    uint32_t chunk_left;
    size_t payload_size, payload_used;
    bool ended;
    /* True to accept recorded poses of fans that are NaN or infinite (parameter `as_is` of
     * replay_decode_input()). The core panics for such a pose. Therefore only a caller that handles
     * a panic may set this field, after replay_open(). */
    bool as_is;
    struct replay_problem problem;
    uint8_t bytes[REPLAY_BUFFER_SIZE];
};

/* Opens the recording `path`. Returns 0. On an error returns -1 and sets `problem`, and no file is
 * open. */
int replay_open(struct replay_reader *reader, const char *path);

/* Opens a recording in the caller's memory. Returns 0, or -1 after an error, as replay_open() does.
 * `memory` must outlive the reader. */
int replay_open_in(struct replay_reader *reader, const uint8_t *memory, size_t size);

/* Reads the next tick. Returns 1 and sets `input` and reader->has_digest. If reader->has_digest is
 * true, also sets reader->digest. Returns 0 at the end mark. Returns -1 and sets reader->problem if
 * the recording is invalid. If reader->chunk_left is 0 after a tick, reader->totals contains the
 * totals after that tick. */
int replay_next(struct replay_reader *reader, struct input *input);

/* Closes the recording without reading the rest. */
void replay_close(struct replay_reader *reader);

/* replay_scan() reads and validates a whole file. replay_scan_on() reads and validates the rest of
 * an open recording. Each function returns 0 and sets `totals` of the whole recording, or returns
 * -1 and sets reader->problem. Afterwards `reader` is closed, but its header remains valid. */
int replay_scan(struct replay_reader *reader, const char *path, struct replay_totals *totals);
int replay_scan_on(struct replay_reader *reader, struct replay_totals *totals);
