/* overlap.h -- measures how deep the bodies of fish penetrate each other, and counts the encounters
 * between fish, as independent checks of the tank.
 *
 * The tank has its own collision detection, and overlap.c shares no code with the tank. overlap.c
 * uses double precision, tests all fifteen separating axes, and tests every pair of boxes whose
 * bounding spheres overlap. The penetration depth is the least translation that separates two
 * boxes.
 *
 * The simulation itself does not use the number of encounters, so the number is not part of the
 * core's state. Each fish has a personal space, and an encounter begins when a fish starts to avoid
 * another fish. */
#pragma once

#include <stdint.h>

#include "core/tank/tank.h"

/* Two bodies count as overlapping if their penetration depth in mm is above this value. A smaller
 * depth counts as a contact. */
#define OVERLAP_DEEP_MM 0.5
/* Maximum number of grid cells along each side of the tank. In the largest tank, a cell is about as
 * wide as two bounding spheres. */
#define OVERLAP_CELL_MAX (TANK_FISH_MAX > TANK_FISH_KIOSK ? 256u : 128u)

struct overlap_box {
    double centre_m[3];
    double axis[3][3]; /* Unit vectors of the box's axes: right, up and back. */
    double half_m[3];
    double reach_m; /* Radius of the bounding sphere around the box's centre. */
};

struct overlap_count {
    uint64_t pairs; /* Number of pairs whose penetration depth is above OVERLAP_DEEP_MM. */
    double deepest_mm;
};

/* Scratch memory for one measurement of all fish in a tank. */
struct overlap {
    uint32_t count;
    struct overlap_box box[TANK_FISH_MAX];
    uint32_t cell[TANK_FISH_MAX];  /* Grid cell of each box. */
    uint32_t order[TANK_FISH_MAX]; /* Indices of the boxes, sorted by grid cell. */
    uint32_t first[OVERLAP_CELL_MAX * OVERLAP_CELL_MAX + 1u];
};

/* Returns the oriented bounding box of a fish's body. */
struct overlap_box overlap_box_of(const struct fish *fish);

/* Returns the penetration depth of two boxes in metres, or 0 if the boxes do not touch. */
double overlap_depth_m(const struct overlap_box *a, const struct overlap_box *b);

/* Adds the overlaps between all swimming fish of `tank` to `total`. Fish on a poi (a paper scoop)
 * or in a bowl are not tested. */
void overlap_add(struct overlap *overlap, const struct tank *tank, struct overlap_count *total);

/* Maximum number of open pairs. A pair of fish is open while its encounter lasts. At the fish
 * density of the 2005 thesis, there are 1.4 overlaps of personal spaces per fish. */
#define TANK_MEETINGS_OPEN_MAX (8u * TANK_FISH_MAX)
/* Minimum number of ticks between two checks of the open pairs. */
#define TANK_MEETINGS_SAMPLE_TICKS 4u
/* Number of ticks without an overlap of the personal spaces after which an encounter has ended. 60
 * ticks are 0.5 s. Two personal spaces that overlap again within this time belong to the same
 * encounter. */
#define TANK_MEETINGS_PART_TICKS 60u

/* Two fish that have an encounter. The pair stays open until the fish have separated. */
struct tank_meeting {
    fish_index low, high;
    /* Number of ticks since the personal spaces of the two fish last overlapped. */
    uint32_t apart_ticks;
    /* Index + 1, in the list `open`, of the next older pair with the same `low`. 0 means that there
     * is no older pair. */
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
    /* Index + 1 of the newest open pair in which the fish is the member `low`. 0 means that there
     * is no open pair. */
    uint32_t newest[TANK_FISH_MAX];
    struct tank_meeting open[TANK_MEETINGS_OPEN_MAX];
    /* Avoidance of each fish at the previous call (enum fish_avoiding). */
    uint8_t avoided[TANK_FISH_MAX];
};

/* Counts the encounters that began since the last call. `ticks` is the number of ticks since that
 * call. All fields of `meetings` must be 0 before the first call. */
void tank_meetings_update(struct tank_meetings *meetings, const struct tank *tank, uint32_t ticks);
