/* tank_meetings.h -- counts the encounters in a tank from the state of its fish.
 *
 * The simulation itself does not use these counts, so they are not part of the core's state. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_MEETINGS_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_MEETINGS_H

#include "core/tank/tank.h"

/* Maximum number of open pairs. At the density of the thesis, 1.4 personal spaces overlap for each
 * fish. */
#define TANK_MEETINGS_OPEN_MAX (8u * TANK_FISH_MAX)
/* Minimum interval between two checks of the open pairs, in ticks. */
#define TANK_MEETINGS_LOOK_TICKS 4u
/* Ticks after which a pair counts as separated. Personal spaces that overlap again within half a
 * second belong to the same encounter. */
#define TANK_MEETINGS_PART_TICKS 60u

/* Two fish in an encounter. The pair is open until the fish have separated. */
struct tank_meeting {
    fish_index low, high;
    uint32_t apart_ticks; /* Ticks since the personal spaces last overlapped. */
    /* Index + 1 of the next older open pair with the same `low`. A value of 0 means no pair. */
    uint32_t older;
};

struct tank_meetings {
    /* Number of encounters by type. A pair counts once until it has separated, however often either
     * fish avoids the other. */
    uint64_t head_on, side, rear_end;
    /* Number of avoidance starts by yaw and by pitch. Each fish's own turns (yaw in the trace) and
     * climbs or dives (pitch) count. */
    uint64_t by_yaw, by_pitch;

    uint32_t unlooked_ticks; /* Ticks since the open pairs were last checked for separation. */
    uint32_t open_count;
    /* Index + 1 of the newest open pair with this fish as `low`. A value of 0 means no pair. */
    uint32_t newest[TANK_FISH_MAX];
    struct tank_meeting open[TANK_MEETINGS_OPEN_MAX];
    /* Avoidance state of each fish in the previous tick, enum fish_avoiding. */
    uint8_t avoided[TANK_FISH_MAX];
};

/* Counts the encounters that began after the last call, which was `ticks` ticks ago. Set all fields
 * to zero before the first call. */
void tank_meetings_update(struct tank_meetings *meetings, const struct tank *tank, uint32_t ticks);

#endif
