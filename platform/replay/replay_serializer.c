/* replay_serializer.c -- reads or writes one field at a time; see replay_serializer.h. */
#include "platform/replay/replay_serializer.h"

#include <string.h>

#include "platform/replay/replay_bytes.h"

void replay_serialize_bytes(struct replay_serializer *walk, void *bytes, size_t count)
{
    if (walk->bad || walk->at + count > walk->size) {
        walk->bad = 1;
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

void replay_serialize_floats(struct replay_serializer *walk, float *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        replay_serialize_u32(walk, &bits);
        memcpy(&values[i], &bits, sizeof bits);
    }
}
