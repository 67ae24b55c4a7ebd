/* poi_pool.c -- implementation of poi_pool.h. */
#include "platform/render/poi_pool.h"

/* Number of samples along each side of the square around the paper. Neighbouring samples are 6.7 mm
 * apart. */
#define LINES 12u
/* Number of bisection steps. They narrow a range of some centimetres to a hundredth of a
 * millimetre. */
#define HALVINGS 12

/* Heights of the paper above the ring's centre, at the sample points on the paper. */
struct relief {
    uint32_t count;
    float height_m[LINES * LINES];
    float low_m, high_m;
};

static void survey(struct relief *relief, const struct scene_poi *poi)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const float radius_m = poi->ring_radius_m;
    *relief = (struct relief){ .low_m = 1.0f, .high_m = -1.0f };
    for (uint32_t i = 0; i < LINES * LINES; i++) {
        const float x = ((float)(i % LINES) + 0.5f) * (2.0f / (float)LINES) - 1.0f;
        const float z = ((float)(i / LINES) + 0.5f) * (2.0f / (float)LINES) - 1.0f;
        const float r2 = x * x + z * z;
        if (r2 > 1.0f) {
            continue;
        }
        const float height_m =
            radius_m * (x * axes.right.y + z * axes.back.y) - poi->sag_m * (1.0f - r2) * axes.up.y;
        relief->height_m[relief->count++] = height_m;
        relief->low_m = f_min(relief->low_m, height_m);
        relief->high_m = f_max(relief->high_m, height_m);
    }
}

/* Returns the mean depth of the water, over the whole paper, if the water's surface is at
 * `level_m`. */
static float mean_depth(const struct relief *relief, float level_m)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < relief->count; i++) {
        sum += f_max(level_m - relief->height_m[i], 0.0f);
    }
    return sum / (float)relief->count;
}

struct poi_pool poi_pool_of(const struct scene_poi *poi)
{
    struct poi_pool pool = { POI_NO_POOL_M, f_clamp(poi->water_m, 0.0f, POI_FILM_M) };
    const float depth_m = poi->water_m - pool.film_m;
    if (!(depth_m > 1e-5f)) {
        return pool;
    }
    struct relief relief;
    survey(&relief, poi);
    float low_m = relief.low_m, high_m = relief.high_m + depth_m;
    for (int i = 0; i < HALVINGS; i++) {
        const float middle_m = 0.5f * (low_m + high_m);
        if (mean_depth(&relief, middle_m) < depth_m) {
            low_m = middle_m;
        } else {
            high_m = middle_m;
        }
    }
    pool.level_m = poi->position_m.y + 0.5f * (low_m + high_m);
    return pool;
}
