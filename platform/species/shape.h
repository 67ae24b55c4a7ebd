/* shape.h -- computes the smooth surfaces of one key (modelled growth stage) before they are
 * meshed: body, eyes and fins.
 *
 * Coordinates are in the drawing's units, in which the distance from the snout to the tail root is
 * 1. x points to the right, y upward from the body's axis, and z from the snout backward. For
 * paired fins, the functions return the right fin, and the left fin is its mirror image. Normals
 * point outward, but a fin's normal may point to either side. */
#pragma once

#include <math.h>

#include "platform/species/drawing.h"

typedef struct {
    double x, y, z;
} v3d;

static inline v3d v3d_sub(v3d a, v3d b)
{
    return (v3d){ a.x - b.x, a.y - b.y, a.z - b.z };
}

/* Returns a + b * s. */
static inline v3d v3d_muladd(v3d a, v3d b, double s)
{
    return (v3d){ a.x + b.x * s, a.y + b.y * s, a.z + b.z * s };
}

static inline v3d v3d_cross(v3d a, v3d b)
{
    return (v3d){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

static inline double v3d_dot(v3d a, v3d b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline double v3d_length(v3d a)
{
    return sqrt(v3d_dot(a, a));
}

/* Returns `a` scaled to length 1. If `a` is (almost) zero, as on a degenerate surface, returns (0,
 * 1, 0). */
static inline v3d v3d_unit(v3d a)
{
    const double length = v3d_length(a);
    return length > 1e-12 ? (v3d){ a.x / length, a.y / length, a.z / length }
                          : (v3d){ 0.0, 1.0, 0.0 };
}

/* Maximum number of floats in a structure that shape_interpolate() interpolates (`width`). */
#define SHAPE_FIELD_MAX 5
/* Interpolates between the `count` structures at `rows`, and writes the structure at the position
 * `at` to `out`. Each structure consists of `width` floats. The first float is the structure's
 * position, and the positions increase. The curve of each other float is smooth and never
 * overshoots (method of Fritsch and Carlson). Before the first position and after the last
 * position, the curves are constant.
 *
 * If `is_round` is true, the interpolation uses the square root of the positions. An outline that
 * starts with size 0 is then round like a ball. Otherwise the outline would be pointed like a
 * cone. */
void shape_interpolate(const void *rows, uint32_t width, uint32_t count, bool is_round, double at,
                       void *out);

/* Converts the body coordinate u to the drawing's position x along the body. u and x are 0 at the
 * snout and 1 at the tail root. */
double shape_body_x(const struct key_text *key, double u);
/* Converts the drawing's position x along the body to the body coordinate u. x and u are 0 at the
 * snout and 1 at the tail root. */
double shape_body_u(const struct key_text *key, double x);

/* Returns the cross section at position `x` along the body. The cross section is interpolated
 * smoothly between the stations (the cross sections that the species text defines). */
struct station shape_section(const struct key_text *key, double x);

/* Returns a point of the body's surface. `u` in (0, 1] runs from the snout to the tail root. `v` in
 * [0, 1] runs round the body: from the middle of the back over the right flank (0.25), the belly
 * (0.5) and the left flank (0.75). */
v3d shape_body_point(const struct key_text *key, double u, double v);
/* Returns the normal of the body's surface at (u, v), with the ranges of shape_body_point(). */
v3d shape_body_normal(const struct key_text *key, double u, double v);

/* Angle in rad (80 degrees), seen from the centre of an eye's ball, between the centre of the pupil
 * and the rim. At the rim the ball meets the skin. */
#define EYE_RIM_RAD 1.4

/* The ball of an eye at (u, v) on the skin. The ball consists of two halves of ellipsoids with
 * radius `radius`: the outer half with depth `out`, and the inner half with depth `in`. The ball's
 * centre is at depth `sunk` below the skin. v is outside [0, 1) for an eye that has migrated over
 * the back. */
struct ball {
    double u, v;
    double radius, out, in, sunk;
};
/* Returns the ball of one eye in the drawing `key`. `side` is 0 for the right eye, 1 for the left
 * eye. */
struct ball shape_eye_ball(const struct key_text *key, uint32_t side);

/* Returns the z coordinate of the body's last point, which is slightly behind the tail root. */
double shape_body_end(const struct key_text *key);
/* Returns a point of the body's round end. `t` is 0 at the tail root and 1 at the body's last
 * point. `v` runs round the body as in shape_body_point(). */
v3d shape_end_point(const struct key_text *key, double t, double v);

/* Returns a point of a fin. `at` in [0, 1] runs from the first ray to the last ray, and `along` in
 * [0, 1] from root to tip. The root (along = 0) is inside the body. Points with along > 0 are
 * outside the body. */
v3d shape_fin_point(const struct key_text *key, enum species_part part, double at, double along);
/* Returns the normal of a fin, with the ranges of shape_fin_point(). */
v3d shape_fin_normal(const struct key_text *key, enum species_part part, double at, double along);

/* Length of a finlet's base, as a fraction of the distance from one finlet to the next. */
#define FINLET_BASE 0.6

/* Returns a corner of a finlet, whose base starts at position `at` [0, 1] of its row. `row` is 0
 * for the upper row and 1 for the lower row. `corner` is 0 for the front end of the base, 1 for the
 * rear end of the base, and 2 for the tip. */
v3d shape_finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner);

/* Returns the fish's length in the drawing's units, as the length measure `measure` defines it. The
 * mesh uses this length as its unit. */
double shape_unit_length(const struct key_text *key, enum species_measure measure);

/* Returns an upper limit of the absolute values of the x, y and z coordinates of all points of the
 * fish, in the drawing's units. */
double shape_farthest(const struct key_text *key);
