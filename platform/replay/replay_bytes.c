/* replay_bytes.c -- reads and writes little-endian numbers; see replay_bytes.h. */
#include "platform/replay/replay_bytes.h"

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

size_t replay_put_optional(int wanted, uint32_t value, uint8_t *out)
{
    if (!wanted) {
        return 0;
    }
    replay_put_u32(out, value);
    return 4;
}

size_t replay_put_u16(uint16_t value, uint8_t *out)
{
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    return 2;
}

uint8_t replay_take_u8(struct replay_rest *rest)
{
    if (rest->size < 1) {
        rest->bad = 1;
        return 0;
    }
    rest->size--;
    return *rest->at++;
}

uint32_t replay_take_u32(struct replay_rest *rest)
{
    if (rest->size < 4) {
        rest->bad = 1;
        return 0;
    }
    const uint32_t value = replay_get_u32(rest->at);
    rest->at += 4;
    rest->size -= 4;
    return value;
}

uint16_t replay_take_u16(struct replay_rest *rest)
{
    const uint32_t low = replay_take_u8(rest), high = replay_take_u8(rest);
    return (uint16_t)(low | high << 8);
}
