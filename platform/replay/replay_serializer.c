/* replay_serializer.c -- reads and writes little-endian numbers, and serializes one field at a time
 * (replay_format.h). */
#include <string.h>

#include "core/base/panic.h"
#include "platform/replay/replay_format.h"

uint32_t replay_get_u32(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

uint64_t replay_get_u64(const uint8_t *bytes)
{
    return (uint64_t)replay_get_u32(bytes) | (uint64_t)replay_get_u32(bytes + 4) << 32;
}

void replay_put_u32(uint8_t *bytes, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

void replay_put_u64(uint8_t *bytes, uint64_t value)
{
    replay_put_u32(bytes, (uint32_t)value);
    replay_put_u32(bytes + 4, (uint32_t)(value >> 32));
}

void replay_serialize_bytes(struct replay_serializer *walk, void *bytes, size_t count)
{
    CORE_ASSERT((walk->out == NULL) != (walk->in == NULL) && walk->at <= walk->size);
    if (walk->bad || walk->at + count > walk->size) {
        walk->bad = true;
        return;
    }
    if (walk->out != NULL) {
        memcpy(walk->out + walk->at, bytes, count);
    } else {
        memcpy(bytes, walk->in + walk->at, count);
    }
    walk->at += count;
}

void replay_serialize_u8(struct replay_serializer *walk, uint8_t *value)
{
    replay_serialize_bytes(walk, value, 1);
}

void replay_serialize_u16(struct replay_serializer *walk, uint16_t *value)
{
    uint8_t bytes[2] = { (uint8_t)*value, (uint8_t)(*value >> 8) };
    replay_serialize_bytes(walk, bytes, sizeof bytes);
    *value = (uint16_t)(bytes[0] | (uint32_t)bytes[1] << 8);
}

void replay_serialize_u32(struct replay_serializer *walk, uint32_t *value)
{
    uint8_t bytes[4];
    replay_put_u32(bytes, *value);
    replay_serialize_bytes(walk, bytes, sizeof bytes);
    *value = replay_get_u32(bytes);
}
