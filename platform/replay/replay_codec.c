/* replay_codec.c -- encodes one input as the difference from the previous input.
 *
 * The first byte is a mask. Each bit states whether one of these parts follows: held buttons,
 * pressed buttons, coins, machine state, controllers, poses. Held buttons, pressed buttons and the
 * coins of each line are u32.
 *
 * The machine state is a mask, followed by the values that changed. The id of the saved ledger
 * entry and the id of the saved edit are u32. One byte has the level bits: portrait screen, store
 * rejects edits, store healthy. Day and minute are u16. Dropped ticks, faults and completed tickets
 * are u32.
 *
 * The controllers are a u16 mask and the bytes that changed. The bytes are the state of each
 * controller, then the step, row and progress of the learn wizard, then the number of files.
 * replay_pose_delta.c encodes the poses. */
#include "platform/replay/replay.h"

#include <string.h>

#include "platform/replay/replay_bytes.h"

enum {
    HAS_HELD = 1u << 0,
    HAS_PRESSED = 1u << 1, /* Presses and coins are stored as values, not as differences. If the bit
                              is 0, the tick has no presses (HAS_PRESSED) or no coins. */
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
    MACHINE_TICKETS = 1u << 7, /* This bit exists only in format 8 and later. */
};

enum {
    LEVEL_UPRIGHT = 1u << 0,
    LEVEL_REFUSED = 1u << 1,
    LEVEL_WELL = 1u << 2,
    LEVEL_ALL = 7u,
};

enum {
    DESK_STEP = CONTROLLER_MAX, /* Index of the learn wizard's step, after one state byte for each
                                   controller. */
    DESK_ROW,
    DESK_PROGRESS,
    DESK_FILES,
    DESK_BYTES,
};
_Static_assert(DESK_BYTES == REPLAY_DESK_BYTES && DESK_BYTES <= 16, "each has its bit in a u16");
_Static_assert(sizeof(struct controller_status) == DESK_BYTES, "the desk's bytes are all of it");

/* ---- Encoding ------------------------------------------------------------------------------ */

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
           (levels ? MACHINE_LEVELS : 0u) | (input->day != before->day ? MACHINE_DAY : 0u) |
           (input->minute != before->minute ? MACHINE_MINUTE : 0u) |
           (dropped ? MACHINE_DROPPED : 0u) | (faults ? MACHINE_FAULTS : 0u) |
           (input->tickets_done != before->tickets_done ? MACHINE_TICKETS : 0u);
}

/* Writes the changed machine state. Returns the number of bytes, or 0 if nothing changed. */
static size_t encode_machine(const struct input *before, const struct input *input, uint8_t *out)
{
    const uint32_t mask = machine_mask(before, input);
    size_t size = 1;
    out[0] = (uint8_t)mask;
    size += replay_put_optional((mask & MACHINE_SAVED_ID) != 0, input->record_saved_id, out + size);
    size += replay_put_optional((mask & MACHINE_EDIT_ID) != 0, input->edit_saved_id, out + size);
    if (mask & MACHINE_LEVELS) {
        out[size++] = levels_of(input);
    }
    if (mask & MACHINE_DAY) {
        size += replay_put_u16(input->day, out + size);
    }
    if (mask & MACHINE_MINUTE) {
        size += replay_put_u16(input->minute, out + size);
    }
    size += replay_put_optional((mask & MACHINE_DROPPED) != 0, input->dropped_ticks, out + size);
    size += replay_put_optional((mask & MACHINE_FAULTS) != 0, input->device_faults, out + size);
    size += replay_put_optional((mask & MACHINE_TICKETS) != 0, input->tickets_done, out + size);
    return mask ? size : 0;
}

static void list_desk(const struct controller_status *desk, uint8_t out[DESK_BYTES])
{
    memcpy(out, desk->state, CONTROLLER_MAX);
    out[DESK_STEP] = desk->learn_step;
    out[DESK_ROW] = desk->learn_row;
    out[DESK_PROGRESS] = desk->learn_progress;
    out[DESK_FILES] = desk->file_count;
}

/* Writes the changed controller bytes. Returns the number of bytes, or 0 if nothing changed. */
static size_t encode_desk(const struct controller_status *before,
                          const struct controller_status *desk, uint8_t *out)
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
    replay_put_u16((uint16_t)mask, out);
    return mask ? size : 0;
}

size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out)
{
    const int held = input->held != before->held;
    const int pressed = input->pressed != 0;
    const int coins = input_coin_pulses(input) != 0;
    const uint32_t mask =
        (held ? HAS_HELD : 0u) | (pressed ? HAS_PRESSED : 0u) | (coins ? HAS_COINS : 0u);
    size_t size = 1;
    size += replay_put_optional(held, input->held, out + size);
    size += replay_put_optional(pressed, input->pressed, out + size);
    for (unsigned i = 0; i < COIN_LINE_COUNT; i++) {
        size += replay_put_optional(coins, input->coin_count[i], out + size);
    }
    const size_t machine_size = encode_machine(before, input, out + size);
    size += machine_size;
    const size_t desk_size = encode_desk(&before->controllers, &input->controllers, out + size);
    size += desk_size;
    const size_t hands_size = replay_pose_delta_encode(before, input, out + size);
    out[0] = (uint8_t)(mask | (machine_size > 0 ? HAS_MACHINE : 0u) |
                       (desk_size > 0 ? HAS_DESK : 0u) | (hands_size > 0 ? HAS_HANDS : 0u));
    return size + hands_size;
}

/* ---- Decoding ------------------------------------------------------------------------------ */

static void decode_levels(struct input *input, struct replay_rest *rest)
{
    const uint8_t levels = replay_take_u8(rest);
    rest->bad |= levels > LEVEL_ALL || levels == levels_of(input);
    input->upright = (levels & LEVEL_UPRIGHT) != 0;
    input->edit_refused = (levels & LEVEL_REFUSED) != 0;
    input->store_well = (levels & LEVEL_WELL) != 0;
}

static void decode_machine(struct input *input, struct replay_rest *rest)
{
    const uint8_t mask = replay_take_u8(rest);
    rest->bad |= mask == 0;
    if (mask & MACHINE_SAVED_ID) {
        input->record_saved_id = replay_take_u32(rest);
    }
    if (mask & MACHINE_EDIT_ID) {
        input->edit_saved_id = replay_take_u32(rest);
    }
    if (mask & MACHINE_LEVELS) {
        decode_levels(input, rest);
    }
    if (mask & MACHINE_DAY) {
        input->day = replay_take_u16(rest);
    }
    if (mask & MACHINE_MINUTE) {
        input->minute = replay_take_u16(rest);
        rest->bad |= input->minute >= 24u * 60u;
    }
    if (mask & MACHINE_DROPPED) {
        input->dropped_ticks = replay_take_u32(rest);
    }
    if (mask & MACHINE_FAULTS) {
        input->device_faults = replay_take_u32(rest);
    }
    if (mask & MACHINE_TICKETS) {
        input->tickets_done = replay_take_u32(rest);
    }
}

static void decode_desk(struct controller_status *desk, struct replay_rest *rest)
{
    uint8_t bytes[DESK_BYTES];
    const uint32_t mask = replay_take_u16(rest);
    list_desk(desk, bytes);
    rest->bad |= mask == 0 || mask >> DESK_BYTES != 0;
    for (unsigned i = 0; i < DESK_BYTES; i++) {
        bytes[i] = mask >> i & 1u ? replay_take_u8(rest) : bytes[i];
        rest->bad |= i < CONTROLLER_MAX && bytes[i] >= CONTROLLER_STATE_COUNT;
    }
    rest->bad |= bytes[DESK_STEP] >= LEARN_STEP_COUNT || bytes[DESK_ROW] >= CONTROLLER_MAX;
    memcpy(desk->state, bytes, CONTROLLER_MAX);
    desk->learn_step = bytes[DESK_STEP];
    desk->learn_row = bytes[DESK_ROW];
    desk->learn_progress = bytes[DESK_PROGRESS];
    desk->file_count = bytes[DESK_FILES];
}

size_t replay_decode_input(struct input *input, const uint8_t *bytes, size_t size)
{
    return replay_decode_as_is(input, bytes, size, 0);
}

size_t replay_decode_as_is(struct input *input, const uint8_t *bytes, size_t size, int as_is)
{
    struct replay_rest rest = { .at = bytes, .size = size, .as_is = as_is };
    struct input next = *input;
    const uint8_t mask = replay_take_u8(&rest);
    if (mask & HAS_HELD) {
        next.held = replay_take_u32(&rest);
    }
    next.pressed = mask & HAS_PRESSED ? replay_take_u32(&rest) : 0;
    for (unsigned i = 0; i < COIN_LINE_COUNT; i++) {
        next.coin_count[i] = mask & HAS_COINS ? replay_take_u32(&rest) : 0;
    }
    if (mask & HAS_MACHINE) {
        decode_machine(&next, &rest);
    }
    if (mask & HAS_DESK) {
        decode_desk(&next.controllers, &rest);
    }
    if (mask & HAS_HANDS) {
        replay_pose_delta_decode(&next, &rest);
    }
    rest.bad |= mask > HAS_ALL || (next.held | next.pressed) > INPUT_BUTTON_ALL;
    if (rest.bad) {
        return 0;
    }
    *input = next;
    return (size_t)(rest.at - bytes);
}

int replay_totals_agree(const struct replay_totals *a, const struct replay_totals *b)
{
    return a->rounds == b->rounds && a->caught == b->caught && a->fouls == b->fouls &&
           a->modes == b->modes && a->players == b->players;
}
