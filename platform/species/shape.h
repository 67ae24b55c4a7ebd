/* shape.h -- the smooth surfaces of one key, before any mesh: body, eyes, fins.
 *
 * In the drawing's units (snout to tail root 1): x right, y up from the axis, z back from the
 * snout. Paired fins are the right ones; the left are their mirror images. Normals point outward;
 * a fin's is on either side. */
#ifndef KINGYO_PLATFORM_SPECIES_SHAPE_H
#define KINGYO_PLATFORM_SPECIES_SHAPE_H

#include "platform/species/drawing.h"

typedef struct {
    double x, y, z;
} point3;

point3 sub(point3 a, point3 b);
point3 mad(point3 a, point3 b, double s); /* a + b s */
point3 cross(point3 a, point3 b);
double dot3(point3 a, point3 b);
double length3(point3 a);
/* Of length 1; upward where a maker's numbers fold a surface so that it has no normal. */
point3 unit(point3 a);

/* A smooth curve through drawn points that never overshoots them (Fritsch and Carlson); beyond
 * their ends it stays at the last. */
double curve_through(const double *x, const double *y, uint32_t count, double at);

/* From body coordinate u to the drawing's x, and back; both rise from 0 to 1. */
double body_x(const struct key_text *key, double u);
double body_u(const struct key_text *key, double x);

/* The cross section at `x` along the body, a smooth curve through the stations. */
struct station section(const struct key_text *key, double x);

/* `u` in (0, 1] from snout to tail root, `v` in [0, 1] round the girth from back over right. */
point3 body_point(const struct key_text *key, double u, double v);
point3 body_normal(const struct key_text *key, double u, double v);

#define EYE_RIM_RAD 1.4 /* From the pupil's centre to where a ball meets the skin: 80 degrees. */

/* An eye: half an ellipsoid outward and half one inward, told from the skin at (u, v), its centre
 * `sunk` below it. v leaves [0, 1) for an eye that has wandered over the back. */
struct ball {
    double u, v;
    double radius, out, in, sunk;
};
struct ball eye_ball(const struct key_text *key, uint32_t side);

/* The body's last point, a little behind its last ring. */
double body_end(const struct key_text *key);
/* Of the round end: `t` 0 at the last ring .. 1 at that point. */
point3 end_point(const struct key_text *key, double t, double v);

/* `at` 0 .. 1 from the first ray to the last, `along` 0 .. 1 from root to tip. The root (0) lies in
 * the body, everything beyond it (down to the least above 0) outside. */
point3 fin_point(const struct key_text *key, enum species_part part, double at, double along);
point3 fin_normal(const struct key_text *key, enum species_part part, double at, double along);

#define FINLET_BASE 0.6 /* Of the step from one finlet to the next. */

/* Of the finlet that starts at `at` of its row: corner 0 fore root, 1 hind root, 2 tip. */
point3 finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner);

/* What becomes the mesh's unit: the species' measure in the drawing's units. */
double unit_length(const struct key_text *key, enum species_measure measure);

/* How far the farthest point of all is from the body's origin, along any axis: an upper bound. */
double farthest(const struct key_text *key);

#endif
