/* replay_bytes.h -- numbers of recordings as bytes, the lowest first. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_BYTES_H
#define KINGYO_PLATFORM_REPLAY_BYTES_H

#include <stddef.h>
#include <stdint.h>

uint32_t replay_get_u32(const uint8_t *bytes);
uint64_t replay_get_u64(const uint8_t *bytes);
void replay_put_u32(uint8_t *bytes, uint32_t value);
void replay_put_u64(uint8_t *bytes, uint64_t value);

/* Each returns how many bytes it wrote; the first writes only what is wanted. */
size_t replay_put_if(int wanted, uint32_t value, uint8_t *out);
size_t replay_put_u16(uint16_t value, uint8_t *out);

/* What is still to be read. Whoever takes more than there is gets 0 and sets `bad`. */
struct replay_rest {
    const uint8_t *at;
    size_t size;
    int bad;
    int as_is; /* Floats that the core's contract forbids are read: the evidence of a panic. */
};

uint8_t replay_take_u8(struct replay_rest *rest);
uint16_t replay_take_u16(struct replay_rest *rest);
uint32_t replay_take_u32(struct replay_rest *rest);

#endif
