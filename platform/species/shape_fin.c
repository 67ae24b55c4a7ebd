/* shape_fin.c -- computes the shapes of the fins. The rays of a fin start inside the skin and bend
 * toward their tips. */
#include "platform/species/shape.h"

#include <math.h>

#include "core/base/panic.h"

#define PI 3.14159265358979323846
/* Depth of the roots of the fins below the skin, as a fraction of the distance from the snout to
 * the tail root. The roots are below the skin so that no gap is visible between fin and skin. */
#define FIN_SINK 0.014
/* Minimum visible length of a fin ray, as a fraction of the distance from the snout to the tail
 * root. A shorter ray has no usable normal. */
#define SHOWN_MIN 0.004
/* Upper limit of the depth of the fins' roots below the skin in a thin body, as a fraction of the
 * body's thickness. The smaller of FIN_SINK and this limit applies. */
#define SINK_SHARE 0.3
/* Distance from the tail root forward to the point inside the body at which the tail fin's rays
 * start. The unit is the distance from the snout to the tail root. */
#define TAIL_SINK 0.035
/* Upper limit of the distance from the tail root forward to the start of the tail fin's rays, as a
 * multiple of the tail stalk's height. The smaller of TAIL_SINK and this limit applies. */
#define STALK_SINK 1.2
/* Maximum distance from the tail root backward to the body's last point, as a fraction of the
 * distance from the snout to the tail root. */
#define END_MAX 0.03
/* Maximum distance from the tail root backward to the body's last point for a thin tail stalk, as a
 * multiple of the stalk's height. The smaller of END_MAX and this limit applies. */
#define END_SHARE 0.25
/* Sideways angle of an unpaired fin's ray at its root, as a fraction of the sideways angle at the
 * tip of the ray. */
#define SIDE_AT_ROOT 0.4
/* Minimum distance from the middle of the tail stalk to each end (upper and lower) of the tail
 * fin's base. The value is a fraction of the maximum distance, which the height of the stalk
 * determines. */
#define THINNEST 0.2
#define RAY_STEPS 12
/* Number of steps in the search for the point at which a ray leaves the body. */
#define EXIT_STEPS 24
/* Maximum fraction of a ray's length that is treated as inside the body. The rest of the ray is
 * always visible. */
#define EXIT_MAX 0.85
/* Length of the part behind the tail stalk in which the sideways extent of the tail fin grows from
 * 0 to its full value. The unit is the distance from the snout to the tail root. */
#define CUP_OPENS 0.05
/* Position along the base of an eel's dorsal or anal fin, [0, 1]. Behind this position, the fin
 * merges with the tail fin. */
#define JOIN_FROM 0.8
/* Minimum distance of a visible fin point from the body's axis, divided by the distance of the skin
 * from the axis in the same direction. */
#define CLEAR_OF 1.02

static double stalk_depth(const struct key_text *key)
{
    return (double)key->stations[key->substep_count - 1].depth;
}

double shape_body_end(const struct key_text *key)
{
    return 1.0 + fmin(END_MAX, END_SHARE * stalk_depth(key));
}

/* Returns the size of the cross section at position `t` of the body's round end, as a fraction of
 * the size of the cross section at the tail root. `t` is 0 at the tail root and 1 at the body's
 * last point. */
static double closing(double t)
{
    return sqrt(fmax(1.0 - t * t, 0.0));
}

v3d shape_end_point(const struct key_text *key, double t, double v)
{
    const v3d p = shape_body_point(key, 1.0, v);
    const double middle = (double)shape_section(key, 1.0).offset, left = closing(t);
    return (v3d){ p.x * left, middle + (p.y - middle) * left,
                  1.0 + t * (shape_body_end(key) - 1.0) };
}

/* Returns the position on a ray of the text for position `at` of the tail fin's mesh. The mesh of a
 * double tail runs from the lower edge of its right half (0) over the fold (0.5) to the lower edge
 * of its left half (1). The text has only the rays of the right half. */
static double tail_at(const struct key_text *key, double at)
{
    return key->double_tail ? fabs(2.0 * at - 1.0) : at;
}

/* Returns a point of the tail fin's base. The base is limited to the height of the tail stalk.
 * `mesh_at` is a position of the tail fin's mesh. The upper end of the base is where tail_at() is
 * 0. */
static v3d tail_root(const struct key_text *key, double mesh_at)
{
    const double at = tail_at(key, mesh_at);
    const struct fin *fin = &key->fins[PART_TAIL];
    const double x = 1.0 - fmin(TAIL_SINK, STALK_SINK * stalk_depth(key));
    const struct station s = shape_section(key, x);
    const double half = 0.5 * (double)s.depth * (1.0 - SINK_SHARE), middle = (double)s.offset;
    const double top = fmax(fmin((double)fin->end, middle + half), middle + THINNEST * half);
    const double bottom = fmin(fmax((double)fin->start, middle - half), middle - THINNEST * half);
    return (v3d){ 0.0, top + (bottom - top) * at, x };
}

/* Returns the depth of a fin's root below the skin at position `x` along the body. */
static double sink_at(const struct key_text *key, double x)
{
    const struct station s = shape_section(key, fmin(fmax(x, 0.0), 1.0));
    return fmin(FIN_SINK, SINK_SHARE * fmin((double)s.depth, (double)s.width));
}

static double base_x(const struct fin *fin, double at)
{
    return (double)fin->start + ((double)fin->end - (double)fin->start) * at;
}

/* Returns the point of a fin's base at position `at` and at depth `inside` below the skin. The base
 * of a fin on the body runs along x. The base of the tail fin is vertical and lies inside the tail
 * stalk. For the tail fin, `at` = 0 is the top of the base, and `inside` is ignored. */
static v3d fin_base(const struct key_text *key, enum species_part part, double at, double inside)
{
    const struct fin *fin = &key->fins[part];
    const double x = base_x(fin, at);
    const struct station s = shape_section(key, fmin(fmax(x, 0.0), 1.0));
    switch (part) {
    case PART_TAIL:
        return tail_root(key, at);
    case PART_DORSAL:
    case PART_DORSAL_2:
        return (v3d){ 0.0, (double)s.offset + 0.5 * (double)s.depth - inside, x };
    case PART_ANAL:
        return (v3d){ 0.0, (double)s.offset - 0.5 * (double)s.depth + inside, x };
    default: {
        const double u = shape_body_u(key, x);
        const v3d skin = shape_body_point(key, u, (double)fin->girth);
        return v3d_muladd(skin, shape_body_normal(key, u, (double)fin->girth), -inside);
    }
    }
}

/* Returns the direction of a ray at fraction `r` of its length.
 *
 * For the dorsal and the anal fin, sweep_deg is the angle by which the ray leans backward, and 0 is
 * perpendicular to the body. For the tail fin, sweep_deg is the angle by which the ray is raised,
 * and 0 is straight backward. In these fins, side_deg is the angle by which the ray turns to the
 * right. The turn increases toward the tip.
 *
 * For a right paired fin, sweep_deg is the angle by which the ray leans backward, and 0 is straight
 * to the right. side_deg is the angle by which the ray is raised. */
static v3d fin_direction(const struct fin *fin, enum species_part part, struct ray ray, double r)
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
        return (v3d){ sin(side), s * cos(side), c * cos(side) };
    case PART_DORSAL:
    case PART_DORSAL_2:
        return (v3d){ sin(side), c * cos(side), s * cos(side) };
    case PART_ANAL:
        return (v3d){ sin(side), -c * cos(side), s * cos(side) };
    default:
        return (v3d){ c * cos(side), c * sin(side), s };
    }
}

/* Returns a point of the ray at position `at` of the fin's base. `along` is 0 where the ray leaves
 * the skin, and 1 at the tip of the ray. The drawn length of a ray includes the part below the
 * skin, so the visible length is shorter by the depth of the root. */
static v3d ray_point(const struct key_text *key, enum species_part part, double at, double along)
{
    const struct fin *fin = &key->fins[part];
    struct ray ray;
    shape_interpolate(fin->rays, 4, fin->ray_count, false,
                      part == PART_TAIL ? tail_at(key, at) : at, &ray);
    const double length = (double)ray.length;
    const double sink = part == PART_TAIL ? 0.0 : sink_at(key, base_x(fin, at));
    const double shown = fmax(length - sink, SHOWN_MIN);
    v3d p = fin_base(key, part, at, 0.0);
    for (int i = 0; i < RAY_STEPS; i++) {
        const double r = along * (i + 0.5) / RAY_STEPS;
        p = v3d_muladd(p, fin_direction(fin, part, ray, r), shown * along / RAY_STEPS);
    }
    if (part == PART_TAIL) {
        /* The tail fin is flat at the tail stalk and reaches its full sideways extent only behind
         * the stalk. Otherwise the tail fin would cut through the sides of the stalk. */
        const double start = shape_body_end(key);
        const double side = key->double_tail ? (at < 0.5) - (at > 0.5) : 1.0;
        p.x *= side * fmin(fmax((p.z - start) / CUP_OPENS, 0.0), 1.0);
    }
    return p;
}

/* Returns the distance of `p` from the body's axis, divided by the distance of the skin from the
 * body's axis in this direction. The result is 1 on the skin, smaller inside the body and larger
 * outside. In front of the snout and behind the body, the result is always CLEAR_OF. */
static double skin_distance_ratio(const struct key_text *key, v3d p)
{
    const double end = shape_body_end(key);
    if (p.z >= end || p.z <= 0.0) {
        return CLEAR_OF;
    }
    const struct station s = shape_section(key, fmin(p.z, 1.0));
    const double left = p.z > 1.0 ? closing((p.z - 1.0) / (end - 1.0)) : 1.0;
    const double e = (double)s.exponent;
    const double x = fabs(p.x) / (0.5 * (double)s.width * left);
    const double y = fabs(p.y - (double)s.offset) / (0.5 * (double)s.depth * left);
    return pow(pow(x, e) + pow(y, e), 1.0 / e);
}

/* Returns the root of a ray (along = 0) or a point of the ray's visible part (along > 0), as if the
 * fin were separate. shape_fin_point() merges an eel's dorsal and anal fins with the tail fin. */
static v3d own_point(const struct key_text *key, enum species_part part, double at, double along)
{
    if (along <= 0.0) {
        return fin_base(key, part, at, sink_at(key, base_x(&key->fins[part], at)));
    }
    if (part == PART_PECTORAL || part == PART_PELVIC) {
        /* A point of a folded paired fin that is inside the body is moved away from the body's
         * axis until the point is just outside the skin. */
        const v3d p = ray_point(key, part, at, along);
        const double out = skin_distance_ratio(key, p);
        if (out >= CLEAR_OF || out < 1e-3) {
            return p;
        }
        const double middle = (double)shape_section(key, fmin(p.z, 1.0)).offset;
        const double k = CLEAR_OF / out;
        return (v3d){ p.x * k, middle + (p.y - middle) * k, p.z };
    }
    /* `exit` is the fraction of the ray's length at which the ray leaves the body. */
    double exit = 0.0;
    while (exit < EXIT_MAX && skin_distance_ratio(key, ray_point(key, part, at, exit)) < CLEAR_OF) {
        exit += 1.0 / EXIT_STEPS;
    }
    exit = fmin(exit, EXIT_MAX);
    return ray_point(key, part, at, exit + (1.0 - exit) * along);
}

v3d shape_fin_point(const struct key_text *key, enum species_part part, double at, double along)
{
    CORE_ASSERT(part < PART_COUNT);
    CORE_ASSERT(key->fins[part].ray_count >= 2);
    const v3d own = own_point(key, part, at, along);
    const bool is_seam = key->confluent && (part == PART_DORSAL || part == PART_ANAL);
    const double t = is_seam ? fmax((at - JOIN_FROM) / (1.0 - JOIN_FROM), 0.0) : 0.0;
    /* `share` is the weight with which an eel's dorsal or anal fin takes the shape of the tail fin
     * at position `at`. 0 means that the two fins are separate at this position. */
    const double share = t * t * (3.0 - 2.0 * t);
    if (share <= 0.0) {
        return own;
    }
    const v3d tail = own_point(key, PART_TAIL, part == PART_DORSAL ? 0.0 : 1.0, along);
    return v3d_muladd(v3d_muladd((v3d){ 0.0, 0.0, 0.0 }, own, 1.0 - share), tail, share);
}

v3d shape_fin_normal(const struct key_text *key, enum species_part part, double at, double along)
{
    const double d = 1e-3;
    const v3d across = v3d_sub(ray_point(key, part, fmin(at + d, 1.0), along),
                               ray_point(key, part, fmax(at - d, 0.0), along));
    const v3d out = v3d_sub(ray_point(key, part, at, fmin(along + d, 1.0)),
                            ray_point(key, part, at, fmax(along - d, 0.0)));
    return v3d_unit(v3d_cross(across, out));
}

v3d shape_finlet_point(const struct key_text *key, uint32_t row, double at, uint32_t corner)
{
    CORE_ASSERT(row < 2);
    CORE_ASSERT(corner < 3);
    CORE_ASSERT(key->finlets[row].count > 0);
    const struct finlets *f = &key->finlets[row];
    const double length = (double)f->end - (double)f->start;
    const double base = corner == 1 ? FINLET_BASE * length / f->count : 0.0;
    const double x = (double)f->start + at * length + base;
    const struct station s = shape_section(key, fmin(x, 1.0));
    const double up = row == 0 ? 1.0 : -1.0;
    const double sink = fmin(FIN_SINK, SINK_SHARE * (double)s.depth);
    const v3d root = { 0.0, (double)s.offset + up * (0.5 * (double)s.depth - sink), x };
    if (corner < 2) {
        return root;
    }
    const double sweep = (double)f->sweep_deg * PI / 180.0;
    return v3d_muladd(root, (v3d){ 0.0, up * cos(sweep), sin(sweep) }, (double)f->length + sink);
}
