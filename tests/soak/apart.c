/* apart.c -- implementation of apart.h: measures all kinds of overlap and the motion of the
 * fish. */
#include "tests/soak/apart.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Side of a grid cell. Two touching fish of 8 cm are never farther apart than this, so only
 * neighbouring cells must be searched for touching fish. */
#define CELL_M 0.11f
#define CELLS_MAX 2048u
#define RING_POINTS 96
#define REVERSAL_RAD_S (20.0f * F_DEG)
#define NEAR_WALL_M 0.03f

struct cells {
    uint32_t columns, rows;
    /* Linked lists of the fish in each cell. An entry is the index of a fish plus 1, and 0 ends the
     * list. */
    uint16_t first[CELLS_MAX], next[TANK_FISH_MAX];
};

static float half_diagonal_m(const struct fish *fish)
{
    return 0.5f * v3_length(v3(fish->width_m, fish->height_m, fish->length_m));
}

static float pair_depth_m(const struct fish *a, const struct fish *b)
{
    const vec3 d = v3_sub(b->position_m, a->position_m);
    const float reach_m = half_diagonal_m(a) + half_diagonal_m(b);
    if (v3_dot(d, d) >= reach_m * reach_m) {
        return 0.0f;
    }
    const struct box box_a = fish_box(a), box_b = fish_box(b);
    return box_gap(&box_a, 0.0f, &box_b, 0.0f).body_m >= 0.0f ? 0.0f : box_depth_m(&box_a, &box_b);
}

static uint32_t line_of(float at_m, float size_m, uint32_t count)
{
    const float line = (at_m + 0.5f * size_m) / CELL_M;
    return (uint32_t)f_clamp(line, 0.0f, (float)(count - 1u));
}

static uint32_t cell_of(const struct cells *cells, const struct tank *tank, vec3 at_m)
{
    return line_of(at_m.z, tank->size_m.z, cells->rows) * cells->columns +
           line_of(at_m.x, tank->size_m.x, cells->columns);
}

static void fill(struct cells *cells, const struct tank *tank)
{
    cells->columns = (uint32_t)(tank->size_m.x / CELL_M) + 1u;
    cells->rows = (uint32_t)(tank->size_m.z / CELL_M) + 1u;
    memset(cells->first, 0, sizeof cells->first);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        if (fish_swims(&tank->fish[i])) {
            const uint32_t cell = cell_of(cells, tank, tank->fish[i].position_m);
            cells->next[i] = cells->first[cell];
            cells->first[cell] = (uint16_t)(i + 1u);
        }
    }
}

/* Checks fish `i` for overlap with those fish of the cell that have a smaller index, so that each
 * pair is checked once. */
static void check_cell(struct apart *apart, const struct tank *tank, const struct cells *cells,
                       uint32_t i, uint32_t cell)
{
    for (uint32_t at = cells->first[cell]; at != 0; at = cells->next[at - 1u]) {
        const uint32_t j = at - 1u;
        if (j >= i) {
            continue;
        }
        const float depth_m = pair_depth_m(&tank->fish[i], &tank->fish[j]);
        apart->pair_m = f_max(apart->pair_m, depth_m);
        apart->pair_count += depth_m > APART_DEEP_M;
    }
}

static void check_pairs(struct apart *apart, const struct tank *tank)
{
    static struct cells cells;
    fill(&cells, tank);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        if (!fish_swims(&tank->fish[i])) {
            continue;
        }
        const uint32_t cell = cell_of(&cells, tank, tank->fish[i].position_m);
        const int column = (int)(cell % cells.columns), row = (int)(cell / cells.columns);
        for (int r = row - 1; r <= row + 1; r++) {
            for (int c = column - 1; c <= column + 1; c++) {
                if (r >= 0 && c >= 0 && r < (int)cells.rows && c < (int)cells.columns) {
                    check_cell(apart, tank, &cells, i, (uint32_t)r * cells.columns + (uint32_t)c);
                }
            }
        }
    }
}

float apart_all_pairs_m(const struct tank *tank)
{
    float deepest_m = 0.0f;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            if (fish_swims(&tank->fish[i]) && fish_swims(&tank->fish[j])) {
                deepest_m = f_max(deepest_m, pair_depth_m(&tank->fish[i], &tank->fish[j]));
            }
        }
    }
    return deepest_m;
}

/* ---- Walls, ring and hull ------------------------------------------------------------------- */

static void note(struct apart *apart, float *deepest_m, float depth_m)
{
    *deepest_m = f_max(*deepest_m, depth_m);
    apart->other_count += depth_m > APART_DEEP_M;
}

static void check_walls(struct apart *apart, const struct tank *tank, const struct fish *fish,
                        const struct box *box)
{
    const vec3 extent = box_extent_m(box), at = fish->position_m;
    const float beyond_x = f_abs(at.x) + extent.x - 0.5f * tank->size_m.x;
    const float beyond_z = f_abs(at.z) + extent.z - 0.5f * tank->size_m.z;
    const float over_m = fish->gait == GAIT_SURFACE ? fish->height_m + 0.003f : 0.0f;
    note(apart, &apart->wall_m, f_max(beyond_x, beyond_z));
    note(apart, &apart->floor_m, extent.y - at.y - tank->size_m.y);
    note(apart, &apart->surface_m, at.y + extent.y - over_m);
}

/* Returns the distance of a point from the surface of a box. The distance is negative if the point
 * is inside the box. */
static float from_box_m(const struct box *box, vec3 point_m)
{
    const vec3 p = vec_basis_to_body(&box->axes, v3_sub(point_m, box->centre_m));
    const vec3 q =
        v3(f_abs(p.x) - box->half_m.x, f_abs(p.y) - box->half_m.y, f_abs(p.z) - box->half_m.z);
    const vec3 out = v3(f_max(q.x, 0.0f), f_max(q.y, 0.0f), f_max(q.z, 0.0f));
    return v3_length(out) + f_min(f_max(q.x, f_max(q.y, q.z)), 0.0f);
}

static vec3 on_ring(const struct poi *poi, const struct basis *axes, float middle_m,
                    float angle_rad)
{
    const vec3 out =
        v3_add(v3_scale(axes->right, cosf(angle_rad)), v3_scale(axes->back, sinf(angle_rad)));
    return v3_muladd(poi->position_m, out, middle_m);
}

static float ring_depth_m(const struct poi *poi, const struct basis *axes, const struct box *box)
{
    const float tube_m = RING_TUBE_PER_RADIUS * POI_OUTER_RADIUS_M;
    const float middle_m = POI_OUTER_RADIUS_M - tube_m;
    const float step = F_TAU / RING_POINTS;
    float least_m = 1e9f, at_rad = 0.0f;
    for (int k = 0; k < RING_POINTS; k++) {
        const float m = from_box_m(box, on_ring(poi, axes, middle_m, step * (float)k));
        if (m < least_m) {
            least_m = m;
            at_rad = step * (float)k;
        }
    }
    for (int k = -16; k <= 16; k++) {
        const float angle_rad = at_rad + step * (float)k / 16.0f;
        least_m = f_min(least_m, from_box_m(box, on_ring(poi, axes, middle_m, angle_rad)));
    }
    return tube_m - least_m;
}

static void check_ring(struct apart *apart, const struct poi *poi, const struct box *box)
{
    const vec3 d = v3_sub(box->centre_m, poi->position_m);
    const float reach_m = POI_OUTER_RADIUS_M + v3_length(box->half_m);
    if (v3_dot(d, d) < reach_m * reach_m) {
        const struct basis axes = vec_basis_from_angles(poi->angles);
        note(apart, &apart->ring_m, ring_depth_m(poi, &axes, box));
    }
}

/* Returns the depth of a point inside the bowl's hull in m. The depth is a first-order
 * approximation of the distance to the hull's surface. The result is negative if the point is
 * outside. */
static float point_in_hull_m(const struct bowl *bowl, vec3 point_m)
{
    const vec3 p = v3_sub(point_m, bowl->position_m);
    const float wide = BOWL_RADIUS_M * BOWL_RADIUS_M, deep = BOWL_DEPTH_M * BOWL_DEPTH_M;
    if (p.y > 0.0f) {
        return -1.0f;
    }
    const float k = sqrtf((p.x * p.x + p.z * p.z) / wide + p.y * p.y / deep);
    const vec3 gradient = v3(p.x / wide, p.y / deep, p.z / wide);
    return (1.0f - k) * k / f_max(v3_length(gradient), 1e-6f);
}

static void check_hull(struct apart *apart, const struct bowl *bowl, const struct box *box)
{
    const float reach_m = BOWL_RADIUS_M + v3_length(box->half_m);
    const vec3 d = v3_sub(box->centre_m, bowl->position_m);
    float deepest_m = 0.0f;
    if (!bowl->present || v3_dot(d, d) > reach_m * reach_m) {
        return;
    }
    for (int i = 0; i < 9 * 9 * 17; i++) {
        const vec3 u = v3((float)(i % 9 - 4) * 0.25f, (float)(i / 9 % 9 - 4) * 0.25f,
                          (float)(i / 81 - 8) * 0.125f);
        const vec3 at = v3(u.x * box->half_m.x, u.y * box->half_m.y, u.z * box->half_m.z);
        const vec3 point_m = v3_add(box->centre_m, vec_basis_to_world(&box->axes, at));
        deepest_m = f_max(deepest_m, point_in_hull_m(bowl, point_m));
    }
    note(apart, &apart->hull_m, deepest_m);
}

/* ---- Speeds and turns of the fish ----------------------------------------------------------- */

static bool is_calm(const struct fish *fish)
{
    return fish->gait == GAIT_REST || fish->gait == GAIT_SWIM;
}

static void check_turn(struct apart *apart, const struct fish *fish, uint32_t i)
{
    const float turn_rad_s =
        f_wrap_angle(fish->angles.yaw_rad - apart->yaw_rad[i]) * (float)CORE_TICK_HZ;
    const int8_t side = turn_rad_s > REVERSAL_RAD_S ? 1 : turn_rad_s < -REVERSAL_RAD_S ? -1 : 0;
    apart->yaw_rad[i] = fish->angles.yaw_rad;
    if (!is_calm(fish) || !apart->known[i]) {
        return;
    }
    apart->yaw_rate_max_rad_s = f_max(apart->yaw_rate_max_rad_s, f_abs(turn_rad_s));
    if (side != 0) {
        apart->reversals += apart->turned[i] == -side;
        apart->turned[i] = side;
    }
}

static void check_pace(struct apart *apart, const struct tank *tank, const struct fish *fish,
                       uint32_t i)
{
    const uint32_t now = (uint32_t)apart->ticks;
    const float away_m = v3_length(v3_sub(fish->position_m, apart->spot_m[i]));
    if (fish->gait != GAIT_SWIM || away_m > APART_STUCK_M || !apart->known[i]) {
        apart->spot_m[i] = fish->position_m;
        apart->spot_tick[i] = now;
    }
    if (fish->gait == GAIT_SWIM) {
        const vec3 v = fish->velocity_m_s;
        /* Speed that the gait of a fish gives at this length and stamina, without the influence of
         * other fish or walls (section 3.3 of the 2013 thesis). */
        const float able = fish->length_m * (0.8f + 0.2f * fish->stamina);
        apart->speed_sum += (double)f_sqrt(v.x * v.x + v.z * v.z);
        apart->free_sum += (double)(able * tank_behavior_params(tank)->swim_speed);
        const float stuck_s = (float)(now - apart->spot_tick[i]) * CORE_TICK_S;
        apart->stuck_s = f_max(apart->stuck_s, stuck_s);
    }
}

static void check_fish(struct apart *apart, const struct tank *tank, uint32_t i)
{
    const struct fish *fish = &tank->fish[i];
    const struct box box = fish_box(fish);
    check_walls(apart, tank, fish, &box);
    check_turn(apart, fish, i);
    check_pace(apart, tank, fish, i);
    const float near_x = 0.5f * tank->size_m.x - f_abs(fish->position_m.x);
    const float near_z = 0.5f * tank->size_m.z - f_abs(fish->position_m.z);
    apart->by_wall += f_min(near_x, near_z) < NEAR_WALL_M;
    apart->fish_ticks++;
}

/* ---- Public functions ----------------------------------------------------------------------- */

void apart_init(struct apart *apart)
{
    memset(apart, 0, sizeof *apart);
}

static bool is_loose(const struct fish *fish)
{
    return fish->gait == GAIT_HELD && fish->holder >= POI_MAX;
}

void apart_check(struct apart *apart, const struct tank *tank, const struct poi *pois,
                 uint32_t poi_count, const struct bowl *bowls, uint32_t bowl_count)
{
    check_pairs(apart, tank);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        apart->loose_ticks[i] = is_loose(fish) ? apart->loose_ticks[i] + 1u : 0u;
        apart->loose_s = f_max(apart->loose_s, (float)apart->loose_ticks[i] * CORE_TICK_S);
        if (!fish_swims(fish)) {
            apart->known[i] = 0;
            continue;
        }
        check_fish(apart, tank, i);
        apart->known[i] = 1;
        const struct box box = fish_box(fish);
        for (uint32_t p = 0; p < poi_count; p++) {
            check_ring(apart, &pois[p], &box);
        }
        for (uint32_t b = 0; b < bowl_count; b++) {
            check_hull(apart, &bowls[b], &box);
        }
    }
    apart->ticks++;
}

float apart_deepest_m(const struct apart *apart)
{
    const float walls_m = f_max(apart->wall_m, f_max(apart->floor_m, apart->surface_m));
    return f_max(f_max(apart->pair_m, walls_m), f_max(apart->ring_m, apart->hull_m));
}

float apart_pace(const struct apart *apart)
{
    return (float)(apart->speed_sum / fmax(apart->free_sum, 1e-9));
}

float apart_reversals_per_s(const struct apart *apart)
{
    const double seconds = (double)apart->fish_ticks * (double)CORE_TICK_S;
    return (float)((double)apart->reversals / fmax(seconds, 1e-9));
}

float apart_wall_crowding(const struct apart *apart, const struct tank *tank)
{
    const float x = tank->size_m.x, z = tank->size_m.z;
    const float inner = (x - 2.0f * NEAR_WALL_M) * (z - 2.0f * NEAR_WALL_M);
    const double share = (double)apart->by_wall / fmax((double)apart->fish_ticks, 1.0);
    return (float)(share / (double)(1.0f - inner / (x * z)));
}
