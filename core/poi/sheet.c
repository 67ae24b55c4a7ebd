/* sheet.c -- wetting, tension, damage and tears, cell by cell. */
#include "core/poi/sheet.h"

#include "core/base/hash.h"
#include "core/base/panic.h"

#define WET_TAU_S 1.0f     /* A cell under water loses its dry strength by this. */
#define SOAKED 0.9999f     /* Driest cell of a sheet that need not be looked at any more. */
#define WICK_M2_S 1.0e-6f  /* In-plane wicking: a front of about 1.4 mm after a second, sqrt(t). */
#define DAMAGE_TAU_S 0.05f /* Life of a cell at its ultimate tension ... */
#define LOAD_RATIO_MIN 0.25f /* ... and below this share of it, a day: ratio^10 is under 1e-6. */
#define EDGE_FACTOR 1.5f     /* Stress concentration along the ring, */
#define WET_LINE_FACTOR 2.5f /* along the line between wet and dry paper (swelling differs), */
#define TIP_FACTOR 2.5f      /* and in front of a tear. */
#define WET_LINE_STEP 0.5f   /* Difference of wetness over two cells that counts as a full line. */
#define FOOT_TENSION_MIN_N_M 0.3f /* A footprint is felt as far as this; less wears nothing. */
#define FIBRE_SHARE 0.25f /* A tear along the fibres needs so much less, across so much more. */
#define SAG_TAU_S 0.03f   /* The belly takes water along and cannot jump. */

/* ---- Water ---------------------------------------------------------------------------------- */

/* Dry paper drinks from wet paper. */
static float creep(const struct sheet *sheet, uint32_t cell, uint32_t other)
{
    return sheet->state[other] == CELL_PAPER ? sheet->wetness[other] - sheet->wetness[cell] : 0.0f;
}

/* Wets what is under water; elsewhere lets water creep. Row 0, column 0 and their opposites lie
 * outside the ring at their corners only, so borders are skipped: creep there is a cell's width. */
static void wet_cells(struct sheet *sheet, struct sheet_wetting wet)
{
    const float soak = 1.0f - f_exp(-CORE_TICK_S / WET_TAU_S);
    float driest = 1.0f;
    const float spread = WICK_M2_S * CORE_TICK_S / (sheet_cell_m(sheet) * sheet_cell_m(sheet));
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const uint32_t row = cell / SHEET_SIDE, column = cell % SHEET_SIDE;
        if (sheet->state[cell] != CELL_PAPER) {
            continue;
        }
        if (wet.x * sheet_line_m(sheet, column) + wet.z * sheet_line_m(sheet, row) < wet.limit_m) {
            sheet->wetness[cell] += soak * (1.0f - sheet->wetness[cell]);
        } else if (row > 0 && column > 0 && row < SHEET_SIDE - 1u && column < SHEET_SIDE - 1u) {
            const float flow = creep(sheet, cell, cell - 1u) + creep(sheet, cell, cell + 1u) +
                               creep(sheet, cell, cell - SHEET_SIDE) +
                               creep(sheet, cell, cell + SHEET_SIDE);
            sheet->wetness[cell] += f_max(0.0f, spread * flow);
        }
        driest = f_min(driest, sheet->wetness[cell]);
    }
    sheet->soaked = driest >= SOAKED;
}

/* Whether any of the ring may be under the line; cheap, and right but for the corners. */
static int reaches_water(const struct sheet *sheet, struct sheet_wetting wet)
{
    return -sheet->radius_m * f_sqrt(wet.x * wet.x + wet.z * wet.z) < wet.limit_m;
}

/* ---- Tension -------------------------------------------------------------------------------- */

struct strain {
    const struct paper_grade *grade;
    float centre_n_m, edge_n_m; /* Membrane tension. */
    float cell_m;
    uint32_t load_count;
    struct footprint {
        float x_m, z_m;
        float own_m;      /* Its radius. */
        float reach2_m2;  /* Beyond this square distance it is not felt. */
        float pull_n_m_m; /* F / (2 pi): tension times radius. */
    } footprints[SHEET_LOAD_MAX];
};

/* Footprint of force F: N = F / (pi d) at its own edge, falling as 1/r beyond it. */
static struct footprint footprint(const struct sheet_load *load, float cell_size_m)
{
    const float pull = f_abs(load->force_n) / F_TAU;
    const float reach = f_max(pull / FOOT_TENSION_MIN_N_M, cell_size_m);
    return (struct footprint){ .x_m = load->x_m,
                               .z_m = load->z_m,
                               .own_m = 0.5f * load->diameter_m,
                               .reach2_m2 = reach * reach,
                               .pull_n_m_m = pull };
}

static float footprint_tension(const struct strain *strain, float x_m, float z_m)
{
    float tension = 0.0f;
    for (uint32_t i = 0; i < strain->load_count; i++) {
        const struct footprint *foot = &strain->footprints[i];
        const float dx = x_m - foot->x_m, dz = z_m - foot->z_m;
        const float square = dx * dx + dz * dz;
        if (square < foot->reach2_m2) {
            tension +=
                foot->pull_n_m_m / f_max(foot->own_m, f_sqrt(square) - 0.5f * strain->cell_m);
        }
    }
    return tension;
}

/* 0 away from holes; else the factor of a tear's tip, larger where it would run along the fibres.
 */
static float tip_factor(const struct sheet *sheet, uint32_t row, uint32_t column)
{
    float worst = 0.0f;
    for (uint32_t i = 0; i < 9; i++) {
        const uint32_t r = row + i / 3u - 1u, c = column + i % 3u - 1u; /* Wraps below 0: huge. */
        if (r >= SHEET_SIDE || c >= SHEET_SIDE || sheet->state[r * SHEET_SIDE + c] != CELL_HOLE) {
            continue;
        }
        const float dx = (float)(i % 3u) - 1.0f, dz = (float)(i / 3u) - 1.0f;
        const float square = dx * dx + dz * dz; /* 1, or 2 at a corner, where it bites less. */
        const float along = dx * sheet->fibre_x + dz * sheet->fibre_z;
        const float grain = 1.0f + FIBRE_SHARE * (2.0f * along * along / square - 1.0f);
        worst = f_max(worst, TIP_FACTOR * grain / f_sqrt(f_sqrt(square)));
    }
    return worst;
}

static float wet_line_factor(const struct sheet *sheet, uint32_t row, uint32_t column)
{
    if (row == 0 || column == 0 || row == SHEET_SIDE - 1u || column == SHEET_SIDE - 1u) {
        return 1.0f;
    }
    const uint32_t cell = row * SHEET_SIDE + column;
    const uint32_t pairs[2][2] = { { cell - 1u, cell + 1u },
                                   { cell - SHEET_SIDE, cell + SHEET_SIDE } };
    float step = 0.0f;
    for (uint32_t i = 0; i < 2; i++) {
        if (sheet->state[pairs[i][0]] == CELL_PAPER && sheet->state[pairs[i][1]] == CELL_PAPER) {
            step = f_max(step, f_abs(sheet->wetness[pairs[i][0]] - sheet->wetness[pairs[i][1]]));
        }
    }
    return 1.0f + (WET_LINE_FACTOR - 1.0f) * f_min(step / WET_LINE_STEP, 1.0f);
}

static float concentration(const struct sheet *sheet, uint32_t row, uint32_t column,
                           float from_edge_m)
{
    const float edge = from_edge_m < sheet_cell_m(sheet) ? EDGE_FACTOR : 1.0f;
    return f_max(edge, f_max(wet_line_factor(sheet, row, column), tip_factor(sheet, row, column)));
}

/* ---- Damage --------------------------------------------------------------------------------- */

/* dD/dt = (1 / tau) ratio^10. Returns whether the cell tore. */
static int wear(struct sheet *sheet, uint32_t cell, float ratio)
{
    const float r2 = ratio * ratio, r4 = r2 * r2, r8 = r4 * r4;
    sheet->damage[cell] += CORE_TICK_S / DAMAGE_TAU_S * f_min(r8 * r2, 1e6f);
    if (sheet->damage[cell] < 1.0f) {
        return 0;
    }
    sheet->damage[cell] = 1.0f;
    sheet->state[cell] = CELL_TEARING;
    return 1;
}

static void strain_cell(struct sheet *sheet, uint32_t cell, const struct strain *strain,
                        struct sheet_events *events)
{
    const uint32_t row = cell / SHEET_SIDE, column = cell % SHEET_SIDE;
    const float x = ((float)column + 0.5f) * strain->cell_m - sheet->radius_m;
    const float z = ((float)row + 0.5f) * strain->cell_m - sheet->radius_m;
    const float square = (x * x + z * z) / (sheet->radius_m * sheet->radius_m);
    const float tension =
        f_lerp(strain->centre_n_m, strain->edge_n_m, square) + footprint_tension(strain, x, z);
    events->tension_max_n_m = f_max(events->tension_max_n_m, tension);
    const float material =
        f_lerp(strain->grade->dry_n_m, strain->grade->wet_n_m, sheet->wetness[cell]);
    const float holds = material * sheet->strength[cell];
    if (tension * TIP_FACTOR * (1.0f + FIBRE_SHARE) < LOAD_RATIO_MIN * holds) {
        return; /* Not even a tear's tip would move. */
    }
    const float from_edge = sheet->radius_m * (1.0f - f_sqrt(square));
    if (wear(sheet, cell, tension / holds * concentration(sheet, row, column, from_edge))) {
        events->cells_torn++;
    }
}

static void open_tears(struct sheet *sheet, uint32_t torn)
{
    if (torn == 0) {
        return;
    }
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet->state[cell] == CELL_TEARING) {
            sheet->state[cell] = CELL_HOLE;
        }
    }
    CORE_ASSERT(sheet->paper_cells >= torn);
    sheet->paper_cells -= torn;
}

static void settle_sag(struct sheet *sheet, float pressure_pa)
{
    const float belly = sheet_belly(sheet_grade(sheet->grade), pressure_pa, sheet->radius_m);
    const float goal = pressure_pa > 0.0f ? -belly : belly; /* Pushed up, it bulges up. */
    sheet->sag_m += (goal - sheet->sag_m) * (CORE_TICK_S / (SAG_TAU_S + CORE_TICK_S));
}

struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count)
{
    CORE_ASSERT(load_count <= SHEET_LOAD_MAX);
    CORE_ASSERT(f_is_finite(pressure_pa));
    struct sheet_events events = { 0 };
    const struct paper_grade *grade = sheet_grade(sheet->grade);
    struct strain strain = {
        .grade = grade,
        .centre_n_m = sheet_tension_centre(grade, pressure_pa, sheet->radius_m),
        .edge_n_m = sheet_tension_edge(grade, pressure_pa, sheet->radius_m),
        .cell_m = sheet_cell_m(sheet),
        .load_count = load_count,
    };
    for (uint32_t i = 0; i < load_count; i++) {
        strain.footprints[i] = footprint(&loads[i], strain.cell_m);
    }
    settle_sag(sheet, pressure_pa);
    sheet->touched |= (uint8_t)reaches_water(sheet, wet);
    if (sheet->touched && !sheet->soaked) {
        wet_cells(sheet, wet);
    }
    const float weakest = sheet->strength_min * (sheet->touched ? grade->wet_n_m : grade->dry_n_m);
    const float worst = TIP_FACTOR * (1.0f + FIBRE_SHARE) * strain.centre_n_m;
    if (load_count == 0 && worst < LOAD_RATIO_MIN * weakest) {
        events.tension_max_n_m = strain.centre_n_m;
        return events; /* Most ticks of a round: nothing that could wear. */
    }
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet->state[cell] == CELL_PAPER) {
            strain_cell(sheet, cell, &strain, &events);
        }
    }
    open_tears(sheet, events.cells_torn);
    return events;
}

/* ---- Questions ------------------------------------------------------------------------------ */

/* The cell whose paper a point within the ring lies on. Where a cell's middle is beyond the ring
 * its sliver belongs to the neighbour toward the centre. */
static uint32_t cell_at(const struct sheet *sheet, float x_m, float z_m)
{
    const float last = (float)(SHEET_SIDE - 1u);
    const float column = f_floor((x_m + sheet->radius_m) / sheet_cell_m(sheet));
    const float row = f_floor((z_m + sheet->radius_m) / sheet_cell_m(sheet));
    uint32_t c = (uint32_t)f_clamp(column, 0.0f, last);
    uint32_t r = (uint32_t)f_clamp(row, 0.0f, last);
    if (sheet->state[r * SHEET_SIDE + c] == CELL_OUTSIDE) {
        if (f_abs(x_m) > f_abs(z_m)) {
            c = x_m > 0.0f ? c - 1u : c + 1u;
        } else {
            r = z_m > 0.0f ? r - 1u : r + 1u;
        }
    }
    return r * SHEET_SIDE + c;
}

int sheet_holds(const struct sheet *sheet, float x_m, float z_m)
{
    if (sheet->paper_cells == 0 || x_m * x_m + z_m * z_m >= sheet->radius_m * sheet->radius_m) {
        return 0;
    }
    return sheet->state[cell_at(sheet, x_m, z_m)] == CELL_PAPER;
}

float sheet_left(const struct sheet *sheet)
{
    return sheet->paper_cells_new > 0 ? (float)sheet->paper_cells / (float)sheet->paper_cells_new
                                      : 0.0f;
}

uint64_t sheet_hash(uint64_t hash, const struct sheet *sheet)
{
    hash = hash_u32(hash, sheet->grade);
    hash = hash_u32(hash, sheet->touched);
    hash = hash_u32(hash, sheet->soaked);
    hash = hash_float(hash, sheet->radius_m);
    hash = hash_float(hash, sheet->fibre_x);
    hash = hash_float(hash, sheet->fibre_z);
    hash = hash_floats(hash, sheet->wetness, SHEET_CELL_COUNT);
    hash = hash_floats(hash, sheet->damage, SHEET_CELL_COUNT);
    hash = hash_floats(hash, sheet->strength, SHEET_CELL_COUNT);
    hash = hash_bytes(hash, sheet->state, SHEET_CELL_COUNT);
    hash = hash_float(hash, sheet->strength_min);
    hash = hash_u32(hash, sheet->paper_cells);
    hash = hash_u32(hash, sheet->paper_cells_new);
    return hash_float(hash, sheet->sag_m);
}
