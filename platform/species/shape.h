/* shape.h -- the smooth surfaces of one key, before meshing: body, eyes, fins.
 *
 * In the drawing's units (snout to tail root 1): x right, y up from the axis, z back from the
 * snout. Paired fins are the right ones; the left are their mirror images. Normals point outward; a
 * fin's normal may be on either side. */
#ifndef KINGYO_PLATFORM_SPECIES_SHAPE_H
#define KINGYO_PLATFORM_SPECIES_SHAPE_H

#include "platform/species/drawing.h"

typedef struct {
    double x, y, z;
} v3d;

v3d v3d_sub(v3d a, v3d b);
v3d v3d_muladd(v3d a, v3d b, double s); /* a + b s */
v3d v3d_cross(v3d a, v3d b);
double v3d_dot(v3d a, v3d b);
double v3d_length(v3d a);
/* Returns a vector of length 1. Returns up if a degenerate surface has no normal. */
v3d v3d_unit(v3d a);

/* Returns the value at `at` of a smooth curve through drawn points that never overshoots them
 * (Fritsch and Carlson). Beyond the ends the curve is constant. */
double shape_curve_through(const double *x, const double *y, uint32_t count, double at);

/* Convert body coordinate u to the drawing's x, and back. Both rise from 0 to 1. */
double shape_body_x(const struct key_text *key, double u);
double shape_body_u(const struct key_text *key, double x);

/* Returns the cross section at `x` along the body, a smooth curve through the stations. */
struct station shape_section(const struct key_text *key, double x);

/* Return a point and the normal of the body: `u` in (0, 1] from snout to tail root, `v` in [0, 1]
 * round the girth from the back over the right flank. */
v3d shape_body_point(const struct key_text *key, double u, double v);
v3d shape_body_normal(const struct key_text *key, double u, double v);

/* Angle from the pupil's centre to the rim where the ball meets the skin: 80 degrees. */
#define EYE_RIM_RAD 1.4

/* An eye: half an ellipsoid outward and half an ellipsoid inward, relative to the skin at (u, v),
 * its centre `sunk` below the skin. v leaves [0, 1) for an eye that has migrated over the back. */
struct ball {
    double u, v;
    double radius, out, in, sunk;
};
struct ball shape_eye_ball(const struct key_text *key, uint32_t side);

/* Returns the z of the body's last point, slightly behind its last ring. */
double shape_body_end(const struct key_text *key);
/* Returns a point of the round end: `t` is 0 at the last ring and 1 at the body's last point. */
v3d shape_end_point(const struct key_text *key, double t, double v);

/* Return a point and the normal of a fin: `at` 0 .. 1 from the first ray to the last, `along` 0
 * .. 1 from root to tip. The root (along = 0) is inside the body, every point with along > 0
 * outside. */
v3d shape_fin_point(const struct key_text *key, enum species_part part, double at, double along);
v3d shape_fin_normal(const struct key_text *key, enum species_part part, double at, double along);

#define FINLET_BASE 0.6 /* Length of a finlet's base, as a fraction of the step between finlets. */

/* Returns a corner of the finlet that starts at `at` of its row: 0 fore root, 1 hind root, 2
 * tip. */
v3d shape_finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner);

/* Returns the length that becomes the mesh's unit: the species' measure in the drawing's units. */
double shape_unit_length(const struct key_text *key, enum species_measure measure);

/* Returns an upper bound of the distance of any point from the body's origin, along any axis. */
double shape_farthest(const struct key_text *key);

#endif
