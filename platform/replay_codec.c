/* replay_codec.c -- one input as the bytes that differ from the input before.
 *
 * First a mask: which of held, pressed, coins, of what the machine says, of the operator's
 * desk and of what hands hold follow. Then those in this order: the numbers as u32; of the machine,
 * a mask of the saved ids (u32 each), levels (a byte: the screen stands, the store keeps no edits,
 * the store is well), day and minute (u16 each), dropped ticks and faults (u32 each), and those of
 * them that changed; of the desk, a u16 mask of
 * its bytes (each controller's state, then step, row and progress of learning, then how many files
 * there are) and those that changed; of what hands hold, a mask of pois (low half) and shades (high
 * half), and of each of these a mask of its own, one byte (a poi's link, wrist and trembling, a
 * shade's presence), those floats that changed, as their bits, and a poi's age as u16. Floats
 * travel whole: a play must come back to the last bit, and of a hand that broke each counts. */
#include "platform/replay.h"

#include <string.h>

enum {
    HAS_HELD = 1u << 0,
    HAS_PRESSED = 1u << 1, /* Edges and coins are not differences: absent means none. */
    HAS_COINS = 1u << 2,
    HAS_MACHINE = 1u << 3,
    HAS_HANDS = 1u << 4,
    HAS_DESK = 1u << 5,
    HAS_ALL = 63u,
};

enum {
    MACHINE_SAVED_ID = 1u << 0,
    MACHINE_EDIT_ID = 1u << 1,
    MACHINE_LEVELS = 1u << 2,
    MACHINE_DAY = 1u << 3,
    MACHINE_MINUTE = 1u << 4,
    MACHINE_DROPPED = 1u << 5,
    MACHINE_FAULTS = 1u << 6,
    MACHINE_ALL = 127u,
};

enum {
    LEVEL_UPRIGHT = 1u << 0,
    LEVEL_REFUSED = 1u << 1,
    LEVEL_WELL = 1u << 2,
    LEVEL_ALL = 7u,
};

enum {
    DESK_STEP = CONTROLLER_MAX, /* Behind a byte for each controller. */
    DESK_ROW,
    DESK_PROGRESS,
    DESK_FILES,
    DESK_BYTES,
};
_Static_assert(DESK_BYTES == REPLAY_DESK_BYTES && DESK_BYTES <= 16, "each has its bit in a u16");
_Static_assert(sizeof(struct desk_input) == DESK_BYTES, "the desk's bytes are all of it");

enum {
    HANDS_POI = 1u << 0,          /* Of poi 0; the others follow, */
    HANDS_SHADE = 1u << POI_MAX,  /* and shade 0 after them. */
};

enum {
    HELD_HAS_BYTE = 1u << 0,
    HELD_HAS_FLOAT = 1u << 1, /* Of the first. */
    POI_FLOATS = 6,
    SHADE_FLOATS = 3,
    POI_HAS_AGE = 1u << 7,    /* Beyond the byte's and the six floats' bits. */
    LINK_WRIST = 1u << 2,     /* Bits 0 and 1 are the link. */
    LINK_TREMBLES = 1u << 3,
    LINK_ALL = 15u,
};

_Static_assert(sizeof(struct poi_target) == POI_FLOATS * sizeof(float), "a target is six floats");
_Static_assert(POI_MAX + SHADE_MAX <= 8, "all that hands hold has its bit in one byte");

/* A poi or a shade in the form that both have on disk: a small number, some floats, an age. */
struct held {
    uint8_t byte;
    uint8_t has_age; /* It can have one. */
    uint16_t age;
    uint32_t float_count;
    uint32_t bits[POI_FLOATS];
};

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

static size_t put_u16(uint16_t value, uint8_t *out)
{
    out[0] = (uint8_t)value;
    out[1] = (uint8_t)(value >> 8);
    return 2;
}

static struct held poi_held(const struct poi_input *poi)
{
    const uint32_t byte = poi->link | (poi->has_wrist ? (uint32_t)LINK_WRIST : 0u) |
                          (poi->trembles ? (uint32_t)LINK_TREMBLES : 0u);
    struct held held = { .byte = (uint8_t)byte,
                         .has_age = 1,
                         .age = poi->age_ticks,
                         .float_count = POI_FLOATS };
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

/* 0 bytes when nothing changed. */
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
        size += put_if(changed, held->bits[i], out + size);
    }
    if (held->age != before->age) {
        mask |= POI_HAS_AGE;
        size += put_u16(held->age, out + size);
    }
    out[0] = mask;
    return mask ? size : 0;
}

/* 0 bytes when no hand moved. */
static size_t encode_hands(const struct input *before, const struct input *input, uint8_t *out)
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

static uint8_t levels_of(const struct input *input)
{
    return (uint8_t)((input->upright ? LEVEL_UPRIGHT : 0u) |
                     (input->edit_refused ? LEVEL_REFUSED : 0u) |
                     (input->store_well ? LEVEL_WELL : 0u));
}

static uint32_t machine_mask(const struct input *before, const struct input *input)
{
    const int saved = input->record_saved_id != before->record_saved_id;
    const int edited = input->edit_saved_id != before->edit_saved_id;
    const int levels = levels_of(input) != levels_of(before);
    const int dropped = input->dropped_ticks != before->dropped_ticks;
    const int faults = input->device_faults != before->device_faults;
    return (saved ? MACHINE_SAVED_ID : 0u) | (edited ? MACHINE_EDIT_ID : 0u) |
           (levels ? MACHINE_LEVELS : 0u) |
           (input->day != before->day ? MACHINE_DAY : 0u) |
           (input->minute != before->minute ? MACHINE_MINUTE : 0u) |
           (dropped ? MACHINE_DROPPED : 0u) | (faults ? MACHINE_FAULTS : 0u);
}

/* 0 bytes when nothing changed. */
static size_t encode_machine(const struct input *before, const struct input *input, uint8_t *out)
{
    const uint32_t mask = machine_mask(before, input);
    size_t size = 1;
    out[0] = (uint8_t)mask;
    size += put_if((mask & MACHINE_SAVED_ID) != 0, input->record_saved_id, out + size);
    size += put_if((mask & MACHINE_EDIT_ID) != 0, input->edit_saved_id, out + size);
    if (mask & MACHINE_LEVELS) {
        out[size++] = levels_of(input);
    }
    if (mask & MACHINE_DAY) {
        size += put_u16(input->day, out + size);
    }
    if (mask & MACHINE_MINUTE) {
        size += put_u16(input->minute, out + size);
    }
    size += put_if((mask & MACHINE_DROPPED) != 0, input->dropped_ticks, out + size);
    size += put_if((mask & MACHINE_FAULTS) != 0, input->device_faults, out + size);
    return mask ? size : 0;
}

static void list_desk(const struct desk_input *desk, uint8_t out[DESK_BYTES])
{
    memcpy(out, desk->state, CONTROLLER_MAX);
    out[DESK_STEP] = desk->learn_step;
    out[DESK_ROW] = desk->learn_row;
    out[DESK_PROGRESS] = desk->learn_progress;
    out[DESK_FILES] = desk->file_count;
}

/* 0 bytes when nothing changed. */
static size_t encode_desk(const struct desk_input *before, const struct desk_input *desk,
                          uint8_t *out)
{
    uint8_t old[DESK_BYTES], new[DESK_BYTES];
    uint32_t mask = 0;
    size_t size = 2;
    list_desk(before, old);
    list_desk(desk, new);
    for (unsigned i = 0; i < DESK_BYTES; i++) {
        if (new[i] != old[i]) {
            mask |= 1u << i;
            out[size++] = new[i];
        }
    }
    put_u16((uint16_t)mask, out);
    return mask ? size : 0;
}

size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out)
{
    const int held = input->held != before->held;
    const int pressed = input->pressed != 0;
    const int coins = coin_pulses(input) != 0;
    const uint32_t mask =
        (held ? HAS_HELD : 0u) | (pressed ? HAS_PRESSED : 0u) | (coins ? HAS_COINS : 0u);
    size_t size = 1;
    size += put_if(held, input->held, out + size);
    size += put_if(pressed, input->pressed, out + size);
    for (unsigned i = 0; i < COIN_LINE_COUNT; i++) {
        size += put_if(coins, input->coin_count[i], out + size);
    }
    const size_t machine_size = encode_machine(before, input, out + size);
    size += machine_size;
    const size_t desk_size = encode_desk(&before->desk, &input->desk, out + size);
    size += desk_size;
    const size_t hands_size = encode_hands(before, input, out + size);
    out[0] = (uint8_t)(mask | (machine_size > 0 ? HAS_MACHINE : 0u) |
                       (desk_size > 0 ? HAS_DESK : 0u) | (hands_size > 0 ? HAS_HANDS : 0u));
    return size + hands_size;
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

static uint16_t take_u16(struct bytes_left *left)
{
    const uint32_t low = take_u8(left), high = take_u8(left);
    return (uint16_t)(low | high << 8);
}

/* Changes what the mask names; the rest stays. */
static void decode_held(struct held *held, uint8_t byte_max, struct bytes_left *left)
{
    const uint8_t mask = take_u8(left);
    const uint32_t known = (2u << held->float_count) - 1u;
    left->bad |= mask == 0 || (mask & ~(known | (held->has_age ? (uint32_t)POI_HAS_AGE : 0u))) != 0;
    if (mask & HELD_HAS_BYTE) {
        held->byte = take_u8(left);
        left->bad |= held->byte > byte_max;
    }
    for (unsigned i = 0; i < held->float_count; i++) {
        if (mask & (uint32_t)HELD_HAS_FLOAT << i) {
            held->bits[i] = take_u32(left);
        }
    }
    if (mask & POI_HAS_AGE) {
        held->age = take_u16(left);
    }
}

static void decode_poi(struct poi_input *poi, struct bytes_left *left)
{
    struct held held = poi_held(poi);
    decode_held(&held, LINK_ALL, left);
    poi->link = held.byte & 3u;
    poi->has_wrist = (held.byte & LINK_WRIST) != 0;
    poi->trembles = (held.byte & LINK_TREMBLES) != 0;
    poi->age_ticks = held.age;
    memcpy(&poi->target, held.bits, sizeof poi->target);
}

static void decode_shade(struct shade_input *shade, struct bytes_left *left)
{
    float floats[SHADE_FLOATS];
    struct held held = shade_held(shade);
    decode_held(&held, 1, left);
    memcpy(floats, held.bits, sizeof floats);
    for (unsigned i = 0; i < SHADE_FLOATS; i++) {
        left->bad |= !f_is_finite(floats[i]);
    }
    *shade = (struct shade_input){ held.byte, floats[0], floats[1], floats[2] };
}

static void decode_hands(struct input *input, struct bytes_left *left)
{
    const uint8_t mask = take_u8(left);
    left->bad |= mask == 0;
    for (unsigned i = 0; i < POI_MAX; i++) {
        if (mask & (uint32_t)HANDS_POI << i) {
            decode_poi(&input->poi[i], left);
        }
    }
    for (unsigned i = 0; i < SHADE_MAX; i++) {
        if (mask & (uint32_t)HANDS_SHADE << i) {
            decode_shade(&input->shade[i], left);
        }
    }
}

static void decode_levels(struct input *input, struct bytes_left *left)
{
    const uint8_t levels = take_u8(left);
    left->bad |= levels > LEVEL_ALL || levels == levels_of(input);
    input->upright = (levels & LEVEL_UPRIGHT) != 0;
    input->edit_refused = (levels & LEVEL_REFUSED) != 0;
    input->store_well = (levels & LEVEL_WELL) != 0;
}

static void decode_machine(struct input *input, struct bytes_left *left)
{
    const uint8_t mask = take_u8(left);
    left->bad |= mask == 0 || mask > MACHINE_ALL;
    if (mask & MACHINE_SAVED_ID) {
        input->record_saved_id = take_u32(left);
    }
    if (mask & MACHINE_EDIT_ID) {
        input->edit_saved_id = take_u32(left);
    }
    if (mask & MACHINE_LEVELS) {
        decode_levels(input, left);
    }
    if (mask & MACHINE_DAY) {
        input->day = take_u16(left);
    }
    if (mask & MACHINE_MINUTE) {
        input->minute = take_u16(left);
        left->bad |= input->minute >= 24u * 60u;
    }
    if (mask & MACHINE_DROPPED) {
        input->dropped_ticks = take_u32(left);
    }
    if (mask & MACHINE_FAULTS) {
        input->device_faults = take_u32(left);
    }
}

static void decode_desk(struct desk_input *desk, struct bytes_left *left)
{
    uint8_t bytes[DESK_BYTES];
    const uint32_t mask = take_u16(left);
    list_desk(desk, bytes);
    left->bad |= mask == 0 || mask >> DESK_BYTES != 0;
    for (unsigned i = 0; i < DESK_BYTES; i++) {
        bytes[i] = mask >> i & 1u ? take_u8(left) : bytes[i];
        left->bad |= i < CONTROLLER_MAX && bytes[i] >= CONTROLLER_STATE_COUNT;
    }
    left->bad |= bytes[DESK_STEP] >= LEARN_STEP_COUNT || bytes[DESK_ROW] >= CONTROLLER_MAX;
    memcpy(desk->state, bytes, CONTROLLER_MAX);
    desk->learn_step = bytes[DESK_STEP];
    desk->learn_row = bytes[DESK_ROW];
    desk->learn_progress = bytes[DESK_PROGRESS];
    desk->file_count = bytes[DESK_FILES];
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
    for (unsigned i = 0; i < COIN_LINE_COUNT; i++) {
        next.coin_count[i] = mask & HAS_COINS ? take_u32(&left) : 0;
    }
    if (mask & HAS_MACHINE) {
        decode_machine(&next, &left);
    }
    if (mask & HAS_DESK) {
        decode_desk(&next.desk, &left);
    }
    if (mask & HAS_HANDS) {
        decode_hands(&next, &left);
    }
    left.bad |= mask > HAS_ALL || (next.held | next.pressed) > INPUT_BUTTON_ALL;
    if (left.bad) {
        return 0;
    }
    *input = next;
    return (size_t)(left.at - bytes);
}

int replay_totals_agree(const struct replay_totals *a, const struct replay_totals *b)
{
    return a->rounds == b->rounds && a->caught == b->caught && a->fouls == b->fouls &&
           a->modes == b->modes && a->players == b->players;
}
