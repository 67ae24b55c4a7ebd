/* replay_bytes.h -- little-endian numbers of recordings. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_BYTES_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_BYTES_H

#include <stddef.h>
#include <stdint.h>

/* Read or write 4 or 8 bytes. */
uint32_t replay_get_u32(const uint8_t *bytes);
uint64_t replay_get_u64(const uint8_t *bytes);
void replay_put_u32(uint8_t *bytes, uint32_t value);
void replay_put_u64(uint8_t *bytes, uint64_t value);

/* Return the number of bytes written. replay_put_optional() writes nothing if `wanted` is 0. */
size_t replay_put_optional(int wanted, uint32_t value, uint8_t *out);
size_t replay_put_u16(uint16_t value, uint8_t *out);

/* Bytes that are still to be read. Reading beyond the end returns 0 and sets `bad`. */
struct replay_rest {
    const uint8_t *at;
    size_t size;
    int bad;
    int as_is; /* 1: accept floats that the core's contract forbids, to read the evidence of a
                  panic. */
};

/* Read one number and advance `rest`. */
uint8_t replay_take_u8(struct replay_rest *rest);
uint16_t replay_take_u16(struct replay_rest *rest);
uint32_t replay_take_u32(struct replay_rest *rest);

#endif
