/* replay_format.h -- the parts of a recording, used by the writer and the reader: byte offsets,
 * little-endian numbers, and the serializer. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* First bytes of a recording. They include control and non-ASCII characters, which a text
 * conversion changes, so that the reader rejects a converted file. */
#define REPLAY_MAGIC "KGR\x1a\r\n\x89\n"
#define REPLAY_CHUNK_TAG "SECS"
#define REPLAY_END_TAG "ENDS"

enum {
    HEADER_VERSION = 8,
    HEADER_SIZE_FIELD = 10,
    HEADER_TICK_HZ = 12,
    HEADER_PROGRAM = 16,
    HEADER_DIGEST_TICKS = 32,
    HEADER_START = 36,
    HEADER_BOOK = 40,
    HEADER_SUM = 44,

    CHUNK_PAYLOAD_SIZE = 4,
    CHUNK_FIRST_TICK = 8,
    CHUNK_TICK_COUNT = 12,
    CHUNK_ROUNDS = 16,
    CHUNK_CAUGHT = 20,
    CHUNK_FOULS = 24,
    CHUNK_WHO = 28,
    CHUNK_HASH = 32,

    END_TICKS = 4,
    END_ROUNDS = 8,
    END_CAUGHT = 12,
    END_FOULS = 16,
    END_WHO = 20,
    END_HASH = 24,
    END_SUM = 32,
};

/* ---- Numbers (replay_serializer.c), pure functions ------------------------------------------- */

/* replay_get_u32() and replay_get_u64() return the number in the first 4 or 8 bytes.
 * replay_put_u32() and replay_put_u64() write `value` to 4 or 8 bytes. */
uint32_t replay_get_u32(const uint8_t *bytes);
uint64_t replay_get_u64(const uint8_t *bytes);
void replay_put_u32(uint8_t *bytes, uint32_t value);
void replay_put_u64(uint8_t *bytes, uint64_t value);

/* ---- Serializer (replay_serializer.c), pure functions ------------------------------------------
 *
 * The serializer reads or writes fields in sequence, so that one function defines the order of
 * fields for both directions. Each call writes the field if `out` is not null, and otherwise reads
 * the field. Numbers are little-endian, and floats are stored as their bits. */

struct replay_serializer {
    uint8_t *out;      /* Destination buffer. Null means that fields are read. */
    const uint8_t *in; /* Source buffer if `out` is null. */
    /* Size of the buffer, and position of the next byte in the buffer, in bytes. */
    size_t size, at;
    /* Format version of the bytes: REPLAY_VERSION_MIN .. REPLAY_VERSION. 0 in a catalog, which has
     * no version. */
    uint32_t version;
    /* True if the buffer was too short. After the value has become true, later calls have no
     * effect. */
    bool bad;
    /* True to accept floats that the core does not permit, for example NaN, when the recording of a
     * panic is read. */
    bool as_is;
};

/* Each function whose name begins with replay_serialize_ writes or reads one field, or an array of
 * `count` elements. */
void replay_serialize_bytes(struct replay_serializer *walk, void *bytes, size_t count);
void replay_serialize_u8(struct replay_serializer *walk, uint8_t *value);
void replay_serialize_u16(struct replay_serializer *walk, uint16_t *value);
void replay_serialize_u32(struct replay_serializer *walk, uint32_t *value);
