/* mark.h -- computes how strongly a painted mark covers a point of the fish. Internal to paint.c
 * and mark.c. */
#pragma once

#include "core/morph/species.h"

/* Point on the skin or on a fin, in the coordinates that the marks use. */
struct mark_point {
    uint8_t part, side;
    /* Coordinate u of struct species_vertex. On the body, u is 0 at the snout and 1 at the tail
     * root. On a fin, u is 0 at the leading ray and 1 at the last ray. On an eye, u is 0 at the
     * centre of the pupil and 1 at the outer edge of the iris. */
    float u;
    /* Height in [0, 1]. On the body, 0 is the belly and 1 is the back. On a fin, 0 is the root and
     * 1 is the tip. */
    float height;
    /* Position from top to bottom in [0, 1]. On the body, 0 is the back and 1 is the belly,
     * measured along the skin. On a fin, 0 is the tip and 1 is the root. */
    float down;
    /* Sideways position in [-1, 1]: -1 is the left flank, 1 is the right flank, and 0 is the back
     * or the belly. */
    float right;
    /* Distance on the skin from the back to the belly at the position `u`, in body lengths. The
     * value is 1 on a fin. */
    float flank;
    float broad; /* Value of `flank` at the highest part of the body. */
};

struct mark_point mark_point_of(const struct species_vertex *at, enum body_form form);

/* Returns the opacity of the mark at the point, from 0 (not covered) to 1 (completely covered). */
float mark_cover(const struct species_mark *mark, const struct mark_point *at);
