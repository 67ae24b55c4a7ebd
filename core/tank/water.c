/* water.c -- the water surface as a damped wave equation on a grid of cells; walls reflect waves.
 *
 * A step is 1/60 s and a cell is about 7 mm wide. Waves travel at 0.23 m/s, the lowest speed of
 * ripples on real water (the capillary-gravity minimum). The low speed also keeps the explicit
 * scheme stable. */
#include "core/tank/water.h"

#include "core/base/hash.h"
#include "core/base/mem.h"

#define WAVE_SPEED_M_S 0.23f
#define STEP_S (1.0f / 60.0f)
/* Fraction of the vertical velocity that remains after a step; waves decay in about a second. */
#define WAVE_KEEP 0.986f
/* Fraction of the height that remains after a step; the surface returns to height 0. */
#define LEVEL_KEEP 0.9985f
/* Limit of (c * dt / dx)^2 along each axis, where c is the wave speed, dt the step and dx the cell
 * size. The explicit scheme diverges if the sum over both axes reaches 1. */
#define COURANT_MAX 0.45f
/* Largest height of a wave. Higher waves would leave a tank whose walls stand 6 cm above the
 * water. */
#define HEIGHT_MAX_M 0.02f
/* Factor that converts a slope to the 8-bit integer of struct scene (scene.h), in which +-127 means
 * a slope of +-0.25. */
#define SLOPE_SCALE 508.0f

void water_init(struct water *water)
{
    memset(water, 0, sizeof *water);
}

/* Returns the depth of a push at a point as a fraction of the depth at the centre of the push. `s`
 * is the squared distance from the centre divided by the squared radius. The result is < 0 in the
 * raised rim of the push and 0 from the radius outward. The volume of the push is zero, because
 * water is incompressible. */
static float press_profile(float s)
{
    return s < 1.0f ? (1.0f - s) * (1.0f - s) * (1.0f - 4.0f * s) : 0.0f;
}

/* First and last cell whose centre can lie within `radius` cells of the position `at`. If `first`
 * is greater than `last`, no cell lies within the radius. */
struct span {
    int32_t first, last;
};

static struct span span_of(float at, float radius, int32_t count)
{
    const float low = f_clamp(at - radius, -1.0f, (float)count);
    const float high = f_clamp(at + radius, -1.0f, (float)count);
    const struct span span = { (int32_t)f_floor(low), (int32_t)f_floor(high) };
    return (struct span){ span.first < 0 ? 0 : span.first,
                          span.last >= count ? count - 1 : span.last };
}

/* Changes the heights of the current step and of the previous step equally. Therefore the push adds
 * no velocity, and waves start from rest. */
void water_press(struct water *water, vec3 size_m, vec3 point_m, float radius_m, float depth_m)
{
    if (f_abs(point_m.x) > 0.5f * size_m.x || f_abs(point_m.z) > 0.5f * size_m.z) {
        return;
    }
    const float dx = size_m.x / (float)RIPPLE_X, dz = size_m.z / (float)RIPPLE_Z;
    /* Enlarges a radius that is too small for the cells of the grid. */
    const float reach_m = f_max(radius_m, 1.5f * f_max(dx, dz));
    const float at_x = (point_m.x + 0.5f * size_m.x) / dx - 0.5f;
    const float at_z = (point_m.z + 0.5f * size_m.z) / dz - 0.5f;
    const struct span columns = span_of(at_x, reach_m / dx, (int32_t)RIPPLE_X);
    const struct span rows = span_of(at_z, reach_m / dz, (int32_t)RIPPLE_Z);
    for (int32_t row = rows.first; row <= rows.last; row++) {
        for (int32_t column = columns.first; column <= columns.last; column++) {
            const float x = ((float)column - at_x) * dx, z = ((float)row - at_z) * dz;
            const float push = depth_m * press_profile((x * x + z * z) / (reach_m * reach_m));
            for (int layer = 0; layer < 2; layer++) {
                float *height = &water->height_m[layer][row][column];
                *height = f_clamp(*height - push, -HEIGHT_MAX_M, HEIGHT_MAX_M);
            }
        }
    }
}

float water_height_m(const struct water *water, vec3 size_m, float x_m, float z_m)
{
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
    /* At a wall, the missing neighbour cell has the height of the cell at the wall, which reflects
     * waves. */
    next[0] = next_height(now[0], next[0],
                          kx * (now[1] - now[0]) + kz * (above[0] - 2.0f * now[0] + below[0]));
    next[end] = next_height(now[end], next[end],
                            kx * (now[end - 1] - now[end]) +
                                kz * (above[end] - 2.0f * now[end] + below[end]));
}

static float courant(float cell_m)
{
    const float c = WAVE_SPEED_M_S * STEP_S / cell_m;
    return f_min(c * c, COURANT_MAX);
}

void water_step(struct water *water, vec3 size_m)
{
    const float kx = courant(size_m.x / (float)RIPPLE_X), kz = courant(size_m.z / (float)RIPPLE_Z);
    const uint32_t last = RIPPLE_Z - 1u;
    float(*now)[RIPPLE_X] = water->height_m[water->newest];
    float(*next)[RIPPLE_X] = water->height_m[1u - water->newest]; /* Heights of the previous
                                                                     step, which the new heights
                                                                     replace. */
    for (uint32_t row = 0; row <= last; row++) {
        const float *above = now[row == 0 ? 0 : row - 1u];
        const float *below = now[row == last ? last : row + 1u];
        step_row(next[row], now[row], above, below, kx, kz);
    }
    water->newest = (uint8_t)(1u - water->newest);
}

static int8_t slope_byte(float slope)
{
    return (int8_t)f_clamp(slope * SLOPE_SCALE, -127.0f, 127.0f);
}

void water_slopes(const struct water *water, vec3 size_m, int8_t slope[RIPPLE_Z][RIPPLE_X][2])
{
    const float per_x = 0.5f * (float)RIPPLE_X / size_m.x,
                per_z = 0.5f * (float)RIPPLE_Z / size_m.z;
    const float(*height)[RIPPLE_X] = water->height_m[water->newest];
    for (uint32_t row = 0; row < RIPPLE_Z; row++) {
        const float *above = height[row == 0 ? 0 : row - 1u];
        const float *below = height[row == RIPPLE_Z - 1u ? row : row + 1u];
        for (uint32_t column = 0; column < RIPPLE_X; column++) {
            const uint32_t left = column == 0 ? 0 : column - 1u;
            const uint32_t right = column == RIPPLE_X - 1u ? column : column + 1u;
            slope[row][column][0] = slope_byte((height[row][right] - height[row][left]) * per_x);
            slope[row][column][1] = slope_byte((below[column] - above[column]) * per_z);
        }
    }
}

uint64_t water_hash(uint64_t hash, const struct water *water)
{
    hash = hash_u32(hash, water->newest);
    return hash_floats(hash, &water->height_m[0][0][0], 2u * RIPPLE_Z * RIPPLE_X);
}
