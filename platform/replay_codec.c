/* replay_codec.c -- one input as the bytes that differ from the input before.
 *
 * First a mask: which of held, pressed, coin_count, record_saved_id and each poi follow. Then
 * those, the numbers as u32; a poi as a mask of its own, its link and wrist in one byte, and
 * those floats that changed, as their bits. Floats travel whole: a play must come back to the
 * last bit. */
#include "platform/replay.h"

#include <string.h>

enum {
    HAS_HELD = 1u << 0,
    HAS_PRESSED = 1u << 1, /* Edges and coins are not differences: absent means none. */
    HAS_COINS = 1u << 2,
    HAS_SAVED_ID = 1u << 3,
    HAS_POI = 1u << 4, /* Of poi 0; the others follow. */
};

enum {
    POI_HAS_LINK = 1u << 0,
    POI_HAS_FLOAT = 1u << 1, /* Of the first of six. */
    POI_FLOATS = 6,
    POI_MASK_ALL = (1u << (1 + POI_FLOATS)) - 1u,
    LINK_WRIST = 1u << 2, /* Bits 0 and 1 are the link. */
    LINK_ALL = 7u,
};

_Static_assert(sizeof(struct poi_target) == POI_FLOATS * sizeof(float), "a target is six floats");

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

/* ---- Encoding ---- */

static size_t put_if(int wanted, uint32_t value, uint8_t *out)
{
    if (!wanted) {
        return 0;
    }
    replay_put_u32(out, value);
    return 4;
}

static void target_bits(const struct poi_target *target, uint32_t bits[POI_FLOATS])
{
    memcpy(bits, target, sizeof *target);
}

static uint8_t link_byte(const struct poi_input *poi)
{
    return (uint8_t)(poi->link | (poi->has_wrist ? LINK_WRIST : 0u));
}

/* 0 bytes when nothing changed. */
static size_t encode_poi(const struct poi_input *before, const struct poi_input *poi, uint8_t *out)
{
    uint32_t old[POI_FLOATS];
    uint32_t new[POI_FLOATS];
    uint8_t mask = 0;
    size_t size = 1;
    target_bits(&before->target, old);
    target_bits(&poi->target, new);
    if (link_byte(poi) != link_byte(before)) {
        mask |= POI_HAS_LINK;
        out[size++] = link_byte(poi);
    }
    for (unsigned i = 0; i < POI_FLOATS; i++) {
        const int changed = old[i] != new[i];
        mask |= (uint8_t)(changed ? (uint32_t)POI_HAS_FLOAT << i : 0u);
        size += put_if(changed, new[i], out + size);
    }
    out[0] = mask;
    return mask ? size : 0;
}

size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out)
{
    const int held = input->held != before->held;
    const int pressed = input->pressed != 0;
    const int coins = input->coin_count != 0;
    const int saved = input->record_saved_id != before->record_saved_id;
    uint32_t mask = (held ? HAS_HELD : 0u) | (pressed ? HAS_PRESSED : 0u) |
                    (coins ? HAS_COINS : 0u) | (saved ? HAS_SAVED_ID : 0u);
    size_t size = 1;
    size += put_if(held, input->held, out + size);
    size += put_if(pressed, input->pressed, out + size);
    size += put_if(coins, input->coin_count, out + size);
    size += put_if(saved, input->record_saved_id, out + size);
    for (unsigned i = 0; i < POI_MAX; i++) {
        const size_t poi_size = encode_poi(&before->poi[i], &input->poi[i], out + size);
        mask |= poi_size > 0 ? (uint32_t)HAS_POI << i : 0u;
        size += poi_size;
    }
    out[0] = (uint8_t)mask;
    return size;
}

/* ---- Decoding ---- */

struct bytes_left {
    const uint8_t *at;
    size_t size;
    int bad;
};

static uint8_t take_u8(struct bytes_left *left)
{
    if (left->size < 1) {
        left->bad = 1;
        return 0;
    }
    left->size--;
    return *left->at++;
}

static uint32_t take_u32(struct bytes_left *left)
{
    if (left->size < 4) {
        left->bad = 1;
        return 0;
    }
    const uint32_t value = replay_get_u32(left->at);
    left->at += 4;
    left->size -= 4;
    return value;
}

static float take_float(struct bytes_left *left)
{
    const uint32_t bits = take_u32(left);
    float value;
    memcpy(&value, &bits, sizeof value);
    left->bad |= !f_is_finite(value);
    return value;
}

static void decode_poi(struct poi_input *poi, struct bytes_left *left)
{
    const uint8_t mask = take_u8(left);
    float *const floats[POI_FLOATS] = {
        &poi->target.position_m.x,    &poi->target.position_m.y,     &poi->target.position_m.z,
        &poi->target.angles.yaw_rad, &poi->target.angles.pitch_rad, &poi->target.angles.roll_rad,
    };
    left->bad |= mask == 0 || mask > POI_MASK_ALL;
    if (mask & POI_HAS_LINK) {
        const uint8_t link = take_u8(left);
        left->bad |= link > LINK_ALL;
        poi->link = link & 3u;
        poi->has_wrist = (link & LINK_WRIST) != 0;
    }
    for (unsigned i = 0; i < POI_FLOATS; i++) {
        if (mask & POI_HAS_FLOAT << i) {
            *floats[i] = take_float(left);
        }
    }
}

size_t replay_decode_input(struct input *input, const uint8_t *bytes, size_t size)
{
    struct bytes_left left = { .at = bytes, .size = size };
    struct input next = *input;
    const uint8_t mask = take_u8(&left);
    if (mask & HAS_HELD) {
        next.held = take_u32(&left);
    }
    next.pressed = mask & HAS_PRESSED ? take_u32(&left) : 0;
    next.coin_count = mask & HAS_COINS ? take_u32(&left) : 0;
    if (mask & HAS_SAVED_ID) {
        next.record_saved_id = take_u32(&left);
    }
    for (unsigned i = 0; i < POI_MAX; i++) {
        if (mask & HAS_POI << i) {
            decode_poi(&next.poi[i], &left);
        }
    }
    left.bad |= (next.held | next.pressed) > INPUT_BUTTON_ALL;
    if (left.bad) {
        return 0;
    }
    *input = next;
    return (size_t)(left.at - bytes);
}
