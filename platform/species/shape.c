/* shape.c -- see shape.h. */
#include "platform/species/shape.h"

#include <math.h>

#define PI 3.14159265358979323846
#define FIN_SINK 0.014   /* How deep fin roots lie under the skin, so that no gap shows. */
#define EYE_SINK 0.006   /* The same for the eye's rim. */
#define EYE_BORDER 0.97  /* Of the section's half height: as high as an eye's rim may reach. */
#define TAIL_ROOT 0.965  /* Where along the body the tail's rays start, inside the last ring. */
#define SIDE_AT_ROOT 0.4 /* Of a median ray's turn to the side; the rest comes along it. */
#define RAY_STEPS 12

/* Curves through drawn points */

/* Fritsch and Carlson's slope at `i`: no overshoot between the points a maker drew. */
static double slope(const double *x, const double *y, uint32_t count, uint32_t i)
{
    if (i == 0 || i == count - 1) {
        const uint32_t j = i == 0 ? 0 : count - 2;
        return (y[j + 1] - y[j]) / (x[j + 1] - x[j]);
    }
    const double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
    const double d0 = (y[i] - y[i - 1]) / h0, d1 = (y[i + 1] - y[i]) / h1;
    if (d0 * d1 <= 0.0) {
        return 0.0;
    }
    const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

static double curve(const double *x, const double *y, uint32_t count, double at)
{
    uint32_t i = 0;
    while (i < count - 2 && at > x[i + 1]) {
        i++;
    }
    const double h = x[i + 1] - x[i];
    const double t = fmin(fmax((at - x[i]) / h, 0.0), 1.0);
    const double m0 = slope(x, y, count, i) * h, m1 = slope(x, y, count, i + 1) * h;
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * y[i] + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * y[i + 1] +
           (t3 - t2) * m1;
}

/* The cross section at `u`. Curves run over the square root of x, so that a section which starts
 * from nothing opens like a ball and not like a cone. */
struct station section(const struct key_text *key, double u)
{
    double x[STATION_MAX], y[4][STATION_MAX];
    for (uint32_t i = 0; i < key->station_count; i++) {
        const struct station *s = &key->stations[i];
        x[i] = sqrt((double)s->x);
        y[0][i] = (double)s->depth;
        y[1][i] = (double)s->width;
        y[2][i] = (double)s->offset;
        y[3][i] = (double)s->exponent;
    }
    const uint32_t n = key->station_count;
    const double at = sqrt(fmax(u, 0.0));
    return (struct station){ .x = (float)u,
                             .depth = (float)curve(x, y[0], n, at),
                             .width = (float)curve(x, y[1], n, at),
                             .offset = (float)curve(x, y[2], n, at),
                             .exponent = (float)curve(x, y[3], n, at) };
}

static struct ray ray_at(const struct fin *fin, double at)
{
    double x[RAY_MAX], y[3][RAY_MAX];
    for (uint32_t i = 0; i < fin->ray_count; i++) {
        x[i] = (double)fin->rays[i].at;
        y[0][i] = (double)fin->rays[i].length;
        y[1][i] = (double)fin->rays[i].sweep_deg;
        y[2][i] = (double)fin->rays[i].side_deg;
    }
    const uint32_t n = fin->ray_count;
    return (struct ray){ .at = (float)at,
                         .length = (float)curve(x, y[0], n, at),
                         .sweep_deg = (float)curve(x, y[1], n, at),
                         .side_deg = (float)curve(x, y[2], n, at) };
}

/* Vectors */

static point3 sub(point3 a, point3 b)
{
    return (point3){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static point3 mad(point3 a, point3 b, double s)
{
    return (point3){ a.x + b.x * s, a.y + b.y * s, a.z + b.z * s };
}

static point3 cross(point3 a, point3 b)
{
    return (point3){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

point3 unit(point3 a)
{
    const double length = sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
    return length > 1e-12 ? (point3){ a.x / length, a.y / length, a.z / length }
                          : (point3){ 0.0, 1.0, 0.0 };
}

/* Surfaces: body by (u along, v round), eye by (rho, angle), fin by (across, along) */

static double superellipse(double sine, double exponent)
{
    return copysign(pow(fabs(sine), 2.0 / exponent), sine);
}

point3 body_point(const struct key_text *key, double u, double v)
{
    const struct station s = section(key, u);
    const double angle = 2.0 * PI * v;
    return (point3){ 0.5 * (double)s.width * superellipse(sin(angle), (double)s.exponent),
                     (double)s.offset +
                         0.5 * (double)s.depth * superellipse(cos(angle), (double)s.exponent),
                     u };
}

point3 body_normal(const struct key_text *key, double u, double v)
{
    const double du = fmin(1e-3, 0.5 * u), dv = 1e-3;
    const point3 along = sub(body_point(key, fmin(u + du, 1.0), v), body_point(key, u - du, v));
    const point3 round = sub(body_point(key, u, v + dv), body_point(key, u, v - dv));
    return unit(cross(along, round));
}

/* How far out the right flank is at height `y`; no higher or lower than EYE_BORDER. */
static double flank(const struct key_text *key, double u, double y)
{
    const struct station s = section(key, u);
    const double up = fabs(y - (double)s.offset) / (0.5 * (double)s.depth);
    const double e = (double)s.exponent;
    return 0.5 * (double)s.width * pow(1.0 - pow(fmin(up, EYE_BORDER), e), 1.0 / e);
}

/* A paraboloid dome over the flank; `rho` 0 at its centre, 1 at its rim. The right eye. */
point3 eye_point(const struct key_text *key, double y, double z)
{
    const struct eye *eye = &key->eye;
    const double radius = 0.5 * (double)eye->diameter;
    const double dy = (y - (double)eye->y) / radius, dz = (z - (double)eye->x) / radius;
    const double dome = 1.0 - dy * dy - dz * dz;
    const double height = (double)eye->bulge * (double)eye->diameter;
    return (point3){ flank(key, z, y) - EYE_SINK + dome * height, y, z };
}

point3 eye_normal(const struct key_text *key, double y, double z)
{
    const double d = 1e-3;
    const point3 up = sub(eye_point(key, y + d, z), eye_point(key, y - d, z));
    const point3 back = sub(eye_point(key, y, z + d), eye_point(key, y, z - d));
    return unit(cross(up, back));
}

/* Where a fin's ray starts. The tail's base stands upright, top first; the others lie along u. */
static point3 fin_root(const struct key_text *key, enum species_part part, double at)
{
    const struct fin *fin = &key->fins[part];
    const double u = (double)fin->start + ((double)fin->end - (double)fin->start) * at;
    const struct station s = section(key, fmin(fmax(u, 0.0), 1.0));
    switch (part) {
    case PART_TAIL:
        return (point3){ 0.0, (double)fin->end + (double)fin->start - u, TAIL_ROOT };
    case PART_DORSAL:
        return (point3){ 0.0, (double)s.offset + 0.5 * (double)s.depth - FIN_SINK, u };
    case PART_ANAL:
        return (point3){ 0.0, (double)s.offset - 0.5 * (double)s.depth + FIN_SINK, u };
    default: {
        const point3 skin = body_point(key, u, (double)fin->girth);
        return mad(skin, body_normal(key, u, (double)fin->girth), -FIN_SINK);
    }
    }
}

/* Which way a ray points at `r` of its length. Dorsal and anal: sweep leans it backward from
 * upright. Tail: sweep lifts it from straight back. Both: side turns it to the right, growing
 * toward the tip. Paired (the right one): sweep leans it back from straight out, side lifts it. */
static point3 fin_direction(const struct fin *fin, enum species_part part, struct ray ray, double r)
{
    const double degrees = PI / 180.0;
    const double curl = (double)fin->curl_deg * r;
    const bool paired = part == PART_PECTORAL || part == PART_PELVIC;
    const double turned = paired ? 1.0 : SIDE_AT_ROOT + (1.0 - SIDE_AT_ROOT) * r;
    const double side = (double)ray.side_deg * degrees * turned;
    const double sweep = part == PART_TAIL ? (double)ray.sweep_deg * degrees * (1.0 - curl / 90.0)
                                           : ((double)ray.sweep_deg + curl) * degrees;
    const double c = cos(sweep), s = sin(sweep);
    switch (part) {
    case PART_TAIL:
        return (point3){ sin(side), s * cos(side), c * cos(side) };
    case PART_DORSAL:
        return (point3){ sin(side), c * cos(side), s * cos(side) };
    case PART_ANAL:
        return (point3){ sin(side), -c * cos(side), s * cos(side) };
    default:
        return (point3){ c * cos(side), c * sin(side), s };
    }
}

point3 fin_point(const struct key_text *key, enum species_part part, double at, double along)
{
    const struct fin *fin = &key->fins[part];
    const struct ray ray = ray_at(fin, at);
    point3 p = fin_root(key, part, at);
    for (int i = 0; i < RAY_STEPS; i++) {
        const double r = along * (i + 0.5) / RAY_STEPS;
        p = mad(p, fin_direction(fin, part, ray, r), (double)ray.length * along / RAY_STEPS);
    }
    return p;
}

point3 fin_normal(const struct key_text *key, enum species_part part, double at, double along)
{
    const double d = 1e-3;
    const point3 across = sub(fin_point(key, part, fmin(at + d, 1.0), along),
                              fin_point(key, part, fmax(at - d, 0.0), along));
    const point3 out = sub(fin_point(key, part, at, fmin(along + d, 1.0)),
                           fin_point(key, part, at, fmax(along - d, 0.0)));
    return unit(cross(across, out));
}

double total_length(const struct key_text *key)
{
    double length = 1.0;
    for (int i = 0; i <= 64; i++) {
        length = fmax(length, fin_point(key, PART_TAIL, i / 64.0, 1.0).z);
    }
    return length;
}
