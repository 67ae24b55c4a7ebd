/* water.c -- the water surface as a damped wave equation on a grid of cells, and the flow around a
 * moving disc (a poi, the paper scoop). Walls reflect waves.
 *
 * A step is 1/60 s and a cell is about 7 mm wide. Waves travel at 0.23 m/s, the lowest speed of
 * ripples on real water (the capillary-gravity minimum). The low speed also keeps the explicit
 * scheme stable.
 *
 * The flow around a disc that moves along its normal is the potential flow (Lamb, Hydrodynamics).
 * The flow around a disc that moves along its plane is an estimate. */
#include "core/tank/water.h"

#include "core/base/panic.h"

#define WAVE_SPEED_M_S 0.23f
#define STEP_S (1.0f / 60.0f)
/* Fraction of the vertical velocity of the surface that remains after one step of STEP_S. With this
 * value (design value) waves decay in about a second. */
#define WAVE_KEEP 0.986f
/* Fraction of the surface's height that remains after one step of STEP_S. The value is less than 1,
 * so that the surface returns to height 0. */
#define LEVEL_KEEP 0.9985f
/* Limit of the squared Courant number (c * dt / dx)^2 along each axis, where c is the wave speed,
 * dt is STEP_S and dx is the cell size. The explicit scheme diverges if the sum over both axes
 * reaches 1. */
#define COURANT_MAX 0.45f
/* Largest height of a wave above the still water surface. The limit keeps waves below the rim of
 * the tank, which is at least 3 cm above the surface in every preset. */
#define HEIGHT_MAX_M 0.02f
/* Factor that converts a slope to the 8-bit integer of struct scene (scene.h), in which +-127 means
 * a slope of +-0.25: 127 / 0.25 is 508. */
#define SLOPE_SCALE 508.0f

/* First and last cell, along one axis, whose centre can lie within `radius` cells of the position
 * `at`. If `first` is greater than `last`, no cell lies within the radius. */
struct span {
    int32_t first, last;
};

static struct span span_of(float at, float radius, int32_t count)
{
    CORE_ASSERT(radius > 0.0f);
    CORE_ASSERT(count > 0);
    const float low = f_clamp(at - radius, -1.0f, (float)count);
    const float high = f_clamp(at + radius, -1.0f, (float)count);
    const struct span span = { (int32_t)f_floor(low), (int32_t)f_floor(high) };
    return (struct span){ span.first < 0 ? 0 : span.first,
                          span.last >= count ? count - 1 : span.last };
}

/* Presses the surface down around a point. The layer of the current heights and the layer of the
 * previous heights change equally. Therefore the push adds no velocity, and the waves start from
 * rest. */
void water_press(struct water *water, vec3 size_m, vec3 point_m, float radius_m, float depth_m)
{
    CORE_ASSERT(size_m.x > 0.0f && size_m.z > 0.0f);
    CORE_ASSERT(radius_m > 0.0f);
    if (f_abs(point_m.x) > 0.5f * size_m.x || f_abs(point_m.z) > 0.5f * size_m.z) {
        return;
    }
    const float dx = size_m.x / (float)RIPPLE_X, dz = size_m.z / (float)RIPPLE_Z;
    /* The dent in the surface has a radius of at least 1.5 cells, because the grid cannot represent
     * a smaller dent. */
    const float reach_m = f_max(radius_m, 1.5f * f_max(dx, dz));
    const float at_x = (point_m.x + 0.5f * size_m.x) / dx - 0.5f;
    const float at_z = (point_m.z + 0.5f * size_m.z) / dz - 0.5f;
    const struct span columns = span_of(at_x, reach_m / dx, (int32_t)RIPPLE_X);
    const struct span rows = span_of(at_z, reach_m / dz, (int32_t)RIPPLE_Z);
    for (int32_t row = rows.first; row <= rows.last; row++) {
        for (int32_t column = columns.first; column <= columns.last; column++) {
            const float x = ((float)column - at_x) * dx, z = ((float)row - at_z) * dz;
            /* `push` is the depth in metres by which the cell is pressed down. The depth is
             * `depth_m` in the middle, negative in a raised rim, and 0 at the distance `reach_m`
             * and beyond. The rim has the same volume as the dent, because water is
             * incompressible. */
            const float s = (x * x + z * z) / (reach_m * reach_m);
            const float push =
                depth_m * (s < 1.0f ? (1.0f - s) * (1.0f - s) * (1.0f - 4.0f * s) : 0.0f);
            for (int layer = 0; layer < 2; layer++) {
                float *height = &water->height_m[layer][row][column];
                *height = f_clamp(*height - push, -HEIGHT_MAX_M, HEIGHT_MAX_M);
            }
        }
    }
}

float water_height_m(const struct water *water, vec3 size_m, float x_m, float z_m)
{
    CORE_ASSERT(size_m.x > 0.0f && size_m.z > 0.0f);
    CORE_ASSERT(water->newest < 2u);
    const float(*height)[RIPPLE_X] = water->height_m[water->newest];
    const float x =
        f_clamp((x_m / size_m.x + 0.5f) * (float)RIPPLE_X - 0.5f, 0.0f, (float)RIPPLE_X - 1.001f);
    const float z =
        f_clamp((z_m / size_m.z + 0.5f) * (float)RIPPLE_Z - 0.5f, 0.0f, (float)RIPPLE_Z - 1.001f);
    const uint32_t column = (uint32_t)x, row = (uint32_t)z;
    const float right = x - (float)column, near = z - (float)row;
    const float far_m = f_lerp(height[row][column], height[row][column + 1u], right);
    const float near_m = f_lerp(height[row + 1u][column], height[row + 1u][column + 1u], right);
    return f_lerp(far_m, near_m, near);
}

static float next_height(float now, float before, float curve)
{
    return LEVEL_KEEP * now + WAVE_KEEP * (now - before) + curve;
}

static void step_row(float *restrict next, const float *restrict now, const float *restrict above,
                     const float *restrict below, float kx, float kz)
{
    const int32_t end = (int32_t)RIPPLE_X - 1;
    for (int32_t i = 1; i < end; i++) {
        const float curve = kx * (now[i - 1] - 2.0f * now[i] + now[i + 1]) +
                            kz * (above[i] - 2.0f * now[i] + below[i]);
        next[i] = next_height(now[i], next[i], curve);
    }
    /* A cell at a wall has no neighbour cell beyond the wall. The formula uses the height of the
     * cell itself instead, so that the wall reflects waves. */
    next[0] = next_height(now[0], next[0],
                          kx * (now[1] - now[0]) + kz * (above[0] - 2.0f * now[0] + below[0]));
    next[end] = next_height(now[end], next[end],
                            kx * (now[end - 1] - now[end]) +
                                kz * (above[end] - 2.0f * now[end] + below[end]));
}

static float courant(float cell_m)
{
    CORE_ASSERT(cell_m > 0.0f);
    const float c = WAVE_SPEED_M_S * STEP_S / cell_m;
    return f_min(c * c, COURANT_MAX);
}

void water_step(struct water *water, vec3 size_m)
{
    CORE_ASSERT(size_m.x > 0.0f && size_m.z > 0.0f);
    CORE_ASSERT(water->newest < 2u);
    const float kx = courant(size_m.x / (float)RIPPLE_X), kz = courant(size_m.z / (float)RIPPLE_Z);
    const uint32_t last = RIPPLE_Z - 1u;
    float(*now)[RIPPLE_X] = water->height_m[water->newest];
    float(*next)[RIPPLE_X] = water->height_m[1u - water->newest]; /* Layer with the heights of the
                                                                     previous step. The new heights
                                                                     replace these heights. */
    for (uint32_t row = 0; row <= last; row++) {
        const float *above = now[row == 0 ? 0 : row - 1u];
        const float *below = now[row == last ? last : row + 1u];
        step_row(next[row], now[row], above, below, kx, kz);
    }
    water->newest = (uint8_t)(1u - water->newest);
}

void water_slopes(const struct water *water, vec3 size_m, int8_t slope[RIPPLE_Z][RIPPLE_X][2])
{
    CORE_ASSERT(size_m.x > 0.0f && size_m.z > 0.0f);
    CORE_ASSERT(water->newest < 2u);
    const float per_x = 0.5f * (float)RIPPLE_X / size_m.x;
    const float per_z = 0.5f * (float)RIPPLE_Z / size_m.z;
    const float(*height)[RIPPLE_X] = water->height_m[water->newest];
    for (uint32_t row = 0; row < RIPPLE_Z; row++) {
        const float *above = height[row == 0 ? 0 : row - 1u];
        const float *below = height[row == RIPPLE_Z - 1u ? row : row + 1u];
        for (uint32_t column = 0; column < RIPPLE_X; column++) {
            const uint32_t left = column == 0 ? 0 : column - 1u;
            const uint32_t right = column == RIPPLE_X - 1u ? column : column + 1u;
            const float slope_x = (height[row][right] - height[row][left]) * per_x;
            const float slope_z = (below[column] - above[column]) * per_z;
            slope[row][column][0] = (int8_t)f_clamp(slope_x * SLOPE_SCALE, -127.0f, 127.0f);
            slope[row][column][1] = (int8_t)f_clamp(slope_z * SLOPE_SCALE, -127.0f, 127.0f);
        }
    }
}

/* ---- Flow around a moving disc --------------------------------------------------------------- */

/* Speed of the water at the edge of a disc (a poi, the paper scoop) that moves along its own plane,
 * as a fraction of the disc's speed. */
#define EDGE_SHARE 0.16f
/* Smallest distance from the edge of a moving disc (a poi, the paper scoop), in disc radii, that
 * the formulas of the flow use. At the edge of an infinitely thin disc the formulas would give an
 * infinite speed. */
#define BODY_SHARE 0.3f
/* Half of the height range in which a horizontal disc (a poi, the paper scoop) enters the water. At
 * this height above the surface the disc counts as dry, and at this depth as completely
 * submerged. */
#define ENTRY_HALF_M 0.005f
#define STILL_M_S 1e-4f
/* Distance from the centre of a moving disc (a poi, the paper scoop), in disc radii, from which the
 * flow counts as zero. On the disc's axis at this distance, the water has a five-hundredth of the
 * disc's speed. */
#define FAR 6.0f

/* Position or velocity in the flow around a poi (paper scoop), which is modelled as a disc of
 * radius 1. `along` is the component along the disc's normal, and `off` is the component
 * perpendicular to the normal. */
struct place {
    float along, off;
};

/* Returns the velocity of the water at the point `at`, around a disc of radius 1 that moves with
 * speed 1 along its normal. The flow is the potential flow around a thin disc (Lamb,
 * Hydrodynamics). The formulas use the oblate spheroidal coordinates zeta and mu of the point.
 * These coordinates are defined by along = zeta * mu and off = sqrt((1 + zeta^2) * (1 - mu^2)). A
 * lower limit for zeta^2 + mu^2 keeps the velocity at the disc's sharp edge finite. */
static struct place broadside(struct place at)
{
    const float square = at.along * at.along + at.off * at.off - 1.0f;
    const float root = f_sqrt(square * square + 4.0f * at.along * at.along);
    const float zeta = f_sqrt(f_max(0.0f, 0.5f * (square + root)));
    const float size = f_sqrt(f_clamp(0.5f * (root - square), 0.0f, 1.0f));
    const float mu = at.along < 0.0f ? -size : size;
    const float zeta2 = zeta * zeta, mu2 = mu * mu;
    const float near = f_max(zeta2 + mu2, BODY_SHARE * BODY_SHARE);
    const float share = 2.0f / F_PI;
    return (struct place){
        .along = share * (0.5f * F_PI - f_atan2(zeta, 1.0f) - zeta / near),
        .off = share * mu * f_sqrt(f_max(0.0f, 1.0f - mu2)) / (near * f_sqrt(1.0f + zeta2)),
    };
}

vec3 water_flow_m_s(const struct obstacle *disc, vec3 point_m)
{
    CORE_ASSERT(disc->radius_m > 0.0f);
    /* Returns early for most points: points in the air or far from the disc, and any point if the
     * disc hardly moves. */
    const vec3 off_m = v3_sub(point_m, disc->centre_m), goes_m_s = obstacle_goes_m_s(disc);
    const float reach_m = FAR * disc->radius_m;
    if (disc->kind != OBSTACLE_DISC || point_m.y > 0.0f ||
        v3_dot(off_m, off_m) >= reach_m * reach_m ||
        v3_dot(goes_m_s, goes_m_s) <= STILL_M_S * STILL_M_S) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    const vec3 to = v3_scale(off_m, 1.0f / disc->radius_m);
    const float along = v3_dot(to, disc->normal);
    const vec3 flat = v3_muladd(to, disc->normal, -along);
    const struct place at = { along, v3_length(flat) };
    const vec3 out = v3_normalize_or(flat, v3(0.0f, 0.0f, 0.0f));
    const float normal_m_s = v3_dot(goes_m_s, disc->normal);
    const vec3 plane_m_s = v3_muladd(goes_m_s, disc->normal, -normal_m_s);
    const float pushing_m_s = (1.0f - disc->open) * normal_m_s;
    const struct place push = broadside(at);
    const vec3 pushed = v3_add(v3_scale(disc->normal, push.along), v3_scale(out, push.off));
    /* Around a disc (a poi, the paper scoop) that moves along its plane, the water moves in the
     * direction of the disc. The speed of the water decays with the cube of the distance from the
     * disc. */
    const float beyond = f_max(0.0f, at.off - 1.0f);
    const float gap = f_sqrt(at.along * at.along + beyond * beyond);
    const float near = 1.0f / (1.0f + f_max(BODY_SHARE, gap));
    const vec3 flow =
        v3_muladd(v3_scale(pushed, pushing_m_s), plane_m_s, EDGE_SHARE * near * near * near);
    /* The flow is multiplied by the fraction [0, 1] of the disc that is under water. The fraction
     * follows from the heights of the lowest and highest points of the disc. */
    const float slope = f_sqrt(f_max(0.0f, 1.0f - disc->normal.y * disc->normal.y));
    const float half_m = f_max(disc->radius_m * slope, ENTRY_HALF_M);
    return v3_limit(v3_scale(flow, f_clamp(0.5f - 0.5f * disc->centre_m.y / half_m, 0.0f, 1.0f)),
                    v3_length(goes_m_s));
}

float water_push_m2_s2(const struct obstacle *disc, vec3 point_m)
{
    return v3_length(obstacle_goes_m_s(disc)) * v3_length(water_flow_m_s(disc, point_m));
}
