/* poi_pool.h -- computes where the water lies that a poi (the paper scoop) carries. Uses no
 * OpenGL. */
#ifndef KINGYO_PLATFORM_RENDER_POI_POOL_H
#define KINGYO_PLATFORM_RENDER_POI_POOL_H

#include "core/scene.h"

/* Maximum thickness of the water film on each face of the paper. Further water collects in the
 * pool. */
#define POI_FILM_M 0.0006f
/* Level of a water pool that is far below all objects. The value means that a poi carries no
 * pool. */
#define POI_NO_POOL_M -1e3f

struct poi_pool {
    float level_m; /* World height of the pool's surface. POI_NO_POOL_M means no pool. */
    float film_m;  /* Thickness of the water film on the paper, at most POI_FILM_M. */
};

/* Returns the pool of a poi. The pool's surface is horizontal in every pose of the poi. The water
 * lies in the sagging paper, against the low side of the ring, or, if the poi is upside down,
 * inside the ring. The pool's volume equals the scene's `water_m`. */
struct poi_pool poi_pool_of(const struct scene_poi *poi);

#endif
