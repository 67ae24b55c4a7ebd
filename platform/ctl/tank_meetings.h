/* tank_meetings.h -- counts the encounters of a tank by watching its fish.
 *
 * No fish knows these figures, so they are no part of the core's state. */
#ifndef KINGYO_PLATFORM_CTL_TANK_MEETINGS_H
#define KINGYO_PLATFORM_CTL_TANK_MEETINGS_H

#include "core/tank/tank.h"

#define MEETINGS_OPEN_MAX (8u * TANK_FISH_MAX) /* At the thesis' density 1.4 a fish overlap. */
#define MEETINGS_LOOK_TICKS 4u /* At least, from one look at the open pairs to the next. */
#define MEETINGS_PART_TICKS 60u /* Spaces that overlap again within half a second never parted. */

/* Two fish that met and have not parted. */
struct meeting {
    fish_index low, high;
    uint32_t apart_ticks; /* Since their personal spaces overlapped. */
    uint32_t older;       /* The next older open pair with the same `low`: index + 1, 0: no pair. */
};

struct meetings {
    /* Onsets. A pair counts once until it has parted, however often either gives way meanwhile. */
    uint64_t head_on, side, rear_end;
    /* Onsets, too, but of each fish's own turns (the trace's yaw) and climbs (pitch). */
    uint64_t by_yaw, by_pitch;

    uint32_t unlooked_ticks; /* Since open pairs were last tried for having parted. */
    uint32_t open_count;
    uint32_t newest[TANK_FISH_MAX]; /* The newest open pair with this fish as `low`: index + 1, 0:
                                       no pair. */
    struct meeting open[MEETINGS_OPEN_MAX];
    uint8_t avoided[TANK_FISH_MAX]; /* enum fish_avoiding of the tick before. */
};

/* Counts the encounters that began since the last call, which was `ticks` ticks ago. All zeros is a
 * fresh count. */
void meetings_watch(struct meetings *meetings, const struct tank *tank, uint32_t ticks);

#endif
