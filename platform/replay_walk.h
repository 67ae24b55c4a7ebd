/* replay_walk.h -- fields as bytes, in one order for both ways: a walk writes each field that it
 * meets, or reads it. Little-endian; floats as their bits. Pure. */
#ifndef KINGYO_PLATFORM_REPLAY_WALK_H
#define KINGYO_PLATFORM_REPLAY_WALK_H

#include <stddef.h>
#include <stdint.h>

struct replay_walk {
    uint8_t *out;      /* Written to, or null: ... */
    const uint8_t *in; /* ... read from. */
    size_t size, at;   /* Of either. */
    uint32_t version;  /* REPLAY_VERSION_MIN .. REPLAY_VERSION of the bytes; 0 in a book. */
    int bad;           /* There was no room, or no more; nothing was written or read since. */
};

void walk_bytes(struct replay_walk *walk, void *bytes, size_t count);
void walk_u8(struct replay_walk *walk, uint8_t *value);
void walk_u16(struct replay_walk *walk, uint16_t *value);
void walk_u32(struct replay_walk *walk, uint32_t *value);
void walk_floats(struct replay_walk *walk, float *values, size_t count);

#endif
