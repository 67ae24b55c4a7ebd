/* replay_serializer.h -- serializer that writes or reads the same fields in the same order.
 *
 * Each call either writes the field or reads it, depending on `out`. Little-endian; floats as their
 * bits. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_SERIALIZER_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_SERIALIZER_H

#include <stddef.h>
#include <stdint.h>

struct replay_serializer {
    uint8_t *out;      /* Destination, or null to read. */
    const uint8_t *in; /* Source if `out` is null. */
    size_t size, at;   /* Size of the buffer in use, and the position in it. */
    uint32_t version;  /* REPLAY_VERSION_MIN .. REPLAY_VERSION of the bytes; 0 in a book. */
    int bad;           /* 1: the buffer ended. Later calls have no effect. */
};

/* Write or read one field, or an array of `count` elements. */
void replay_serialize_bytes(struct replay_serializer *walk, void *bytes, size_t count);
void replay_serialize_u8(struct replay_serializer *walk, uint8_t *value);
void replay_serialize_u16(struct replay_serializer *walk, uint16_t *value);
void replay_serialize_u32(struct replay_serializer *walk, uint32_t *value);
void replay_serialize_floats(struct replay_serializer *walk, float *values, size_t count);

#endif
