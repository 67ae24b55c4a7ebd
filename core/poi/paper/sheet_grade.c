/* sheet_grade.c -- defines the paper grades and the random variation between sheets. */
#include "core/poi/paper/sheet.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"

/* Standard deviation of the strength between the sheets of one grade, as a fraction of the
 * strength. */
#define STRENGTH_SD 0.12f
/* Standard deviation of the strength between thick and thin patches of pulp (cloud()) within one
 * sheet, as a fraction of the strength. */
#define PATCH_SD 0.05f
/* Amplitude of the random strength from cell to cell, as a fraction of the strength. This variation
 * makes tears change direction. */
#define FLOC 0.05f
#define SPOT_COUNT 3u /* Number of thin spots in a sheet. */

/* Properties of the paper grades, strongest first. These values are the least certain constants of
 * the game. Sources:
 *
 *   areal mass   The value is a guess. Poi paper is similar to tissue, which has 14 to 25 g/m^2,
 *                and no maker publishes a value. All sellers but one give thinner paper a higher
 *                grade number.
 *   dry          The value is a guess: areal mass times 20 N m/g, which is the tensile index of a
 *                soft tissue (15 to 30 N m/g; kozo paper has 40 to 70).
 *   wet          The ratio to dry has a source: wet plain paper keeps less than a tenth of its
 *                strength, and wet-strength paper keeps 15 % or more. The table has 7 to 12.5 %,
 *                chosen in play tests, so that the grades differ noticeably.
 *   stiffness    The value is a guess: wet paper strains by 1 to 2 % before it breaks.
 *   STRENGTH_SD  The value is a guess. Contestants choose among pois by eye, so that pois of one
 *                grade do differ.
 *   FLOC, spots  The values are a guess. Contestants in finals choose pois by thin places and by
 *                fibre direction, so that both exist.
 *
 * The section Calibrate of README.md describes how to measure the wet strength with weights, and
 * `kingyoctl paper --calibrate` converts the weights into a line of this table. */
static const struct paper_grade grades[SHEET_GRADE_MAX - SHEET_GRADE_MIN + 1u] = {
    { .areal_kg_m2 = 0.024f, .dry_n_m = 480.0f, .wet_n_m = 60.0f, .stiffness_n_m = 2800.0f },
    { .areal_kg_m2 = 0.020f, .dry_n_m = 400.0f, .wet_n_m = 45.0f, .stiffness_n_m = 2300.0f },
    { .areal_kg_m2 = 0.017f, .dry_n_m = 340.0f, .wet_n_m = 32.0f, .stiffness_n_m = 2000.0f },
    { .areal_kg_m2 = 0.014f, .dry_n_m = 280.0f, .wet_n_m = 20.0f, .stiffness_n_m = 1600.0f },
};

static float cube_root(float x)
{
    CORE_ASSERT(x >= 0.0f);
    return x < 1e-30f ? 0.0f : f_exp(f_log(x) * (1.0f / 3.0f));
}

const struct paper_grade *sheet_grade(uint8_t grade)
{
    CORE_ASSERT(grade >= SHEET_GRADE_MIN);
    CORE_ASSERT(grade <= SHEET_GRADE_MAX);
    return &grades[grade - SHEET_GRADE_MIN];
}

/* Returns (Y * p^2 * a^2)^(1/3), the common factor of the tensions at the centre and at the edge. Y
 * is the stiffness, p is the pressure, and a is the radius. */
static float hencky(const struct paper_grade *grade, float pressure_pa, float radius_m)
{
    CORE_ASSERT(radius_m > 0.0f);
    const float pa = pressure_pa * radius_m;
    return cube_root(grade->stiffness_n_m * pa * pa);
}

float sheet_tension_centre(const struct paper_grade *grade, float pressure_pa, float radius_m)
{
    return 0.423f * hencky(grade, pressure_pa, radius_m);
}

float sheet_tension_edge(const struct paper_grade *grade, float pressure_pa, float radius_m)
{
    return 0.328f * hencky(grade, pressure_pa, radius_m);
}

float sheet_belly(const struct paper_grade *grade, float pressure_pa, float radius_m)
{
    CORE_ASSERT(radius_m > 0.0f);
    const float strain = f_abs(pressure_pa) * radius_m / grade->stiffness_n_m;
    return 0.662f * radius_m * cube_root(strain);
}

struct spot {
    float x_m, z_m, radius_m, loss;
};

/* Returns smooth random noise that imitates thick and thin patches of pulp about four cells wide.
 * The noise is interpolated between random values on a coarse lattice. */
static float cloud(uint32_t seed, uint32_t column, uint32_t row)
{
    const uint32_t cx = column / 4u, cz = row / 4u;
    const float fx = (float)(column % 4u) * 0.25f, fz = (float)(row % 4u) * 0.25f;
    float corner[4];
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t at = (cz + i / 2u) * 16u + cx + i % 2u;
        corner[i] = rng_normal((struct rng_key){ seed, 1, at, RNG_SHEET_STRENGTH });
    }
    return f_lerp(f_lerp(corner[0], corner[1], fx), f_lerp(corner[2], corner[3], fx), fz);
}

static void init_cell(struct sheet *sheet, uint32_t row, uint32_t column, float whole,
                      uint32_t seed, const struct spot spots[SPOT_COUNT])
{
    CORE_ASSERT(row < SHEET_SIDE && column < SHEET_SIDE);
    const float x = sheet_line_m(sheet, column), z = sheet_line_m(sheet, row);
    const uint32_t cell = row * SHEET_SIDE + column;
    if (x * x + z * z >= sheet->radius_m * sheet->radius_m) {
        return;
    }
    const struct rng_key key = { seed, 3, cell, RNG_SHEET_STRENGTH };
    const float floc = rng_range(key, 1.0f - FLOC, 1.0f + FLOC);
    float strength = whole * floc * (1.0f + PATCH_SD * cloud(seed, column, row));
    for (uint32_t i = 0; i < SPOT_COUNT; i++) {
        const float dx = x - spots[i].x_m, dz = z - spots[i].z_m;
        const float near = (dx * dx + dz * dz) / (spots[i].radius_m * spots[i].radius_m);
        strength *= 1.0f - spots[i].loss * f_exp(-near);
    }
    sheet->state[cell] = CELL_PAPER;
    sheet->strength[cell] = f_max(strength, 0.4f);
    sheet->strength_min = f_min(sheet->strength_min, sheet->strength[cell]);
    sheet->paper_cells_new++;
}

void sheet_init(struct sheet *sheet, uint8_t grade, float radius_m, uint32_t seed)
{
    CORE_ASSERT(sheet_grade(grade) != 0);
    CORE_ASSERT(radius_m > 0.0f);
    memset(sheet, 0, sizeof *sheet);
    sheet->grade = grade;
    sheet->radius_m = radius_m;
    sheet->strength_min = 2.0f;
    const float fibre = F_PI * rng_unit((struct rng_key){ seed, 2, 0, RNG_SHEET_STRENGTH });
    sheet->fibre_x = f_cos(fibre);
    sheet->fibre_z = f_sin(fibre);
    struct spot spots[SPOT_COUNT];
    for (uint32_t i = 0; i < SPOT_COUNT; i++) {
        const float angle = F_TAU * rng_unit((struct rng_key){ seed, i, 0, RNG_SHEET_SPOT });
        const struct rng_key far = { seed, i, 1, RNG_SHEET_SPOT };
        const struct rng_key wide = { seed, i, 2, RNG_SHEET_SPOT };
        const struct rng_key deep = { seed, i, 3, RNG_SHEET_SPOT };
        const float reach = radius_m * f_sqrt(rng_unit(far));
        spots[i] = (struct spot){
            .x_m = reach * f_cos(angle),
            .z_m = reach * f_sin(angle),
            .radius_m = rng_range(wide, 0.003f, 0.007f),
            .loss = rng_range(deep, 0.08f, 0.22f),
        };
    }
    const float normal = rng_normal((struct rng_key){ seed, 0, 0, RNG_SHEET_STRENGTH });
    const float whole = 1.0f + STRENGTH_SD * f_clamp(normal, -2.5f, 2.5f);
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        for (uint32_t column = 0; column < SHEET_SIDE; column++) {
            init_cell(sheet, row, column, whole, seed, spots);
        }
    }
    sheet->paper_cells = sheet->paper_cells_new;
}

void sheet_idealise(struct sheet *sheet)
{
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet->strength[cell] = sheet->strength[cell] > 0.0f ? 1.0f : 0.0f;
    }
    sheet->strength_min = 1.0f;
    sheet->ideal = true;
}
