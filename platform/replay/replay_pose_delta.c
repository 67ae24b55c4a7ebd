/* replay_pose_delta.c -- encodes the poses of pois and fans as differences; see
 * replay_pose_delta.h. */
#include "platform/replay/replay_pose_delta.h"

#include <string.h>

enum {
    HANDS_POI = 1u << 0,         /* Bit of poi 0. The bits of the other pois follow. */
    HANDS_SHADE = 1u << POI_MAX, /* Bit of fan 0, after the bits of the pois. */
};

enum {
    HELD_HAS_BYTE = 1u << 0,
    HELD_HAS_FLOAT = 1u << 1, /* Bit of the first float. The bits of the other floats follow. */
    POI_FLOATS = 6,
    SHADE_FLOATS = 3,
    POI_HAS_AGE = 1u << 7, /* Bit of a poi's age, after the bits of the byte and the six floats. */
    LINK_WRIST = 1u << 2,  /* Bits 0 and 1 of the byte contain the link. */
    LINK_TREMBLES = 1u << 3,
    LINK_ALL = 15u,
};

_Static_assert(sizeof(struct poi_target) == POI_FLOATS * sizeof(float), "a target is six floats");
_Static_assert(POI_MAX + SHADE_MAX <= 8, "all that hands hold has its bit in one byte");

/* Stored form of a poi or a fan: one byte, floats and an age. */
struct held {
    uint8_t byte;
    uint8_t has_age; /* 1 for a poi and 0 for a fan, because a fan has no age. */
    uint16_t age;
    uint32_t float_count;
    uint32_t bits[POI_FLOATS];
};

/* ---- Encoding ------------------------------------------------------------------------------ */

static struct held poi_held(const struct poi_input *poi)
{
    const uint32_t byte = poi->link | (poi->has_wrist ? (uint32_t)LINK_WRIST : 0u) |
                          (poi->trembles ? (uint32_t)LINK_TREMBLES : 0u);
    struct held held = {
        .byte = (uint8_t)byte, .has_age = 1, .age = poi->age_ticks, .float_count = POI_FLOATS
    };
    memcpy(held.bits, &poi->target, sizeof poi->target);
    return held;
}

static struct held shade_held(const struct shade_input *shade)
{
    const float floats[SHADE_FLOATS] = { shade->x_m, shade->z_m, shade->radius_m };
    struct held held = { .byte = shade->present != 0, .float_count = SHADE_FLOATS };
    memcpy(held.bits, floats, sizeof floats);
    return held;
}

/* Writes the fields that changed. Returns the number of bytes, or 0 if nothing changed. */
static size_t encode_held(const struct held *before, const struct held *held, uint8_t *out)
{
    uint8_t mask = 0;
    size_t size = 1;
    if (held->byte != before->byte) {
        mask |= HELD_HAS_BYTE;
        out[size++] = held->byte;
    }
    for (unsigned i = 0; i < held->float_count; i++) {
        const int changed = before->bits[i] != held->bits[i];
        mask |= (uint8_t)(changed ? (uint32_t)HELD_HAS_FLOAT << i : 0u);
        size += replay_put_optional(changed, held->bits[i], out + size);
    }
    if (held->age != before->age) {
        mask |= POI_HAS_AGE;
        size += replay_put_u16(held->age, out + size);
    }
    out[0] = mask;
    return mask ? size : 0;
}

size_t replay_pose_delta_encode(const struct input *before, const struct input *input, uint8_t *out)
{
    uint32_t mask = 0;
    size_t size = 1;
    for (unsigned i = 0; i < POI_MAX; i++) {
        const struct held old = poi_held(&before->poi[i]), new = poi_held(&input->poi[i]);
        const size_t held_size = encode_held(&old, &new, out + size);
        mask |= held_size > 0 ? (uint32_t)HANDS_POI << i : 0u;
        size += held_size;
    }
    for (unsigned i = 0; i < SHADE_MAX; i++) {
        const struct held old = shade_held(&before->shade[i]), new = shade_held(&input->shade[i]);
        const size_t held_size = encode_held(&old, &new, out + size);
        mask |= held_size > 0 ? (uint32_t)HANDS_SHADE << i : 0u;
        size += held_size;
    }
    out[0] = (uint8_t)mask;
    return mask ? size : 0;
}

/* ---- Decoding ------------------------------------------------------------------------------ */

/* Updates the fields whose bits are set in the mask. All other fields keep their values. */
static void decode_held(struct held *held, uint8_t byte_max, struct replay_rest *rest)
{
    const uint8_t mask = replay_take_u8(rest);
    const uint32_t known = (2u << held->float_count) - 1u;
    rest->bad |= mask == 0 || (mask & ~(known | (held->has_age ? (uint32_t)POI_HAS_AGE : 0u))) != 0;
    if (mask & HELD_HAS_BYTE) {
        held->byte = replay_take_u8(rest);
        rest->bad |= held->byte > byte_max;
    }
    for (unsigned i = 0; i < held->float_count; i++) {
        if (mask & (uint32_t)HELD_HAS_FLOAT << i) {
            held->bits[i] = replay_take_u32(rest);
        }
    }
    if (mask & POI_HAS_AGE) {
        held->age = replay_take_u16(rest);
    }
}

static void decode_poi(struct poi_input *poi, struct replay_rest *rest)
{
    struct held held = poi_held(poi);
    decode_held(&held, LINK_ALL, rest);
    poi->link = held.byte & 3u;
    poi->has_wrist = (held.byte & LINK_WRIST) != 0;
    poi->trembles = (held.byte & LINK_TREMBLES) != 0;
    poi->age_ticks = held.age;
    memcpy(&poi->target, held.bits, sizeof poi->target);
}

static void decode_shade(struct shade_input *shade, struct replay_rest *rest)
{
    float floats[SHADE_FLOATS];
    struct held held = shade_held(shade);
    decode_held(&held, 1, rest);
    memcpy(floats, held.bits, sizeof floats);
    for (unsigned i = 0; i < SHADE_FLOATS; i++) {
        rest->bad |= !f_is_finite(floats[i]) && !rest->as_is;
    }
    *shade = (struct shade_input){ held.byte, floats[0], floats[1], floats[2] };
}

void replay_pose_delta_decode(struct input *input, struct replay_rest *rest)
{
    const uint8_t mask = replay_take_u8(rest);
    rest->bad |= mask == 0;
    for (unsigned i = 0; i < POI_MAX; i++) {
        if (mask & (uint32_t)HANDS_POI << i) {
            decode_poi(&input->poi[i], rest);
        }
    }
    for (unsigned i = 0; i < SHADE_MAX; i++) {
        if (mask & (uint32_t)HANDS_SHADE << i) {
            decode_shade(&input->shade[i], rest);
        }
    }
}
