/* mark.h -- the share of a point that a painted mark covers. Private to paint.c and mark.c. */
#ifndef KINGYO_CORE_MORPH_MARK_H
#define KINGYO_CORE_MORPH_MARK_H

#include "core/morph/species.h"

/* A point of the skin or of a fin, in the coordinates of marks. */
struct mark_point {
    uint8_t part, side;
    float u;      /* Along the body, or along the base of a fin. */
    float height; /* 0 belly .. 1 back; for a fin 0 root .. 1 tip. */
    float down;   /* Around the flank, 0 back .. 1 belly; for a fin 1 .. 0. */
    float right;  /* -1 left .. 1 right, 0 on the midlines. */
    float flank;  /* Distance of `down` from 0 to 1, in body lengths; for a fin in lengths of its
                     base. */
    float broad;  /* `flank` at the broadest place of the body. */
};

struct mark_point mark_point_of(const struct species_vertex *at, enum body_form form);

/* Returns the cover in [0, 1]. */
float mark_cover(const struct species_mark *mark, const struct mark_point *at);

#endif
