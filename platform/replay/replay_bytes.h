/* replay_bytes.h -- reads and writes little-endian numbers of recordings. Pure functions. */
#ifndef KINGYO_PLATFORM_REPLAY_REPLAY_BYTES_H
#define KINGYO_PLATFORM_REPLAY_REPLAY_BYTES_H

#include <stddef.h>
#include <stdint.h>

/* The get functions return the number in the first 4 or 8 bytes. The put functions write `value` to
 * 4 or 8 bytes. */
uint32_t replay_get_u32(const uint8_t *bytes);
uint64_t replay_get_u64(const uint8_t *bytes);
void replay_put_u32(uint8_t *bytes, uint32_t value);
void replay_put_u64(uint8_t *bytes, uint64_t value);

/* Each function returns the number of written bytes. replay_put_optional() writes `value` as 4
 * bytes if `wanted` is not 0, otherwise nothing. replay_put_u16() writes 2 bytes. */
size_t replay_put_optional(int wanted, uint32_t value, uint8_t *out);
size_t replay_put_u16(uint16_t value, uint8_t *out);

/* Bytes that are not yet read. Reading beyond the end returns 0 and sets `bad` to 1. */
struct replay_rest {
    const uint8_t *at;
    size_t size;
    int bad;
    int as_is; /* 1 if floats are accepted that the core does not permit, to read the recording of a
                  panic. */
};

/* Each function returns the next number in `rest` and advances `rest`. */
uint8_t replay_take_u8(struct replay_rest *rest);
uint16_t replay_take_u16(struct replay_rest *rest);
uint32_t replay_take_u32(struct replay_rest *rest);

#endif
