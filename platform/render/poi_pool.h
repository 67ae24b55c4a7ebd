/* poi_pool.h -- where the water lies that a poi carries. Knows no OpenGL. */
#ifndef KINGYO_PLATFORM_RENDER_POI_POOL_H
#define KINGYO_PLATFORM_RENDER_POI_POOL_H

#include "core/scene.h"

#define POI_FILM_M 0.0006f  /* On each face so much clings; what is more runs together. */
#define POI_NO_POOL_M -1e3f /* A level that is below everything. */

struct poi_pool {
    float level_m; /* World height of its surface, POI_NO_POOL_M when there is none. */
    float film_m;  /* Depth of what clings to the paper, <= POI_FILM_M. */
};

/* The pool is level, whatever the poi does: it lies in the belly, against the low side of the ring,
 * or, upside down, in the ring itself. Volume for volume what `water_m` says. */
struct poi_pool poi_pool_of(const struct scene_poi *poi);

#endif
