/* loft_rings.c -- computes the positions of the rings along the body.
 *
 * The rings have equal body coordinates in every key, and are closer to each other where the
 * outline of any key bends. Between two rings the outline is a straight line. Its deviation from
 * the curve is proportional to the curvature multiplied by the square of the ring distance. A ring
 * density proportional to the square root of the curvature therefore gives an equal deviation
 * everywhere. */
#include "platform/species/loft_parts.h"

#include <math.h>

#define SAMPLES 256
/* Fraction of the rings that are evenly spaced. Evenly spaced rings are needed because the swimming
 * wave bends the whole body. */
#define EVEN_SHARE 0.30
/* Factor by which rings are denser on the head, because viewers look mostly at the mouth, the eyes
 * and the gill cover. */
#define HEAD_FAVOUR 1.9

/* Writes the outlines of a key at body coordinate `u` to `out`: height of the back, height of
 * the belly, and distance of the flank from the middle. The values are fractions of the key's
 * length. */
static void outline(const struct key_text *key, double u, double out[3])
{
    const struct station s = shape_section(key, shape_body_x(key, u));
    out[0] = (double)s.offset + 0.5 * (double)s.depth;
    out[1] = (double)s.offset - 0.5 * (double)s.depth;
    out[2] = 0.5 * (double)s.width;
}

/* Returns the largest curvature at body coordinate `u` of all outlines of all keys. */
static double bend(const struct species_text *species, double u)
{
    const double d = 1.0 / SAMPLES;
    double most = 0.0;
    for (uint32_t key = 0; key < species->key_count; key++) {
        double before[3], at[3], after[3];
        outline(&species->keys[key], u - d, before);
        outline(&species->keys[key], u, at);
        outline(&species->keys[key], u + d, after);
        for (int i = 0; i < 3; i++) {
            most = fmax(most, fabs(before[i] - 2.0 * at[i] + after[i]) / (d * d));
        }
    }
    return most;
}

/* Moves the nearest ring to the rear edge of the gill cover, where the head and the trunk meet. */
static void ring_at_gill(double *u, uint32_t count)
{
    uint32_t nearest = 0;
    for (uint32_t ring = 1; ring < count; ring++) {
        if (fabs(u[ring] - (double)GILL_U) < fabs(u[nearest] - (double)GILL_U)) {
            nearest = ring;
        }
    }
    u[nearest] = (double)GILL_U;
}

void loft_place_rings(const struct species_text *species, uint32_t count, double *u)
{
    double sum[SAMPLES + 1] = { 0.0 };
    for (int i = 0; i < SAMPLES; i++) {
        const double at = fmin(fmax((i + 0.5) / SAMPLES, 1.0 / SAMPLES), 1.0 - 1.0 / SAMPLES);
        sum[i + 1] = sum[i] + sqrt(bend(species, at)) * (at < (double)GILL_U ? HEAD_FAVOUR : 1.0);
    }
    const double even = EVEN_SHARE / (1.0 - EVEN_SHARE) * fmax(sum[SAMPLES], 1e-9) / SAMPLES;
    for (int i = 0; i <= SAMPLES; i++) {
        sum[i] += even * i;
    }
    int i = 0;
    for (uint32_t ring = 0; ring < count; ring++) {
        const double wanted = sum[SAMPLES] * (ring + 1) / count;
        while (i < SAMPLES - 1 && sum[i + 1] < wanted) {
            i++;
        }
        u[ring] = fmin((i + (wanted - sum[i]) / (sum[i + 1] - sum[i])) / SAMPLES, 1.0);
    }
    u[count - 1] = 1.0;
    ring_at_gill(u, count);
}
