/* shape.h -- the smooth surfaces of one key (modelled growth stage) before meshing: body, eyes,
 * fins.
 *
 * Coordinates are in the drawing's units, in which the distance from snout to tail root is 1: x to
 * the right, y upward from the axis, z backward from the snout. For paired fins, the functions
 * return the right fin; the left fin is its mirror image. Normals point outward, but a fin's normal
 * may be on either side. */
#ifndef KINGYO_PLATFORM_SPECIES_SHAPE_H
#define KINGYO_PLATFORM_SPECIES_SHAPE_H

#include "platform/species/drawing.h"

typedef struct {
    double x, y, z;
} v3d;

v3d v3d_sub(v3d a, v3d b);
v3d v3d_muladd(v3d a, v3d b, double s); /* Returns a + b s. */
v3d v3d_cross(v3d a, v3d b);
double v3d_dot(v3d a, v3d b);
double v3d_length(v3d a);
/* Returns `a` scaled to length 1. Returns (0, 1, 0) if `a` has no direction, as on a degenerate
 * surface. */
v3d v3d_unit(v3d a);

/* Returns the value at `at` of a smooth curve through `count` drawn points, which never overshoots
 * them (Fritsch and Carlson). The curve is constant beyond the first and last point. */
double shape_curve_through(const double *x, const double *y, uint32_t count, double at);

/* Converts body coordinate u to the drawing's x. Both rise from 0 to 1. */
double shape_body_x(const struct key_text *key, double u);
/* Converts the drawing's x to body coordinate u. Both rise from 0 to 1. */
double shape_body_u(const struct key_text *key, double x);

/* Returns the cross section at `x` along the body, a smooth curve through the stations. */
struct station shape_section(const struct key_text *key, double x);

/* Returns a point of the body. `u` in (0, 1] runs from snout to tail root. `v` in [0, 1] runs round
 * the girth, from the back over the right flank. */
v3d shape_body_point(const struct key_text *key, double u, double v);
/* Returns the normal of the body at (u, v), with the ranges of shape_body_point(). */
v3d shape_body_normal(const struct key_text *key, double u, double v);

/* Angle from the pupil's centre to the rim, where the eye's ball meets the skin: 80 degrees. */
#define EYE_RIM_RAD 1.4

/* An eye: half an ellipsoid outward (`out`) and half an ellipsoid inward (`in`) from the skin at
 * (u, v). Its centre is `sunk` below the skin. v is outside [0, 1) for an eye that has migrated
 * over the back. */
struct ball {
    double u, v;
    double radius, out, in, sunk;
};
/* Returns the eye of a key on `side`. */
struct ball shape_eye_ball(const struct key_text *key, uint32_t side);

/* Returns the z of the body's last point, slightly behind its last ring. */
double shape_body_end(const struct key_text *key);
/* Returns a point of the round end of the body. `t` is 0 at the last ring and 1 at the body's last
 * point. */
v3d shape_end_point(const struct key_text *key, double t, double v);

/* Returns a point of a fin. `at` in [0, 1] runs from the first ray to the last ray, and `along` in
 * [0, 1] from root to tip. The root (along = 0) is inside the body. Every point with along > 0 is
 * outside. */
v3d shape_fin_point(const struct key_text *key, enum species_part part, double at, double along);
/* Returns the normal of a fin, with the ranges of shape_fin_point(). */
v3d shape_fin_normal(const struct key_text *key, enum species_part part, double at, double along);

/* Length of a finlet's base, as a fraction of the distance from one finlet to the next. */
#define FINLET_BASE 0.6

/* Returns a corner of the finlet that starts at position `at` of its row. Corner 0 is the front end
 * of the base, 1 the rear end of the base, 2 the tip. */
v3d shape_finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner);

/* Returns the species' measure in the drawing's units. The measure becomes the unit of length of
 * the mesh. */
double shape_unit_length(const struct key_text *key, enum species_measure measure);

/* Returns an upper bound of the distance of any point from the body's origin, along any axis. */
double shape_farthest(const struct key_text *key);

#endif
