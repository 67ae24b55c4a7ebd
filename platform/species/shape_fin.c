/* shape_fin.c -- fins: rays that start inside the skin and bend toward their tips. */
#include "platform/species/shape.h"

#include <math.h>

#define PI 3.14159265358979323846
#define FIN_SINK 0.014   /* How deep fin roots lie under the skin, so that no gap shows. */
#define SHOWN_MIN 0.004  /* So much of a ray shows, however short: less has no side to face to. */
#define SINK_SHARE 0.3   /* Of a thinner body's thickness: no deeper than this. */
#define TAIL_SINK 0.035  /* So far before the last ring the tail's rays start, ... */
#define STALK_SINK 1.2   /* ... or so much of the stalk's end depth where it is thin. */
#define END_MAX 0.03     /* So far behind the last ring the body closes, ... */
#define END_SHARE 0.25   /* ... or so much of that depth. */
#define SIDE_AT_ROOT 0.4 /* Of a median ray's turn to the side; the rest comes along it. */
#define THINNEST 0.2     /* Of half the stalk: a tail's base reaches so far up and down at least. */
#define RAY_STEPS 12
#define EXIT_STEPS 24    /* A ray's way out of the body is told to so fine a part of it. */
#define EXIT_MAX 0.85    /* A ray shows at least the rest. */
#define CUP_OPENS 0.05   /* So far behind the stalk a tail is as wide as its rays say. */
#define JOIN_FROM 0.8    /* Of an eel's dorsal and anal base: there they begin to join the tail. */
#define CLEAR_OF 1.02    /* A fin that hugs the flank lies so much farther out. */

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

static double stalk_depth(const struct key_text *key)
{
    return (double)key->stations[key->station_count - 1].depth;
}

double body_end(const struct key_text *key)
{
    return 1.0 + fmin(END_MAX, END_SHARE * stalk_depth(key));
}

/* How much of the tail root's girth is left at `t` of the way to that point: a round end. */
static double closing(double t)
{
    return sqrt(fmax(1.0 - t * t, 0.0));
}

point3 end_point(const struct key_text *key, double t, double v)
{
    const point3 p = body_point(key, 1.0, v);
    const double middle = (double)section(key, 1.0).offset, left = closing(t);
    return (point3){ p.x * left, middle + (p.y - middle) * left, 1.0 + t * (body_end(key) - 1.0) };
}

/* From the base's top (0) to its bottom, within the stalk however tall a maker draws it. */
static point3 tail_root(const struct key_text *key, double at)
{
    const struct fin *fin = &key->fins[PART_TAIL];
    const double x = 1.0 - fmin(TAIL_SINK, STALK_SINK * stalk_depth(key));
    const struct station s = section(key, x);
    const double half = 0.5 * (double)s.depth * (1.0 - SINK_SHARE), middle = (double)s.offset;
    const double top = fmax(fmin((double)fin->end, middle + half), middle + THINNEST * half);
    const double bottom = fmin(fmax((double)fin->start, middle - half), middle - THINNEST * half);
    return (point3){ 0.0, top + (bottom - top) * at, x };
}

/* How deep a fin's root lies under the skin at `x`. */
static double sink_at(const struct key_text *key, double x)
{
    const struct station s = section(key, fmin(fmax(x, 0.0), 1.0));
    return fmin(FIN_SINK, SINK_SHARE * fmin((double)s.depth, (double)s.width));
}

static double base_x(const struct fin *fin, double at)
{
    return (double)fin->start + ((double)fin->end - (double)fin->start) * at;
}

/* Where a fin's ray leaves the skin, or its root so far `inside` it. The tail's base stands upright
 * in the stalk, top first; the others lie along x. */
static point3 fin_base(const struct key_text *key, enum species_part part, double at, double inside)
{
    const struct fin *fin = &key->fins[part];
    const double x = base_x(fin, at);
    const struct station s = section(key, fmin(fmax(x, 0.0), 1.0));
    switch (part) {
    case PART_TAIL:
        return tail_root(key, at);
    case PART_DORSAL:
    case PART_DORSAL_2:
        return (point3){ 0.0, (double)s.offset + 0.5 * (double)s.depth - inside, x };
    case PART_ANAL:
        return (point3){ 0.0, (double)s.offset - 0.5 * (double)s.depth + inside, x };
    default: {
        const double u = body_u(key, x);
        const point3 skin = body_point(key, u, (double)fin->girth);
        return mad(skin, body_normal(key, u, (double)fin->girth), -inside);
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

/* Along a ray from where it leaves the skin: a drawn length starts at the sunken root. */
static point3 ray_point(const struct key_text *key, enum species_part part, double at, double along)
{
    const struct fin *fin = &key->fins[part];
    const struct ray ray = ray_at(fin, at);
    const double length = (double)ray.length;
    const double sink = part == PART_TAIL ? 0.0 : sink_at(key, base_x(fin, at));
    const double shown = fmax(length - sink, SHOWN_MIN);
    point3 p = fin_base(key, part, at, 0.0);
    for (int i = 0; i < RAY_STEPS; i++) {
        const double r = along * (i + 0.5) / RAY_STEPS;
        p = mad(p, fin_direction(fin, part, ray, r), shown * along / RAY_STEPS);
    }
    if (part == PART_TAIL) { /* A cupped tail opens behind the stalk, not through its flanks. */
        const double start = body_end(key);
        p.x *= fmin(fmax((p.z - start) / CUP_OPENS, 0.0), 1.0);
    }
    return p;
}

/* How far out of the body's axis `p` is, 1 at the skin; before and behind the body it is out. */
static double outness(const struct key_text *key, point3 p)
{
    const double end = body_end(key);
    if (p.z >= end || p.z <= 0.0) {
        return CLEAR_OF;
    }
    const struct station s = section(key, fmin(p.z, 1.0));
    const double left = p.z > 1.0 ? closing((p.z - 1.0) / (end - 1.0)) : 1.0;
    const double e = (double)s.exponent;
    const double x = fabs(p.x) / (0.5 * (double)s.width * left);
    const double y = fabs(p.y - (double)s.offset) / (0.5 * (double)s.depth * left);
    return pow(pow(x, e) + pow(y, e), 1.0 / e);
}

/* How much of a ray runs within the body, from where it leaves the skin. */
static double fin_exit(const struct key_text *key, enum species_part part, double at)
{
    double along = 0.0;
    while (along < EXIT_MAX && outness(key, ray_point(key, part, at, along)) < CLEAR_OF) {
        along += 1.0 / EXIT_STEPS;
    }
    return fmin(along, EXIT_MAX);
}

/* A paired fin that is folded back lies on the flank where its rays would run within. */
static point3 on_flank(const struct key_text *key, point3 p)
{
    const double out = outness(key, p);
    if (out >= CLEAR_OF || out < 1e-3) {
        return p;
    }
    const double middle = (double)section(key, fmin(p.z, 1.0)).offset;
    const double k = CLEAR_OF / out;
    return (point3){ p.x * k, middle + (p.y - middle) * k, p.z };
}

/* The root of a ray, or what is seen of it. */
static point3 own_point(const struct key_text *key, enum species_part part, double at, double along)
{
    if (along <= 0.0) {
        return fin_base(key, part, at, sink_at(key, base_x(&key->fins[part], at)));
    }
    if (part == PART_PECTORAL || part == PART_PELVIC) {
        return on_flank(key, ray_point(key, part, at, along));
    }
    const double exit = fin_exit(key, part, at);
    return ray_point(key, part, at, exit + (1.0 - exit) * along);
}

/* How far an eel's dorsal or anal fin has become the edge of its tail fin. */
static double joined(const struct key_text *key, enum species_part part, double at)
{
    if (!key->confluent || (part != PART_DORSAL && part != PART_ANAL)) {
        return 0.0;
    }
    const double t = fmax((at - JOIN_FROM) / (1.0 - JOIN_FROM), 0.0);
    return t * t * (3.0 - 2.0 * t);
}

point3 fin_point(const struct key_text *key, enum species_part part, double at, double along)
{
    const point3 own = own_point(key, part, at, along);
    const double share = joined(key, part, at);
    if (share <= 0.0) {
        return own;
    }
    const point3 tail = own_point(key, PART_TAIL, part == PART_DORSAL ? 0.0 : 1.0, along);
    return mad(mad((point3){ 0.0, 0.0, 0.0 }, own, 1.0 - share), tail, share);
}

point3 fin_normal(const struct key_text *key, enum species_part part, double at, double along)
{
    const double d = 1e-3;
    const point3 across = sub(ray_point(key, part, fmin(at + d, 1.0), along),
                              ray_point(key, part, fmax(at - d, 0.0), along));
    const point3 out = sub(ray_point(key, part, at, fmin(along + d, 1.0)),
                           ray_point(key, part, at, fmax(along - d, 0.0)));
    return unit(cross(across, out));
}

point3 finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner)
{
    const struct finlets *f = &key->finlets[row];
    const double length = (double)f->end - (double)f->start;
    const double base = corner == 1 ? FINLET_BASE * length / f->count : 0.0;
    const double x = (double)f->start + at * length + base;
    const struct station s = section(key, fmin(x, 1.0));
    const double up = row == 0 ? 1.0 : -1.0;
    const double sink = fmin(FIN_SINK, SINK_SHARE * (double)s.depth);
    const point3 root = { 0.0, (double)s.offset + up * (0.5 * (double)s.depth - sink), x };
    if (corner < 2) {
        return root;
    }
    const double sweep = (double)f->sweep_deg * PI / 180.0;
    return mad(root, (point3){ 0.0, up * cos(sweep), sin(sweep) }, (double)f->length + sink);
}
