/* overlap.h -- measures how deep the bodies of fish penetrate each other, as an independent check
 * of the tank.
 *
 * The tank has its own collision detection, and overlap.c shares no code with the tank. overlap.c
 * uses double precision, tests all fifteen separating axes, and tests every pair of boxes whose
 * bounding spheres overlap. The penetration depth is the least translation that separates two
 * boxes. */
#ifndef KINGYO_PLATFORM_CTL_TANK_OVERLAP_H
#define KINGYO_PLATFORM_CTL_TANK_OVERLAP_H

#include <stdint.h>

#include "core/tank/tank.h"

/* Penetration depth in mm above which two bodies count as overlapping. A smaller depth counts as a
 * contact. */
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

#endif
