/* shape.c -- implementation of shape.h: curves through drawn points, and the body. */
#include "platform/species/shape.h"

#include <math.h>

#define PI 3.14159265358979323846

/* Curves through drawn points */

/* Returns Fritsch and Carlson's slope at `i`, which prevents overshoot between the drawn points. */
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

double curve_through(const double *x, const double *y, uint32_t count, double at)
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

/* Returns the cross section at `x`. Curves run over the square root of x, so that a section which
 * starts at size 0 opens like a ball and not like a cone. */
struct station section(const struct key_text *key, double along)
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
    const double at = sqrt(fmax(along, 0.0));
    return (struct station){ .x = (float)along,
                             .depth = (float)curve_through(x, y[0], n, at),
                             .width = (float)curve_through(x, y[1], n, at),
                             .offset = (float)curve_through(x, y[2], n, at),
                             .exponent = (float)curve_through(x, y[3], n, at) };
}

/* Body coordinate u is linear in x on both sides of the gill cover, which every key has at
 * GILL_U. */

double body_x(const struct key_text *key, double u)
{
    const double gill = key->gill > 0.0f ? (double)key->gill : (double)GILL_U;
    const double at[] = { 0.0, (double)GILL_U, 1.0 }, x[] = { 0.0, gill, 1.0 };
    return curve_through(at, x, 3, u);
}

double body_u(const struct key_text *key, double x)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 40; i++) {
        const double middle = 0.5 * (low + high);
        *(body_x(key, middle) < x ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

/* Vectors */

point3 sub(point3 a, point3 b)
{
    return (point3){ a.x - b.x, a.y - b.y, a.z - b.z };
}

point3 mad(point3 a, point3 b, double s)
{
    return (point3){ a.x + b.x * s, a.y + b.y * s, a.z + b.z * s };
}

point3 cross(point3 a, point3 b)
{
    return (point3){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

double dot3(point3 a, point3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double length3(point3 a)
{
    return sqrt(dot3(a, a));
}

point3 unit(point3 a)
{
    const double length = length3(a);
    return length > 1e-12 ? (point3){ a.x / length, a.y / length, a.z / length }
                          : (point3){ 0.0, 1.0, 0.0 };
}

/* Surfaces: the body by (u along, v round) */

static double superellipse(double sine, double exponent)
{
    return copysign(pow(fabs(sine), 2.0 / exponent), sine);
}

point3 body_point(const struct key_text *key, double u, double v)
{
    const double x = body_x(key, u);
    const struct station s = section(key, x);
    const double angle = 2.0 * PI * v;
    return (point3){ 0.5 * (double)s.width * superellipse(sin(angle), (double)s.exponent),
                     (double)s.offset +
                         0.5 * (double)s.depth * superellipse(cos(angle), (double)s.exponent),
                     x };
}

point3 body_normal(const struct key_text *key, double u, double v)
{
    const double du = fmin(1e-3, 0.5 * u), dv = 1e-3;
    const point3 along = sub(body_point(key, fmin(u + du, 1.0), v), body_point(key, u - du, v));
    const point3 round = sub(body_point(key, u, v + dv), body_point(key, u, v - dv));
    return unit(cross(along, round));
}
