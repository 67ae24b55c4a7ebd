/* replay_codec.c -- encodes and decodes one input as the difference from the previous input. One
 * list of fields serves both directions.
 *
 * A group of fields consists of a mask and the changed fields. Each bit of the mask states whether
 * one field follows the mask. The fields have the order of the bits.
 *
 * The encoded input starts with a mask of one byte. The bits of this mask state which of the
 * following parts are present:
 *
 *   held buttons     u32
 *   pressed buttons  u32, the buttons of this tick and not a difference
 *   coins            u32 for each coin line, the coins of this tick and not a difference
 *   machine state    a group of the fields below
 *   controllers      a group of bytes with a u16 mask: the state of each controller, the step, row
 *                    and progress of the learn wizard, and the number of files
 *   poses            a byte with one bit for each changed poi (low half) and fan (high half), then
 *                    one group for each changed poi or fan
 *
 * The fields of the machine state are the id of the saved ledger entry (u32), the id of the saved
 * edit (u32), a byte of flags (portrait screen, store rejects edits, store healthy), the day (u16),
 * the minute (u16), and the numbers of dropped ticks, faults and completed tickets (u32 each).
 *
 * The group of a pose consists of a status byte, the floats of the pose and, for a poi, the age of
 * the newest report (u16). The status byte of a poi contains struct poi_input's link, has_wrist,
 * trembles and has_gap. The status byte of a fan states whether the fan is present. Floats are
 * stored with all their bits, because a replay must be identical even for invalid poses. */
#include <string.h>

#include "core/base/panic.h"
#include "platform/replay/replay.h"
#include "platform/replay/replay_format.h"

enum {
    HAS_HELD = 1u << 0,
    /* Mask bit of the pressed buttons. If this bit is 0, no button was pressed in the tick.
     * Likewise, if HAS_COINS is 0, no coin was inserted in the tick. */
    HAS_PRESSED = 1u << 1,
    HAS_COINS = 1u << 2,
    HAS_MACHINE = 1u << 3,
    HAS_HANDS = 1u << 4,
    HAS_CONTROLLERS = 1u << 5,
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
    MACHINE_TICKETS = 1u << 7, /* Mask bit of the number of completed tickets. The bit exists only
                                  in format 8 and later. */
};

enum {
    LEVEL_UPRIGHT = 1u << 0,
    LEVEL_REFUSED = 1u << 1,
    LEVEL_WELL = 1u << 2,
    LEVEL_TURNED = 1u << 3,
    LEVEL_ALL = 15u,
};

enum {
    /* Index of the learn wizard's step in the bytes of struct controller_status. The struct
     * begins with one state byte for each controller. */
    CONTROLLERS_STEP = CONTROLLER_MAX,
    CONTROLLERS_ROW,
    CONTROLLERS_PROGRESS,
    CONTROLLERS_FILES,
    /* The update state was added to format 10, whose older files have no such bit in the mask. */
    CONTROLLERS_UPDATE,
    CONTROLLERS_BYTES,
};
_Static_assert(CONTROLLERS_BYTES == REPLAY_CONTROLLERS_BYTES && CONTROLLERS_BYTES <= 16,
               "each has its bit in a u16");
_Static_assert(sizeof(struct controller_status) == CONTROLLERS_BYTES,
               "the group has every byte of the struct");
_Static_assert(offsetof(struct controller_status, learn_step) == CONTROLLERS_STEP &&
                   offsetof(struct controller_status, learn_row) == CONTROLLERS_ROW,
               "the bytes have the order of the struct");

enum {
    POSE_HAS_BYTE = 1u << 0,
    POSE_HAS_FLOAT = 1u << 1, /* Mask bit of a pose's first float. The bits of the other floats
                                 follow. */
    POI_FLOATS = 6,
    SHADE_FLOATS = 3,
    POI_HAS_AGE = 1u << 7, /* Mask bit of poi_input.age_ticks, the age of the newest report. The
                              lower bits are the mask bits of the status byte and of the six
                              floats. */
    LINK_WRIST = 1u << 2,  /* Bit of poi_input.has_wrist (the controller measures angles) in a poi's
                              status byte. Bits 0 and 1 of the status byte contain poi_input.link,
                              the source of the pose. */
    LINK_TREMBLES = 1u << 3,
    LINK_GAP = 1u << 4, /* Bit of poi_input.has_gap: the controller's motion since the last tick was
                           not observed. Older recordings never set this bit. */
    LINK_ALL = 31u,
};
_Static_assert(sizeof(struct poi_target) == POI_FLOATS * sizeof(float), "a target is six floats");
_Static_assert(POI_MAX + SHADE_MAX <= 8, "all that hands hold has its bit in one byte");

/* ---- Groups: a mask and the changed fields --------------------------------------------------- */

/* State of writing or reading a group, which is a mask and the fields that changed. */
struct group {
    struct replay_serializer *walk;
    size_t at;     /* Position of the group's mask in the buffer, in bytes. */
    uint16_t mask; /* Mask of the group. Each bit states whether a field follows the mask. */
    bool is_wide;  /* True if the mask is a u16, false if the mask is a byte. */
};

static void serialize_mask(struct group *group)
{
    uint8_t low = (uint8_t)group->mask;
    if (group->is_wide) {
        replay_serialize_u16(group->walk, &group->mask);
    } else {
        replay_serialize_u8(group->walk, &low);
        group->mask = low;
    }
}

/* Starts a group. A reader reads the group's mask, and a writer reserves the bytes of the mask. */
static struct group group_begin(struct replay_serializer *walk, bool is_wide)
{
    struct group group = { .walk = walk, .at = walk->at, .is_wide = is_wide };
    serialize_mask(&group);
    return group;
}

/* Returns true if the field with the mask bit `bit` must be serialized. A writer serializes the
 * field if `has_changed` is true, and sets the bit. A reader serializes the field if the bit is
 * set. */
static bool group_has(struct group *group, uint32_t bit, bool has_changed)
{
    CORE_ASSERT(bit != 0 && bit <= (group->is_wide ? 0x8000u : 0x80u));
    if (group->walk->out && has_changed) {
        group->mask |= (uint16_t)bit;
    }
    return (group->mask & bit) != 0;
}

static void group_u8(struct group *group, uint32_t bit, uint8_t before, uint8_t *value)
{
    if (group_has(group, bit, *value != before)) {
        replay_serialize_u8(group->walk, value);
    }
}

static void group_u16(struct group *group, uint32_t bit, uint16_t before, uint16_t *value)
{
    if (group_has(group, bit, *value != before)) {
        replay_serialize_u16(group->walk, value);
    }
}

static void group_u32(struct group *group, uint32_t bit, uint32_t before, uint32_t *value)
{
    if (group_has(group, bit, *value != before)) {
        replay_serialize_u32(group->walk, value);
    }
}

/* Ends a group. A writer writes the mask to its reserved bytes, or removes the group if no field
 * was written. A reader rejects a mask of 0 and a mask with bits that are not in `known`. Returns
 * true if the group has at least one field. */
static bool group_end(struct group *group, uint32_t known)
{
    struct replay_serializer *walk = group->walk;
    CORE_ASSERT(!walk->out || (group->mask & ~known) == 0);
    if (!walk->out) {
        walk->bad |= group->mask == 0 || (group->mask & ~known) != 0;
    } else if (group->mask == 0) {
        walk->at = group->at;
    } else {
        const size_t end = walk->at;
        walk->at = group->at;
        serialize_mask(group);
        walk->at = end;
    }
    return group->mask != 0;
}

/* ---- Machine state and controllers ----------------------------------------------------------- */

static uint8_t levels_of(const struct input *input)
{
    return (uint8_t)((input->upright ? LEVEL_UPRIGHT : 0u) |
                     (input->edit_refused ? LEVEL_REFUSED : 0u) |
                     (input->store_well ? LEVEL_WELL : 0u) |
                     (input->is_turned ? LEVEL_TURNED : 0u));
}

static bool walk_machine(struct replay_serializer *walk, const struct input *before,
                         struct input *input)
{
    struct group group = group_begin(walk, false);
    const uint8_t old = levels_of(before);
    uint8_t levels = levels_of(input);
    group_u32(&group, MACHINE_SAVED_ID, before->record_saved_id, &input->record_saved_id);
    group_u32(&group, MACHINE_EDIT_ID, before->edit_saved_id, &input->edit_saved_id);
    group_u8(&group, MACHINE_LEVELS, old, &levels);
    group_u16(&group, MACHINE_DAY, before->day, &input->day);
    group_u16(&group, MACHINE_MINUTE, before->minute, &input->minute);
    group_u32(&group, MACHINE_DROPPED, before->dropped_ticks, &input->dropped_ticks);
    group_u32(&group, MACHINE_FAULTS, before->device_faults, &input->device_faults);
    group_u32(&group, MACHINE_TICKETS, before->tickets_done, &input->tickets_done);
    if (group.mask & MACHINE_LEVELS) {
        walk->bad |= levels > LEVEL_ALL || levels == old;
        input->upright = (levels & LEVEL_UPRIGHT) != 0;
        input->edit_refused = (levels & LEVEL_REFUSED) != 0;
        input->store_well = (levels & LEVEL_WELL) != 0;
        input->is_turned = (levels & LEVEL_TURNED) != 0;
    }
    walk->bad |= (group.mask & MACHINE_MINUTE) && input->minute >= 24u * 60u && !walk->out;
    return group_end(&group, 0xffu);
}

static bool walk_controllers(struct replay_serializer *walk, const struct input *before,
                             struct input *input)
{
    /* struct controller_status consists of bytes only. Bit i of the group's mask belongs to byte i
     * of the struct. */
    const uint8_t *old = (const uint8_t *)&before->controllers;
    uint8_t *bytes = (uint8_t *)&input->controllers;
    struct group group = group_begin(walk, true);
    for (unsigned i = 0; i < CONTROLLERS_BYTES; i++) {
        group_u8(&group, 1u << i, old[i], &bytes[i]);
        walk->bad |= !walk->out && i < CONTROLLER_MAX && bytes[i] >= CONTROLLER_STATE_COUNT;
    }
    walk->bad |= !walk->out && (bytes[CONTROLLERS_STEP] >= LEARN_STEP_COUNT ||
                                bytes[CONTROLLERS_ROW] >= CONTROLLER_MAX ||
                                bytes[CONTROLLERS_UPDATE] >= UPDATE_STATE_COUNT);
    return group_end(&group, (1u << CONTROLLERS_BYTES) - 1u);
}

/* ---- Poses ----------------------------------------------------------------------------------- */

/* Stored form of the pose of a poi or a hand-held fan: a status byte, floats and an age. */
struct stored_pose {
    uint8_t byte;
    bool has_age; /* True for a poi. A hand-held fan has no age. */
    uint16_t age;
    uint32_t float_count;
    uint32_t bits[POI_FLOATS];
};

static bool walk_stored(struct replay_serializer *walk, const struct stored_pose *before,
                        struct stored_pose *pose, uint8_t byte_max)
{
    CORE_ASSERT(pose->float_count <= POI_FLOATS);
    struct group group = group_begin(walk, false);
    group_u8(&group, POSE_HAS_BYTE, before->byte, &pose->byte);
    walk->bad |= (group.mask & POSE_HAS_BYTE) && pose->byte > byte_max && !walk->out;
    for (unsigned i = 0; i < pose->float_count; i++) {
        group_u32(&group, (uint32_t)POSE_HAS_FLOAT << i, before->bits[i], &pose->bits[i]);
    }
    group_u16(&group, POI_HAS_AGE, before->age, &pose->age);
    return group_end(&group, ((2u << pose->float_count) - 1u) |
                                 (pose->has_age ? (uint32_t)POI_HAS_AGE : 0u));
}

static struct stored_pose stored_poi(const struct poi_input *poi)
{
    const uint32_t byte = poi->link | (poi->has_wrist ? (uint32_t)LINK_WRIST : 0u) |
                          (poi->trembles ? (uint32_t)LINK_TREMBLES : 0u) |
                          (poi->has_gap ? (uint32_t)LINK_GAP : 0u);
    struct stored_pose pose = {
        .byte = (uint8_t)byte, .has_age = true, .age = poi->age_ticks, .float_count = POI_FLOATS
    };
    memcpy(pose.bits, &poi->target, sizeof poi->target);
    return pose;
}

static bool walk_poi(struct replay_serializer *walk, const struct poi_input *before,
                     struct poi_input *poi)
{
    const struct stored_pose old = stored_poi(before);
    struct stored_pose pose = stored_poi(poi);
    const bool has_changed = walk_stored(walk, &old, &pose, LINK_ALL);
    if (!walk->out) {
        poi->link = pose.byte & 3u;
        poi->has_wrist = (pose.byte & LINK_WRIST) != 0;
        poi->trembles = (pose.byte & LINK_TREMBLES) != 0;
        poi->has_gap = (pose.byte & LINK_GAP) != 0;
        poi->age_ticks = pose.age;
        memcpy(&poi->target, pose.bits, sizeof poi->target);
    }
    return has_changed;
}

static struct stored_pose stored_shade(const struct shade_input *shade)
{
    const float floats[SHADE_FLOATS] = { shade->x_m, shade->z_m, shade->radius_m };
    struct stored_pose pose = { .byte = shade->present != 0, .float_count = SHADE_FLOATS };
    memcpy(pose.bits, floats, sizeof floats);
    return pose;
}

static bool walk_shade(struct replay_serializer *walk, const struct shade_input *before,
                       struct shade_input *shade)
{
    const struct stored_pose old = stored_shade(before);
    struct stored_pose pose = stored_shade(shade);
    const bool has_changed = walk_stored(walk, &old, &pose, 1);
    if (!walk->out) {
        float floats[SHADE_FLOATS];
        memcpy(floats, pose.bits, sizeof floats);
        for (unsigned i = 0; i < SHADE_FLOATS; i++) {
            walk->bad |= !f_is_finite(floats[i]) && !walk->as_is;
        }
        *shade = (struct shade_input){ pose.byte, floats[0], floats[1], floats[2] };
    }
    return has_changed;
}

/* Serializes the poses. The group's mask has one bit for each poi and fan: bit i is poi i, and bit
 * POI_MAX + i is fan i. */
static bool walk_poses(struct replay_serializer *walk, const struct input *before,
                       struct input *input)
{
    struct group group = group_begin(walk, false);
    for (unsigned i = 0; i < POI_MAX + SHADE_MAX; i++) {
        const uint32_t bit = 1u << i;
        if (walk->out || group_has(&group, bit, false)) {
            const bool has_changed = i < POI_MAX ? walk_poi(walk, &before->poi[i], &input->poi[i])
                                                 : walk_shade(walk, &before->shade[i - POI_MAX],
                                                              &input->shade[i - POI_MAX]);
            group_has(&group, bit, has_changed);
        }
    }
    return group_end(&group, 0xffu);
}

/* ---- One input ------------------------------------------------------------------------------- */

/* Writes `input` as the difference from `before`, or reads such a difference into `input`. To read,
 * the caller passes the previous input as `input` and as `before`. */
static void walk_input(struct replay_serializer *walk, const struct input *before,
                       struct input *input)
{
    static const struct {
        uint32_t bit;
        bool (*serialize)(struct replay_serializer *walk, const struct input *before,
                          struct input *input);
    } parts[] = {
        { HAS_MACHINE, walk_machine },
        { HAS_CONTROLLERS, walk_controllers },
        { HAS_HANDS, walk_poses },
    };
    struct group group = group_begin(walk, false);
    group_u32(&group, HAS_HELD, before->held, &input->held);
    if (!walk->out) {
        input->pressed = 0;
        memset(input->coin_count, 0, sizeof input->coin_count);
    }
    group_u32(&group, HAS_PRESSED, 0, &input->pressed);
    if (group_has(&group, HAS_COINS, input_coin_pulses(input) != 0)) {
        for (unsigned i = 0; i < COIN_LINE_COUNT; i++) {
            replay_serialize_u32(walk, &input->coin_count[i]);
        }
    }
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        if (walk->out || group_has(&group, parts[i].bit, false)) {
            group_has(&group, parts[i].bit, parts[i].serialize(walk, before, input));
        }
    }
    if (walk->out) {
        walk->out[group.at] = (uint8_t)group.mask; /* A tick without any change is stored as one
                                                      byte: the mask of the input, which is 0. */
    } else {
        walk->bad |= group.mask > HAS_ALL || (input->held | input->pressed) > INPUT_BUTTON_ALL;
    }
}

size_t replay_encode_input(const struct input *before, const struct input *input, uint8_t *out)
{
    /* The serializer needs a non-const pointer because it also reads. Therefore a copy of the input
     * is serialized. */
    struct input copy = *input;
    struct replay_serializer walk = { .out = out, .size = REPLAY_TICK_SIZE_MAX - 4u };
    walk_input(&walk, before, &copy);
    CORE_ASSERT(!walk.bad);
    return walk.at;
}

size_t replay_decode_input(struct input *input, const uint8_t *bytes, size_t size, bool as_is)
{
    struct replay_serializer walk = { .in = bytes, .size = size, .as_is = as_is };
    struct input next = *input;
    walk_input(&walk, input, &next);
    if (walk.bad) {
        return 0;
    }
    *input = next;
    return walk.at;
}

bool replay_totals_agree(const struct replay_totals *a, const struct replay_totals *b)
{
    return a->rounds == b->rounds && a->caught == b->caught && a->fouls == b->fouls &&
           a->modes == b->modes && a->players == b->players;
}
