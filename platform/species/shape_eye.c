/* shape_eye.c -- computes where an eye lies on the skin, and how far the eye's ball protrudes. */
#include "platform/species/shape.h"

#include <math.h>

#define PI 3.14159265358979323846
/* Maximum height of an eye's centre above the middle of the cross section, as a fraction of half of
 * the cross section's height. */
#define HIGHEST 0.97
/* Upper limit of the result of skin_drop(), as a fraction of the ball's radius. The limit applies
 * where the skin around the eye is a sharp ridge. */
#define DROP_MAX 0.35
/* Maximum depth of the ball's centre below the skin, as a fraction of half of the head's thickness
 * at the eye. */
#define SUNK_MAX 0.6
/* Maximum depth of the ball's back below the skin, as a fraction of half of the head's thickness at
 * the eye. The limit prevents that the ball emerges on the opposite side. */
#define DEPTH_MAX 0.9
/* Minimum depth of each half of a ball. A flatter ball has no usable normals. */
#define THINNEST 1e-3

/* Returns the surface coordinate v of the right flank at height `y`: 0 is the middle of the back,
 * 0.5 the middle of the belly. */
static double girth_at(const struct station *s, double y)
{
    const double up = (y - (double)s->offset) / (0.5 * (double)s->depth);
    const double share = pow(fmin(fabs(up), HIGHEST), 0.5 * (double)s->exponent);
    return acos(copysign(share, up)) / (2.0 * PI);
}

/* Returns the mean distance between the plane that touches the skin at the eye's centre and the
 * skin under the ball's rim. The result is at most DROP_MAX times the ball's radius. */
static double skin_drop(const struct key_text *key, const struct ball *ball, v3d skin, v3d n)
{
    const double d = 1e-3;
    const v3d along = v3d_sub(shape_body_point(key, ball->u + d, ball->v), skin);
    const v3d round = v3d_sub(shape_body_point(key, ball->u, ball->v + d), skin);
    const double du = d * ball->radius / fmax(v3d_length(along), 1e-9);
    const double dv = d * ball->radius / fmax(v3d_length(round), 1e-9);
    const double step[4][2] = { { du, 0 }, { -du, 0 }, { 0, dv }, { 0, -dv } };
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        const double u = fmin(fmax(ball->u + step[i][0], 0.002), 1.0);
        const v3d to = v3d_sub(shape_body_point(key, u, ball->v + step[i][1]), skin);
        const double fall = -v3d_dot(to, n);
        const double away = v3d_length(v3d_muladd(to, n, fall));
        sum += 0.25 * fall * pow(ball->radius / fmax(away, 1e-6), 2.0);
    }
    return fmin(fmax(sum, 0.0), DROP_MAX * ball->radius);
}

struct ball shape_eye_ball(const struct key_text *key, uint32_t side)
{
    const struct eye *eye = &key->eyes[side];
    const struct station s = shape_section(key, (double)eye->x);
    const double girth = girth_at(&s, (double)eye->y) * (1.0 - (double)eye->turn_deg / 90.0);
    struct ball ball = { .u = shape_body_u(key, (double)eye->x),
                         .v = side == 0 ? girth : 1.0 - girth,
                         .radius = 0.5 * (double)eye->diameter };
    const v3d skin = shape_body_point(key, ball.u, ball.v),
              n = shape_body_normal(key, ball.u, ball.v);
    const v3d axis = { 0.0, (double)s.offset, skin.z };
    const double half = fmax(v3d_dot(v3d_sub(skin, axis), n), THINNEST);
    const double drop = skin_drop(key, &ball, skin, n);
    const double stands_out = (double)eye->bulge * (double)eye->diameter;
    const double out = (stands_out + drop) / (1.0 - cos(EYE_RIM_RAD));
    ball.sunk = fmin(out - stands_out, SUNK_MAX * half);
    ball.out = fmax(ball.sunk + stands_out, THINNEST);
    ball.in = fmin(ball.out, fmax(DEPTH_MAX * half - ball.sunk, THINNEST));
    return ball;
}
