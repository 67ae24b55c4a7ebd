/* shape.h -- the smooth surfaces of one key, before any mesh: body, eyes, fins.
 *
 * In the drawing's units (standard length 1): x right, y up from the axis, z back from the snout.
 * Eyes and paired fins are the right ones; the left are their mirror images. Normals point outward;
 * a fin's is on either side. */
#ifndef KINGYO_PLATFORM_SPECIES_SHAPE_H
#define KINGYO_PLATFORM_SPECIES_SHAPE_H

#include "platform/species/drawing.h"

typedef struct {
    double x, y, z;
} point3;

/* Of length 1; upward where a maker's numbers fold a surface so that it has no normal. */
point3 unit(point3 a);

/* The cross section at `u` along the body, a smooth curve through the stations. */
struct station section(const struct key_text *key, double u);

/* `u` in (0, 1] from snout to tail root, `v` in [0, 1] round the girth from back over right. */
point3 body_point(const struct key_text *key, double u, double v);
point3 body_normal(const struct key_text *key, double u, double v);

/* The dome over the flank at height `y`, `z` behind the snout. */
point3 eye_point(const struct key_text *key, double y, double z);
point3 eye_normal(const struct key_text *key, double y, double z);

/* `at` 0 .. 1 from the first ray to the last, `along` 0 .. 1 from root to tip. */
point3 fin_point(const struct key_text *key, enum species_part part, double at, double along);
point3 fin_normal(const struct key_text *key, enum species_part part, double at, double along);

/* From the snout to the farthest tip of the tail: what becomes the mesh's unit length. */
double total_length(const struct key_text *key);

#endif
