/* sheet.c -- tension, damage and tears, cell by cell. */
#include "core/poi/sheet.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/poi/soak.h"
#include "core/poi/tear.h"

#define LOAD_RATIO_MIN 0.25f /* Of its ultimate tension paper bears for half a day. */
#define LOAD_RATIO_NIL 0.02f /* Counts as none: its tenth power is no normal number. */
#define EDGE_FACTOR 1.5f     /* Stress concentration along the ring ... */
#define WET_LINE_FACTOR 2.5f /* ... and along the line between wet and dry (swelling differs). */
#define STANDING_FACTOR_WORST (EDGE_FACTOR * WET_LINE_FACTOR)
#define FOOT_TENSION_MIN_N_M 0.3f /* A footprint is felt as far as this; less wears nothing. */
#define SAG_TAU_S 0.03f /* The belly takes water along and cannot jump. */

/* One tick's loads on every cell. */
struct strain {
    const struct paper_grade *grade;
    float centre_n_m, edge_n_m; /* Membrane tension. */
    float cell_m;
    uint32_t load_count;
    struct footprint {
        float x_m, z_m;
        float own_m;      /* Its radius. */
        float reach_m;    /* Beyond it is not felt. */
        float pull_n_m_m; /* F / (2 pi): tension times radius. */
    } footprints[SHEET_LOAD_MAX];
    struct tear_map map;
    float load[SHEET_CELL_COUNT];  /* Tension over strength, 0 where there is no paper; ... */
    float ratio[SHEET_CELL_COUNT]; /* ... raised where stress gathers. */
};

/* ---- Tension -------------------------------------------------------------------------------- */

/* Footprint of force F: N = F / (pi d) at its own edge, falling as 1/r beyond it. */
static struct footprint footprint(const struct sheet_load *load, float cell_size_m)
{
    const float pull = f_abs(load->force_n) / F_TAU;
    return (struct footprint){ .x_m = load->x_m,
                               .z_m = load->z_m,
                               .own_m = 0.5f * load->diameter_m,
                               .reach_m = f_max(pull / FOOT_TENSION_MIN_N_M, cell_size_m),
                               .pull_n_m_m = pull };
}

static void add_footprint(const struct footprint *foot, const float x_m[SHEET_SIDE], float z_m,
                          float cell_size_m, float tension[SHEET_SIDE])
{
    const float dz = z_m - foot->z_m;
    const float reach2 = foot->reach_m * foot->reach_m;
    if (dz * dz >= reach2) {
        return;
    }
    for (uint32_t column = 0; column < SHEET_SIDE; column++) {
        const float dx = x_m[column] - foot->x_m;
        const float square = dx * dx + dz * dz;
        const float away = f_max(foot->own_m, f_sqrt(square) - 0.5f * cell_size_m);
        const float pull = square < reach2 ? foot->pull_n_m_m : 0.0f;
        tension[column] += pull / away;
    }
}

/* What a cell bears at most. */
static float holds_n_m(const struct sheet *sheet, const struct paper_grade *grade, uint32_t cell)
{
    const float wet = grade->wet_n_m * soak_keeps(sheet, cell);
    return f_lerp(grade->dry_n_m, wet, sheet->wetness[cell]) * sheet->strength[cell];
}

static void strain_row(struct strain *strain, const struct sheet *sheet, uint32_t row,
                       float *tension_max_n_m)
{
    float x_m[SHEET_SIDE], tension[SHEET_SIDE];
    const float z_m = sheet_line_m(sheet, row);
    const float per_radius2 = 1.0f / (sheet->radius_m * sheet->radius_m);
    for (uint32_t column = 0; column < SHEET_SIDE; column++) {
        x_m[column] = sheet_line_m(sheet, column);
        const float square = (x_m[column] * x_m[column] + z_m * z_m) * per_radius2;
        tension[column] = f_lerp(strain->centre_n_m, strain->edge_n_m, square);
    }
    for (uint32_t i = 0; i < strain->load_count; i++) {
        add_footprint(&strain->footprints[i], x_m, z_m, strain->cell_m, tension);
    }
    for (uint32_t column = 0; column < SHEET_SIDE; column++) {
        const uint32_t cell = row * SHEET_SIDE + column;
        const float pull = sheet->state[cell] == CELL_PAPER ? tension[column] : 0.0f;
        const float load = pull / f_max(holds_n_m(sheet, strain->grade, cell), 1e-3f);
        strain->load[cell] = load < LOAD_RATIO_NIL ? 0.0f : load;
        *tension_max_n_m = f_max(*tension_max_n_m, pull);
    }
}

/* ---- Concentration -------------------------------------------------------------------------- */

/* At the ring and along a wet line; where the two meet each raises what the other did. */
static float standing_factor(const struct sheet *sheet, uint32_t row, uint32_t column)
{
    const float x = sheet_line_m(sheet, column), z = sheet_line_m(sheet, row);
    const float inner = sheet->radius_m - sheet_cell_m(sheet);
    const float edge = x * x + z * z > inner * inner ? EDGE_FACTOR : 1.0f;
    const int has_line = sheet->touched && !sheet->soaked;
    const float line = has_line ? soak_line(sheet, row, column) : 0.0f;
    return edge * (1.0f + (WET_LINE_FACTOR - 1.0f) * line);
}

static void gather_stress(struct strain *strain, const struct sheet *sheet, uint32_t row,
                          uint32_t column, int at_tear)
{
    const uint32_t cell = row * SHEET_SIDE + column;
    if (strain->load[cell] <= 0.0f) {
        strain->ratio[cell] = 0.0f;
        return;
    }
    float factor = 1.0f;
    if (!sheet->ideal) {
        const float tip = at_tear ? tear_factor(&strain->map, sheet, row, column) : 0.0f;
        factor = f_max(standing_factor(sheet, row, column), tip);
    }
    strain->ratio[cell] = strain->load[cell] * factor;
}

static void gather_stress_everywhere(struct strain *strain, const struct sheet *sheet)
{
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        const uint32_t front = tear_front(&strain->map, row);
        for (uint32_t column = 0; column < SHEET_SIDE; column++) {
            gather_stress(strain, sheet, row, column, (int)(front >> column & 1u));
        }
    }
}

/* After a tear grew: what is a hole bears nothing, and what lies beside one bears more. */
static void gather_stress_at_tears(struct strain *strain, const struct sheet *sheet)
{
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        const uint32_t front = tear_front(&strain->map, row);
        for (uint32_t column = 0; column < SHEET_SIDE; column++) {
            const uint32_t cell = row * SHEET_SIDE + column;
            if (front >> column & 1u) {
                gather_stress(strain, sheet, row, column, 1);
            } else if (strain->map.hole[row] >> column & 1u) {
                strain->load[cell] = strain->ratio[cell] = 0.0f;
            }
        }
    }
}

/* ---- Damage --------------------------------------------------------------------------------- */

_Static_assert(SHEET_DAMAGE_EXPONENT == 10, "as it is multiplied here");

/* dD/dt = (1 / tau) ratio^10. */
static float wear_per_s(float ratio)
{
    const float r2 = ratio * ratio, r4 = r2 * r2, r8 = r4 * r4;
    return f_min(r8 * r2, 1e6f) * (1.0f / SHEET_DAMAGE_TAU_S);
}

/* Whether a cell tears before the tick is over. */
static int tears_now(const struct strain *strain, const struct sheet *sheet)
{
    float worst = 0.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const float wear = CORE_TICK_S * wear_per_s(strain->ratio[cell]);
        worst = f_max(worst, wear > 0.0f ? sheet->damage[cell] + wear : 0.0f);
    }
    return worst >= 1.0f;
}

static void wear(const struct strain *strain, struct sheet *sheet, float seconds)
{
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet->damage[cell] += seconds * wear_per_s(strain->ratio[cell]);
    }
}

/* What is worn through opens, all at once. Returns how many cells. */
static uint32_t open_tears(struct strain *strain, struct sheet *sheet)
{
    uint32_t torn = 0;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet->state[cell] == CELL_PAPER && sheet->damage[cell] >= 1.0f) {
            const uint32_t bit = 1u << cell % SHEET_SIDE;
            sheet->damage[cell] = 1.0f;
            sheet->state[cell] = CELL_HOLE;
            strain->map.paper[cell / SHEET_SIDE] &= ~bit;
            strain->map.hole[cell / SHEET_SIDE] |= bit;
            torn++;
        }
    }
    return torn;
}

static uint32_t tear(struct strain *strain, struct sheet *sheet)
{
    uint32_t torn = 0;
    for (uint32_t step = 0; step < SHEET_STEPS_MAX; step++) {
        wear(strain, sheet, CORE_TICK_S / (float)SHEET_STEPS_MAX);
        uint32_t gone = open_tears(strain, sheet);
        if (gone > 0) {
            gone += tear_drop_loose(&strain->map, sheet);
            gather_stress_at_tears(strain, sheet);
            CORE_ASSERT(sheet->paper_cells >= gone);
            sheet->paper_cells -= gone;
            torn += gone;
        }
    }
    return torn;
}

/* ---- The tick ------------------------------------------------------------------------------- */

static void settle_sag(struct sheet *sheet, float pressure_pa)
{
    const float belly = sheet_belly(sheet_grade(sheet->grade), pressure_pa, sheet->radius_m);
    const float goal = pressure_pa > 0.0f ? -belly : belly; /* Pushed up, it bulges up. */
    sheet->sag_m += (goal - sheet->sag_m) * (CORE_TICK_S / (SAG_TAU_S + CORE_TICK_S));
}

/* Nothing on it but a pressure that would not even drive a tear on. */
static int is_calm(const struct sheet *sheet, const struct paper_grade *grade, float centre_n_m)
{
    const float wettest = grade->wet_n_m * (1.0f - SHEET_SOFTENING);
    const float weakest = sheet->strength_min * (sheet->touched ? wettest : grade->dry_n_m);
    const float factor =
        sheet->paper_cells < sheet->paper_cells_new ? TEAR_FACTOR_WORST : STANDING_FACTOR_WORST;
    return factor * centre_n_m < LOAD_RATIO_MIN * weakest;
}

static void show_stress(const struct strain *strain, struct sheet *sheet)
{
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet->stress[cell] = (uint8_t)(f_min(strain->ratio[cell], 1.0f) * 255.0f);
    }
}

static struct sheet_events strain_cells(struct sheet *sheet, struct strain *strain)
{
    struct sheet_events events = { 0 };
    strain->map = tear_map_of(sheet);
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        strain_row(strain, sheet, row, &events.tension_max_n_m);
    }
    gather_stress_everywhere(strain, sheet);
    if (tears_now(strain, sheet)) {
        events.cells_torn = tear(strain, sheet);
    } else {
        wear(strain, sheet, CORE_TICK_S);
    }
    show_stress(strain, sheet);
    return events;
}

struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count)
{
    CORE_ASSERT(load_count <= SHEET_LOAD_MAX);
    CORE_ASSERT(f_is_finite(pressure_pa));
    const struct paper_grade *grade = sheet_grade(sheet->grade);
    const float borne_pa = pressure_pa * sheet_left(sheet);
    struct strain strain; /* 9 KiB, all of it written before it is read. */
    strain.grade = grade;
    strain.centre_n_m = sheet_tension_centre(grade, borne_pa, sheet->radius_m);
    strain.edge_n_m = sheet_tension_edge(grade, borne_pa, sheet->radius_m);
    strain.cell_m = sheet_cell_m(sheet);
    strain.load_count = load_count;
    settle_sag(sheet, pressure_pa);
    soak_tick(sheet, wet);
    if (load_count == 0 && is_calm(sheet, grade, strain.centre_n_m)) {
        memset(sheet->stress, 0, sizeof sheet->stress);
        return (struct sheet_events){ .tension_max_n_m = strain.centre_n_m };
    }
    for (uint32_t i = 0; i < load_count; i++) {
        strain.footprints[i] = footprint(&loads[i], strain.cell_m);
    }
    return strain_cells(sheet, &strain);
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
    hash = hash_u32(hash, sheet->ideal);
    hash = hash_float(hash, sheet->radius_m);
    hash = hash_float(hash, sheet->fibre_x);
    hash = hash_float(hash, sheet->fibre_z);
    hash = hash_floats(hash, sheet->wetness, SHEET_CELL_COUNT);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        hash = hash_u32(hash, sheet->soak_ticks[cell]);
    }
    hash = hash_floats(hash, sheet->damage, SHEET_CELL_COUNT);
    hash = hash_floats(hash, sheet->strength, SHEET_CELL_COUNT);
    hash = hash_bytes(hash, sheet->state, SHEET_CELL_COUNT);
    hash = hash_float(hash, sheet->strength_min);
    hash = hash_u32(hash, sheet->paper_cells);
    hash = hash_u32(hash, sheet->paper_cells_new);
    return hash_float(hash, sheet->sag_m);
}
