/* tank_meetings.h -- counts the encounters between fish from the states of the fish.
 *
 * The simulation itself does not use the counts, so the counts are not part of the core's state.
 * Each fish has a personal space, and an encounter begins when a fish starts to avoid another
 * fish. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_MEETINGS_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_MEETINGS_H

#include "core/tank/tank.h"

/* Maximum number of open pairs. A pair of fish is open while its encounter lasts. At the fish
 * density of the 2005 thesis, there are 1.4 overlaps of personal spaces per fish. */
#define TANK_MEETINGS_OPEN_MAX (8u * TANK_FISH_MAX)
/* Minimum number of ticks between two checks of the open pairs. */
#define TANK_MEETINGS_LOOK_TICKS 4u
/* Number of ticks without an overlap of the personal spaces after which an encounter has ended. 60
 * ticks are 0.5 s. Two personal spaces that overlap again within this time belong to the same
 * encounter. */
#define TANK_MEETINGS_PART_TICKS 60u

/* Two fish that have an encounter. The pair stays open until the fish have separated. */
struct tank_meeting {
    fish_index low, high;
    uint32_t apart_ticks; /* Number of ticks for which the personal spaces of the two fish have not
                             overlapped. */
    /* Index + 1 of the next older open pair with the same `low`. 0 means that there is no older
     * pair. */
    uint32_t older;
};

struct tank_meetings {
    /* Number of encounters of each type: head-on, from the side, and from behind. An encounter is
     * counted once, even if the fish start several avoidances before they separate. */
    uint64_t head_on, side, rear_end;
    /* Number of avoidances by yaw (a turn) and by pitch (a climb or a dive). Each fish's avoidances
     * are counted separately. */
    uint64_t by_yaw, by_pitch;

    uint32_t unlooked_ticks; /* Number of ticks since the last check of the open pairs. */
    uint32_t open_count;
    /* Index + 1 of the newest open pair in which the fish is `low`. 0 means that there is no open
     * pair. */
    uint32_t newest[TANK_FISH_MAX];
    struct tank_meeting open[TANK_MEETINGS_OPEN_MAX];
    /* Avoidance of each fish at the previous call (enum fish_avoiding). */
    uint8_t avoided[TANK_FISH_MAX];
};

/* Counts the encounters that began since the last call. `ticks` is the number of ticks since that
 * call. All fields of `meetings` must be 0 before the first call. */
void tank_meetings_update(struct tank_meetings *meetings, const struct tank *tank, uint32_t ticks);

#endif
