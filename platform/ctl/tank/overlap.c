/* overlap.c -- finds overlapping bodies of fish with a grid. A cell is as wide as the largest
 * bounding sphere. Only the 3 x 3 cells around a body can therefore contain bodies that overlap the
 * body. */
#include "platform/ctl/tank/overlap.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "core/base/panic.h"

/* Two edges count as parallel if the sine of the angle between them is below this value. The cross
 * product of parallel edges gives no separating axis. */
#define PARALLEL 1e-6

static double double3_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Computes the oriented bounding box of a fish. The rotations are applied in the order yaw about
 * +y, pitch and roll. */
struct overlap_box overlap_box_of(const struct fish *fish)
{
    const double cy = cos((double)fish->angles.yaw_rad), sy = sin((double)fish->angles.yaw_rad);
    const double cp = cos((double)fish->angles.pitch_rad), sp = sin((double)fish->angles.pitch_rad);
    const double cr = cos((double)fish->angles.roll_rad), sr = sin((double)fish->angles.roll_rad);
    const double across[3] = { cy, 0.0, -sy }, over[3] = { sy * sp, cp, cy * sp };
    struct overlap_box box = {
        .centre_m = { (double)fish->position_m.x, (double)fish->position_m.y,
                      (double)fish->position_m.z },
        .axis[2] = { sy * cp, -sp, cy * cp },
        .half_m = { 0.5 * (double)fish->width_m, 0.5 * (double)fish->height_m,
                    0.5 * (double)fish->length_m },
    };
    for (int i = 0; i < 3; i++) {
        box.axis[0][i] = cr * across[i] - sr * over[i];
        box.axis[1][i] = cr * over[i] + sr * across[i];
    }
    box.reach_m = sqrt(double3_dot(box.half_m, box.half_m));
    return box;
}

static double shadow_m(const struct overlap_box *box, const double axis[3])
{
    return box->half_m[0] * fabs(double3_dot(box->axis[0], axis)) +
           box->half_m[1] * fabs(double3_dot(box->axis[1], axis)) +
           box->half_m[2] * fabs(double3_dot(box->axis[2], axis));
}

/* Computes axis number `n` of the fifteen axes that may separate two boxes: the three axes of each
 * box, and the cross product of each axis of `a` with each axis of `b`. Returns false for a cross
 * product of parallel axes. */
static bool separating_axis(const struct overlap_box *a, const struct overlap_box *b, int n,
                            double axis[3])
{
    if (n < 6) {
        memcpy(axis, n < 3 ? a->axis[n] : b->axis[n - 3], 3 * sizeof axis[0]);
        return true;
    }
    const double *u = a->axis[(n - 6) / 3], *v = b->axis[(n - 6) % 3];
    axis[0] = u[1] * v[2] - u[2] * v[1];
    axis[1] = u[2] * v[0] - u[0] * v[2];
    axis[2] = u[0] * v[1] - u[1] * v[0];
    const double length = sqrt(double3_dot(axis, axis));
    for (int k = 0; k < 3; k++) {
        axis[k] /= length;
    }
    return length >= PARALLEL;
}

double overlap_depth_m(const struct overlap_box *a, const struct overlap_box *b)
{
    double d[3], axis[3], least_m = INFINITY;
    for (int i = 0; i < 3; i++) {
        d[i] = b->centre_m[i] - a->centre_m[i];
    }
    for (int n = 0; n < 15; n++) {
        if (separating_axis(a, b, n, axis)) {
            const double overlap_m =
                shadow_m(a, axis) + shadow_m(b, axis) - fabs(double3_dot(d, axis));
            if (overlap_m <= 0.0) {
                return 0.0;
            }
            least_m = fmin(least_m, overlap_m);
        }
    }
    return least_m;
}

/* ---- All pairs of fish ----------------------------------------------------------------------- */

/* A grid of square cells over the floor of the tank. */
struct floor_grid {
    double side_m, half_x_m, half_z_m;
    uint32_t columns, rows;
};

static uint32_t cell_along(double place_m, double half_m, double side_m, uint32_t count)
{
    return (uint32_t)fmin(fmax(floor((place_m + half_m) / side_m), 0.0), (double)(count - 1u));
}

/* Sorts the boxes by grid cell with a counting sort. Afterwards the boxes in cell c are
 * order[first[c]] .. order[first[c + 1] - 1]. */
static void sort_by_cell(struct overlap *overlap, const struct floor_grid *grid)
{
    const uint32_t cells = grid->columns * grid->rows;
    memset(overlap->first, 0, (cells + 1u) * sizeof overlap->first[0]);
    for (uint32_t i = 0; i < overlap->count; i++) {
        const double *at = overlap->box[i].centre_m;
        overlap->cell[i] =
            cell_along(at[2], grid->half_z_m, grid->side_m, grid->rows) * grid->columns +
            cell_along(at[0], grid->half_x_m, grid->side_m, grid->columns);
        overlap->first[overlap->cell[i]]++;
    }
    for (uint32_t c = 1; c <= cells; c++) {
        overlap->first[c] += overlap->first[c - 1];
    }
    for (uint32_t i = overlap->count; i-- > 0;) {
        overlap->order[--overlap->first[overlap->cell[i]]] = i;
    }
}

/* Tests box `i` against the boxes of its own cell and of the neighbouring cells. Over all calls,
 * each pair of boxes is tested once. */
static void test_neighbours(const struct overlap *overlap, const struct floor_grid *grid,
                            uint32_t i, struct overlap_count *total)
{
    const uint32_t column = overlap->cell[i] % grid->columns;
    const uint32_t row = overlap->cell[i] / grid->columns;
    const uint32_t left = column > 0 ? column - 1u : 0u;
    const uint32_t right = column + 1u < grid->columns ? column + 1u : column;
    for (uint32_t r = row > 0 ? row - 1u : 0u; r <= row + 1u && r < grid->rows; r++) {
        const uint32_t begin = overlap->first[r * grid->columns + left];
        const uint32_t end = overlap->first[r * grid->columns + right + 1u];
        for (uint32_t k = begin; k < end; k++) {
            const struct overlap_box *a = &overlap->box[i], *b = &overlap->box[overlap->order[k]];
            const double x = a->centre_m[0] - b->centre_m[0], y = a->centre_m[1] - b->centre_m[1],
                         z = a->centre_m[2] - b->centre_m[2], both_m = a->reach_m + b->reach_m;
            if (overlap->order[k] > i && x * x + y * y + z * z < both_m * both_m) {
                const double depth_mm = 1000.0 * overlap_depth_m(a, b);
                total->deepest_mm = fmax(total->deepest_mm, depth_mm);
                total->pairs += depth_mm > OVERLAP_DEEP_MM ? 1u : 0u;
            }
        }
    }
}

void overlap_add(struct overlap *overlap, const struct tank *tank, struct overlap_count *total)
{
    const double x_m = (double)tank->size_m.x, z_m = (double)tank->size_m.z;
    double reach_m = 1e-3;
    CORE_ASSERT(tank->fish_count <= TANK_FISH_MAX && x_m > 0.0 && z_m > 0.0);
    overlap->count = 0;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        if (fish_swims(&tank->fish[i])) {
            overlap->box[overlap->count] = overlap_box_of(&tank->fish[i]);
            reach_m = fmax(reach_m, overlap->box[overlap->count++].reach_m);
        }
    }
    const double side_m = fmax(2.0 * reach_m, fmax(x_m, z_m) / (double)(OVERLAP_CELL_MAX - 1u));
    const struct floor_grid grid = {
        .side_m = side_m,
        .half_x_m = 0.5 * x_m,
        .half_z_m = 0.5 * z_m,
        .columns = cell_along(x_m, 0.0, side_m, OVERLAP_CELL_MAX) + 1u,
        .rows = cell_along(z_m, 0.0, side_m, OVERLAP_CELL_MAX) + 1u,
    };
    CORE_ASSERT(grid.columns <= OVERLAP_CELL_MAX && grid.rows <= OVERLAP_CELL_MAX);
    sort_by_cell(overlap, &grid);
    for (uint32_t i = 0; i < overlap->count; i++) {
        test_neighbours(overlap, &grid, i, total);
    }
}

/* ---- Encounters ------------------------------------------------------------------------------ */

/* Returns true if the personal spaces of two fish overlap. */
static bool spaces_overlap(const struct tank *tank, const struct tank_meeting *pair)
{
    struct box spaces[2];
    for (uint32_t i = 0; i < 2; i++) {
        const struct fish *fish = &tank->fish[i == 0 ? pair->low : pair->high];
        const float margin_m = tank->space * fish->length_m;
        spaces[i] = fish_box(fish);
        spaces[i].half_m = v3_add(spaces[i].half_m, v3(margin_m, margin_m, margin_m));
    }
    return box_depth_m(&spaces[0], &spaces[1]) > 0.0f;
}

/* Appends a pair to the list of open pairs, and links the pair to the older open pairs whose member
 * `low` is the same fish. */
static void open_pair(struct tank_meetings *meetings, const struct tank_meeting *pair)
{
    CORE_ASSERT(meetings->open_count < TANK_MEETINGS_OPEN_MAX && pair->low < TANK_FISH_MAX);
    struct tank_meeting *added = &meetings->open[meetings->open_count++];
    *added = *pair;
    added->older = meetings->newest[pair->low];
    meetings->newest[pair->low] = meetings->open_count;
}

static void remove_separated_pairs(struct tank_meetings *meetings, const struct tank *tank,
                                   uint32_t ticks)
{
    const uint32_t count = meetings->open_count;
    meetings->open_count = 0;
    memset(meetings->newest, 0, tank->fish_count * sizeof meetings->newest[0]);
    for (uint32_t i = 0; i < count; i++) {
        struct tank_meeting pair = meetings->open[i];
        pair.apart_ticks = spaces_overlap(tank, &pair) ? 0 : pair.apart_ticks + ticks;
        if (pair.apart_ticks < TANK_MEETINGS_PART_TICKS) {
            /* The list may be changed inside the loop, because open_pair() writes at or before
             * index `i` and the entry at `i` has already been read. */
            open_pair(meetings, &pair);
        }
    }
}

static void tank_meetings_begin(struct tank_meetings *meetings, const struct fish *fish,
                                fish_index index)
{
    const fish_index with = fish->avoid_with;
    const struct tank_meeting pair = { index < with ? index : with, index < with ? with : index, 0,
                                       0 };
    for (uint32_t at = meetings->newest[pair.low]; at > 0; at = meetings->open[at - 1].older) {
        if (meetings->open[at - 1].high == pair.high) {
            /* The pair is already in the list of open pairs, so its encounter has been counted. */
            return;
        }
    }
    if (meetings->open_count < TANK_MEETINGS_OPEN_MAX) {
        open_pair(meetings, &pair);
    }
    meetings->head_on += fish->avoid_kind == MEET_HEAD_ON ? 1u : 0u;
    meetings->side += fish->avoid_kind == MEET_SIDE || fish->avoid_kind == MEET_STRUCK ? 1u : 0u;
    meetings->rear_end += fish->avoid_kind == MEET_REAR_END ? 1u : 0u;
}

void tank_meetings_update(struct tank_meetings *meetings, const struct tank *tank, uint32_t ticks)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        if (fish->avoiding != meetings->avoided[i]) {
            if (fish->avoiding == AVOID_YAW) {
                meetings->by_yaw++;
                tank_meetings_begin(meetings, fish, (fish_index)i);
            }
            meetings->by_pitch += fish->avoiding == AVOID_PITCH ? 1u : 0u;
            meetings->avoided[i] = fish->avoiding;
        }
    }
    meetings->unlooked_ticks += ticks;
    if (meetings->unlooked_ticks >= TANK_MEETINGS_SAMPLE_TICKS) {
        remove_separated_pairs(meetings, tank, meetings->unlooked_ticks);
        meetings->unlooked_ticks = 0;
    }
}
