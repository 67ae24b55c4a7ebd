/* shape_size.c -- computes the size of a drawing before the drawing is scaled to the species'
 * length measure. */
#include "platform/species/shape.h"

#include <math.h>

/* Number of sample points on the rear edge of a tail fin, among which the rearmost point is
 * searched. */
#define TIPS 64

static double widest(const struct key_text *key)
{
    double width = 0.0;
    for (uint32_t i = 0; i < key->substep_count; i++) {
        /* Only the stations are examined, because the body is nowhere wider than at its widest
         * station. */
        width = fmax(width, (double)key->stations[i].width);
    }
    return width;
}

static double hindmost(const struct key_text *key)
{
    double z = 1.0;
    for (int i = 0; i <= TIPS; i++) {
        z = fmax(z, shape_fin_point(key, PART_TAIL, (double)i / TIPS, 1.0).z);
    }
    return z;
}

double shape_unit_length(const struct key_text *key, enum species_measure measure)
{
    const bool tail = key->fins[PART_TAIL].ray_count > 0;
    switch (measure) {
    case MEASURE_DISC:
        return widest(key);
    case MEASURE_TOTAL:
        return tail ? hindmost(key) : 1.0;
    case MEASURE_FORK:
        return tail ? shape_fin_point(key, PART_TAIL, 0.5, 1.0).z : 1.0;
    default:
        return 1.0;
    }
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
