/* shape.c -- implementation of shape.h: curves through the drawn points, the body's surface, the
 * eyes, and the size of a drawing. */
#include "platform/species/shape.h"

#include <math.h>
#include <string.h>

#include "core/base/panic.h"

#define PI 3.14159265358979323846

/* ---- Curves through drawn points ------------------------------------------------------------ */

/* Returns the slope, at point `i`, of a smooth curve through the `count` points (x, y). The method
 * of Fritsch and Carlson chooses the slopes so that the curve does not overshoot between the
 * points. */
static double monotone_slope(const double *x, const double *y, uint32_t count, uint32_t i)
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

static double curve_through(const double *x, const double *y, uint32_t count, double at)
{
    CORE_ASSERT(count >= 2);
    uint32_t i = 0;
    while (i < count - 2 && at > x[i + 1]) {
        i++;
    }
    const double h = x[i + 1] - x[i];
    const double t = fmin(fmax((at - x[i]) / h, 0.0), 1.0);
    const double m0 = monotone_slope(x, y, count, i) * h,
                 m1 = monotone_slope(x, y, count, i + 1) * h;
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * y[i] + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * y[i + 1] +
           (t3 - t2) * m1;
}

void shape_interpolate(const void *rows, uint32_t width, uint32_t count, bool is_round, double at,
                       void *out)
{
    CORE_ASSERT(count >= 2 && count <= STATION_MAX);
    CORE_ASSERT(width <= SHAPE_FIELD_MAX);
    double x[STATION_MAX], y[SHAPE_FIELD_MAX][STATION_MAX];
    float result[SHAPE_FIELD_MAX] = { (float)at };
    for (uint32_t i = 0; i < count; i++) {
        float row[SHAPE_FIELD_MAX];
        memcpy(row, (const char *)rows + i * width * sizeof row[0], width * sizeof row[0]);
        x[i] = is_round ? sqrt((double)row[0]) : (double)row[0];
        for (uint32_t k = 1; k < width; k++) {
            y[k][i] = (double)row[k];
        }
    }
    for (uint32_t k = 1; k < width; k++) {
        const double place = is_round ? sqrt(fmax(at, 0.0)) : at;
        result[k] = (float)curve_through(x, y[k], count, place);
    }
    memcpy(out, result, width * sizeof result[0]);
}

struct station shape_section(const struct key_text *key, double x)
{
    struct station station;
    shape_interpolate(key->stations, 5, key->substep_count, true, x, &station);
    return station;
}

/* The body coordinate u is a piecewise linear function of x. The two linear pieces meet at the gill
 * cover's rear edge, where u = GILL_U in every key. */

double shape_body_x(const struct key_text *key, double u)
{
    const double gill = key->gill > 0.0f ? (double)key->gill : (double)GILL_U;
    const double at[] = { 0.0, (double)GILL_U, 1.0 }, x[] = { 0.0, gill, 1.0 };
    return curve_through(at, x, 3, u);
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

/* ---- Surface of the body --------------------------------------------------------------------- */

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

/* ---- Eyes ------------------------------------------------------------------------------------ */

/* This section computes where an eye lies on the skin, and how far the eye's ball protrudes. */

/* Maximum height of an eye's centre above the middle of the cross section. The unit is half of the
 * cross section's height. */
#define HIGHEST 0.97
/* Upper limit of `drop` in shape_eye_ball(), the mean depth of the skin under the rim of an eye's
 * ball. The unit is the ball's radius. The limit applies where the skin around the eye is a sharp
 * ridge. */
#define DROP_MAX 0.35
/* Maximum depth below the skin at which an eye ball has its centre. The unit is half of the head's
 * thickness at the eye. */
#define SUNK_MAX 0.6
/* Maximum depth below the skin that the back of an eye ball reaches. The unit is half of the
 * head's thickness at the eye. Without this limit, the ball could emerge on the opposite side of
 * the head. */
#define DEPTH_MAX 0.9
/* Lower limit, in the drawing's units, for the depth of the two halves of an eye's ball and for
 * half of the head's thickness at the eye. A flatter ball has no usable normals. */
#define THINNEST 1e-3

struct ball shape_eye_ball(const struct key_text *key, uint32_t side)
{
    CORE_ASSERT(side < 2);
    CORE_ASSERT(key->eyes[side].diameter > 0.0f);
    const struct eye *eye = &key->eyes[side];
    const struct station s = shape_section(key, (double)eye->x);
    /* `girth` is the surface coordinate v at which a right eye lies: 0 is the middle of the back,
     * 0.25 is the flank, and 0.5 is the middle of the belly. The eye's height determines `girth`,
     * and the migration angle turn_deg moves the eye toward the back and beyond it. */
    const double up = ((double)eye->y - (double)s.offset) / (0.5 * (double)s.depth);
    const double share = pow(fmin(fabs(up), HIGHEST), 0.5 * (double)s.exponent);
    const double girth =
        (acos(copysign(share, up)) / (2.0 * PI)) * (1.0 - (double)eye->turn_deg / 90.0);
    struct ball ball = { .u = shape_body_u(key, (double)eye->x),
                         .v = side == 0 ? girth : 1.0 - girth,
                         .radius = 0.5 * (double)eye->diameter };
    const v3d skin = shape_body_point(key, ball.u, ball.v),
              n = shape_body_normal(key, ball.u, ball.v);
    const v3d axis = { 0.0, (double)s.offset, skin.z };
    const double half = fmax(v3d_dot(v3d_sub(skin, axis), n), THINNEST);
    /* Computes `drop`: how far the skin under the rim of the eye's ball lies, on average, below the
     * tangent plane of the skin at the eye's centre. `drop` is at most DROP_MAX times the ball's
     * radius. */
    const double d = 1e-3;
    const v3d along = v3d_sub(shape_body_point(key, ball.u + d, ball.v), skin);
    const v3d round = v3d_sub(shape_body_point(key, ball.u, ball.v + d), skin);
    const double du = d * ball.radius / fmax(v3d_length(along), 1e-9);
    const double dv = d * ball.radius / fmax(v3d_length(round), 1e-9);
    const double step[4][2] = { { du, 0 }, { -du, 0 }, { 0, dv }, { 0, -dv } };
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        const double u = fmin(fmax(ball.u + step[i][0], 0.002), 1.0);
        const v3d to = v3d_sub(shape_body_point(key, u, ball.v + step[i][1]), skin);
        const double fall = -v3d_dot(to, n);
        const double away = v3d_length(v3d_muladd(to, n, fall));
        sum += 0.25 * fall * pow(ball.radius / fmax(away, 1e-6), 2.0);
    }
    const double drop = fmin(fmax(sum, 0.0), DROP_MAX * ball.radius);
    const double stands_out = (double)eye->bulge * (double)eye->diameter;
    const double out = (stands_out + drop) / (1.0 - cos(EYE_RIM_RAD));
    ball.sunk = fmin(out - stands_out, SUNK_MAX * half);
    ball.out = fmax(ball.sunk + stands_out, THINNEST);
    ball.in = fmin(ball.out, fmax(DEPTH_MAX * half - ball.sunk, THINNEST));
    return ball;
}

/* ---- Size of a drawing before scaling -------------------------------------------------------- */

/* This section computes the length of a fish in the units of its drawing. The length is measured as
 * the species' length measure (enum species_measure) defines. */

/* Number of points on the rear edge of a tail fin. The length functions use the rearmost of these
 * points. */
#define TIPS 64

double shape_unit_length(const struct key_text *key, enum species_measure measure)
{
    const bool tail = key->fins[PART_TAIL].ray_count > 0;
    double length = measure == MEASURE_DISC ? 0.0 : 1.0;
    if (measure == MEASURE_DISC) {
        /* MEASURE_DISC is the greatest width of the flat body of a ray. The loop examines only the
         * stations (the cross sections that the species text defines), because the interpolated
         * width between two stations never exceeds the width of the wider station. */
        for (uint32_t i = 0; i < key->substep_count; i++) {
            length = fmax(length, (double)key->stations[i].width);
        }
    } else if (measure == MEASURE_TOTAL && tail) {
        for (int i = 0; i <= TIPS; i++) {
            length = fmax(length, shape_fin_point(key, PART_TAIL, (double)i / TIPS, 1.0).z);
        }
    } else if (measure == MEASURE_FORK && tail) {
        length = shape_fin_point(key, PART_TAIL, 0.5, 1.0).z;
    }
    return length;
}

double shape_farthest(const struct key_text *key)
{
    double body = 1.0, ray = 0.0;
    for (uint32_t i = 0; i < key->substep_count; i++) {
        const struct station *s = &key->stations[i];
        const double up = fabs((double)s->offset) + 0.5 * (double)s->depth;
        body = fmax(body, fmax(up, 0.5 * (double)s->width));
    }
    for (uint32_t part = PART_TAIL; part < PART_COUNT; part++) {
        for (uint32_t i = 0; i < key->fins[part].ray_count; i++) {
            ray = fmax(ray, (double)key->fins[part].rays[i].length);
        }
    }
    return body + ray;
}
