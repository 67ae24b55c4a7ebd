/* mark.h -- how much of a point a painted mark covers. Private to paint.c and mark.c. */
#ifndef KINGYO_CORE_MORPH_MARK_H
#define KINGYO_CORE_MORPH_MARK_H

#include "core/morph/species.h"

/* A point of the skin or a fin, as marks see it. */
struct mark_point {
    uint8_t part, side;
    float u;       /* Along the body, or a fin's base. */
    float height;  /* 0 belly .. 1 back; of a fin 0 root .. 1 tip. */
    float down;    /* Round the flank, 0 back .. 1 belly; of a fin 1 .. 0. */
    float right;   /* -1 left .. 1 right, 0 on the midlines. */
    float flank;   /* What `down` 0 to 1 measures, in body lengths; of a fin, in its base's. */
    float broad;   /* The same where the body is broadest. */
};

struct mark_point mark_point_of(const struct species_vertex *at, enum body_form form);

/* [0, 1]: 0 untouched .. 1 covered. */
float mark_cover(const struct species_mark *mark, const struct mark_point *at);

#endif
