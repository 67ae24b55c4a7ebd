/* carried_separation.c -- separates carried fish, each modelled as a capsule in the plane of the
 * paper. */
#include "core/poi/catch/carried_fish.h"

#include "core/base/panic.h"
#include "core/poi/poi.h"

/* Half the length of the axis of the capsule that models a fish, in body lengths. The capsule
 * excludes the thin snout and tail fin. */
#define SPINE_HALF 0.30f
/* Radius of the capsule as a fraction of the body's extent in the plane. The fraction is less than
 * one half, because bodies taper. */
#define GIRTH 0.36f
/* Largest distance by which a fish is moved in one tick to separate overlapping fish. The value
 * equals 0.18 m/s. */
#define PUSH_MAX_M 0.0015f
/* Distance between the fish's centre and the ring when the fish's belly touches the ring. */
#define WALL_M 0.004f
/* Overlap above which a fish is pushed over the ring, as a fraction of the sum of the two capsule
 * radii. */
#define SQUEEZE 0.5f

struct flat { /* Point or vector in the plane of the paper. */
    float x, z;
};

struct capsule {
    struct flat centre, axis; /* Centre of the capsule, and the unit vector along its axis. */
    float half_m, radius_m;
};

static struct capsule capsule_of(const struct carried_fish *carried, const struct fish *fish)
{
    CORE_ASSERT(fish->length_m > 0.0f);
    return (struct capsule){
        .centre = { carried->x_m, carried->z_m },
        .axis = { f_sin(carried->heading_rad), f_cos(carried->heading_rad) },
        .half_m = SPINE_HALF * fish->length_m,
        .radius_m = GIRTH * f_lerp(fish->width_m, fish->height_m, carried->lie),
    };
}

static struct flat capsule_point_at(const struct capsule *capsule, float way_m)
{
    return (struct flat){ capsule->centre.x + way_m * capsule->axis.x,
                          capsule->centre.z + way_m * capsule->axis.z };
}

/* Returns the vector from the point `from` to the nearest point of the capsule's axis. */
static struct flat to_axis(struct flat from, const struct capsule *capsule)
{
    const float x = from.x - capsule->centre.x, z = from.z - capsule->centre.z;
    const float way =
        f_clamp(x * capsule->axis.x + z * capsule->axis.z, -capsule->half_m, capsule->half_m);
    const struct flat on = capsule_point_at(capsule, way);
    return (struct flat){ on.x - from.x, on.z - from.z };
}

static float square_m2(struct flat way)
{
    return way.x * way.x + way.z * way.z;
}

static bool axes_cross(const struct capsule *a, const struct capsule *b)
{
    const float cross = a->axis.x * b->axis.z - a->axis.z * b->axis.x;
    const float x = b->centre.x - a->centre.x, z = b->centre.z - a->centre.z;
    if (f_abs(cross) < 1e-4f) {
        return false; /* Parallel axes do not cross; the caller tests the ends of the axes. */
    }
    const float on_a = (x * b->axis.z - z * b->axis.x) / cross;
    const float on_b = (x * a->axis.z - z * a->axis.x) / cross;
    return f_abs(on_a) < a->half_m && f_abs(on_b) < b->half_m;
}

/* Returns the shortest vector from the axis of `a` to the axis of `b`. If the axes cross, returns a
 * very short vector in the direction from the centre of `a` to the centre of `b`. */
static struct flat axis_gap(const struct capsule *a, const struct capsule *b)
{
    struct flat best = { b->centre.x - a->centre.x, b->centre.z - a->centre.z };
    if (axes_cross(a, b)) {
        const float length = f_max(f_sqrt(square_m2(best)), 1e-6f);
        return (struct flat){ 1e-6f * best.x / length, 1e-6f * best.z / length };
    }
    for (int end = -1; end <= 1; end += 2) {
        const struct flat out = to_axis(capsule_point_at(a, (float)end * a->half_m), b);
        const struct flat in = to_axis(capsule_point_at(b, (float)end * b->half_m), a);
        best = square_m2(out) < square_m2(best) ? out : best;
        best = square_m2(in) < square_m2(best) ? (struct flat){ -in.x, -in.z } : best;
    }
    return best;
}

static float overlap_m(const struct capsule *a, const struct capsule *b, struct flat *out)
{
    const float reach_m = a->half_m + a->radius_m + b->half_m + b->radius_m;
    const struct flat apart = { b->centre.x - a->centre.x, b->centre.z - a->centre.z };
    if (square_m2(apart) >= reach_m * reach_m) {
        return -1.0f;
    }
    const struct flat way = axis_gap(a, b);
    const float length_m = f_sqrt(square_m2(way));
    *out = length_m > 1e-9f ? (struct flat){ way.x / length_m, way.z / length_m }
                            : (struct flat){ a->axis.z, -a->axis.x };
    return a->radius_m + b->radius_m - length_m;
}

/* Pushes a fish by (x_m, z_m). The fish stays within a ring of the inner radius `radius_m` unless
 * `is_squeezed` is set. */
static void push_within_ring(struct carried_fish *carried, float radius_m, float x_m, float z_m,
                             bool is_squeezed)
{
    const float wall_m = radius_m - WALL_M;
    const float before_m = f_sqrt(carried->x_m * carried->x_m + carried->z_m * carried->z_m);
    carried->x_m += x_m;
    carried->z_m += z_m;
    const float now_m = f_sqrt(carried->x_m * carried->x_m + carried->z_m * carried->z_m);
    const float most_m = f_max(before_m, wall_m);
    if (now_m > most_m && !is_squeezed) {
        carried->x_m *= most_m / now_m;
        carried->z_m *= most_m / now_m;
    }
}

static void separate_carried(float radius_m, struct carried_fish *a, const struct fish *fish_a,
                             struct carried_fish *b, const struct fish *fish_b)
{
    CORE_ASSERT(a != b);
    const struct capsule one = capsule_of(a, fish_a), other = capsule_of(b, fish_b);
    struct flat out = { 0.0f, 0.0f };
    const float deep_m = overlap_m(&one, &other, &out);
    if (deep_m <= 0.0f) {
        return;
    }
    const float mass_a = fish_mass_kg(fish_a->length_m), mass_b = fish_mass_kg(fish_b->length_m);
    const float share_a = mass_b / (mass_a + mass_b);
    const float step_m = f_min(0.5f * deep_m, PUSH_MAX_M);
    const bool is_squeezed = deep_m > SQUEEZE * (one.radius_m + other.radius_m);
    push_within_ring(a, radius_m, -share_a * step_m * out.x, -share_a * step_m * out.z,
                     is_squeezed);
    push_within_ring(b, radius_m, (1.0f - share_a) * step_m * out.x,
                     (1.0f - share_a) * step_m * out.z, is_squeezed);
    /* Removes the speed with which the fish approach each other. Fish `a` gets the fraction
     * `share_a` of the change, and fish `b` gets the rest. */
    const float closing =
        (a->slide_x_m_s - b->slide_x_m_s) * out.x + (a->slide_z_m_s - b->slide_z_m_s) * out.z;
    if (closing > 0.0f) {
        a->slide_x_m_s -= share_a * closing * out.x;
        a->slide_z_m_s -= share_a * closing * out.z;
        b->slide_x_m_s += (1.0f - share_a) * closing * out.x;
        b->slide_z_m_s += (1.0f - share_a) * closing * out.z;
    }
}

void carried_separation_tick(struct poi *poi, const struct fish *fish)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    for (uint32_t i = 1; i < poi->carried_count; i++) {
        struct carried_fish *a = &poi->carried_fish[i];
        for (uint32_t k = 0; k < i && a->state == CARRIED_LYING; k++) {
            struct carried_fish *b = &poi->carried_fish[k];
            if (b->state == CARRIED_LYING) {
                separate_carried(poi_radius_m(poi), b, &fish[b->fish], a, &fish[a->fish]);
            }
        }
    }
}
