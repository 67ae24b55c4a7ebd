/* replay_serializer.h -- reads or writes fields in sequence, so that one function defines the order
 * of fields for both directions.
 *
 * Each call writes the field if `out` is not null, and otherwise reads it. Numbers are
 * little-endian, and floats are stored as their bits. Pure functions. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_SERIALIZER_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_SERIALIZER_H

#include <stddef.h>
#include <stdint.h>

struct replay_serializer {
    uint8_t *out;      /* Destination buffer. Null means that fields are read. */
    const uint8_t *in; /* Source buffer if `out` is null. */
    size_t size, at;   /* Size of the buffer, and position of the next byte in the buffer, in
                          bytes. */
    uint32_t version;  /* Format version of the bytes: REPLAY_VERSION_MIN .. REPLAY_VERSION. 0 in a
                          catalog, which has no version. */
    int bad;           /* 1 if the buffer was too short. Later calls have no effect. */
};

/* Each function writes or reads one field, or an array of `count` elements. */
void replay_serialize_bytes(struct replay_serializer *walk, void *bytes, size_t count);
void replay_serialize_u8(struct replay_serializer *walk, uint8_t *value);
void replay_serialize_u16(struct replay_serializer *walk, uint16_t *value);
void replay_serialize_u32(struct replay_serializer *walk, uint32_t *value);
void replay_serialize_floats(struct replay_serializer *walk, float *values, size_t count);

#endif
