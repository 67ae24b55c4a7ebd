/* shape.c -- implementation of shape.h: curves through the drawn points, and the body's surface. */
#include "platform/species/shape.h"

#include <math.h>

#define PI 3.14159265358979323846

/* ---- Curves through drawn points ------------------------------------------------------------ */

/* Returns the slope of the curve at point `i`. The method of Fritsch and Carlson chooses the slopes
 * so that the curve does not overshoot between the points. */
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

double shape_curve_through(const double *x, const double *y, uint32_t count, double at)
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

/* Returns the cross section at position `along`. The interpolation uses the square root of x,
 * because an outline that starts with size 0 is then round like a ball. With x itself, the outline
 * would be pointed like a cone. */
struct station shape_section(const struct key_text *key, double along)
{
    double x[STATION_MAX], y[4][STATION_MAX];
    for (uint32_t i = 0; i < key->substep_count; i++) {
        const struct station *s = &key->stations[i];
        x[i] = sqrt((double)s->x);
        y[0][i] = (double)s->depth;
        y[1][i] = (double)s->width;
        y[2][i] = (double)s->offset;
        y[3][i] = (double)s->exponent;
    }
    const uint32_t n = key->substep_count;
    const double at = sqrt(fmax(along, 0.0));
    return (struct station){ .x = (float)along,
                             .depth = (float)shape_curve_through(x, y[0], n, at),
                             .width = (float)shape_curve_through(x, y[1], n, at),
                             .offset = (float)shape_curve_through(x, y[2], n, at),
                             .exponent = (float)shape_curve_through(x, y[3], n, at) };
}

/* On each side of the gill cover's rear edge, the body coordinate u is a linear function of x. The
 * edge is at u = GILL_U in every key. */

double shape_body_x(const struct key_text *key, double u)
{
    const double gill = key->gill > 0.0f ? (double)key->gill : (double)GILL_U;
    const double at[] = { 0.0, (double)GILL_U, 1.0 }, x[] = { 0.0, gill, 1.0 };
    return shape_curve_through(at, x, 3, u);
}

double shape_body_u(const struct key_text *key, double x)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 40; i++) {
        const double middle = 0.5 * (low + high);
        *(shape_body_x(key, middle) < x ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

/* ---- Vector functions ----------------------------------------------------------------------- */

v3d v3d_sub(v3d a, v3d b)
{
    return (v3d){ a.x - b.x, a.y - b.y, a.z - b.z };
}

v3d v3d_muladd(v3d a, v3d b, double s)
{
    return (v3d){ a.x + b.x * s, a.y + b.y * s, a.z + b.z * s };
}

v3d v3d_cross(v3d a, v3d b)
{
    return (v3d){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

double v3d_dot(v3d a, v3d b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double v3d_length(v3d a)
{
    return sqrt(v3d_dot(a, a));
}

v3d v3d_unit(v3d a)
{
    const double length = v3d_length(a);
    return length > 1e-12 ? (v3d){ a.x / length, a.y / length, a.z / length }
                          : (v3d){ 0.0, 1.0, 0.0 };
}

/* ---- Surface of the body at (u, v): u along the body, v round the body ---------------------- */

static double superellipse(double sine, double exponent)
{
    return copysign(pow(fabs(sine), 2.0 / exponent), sine);
}

v3d shape_body_point(const struct key_text *key, double u, double v)
{
    const double x = shape_body_x(key, u);
    const struct station s = shape_section(key, x);
    const double angle = 2.0 * PI * v;
    return (v3d){ 0.5 * (double)s.width * superellipse(sin(angle), (double)s.exponent),
                  (double)s.offset +
                      0.5 * (double)s.depth * superellipse(cos(angle), (double)s.exponent),
                  x };
}

v3d shape_body_normal(const struct key_text *key, double u, double v)
{
    const double du = fmin(1e-3, 0.5 * u), dv = 1e-3;
    const v3d along =
        v3d_sub(shape_body_point(key, fmin(u + du, 1.0), v), shape_body_point(key, u - du, v));
    const v3d round = v3d_sub(shape_body_point(key, u, v + dv), shape_body_point(key, u, v - dv));
    return v3d_unit(v3d_cross(along, round));
}
