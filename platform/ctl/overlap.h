/* overlap.h -- how deep bodies are in each other, measured from outside.
 *
 * The tank has its own boxes; this is the judge and shares none of their code: double precision,
 * all fifteen axes, every pair whose balls meet. Depth is the least translation that parts two
 * boxes. */
#ifndef KINGYO_PLATFORM_CTL_OVERLAP_H
#define KINGYO_PLATFORM_CTL_OVERLAP_H

#include <stdint.h>

#include "core/tank/tank.h"

#define OVERLAP_DEEP_MM 0.5 /* Deeper is an overlap; less is a brush. */
/* Cells along a side: in the largest tank of either build a cell is about as wide as two balls. */
#define OVERLAP_CELL_MAX (TANK_FISH_MAX > TANK_FISH_KIOSK ? 256u : 128u)

struct overlap_box {
    double centre_m[3];
    double axis[3][3]; /* Unit: right, up, back. */
    double half_m[3];
    double reach_m; /* Of the ball that holds it. */
};

struct overlap_count {
    uint64_t pairs; /* Deeper than OVERLAP_DEEP_MM. */
    double deepest_mm;
};

/* Scratch of one look at all fish. */
struct overlap {
    uint32_t count;
    struct overlap_box box[TANK_FISH_MAX];
    uint32_t cell[TANK_FISH_MAX];  /* Of each box. */
    uint32_t order[TANK_FISH_MAX]; /* Boxes by cell. */
    uint32_t first[OVERLAP_CELL_MAX * OVERLAP_CELL_MAX + 1u];
};

struct overlap_box overlap_box_of(const struct fish *fish);

/* 0 when apart. */
double overlap_depth_m(const struct overlap_box *a, const struct overlap_box *b);

/* Adds to `total` what overlaps among the fish that swim; held ones and those in a bowl do not
 * count. */
void overlap_add(struct overlap *overlap, const struct tank *tank, struct overlap_count *total);

#endif
