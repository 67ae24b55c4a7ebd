/* mark.h -- the share of a point on a fish that a painted mark covers. Internal to paint.c and
 * mark.c. */
#ifndef KINGYO_CORE_MORPH_MARK_H
#define KINGYO_CORE_MORPH_MARK_H

#include "core/morph/species.h"

/* Point on the skin or on a fin, in the coordinates that marks use. */
struct mark_point {
    uint8_t part, side;
    float u;      /* Position along the body, or along the base of a fin, in [0, 1]. */
    float height; /* Height of the point: 0 at the belly and 1 at the back; on a fin, 0 at the root
                     and 1 at the tip. */
    float down;   /* Position around the flank: 0 at the back and 1 at the belly; on a fin, 1 at the
                     root and 0 at the tip. */
    float right;  /* Position to the right: -1 at the left flank, 1 at the right flank, 0 at the
                     back and the belly. */
    float flank;  /* Distance on the skin between `down` = 0 and `down` = 1 at this point, in body
                     lengths; 1 on a fin. */
    float broad;  /* Value of `flank` at the broadest place of the body. */
};

struct mark_point mark_point_of(const struct species_vertex *at, enum body_form form);

/* Returns the share [0, 1] of the point that the mark covers. */
float mark_cover(const struct species_mark *mark, const struct mark_point *at);

#endif
