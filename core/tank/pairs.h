/* pairs.h -- which bodies are near each other: exactly, in time that grows as their number.
 *
 * Bodies are sorted into square cells of the floor plan whose side is the largest sum of two
 * reaches, so that whoever is near lies in the same cell or in one of the eight about it: 8.602 cm
 * for fish of 5 cm with spaces of 7 x 4 x 3 cm that pitch (the 2013 thesis' 3.5 cm lose a quarter
 * of them). Half of the nine cells is enough, for every pair is then met from one of its ends.
 *
 * Two steps, several pairs at once: balls, heights and sides leave 2.9 pairs a fish of 22 at the
 * thesis' density; of those, fifteen axes (separating-axis theorem) find 1.5. What is found, and
 * in which order, does not depend on how many lanes the machine has. */
#ifndef KINGYO_CORE_TANK_PAIRS_H
#define KINGYO_CORE_TANK_PAIRS_H

#include "core/base/lanes.h"
#include "core/tank/body.h"
#include "core/tank/grid.h"

#define PAIRS_BATCH 256u /* As many near pairs at a time: they stay in the first cache. */

enum pairs_search {
    PAIRS_GRID = 0,
    PAIRS_ALL = 1, /* Each with each, for comparison (the thesis' table 4.2): the same pairs in the
                      same order, in time that grows as the square. */
};

/* What is searched. Columns are indexed by fish. */
struct pairs_of {
    const struct body *body;
    const uint8_t *flags;    /* Fish with one of the bits `which` are searched. */
    const float *reach_m;    /* How far from its skin a body is also felt, beside its margin. */
    uint32_t count;
    uint8_t which;
    uint8_t search;          /* enum pairs_search */
    uint8_t lanes;           /* 0, 4 or 8, as lanes_built() */
    uint8_t bodies_only;     /* Who is near by its personal space alone need not be found. */
    float width_m, breadth_m; /* The floor plan; whoever is outside is searched all the same. */
};

/* A pair whose bodies are nearer than the sum of their reaches, or whose spaces overlap. */
struct found {
    uint32_t a, b;  /* Fish. */
    float gap_m;    /* Between the bodies: the largest separation over all axes. < 0: overlap. */
    uint8_t axis;   /* Which axis shows it; pairs_axis() makes a vector of it. */
    uint8_t spaces; /* Whether the personal spaces overlap. */
};

/* Scratch of a search; nothing in it is remembered. */
struct pairs {
    struct grid grid;
    fish_index member[TANK_FISH_MAX + LANES_MAX]; /* Who is searched. */
    uint32_t cell, item, other; /* Where in the cells' order the search stands. */
    uint8_t search;
    /* Columns in the order of the cells. A ball and half a height hold all by which a body is felt;
     * lanes read a little beyond the last. */
    float x_m[TANK_FISH_MAX + LANES_MAX], y_m[TANK_FISH_MAX + LANES_MAX],
        z_m[TANK_FISH_MAX + LANES_MAX], ball_m[TANK_FISH_MAX + LANES_MAX],
        slab_m[TANK_FISH_MAX + LANES_MAX];
    uint32_t near_count;
    uint32_t near_a[PAIRS_BATCH + LANES_MAX], near_b[PAIRS_BATCH + LANES_MAX]; /* Items. */
};

/* Sorts the bodies into cells and stands before the first pair. */
void pairs_begin(struct pairs *pairs, const struct pairs_of *of);

/* The next pairs, in a fixed order: `*count` of them, 0 .. PAIRS_BATCH. Returns 0 after the last.
 * `found` has room for PAIRS_BATCH + LANES_MAX. */
int pairs_next(struct pairs *pairs, const struct pairs_of *of, struct found *found,
               uint32_t *count);

/* The gaps between the bodies of `count` pairs of fish, as struct found gives them, right to 1 um
 * where they are under half a metre; by as many `lanes` as lanes_built(). All three lists have room
 * for LANES_MAX more, and what stands there in `a` and `b` is some fish or other. */
void pairs_gaps(const struct body *body, const fish_index *a, const fish_index *b, uint32_t count,
                uint8_t lanes, float *gap_m);

/* Unit, from a toward b: the direction in which the gap of a found pair is measured. */
vec3 pairs_axis(const struct body *a, const struct body *b, uint8_t axis);

#endif
