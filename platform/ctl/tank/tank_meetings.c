/* tank_meetings.c -- detects when two fish begin to avoid each other, and when the two fish have
 * separated. */
#include "platform/ctl/tank/tank_meetings.h"

#include <string.h>

static int overlap(const struct tank *tank, const struct tank_meeting *pair)
{
    struct box spaces[2];
    for (uint32_t i = 0; i < 2; i++) {
        const struct fish *fish = &tank->fish[i == 0 ? pair->low : pair->high];
        const float margin_m = tank->space * fish->length_m;
        spaces[i] = fish_box(fish);
        spaces[i].half_m = v3_add(spaces[i].half_m, v3(margin_m, margin_m, margin_m));
    }
    return box_depth_m(&spaces[0], &spaces[1]) > 0.0f;
}

/* Appends a pair to the list of open pairs, and links the pair to the older pairs with the same
 * `low`. */
static void open_pair(struct tank_meetings *meetings, const struct tank_meeting *pair)
{
    struct tank_meeting *added = &meetings->open[meetings->open_count++];
    *added = *pair;
    added->older = meetings->newest[pair->low];
    meetings->newest[pair->low] = meetings->open_count;
}

static void forget_the_parted(struct tank_meetings *meetings, const struct tank *tank,
                              uint32_t ticks)
{
    const uint32_t count = meetings->open_count;
    meetings->open_count = 0;
    memset(meetings->newest, 0, tank->fish_count * sizeof meetings->newest[0]);
    for (uint32_t i = 0; i < count; i++) {
        struct tank_meeting pair = meetings->open[i];
        pair.apart_ticks = overlap(tank, &pair) ? 0 : pair.apart_ticks + ticks;
        if (pair.apart_ticks < TANK_MEETINGS_PART_TICKS) {
            /* open_pair() writes at or before index `i`, and the entry at `i` has already been
             * read. */
            open_pair(meetings, &pair);
        }
    }
}

static int is_open(const struct tank_meetings *meetings, const struct tank_meeting *pair)
{
    for (uint32_t at = meetings->newest[pair->low]; at > 0; at = meetings->open[at - 1].older) {
        if (meetings->open[at - 1].high == pair->high) {
            return 1;
        }
    }
    return 0;
}

static void tank_meetings_begin(struct tank_meetings *meetings, const struct fish *fish,
                                fish_index index)
{
    const fish_index with = fish->avoid_with;
    const struct tank_meeting pair = { index < with ? index : with, index < with ? with : index, 0,
                                       0 };
    if (is_open(meetings, &pair)) {
        return;
    }
    if (meetings->open_count < TANK_MEETINGS_OPEN_MAX) {
        open_pair(meetings, &pair);
    }
    meetings->head_on += fish->avoid_kind == MEET_HEAD_ON ? 1u : 0u;
    meetings->side += fish->avoid_kind == MEET_SIDE || fish->avoid_kind == MEET_STRUCK ? 1u : 0u;
    meetings->rear_end += fish->avoid_kind == MEET_REAR_END ? 1u : 0u;
}

void tank_meetings_update(struct tank_meetings *meetings, const struct tank *tank, uint32_t ticks)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        if (fish->avoiding != meetings->avoided[i]) {
            if (fish->avoiding == AVOID_YAW) {
                meetings->by_yaw++;
                tank_meetings_begin(meetings, fish, (fish_index)i);
            }
            meetings->by_pitch += fish->avoiding == AVOID_PITCH ? 1u : 0u;
            meetings->avoided[i] = fish->avoiding;
        }
    }
    meetings->unlooked_ticks += ticks;
    if (meetings->unlooked_ticks >= TANK_MEETINGS_LOOK_TICKS) {
        forget_the_parted(meetings, tank, meetings->unlooked_ticks);
        meetings->unlooked_ticks = 0;
    }
}
