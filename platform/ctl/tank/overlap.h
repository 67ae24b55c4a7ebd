/* overlap.h -- measures independently how deep bodies penetrate each other.
 *
 * The tank has its own boxes. This module checks the tank and shares no code with it: it uses
 * double precision, all fifteen axes, and every pair whose bounding balls overlap. The depth is the
 * least translation that separates two boxes. */
#ifndef KINGYO_PLATFORM_CTL_TANK_OVERLAP_H
#define KINGYO_PLATFORM_CTL_TANK_OVERLAP_H

#include <stdint.h>

#include "core/tank/tank.h"

/* Depth in mm above which a penetration counts as an overlap. A smaller penetration counts as a
 * contact. */
#define OVERLAP_DEEP_MM 0.5
/* Maximum number of cells along a side. In the largest tank of either build, a cell is about as
 * wide as two bounding balls. */
#define OVERLAP_CELL_MAX (TANK_FISH_MAX > TANK_FISH_KIOSK ? 256u : 128u)

struct overlap_box {
    double centre_m[3];
    double axis[3][3]; /* Unit axes of the box: right, up and back. */
    double half_m[3];
    double reach_m; /* Radius of the ball that contains the box. */
};

struct overlap_count {
    uint64_t pairs; /* Number of pairs deeper than OVERLAP_DEEP_MM. */
    double deepest_mm;
};

/* Scratch memory for one measurement of all fish. */
struct overlap {
    uint32_t count;
    struct overlap_box box[TANK_FISH_MAX];
    uint32_t cell[TANK_FISH_MAX];  /* Cell of each box. */
    uint32_t order[TANK_FISH_MAX]; /* Box numbers, sorted by cell. */
    uint32_t first[OVERLAP_CELL_MAX * OVERLAP_CELL_MAX + 1u];
};

/* Returns the oriented box of a fish. */
struct overlap_box overlap_box_of(const struct fish *fish);

/* Returns the penetration depth of two boxes, or 0 if they are separate. */
double overlap_depth_m(const struct overlap_box *a, const struct overlap_box *b);

/* Adds to `total` the overlaps of all swimming fish. Fish that are held or in a bowl do not
 * count. */
void overlap_add(struct overlap *overlap, const struct tank *tank, struct overlap_count *total);

#endif
