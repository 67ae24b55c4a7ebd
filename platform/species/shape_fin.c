/* shape_fin.c -- fins: rays that start inside the skin and bend toward their tips. */
#include "platform/species/shape.h"

#include <math.h>

#define PI 3.14159265358979323846
#define FIN_SINK 0.014   /* How deep fin roots lie under the skin, so that no gap shows. */
#define SINK_SHARE 0.3   /* Of a thinner body's thickness: no deeper than this. */
#define TAIL_ROOT 0.965  /* Where along the body the tail's rays start, inside the last ring. */
#define SIDE_AT_ROOT 0.4 /* Of a median ray's turn to the side; the rest comes along it. */
#define RAY_STEPS 12

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
                         .length = (float)curve_through(x, y[0], n, at),
                         .sweep_deg = (float)curve_through(x, y[1], n, at),
                         .side_deg = (float)curve_through(x, y[2], n, at) };
}

/* Where a fin's ray starts. The tail's base stands upright, top first; the others lie along u. */
static point3 fin_root(const struct key_text *key, enum species_part part, double at)
{
    const struct fin *fin = &key->fins[part];
    const double x = (double)fin->start + ((double)fin->end - (double)fin->start) * at;
    const struct station s = section(key, fmin(fmax(x, 0.0), 1.0));
    const double thin = fmin((double)s.depth, (double)s.width);
    const double sink = fmin(FIN_SINK, SINK_SHARE * thin);
    switch (part) {
    case PART_TAIL:
        return (point3){ 0.0, (double)fin->end + (double)fin->start - x, TAIL_ROOT };
    case PART_DORSAL:
    case PART_DORSAL_2:
        return (point3){ 0.0, (double)s.offset + 0.5 * (double)s.depth - sink, x };
    case PART_ANAL:
        return (point3){ 0.0, (double)s.offset - 0.5 * (double)s.depth + sink, x };
    default: {
        const double u = body_u(key, x);
        const point3 skin = body_point(key, u, (double)fin->girth);
        return mad(skin, body_normal(key, u, (double)fin->girth), -sink);
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
    case PART_DORSAL_2:
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

point3 finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner)
{
    const struct finlets *f = &key->finlets[row];
    const double step = ((double)f->end - (double)f->start) / f->count;
    const double x = (double)f->start + at * (step * f->count) + (corner == 1 ? FINLET_BASE * step : 0.0);
    const struct station s = section(key, fmin(x, 1.0));
    const double up = row == 0 ? 1.0 : -1.0;
    const double sink = fmin(FIN_SINK, SINK_SHARE * (double)s.depth);
    const point3 root = { 0.0, (double)s.offset + up * (0.5 * (double)s.depth - sink), x };
    if (corner < 2) {
        return root;
    }
    const double sweep = (double)f->sweep_deg * PI / 180.0, length = (double)f->length + sink;
    return mad(root, (point3){ 0.0, up * cos(sweep), sin(sweep) }, length);
}

double unit_length(const struct key_text *key, enum species_measure measure)
{
    double length = measure == MEASURE_DISC ? 0.0 : 1.0;
    const bool tail = key->fins[PART_TAIL].ray_count > 0;
    for (int i = 0; i <= 64; i++) {
        if (measure == MEASURE_TOTAL && tail) {
            length = fmax(length, fin_point(key, PART_TAIL, i / 64.0, 1.0).z);
        } else if (measure == MEASURE_DISC) {
            length = fmax(length, (double)section(key, i / 64.0).width);
        }
    }
    return measure == MEASURE_FORK && tail ? fin_point(key, PART_TAIL, 0.5, 1.0).z : length;
}
