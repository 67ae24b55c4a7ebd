/* sheet.c -- simulates one tick of the paper: loads, stress concentration and tears. */
#include "core/poi/paper/sheet.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/poi/paper/strain.h"

/* Fraction of the ultimate tension below which damage is ignored. At this fraction, the paper would
 * last for half a day. */
#define LOAD_RATIO_MIN 0.25f
/* Stress concentration factor at the line between wet and dry paper. Wet paper swells more than dry
 * paper, which causes stress at the line. */
#define WET_LINE_FACTOR 2.5f
#define STANDING_FACTOR_WORST (STRAIN_EDGE * WET_LINE_FACTOR)
/* Tension below which the effect of a footprint is ignored, because a lower tension causes no
 * damage. */
#define FOOT_TENSION_MIN_N_M 0.3f
/* Time constant of the sag. The sag moves water along with it and therefore cannot change
 * abruptly. */
#define SAG_TAU_S 0.03f

/* ---- Stress concentration -------------------------------------------------------------------- */

/* Multiplies the load of each cell beside a tear by the stress factor of the tear, and stores the
 * product in strain->ratio if it is higher than the stored value. `row` selects the row of
 * cells. */
static void gather_at_tears(struct strain *strain, const struct sheet *sheet, uint32_t row)
{
    const uint32_t front = tear_front(&strain->map, row);
    for (uint32_t column = 0; front != 0 && column < SHEET_SIDE; column++) {
        if (front >> column & 1u) {
            const uint32_t cell = row * SHEET_SIDE + column;
            const float tip = strain->load[cell] * tear_factor(&strain->map, sheet, row, column);
            strain->ratio[cell] = f_max(strain->ratio[cell], tip);
        }
    }
}

/* Multiplies strain->ratio of the cells in a row by the stress factor of the line between wet and
 * dry paper. Then applies the stress factors of tears. */
static void gather_row(struct strain *strain, const struct sheet *sheet, uint32_t row)
{
    for (uint32_t column = 0; (sheet->touched && !sheet->soaked) && column < SHEET_SIDE; column++) {
        strain->ratio[row * SHEET_SIDE + column] *=
            1.0f + (WET_LINE_FACTOR - 1.0f) * paper_wetting_line(sheet, row, column);
    }
    gather_at_tears(strain, sheet, row);
}

/* Sets the load of all hole cells in the row to 0. */
static void relieve_row(struct strain *strain, uint32_t row)
{
    CORE_ASSERT(row < SHEET_SIDE);
    for (uint32_t column = 0; column < SHEET_SIDE; column++) {
        if (strain->map.hole[row] >> column & 1u) {
            strain->load[row * SHEET_SIDE + column] = 0.0f;
            strain->ratio[row * SHEET_SIDE + column] = 0.0f;
        }
    }
}

/* Recomputes strain->ratio, the load of a cell times its stress factor, near the holes that changed
 * in this tick. Bit i of `changed` is set if a hole in row i grew. A ratio never decreases here,
 * because the stress beside a growing tear never decreases. */
static void regather(struct strain *strain, const struct sheet *sheet, uint32_t changed)
{
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        if (changed >> row & 1u) {
            relieve_row(strain, row);
        }
    }
    if (sheet->ideal) {
        return;
    }
    const uint32_t near = changed | changed << 1 | changed << 2 | changed << 3 | changed >> 1 |
                          changed >> 2 | changed >> 3;
    _Static_assert(TEAR_REACH == 3u, "as many rows up and down");
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        if (near >> row & 1u) {
            gather_at_tears(strain, sheet, row);
        }
    }
}

/* ---- Growth of tears ------------------------------------------------------------------------ */

static uint32_t tear_step(struct strain *strain, struct sheet *sheet)
{
    const float seconds = CORE_TICK_S / (float)SHEET_STEPS_MAX;
    uint32_t before[SHEET_SIDE], gone = 0;
    MEM_COPY(before, strain->map.hole, sizeof before);
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        gone += tear_open_row(&strain->map, sheet, row, strain_wear(strain, sheet, row, seconds));
    }
    if (gone > 0) {
        gone += tear_drop_loose(&strain->map, sheet);
        /* Bit i of `changed` is set if the holes of row i changed. */
        uint32_t changed = 0;
        for (uint32_t row = 0; row < SHEET_SIDE; row++) {
            changed |= (uint32_t)(strain->map.hole[row] != before[row]) << row;
        }
        regather(strain, sheet, changed);
    }
    return gone;
}

/* Advances the damage by one tick and returns the number of torn cells. A tick is divided into
 * substeps only if a cell tears, because otherwise the load is constant and the damage grows at a
 * constant rate. */
static uint32_t wear_tick(struct strain *strain, struct sheet *sheet)
{
    uint32_t torn = 0;
    bool tears = false;
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        tears |= strain_tears(strain, sheet, row, CORE_TICK_S);
    }
    for (uint32_t row = 0; !tears && row < SHEET_SIDE; row++) {
        (void)strain_wear(strain, sheet, row, CORE_TICK_S);
    }
    for (uint32_t step = 0; tears && step < SHEET_STEPS_MAX; step++) {
        torn += tear_step(strain, sheet);
    }
    /* Removes loose paper until no loose paper remains. */
    uint32_t gone = 0, dropped = torn;
    for (uint32_t sweep = 0; dropped > 0 && sweep < SHEET_SIDE; sweep++) {
        dropped = tear_drop_loose(&strain->map, sheet);
        gone += dropped;
    }
    for (uint32_t row = 0; gone > 0 && row < SHEET_SIDE; row++) {
        relieve_row(strain, row);
    }
    torn += gone;
    CORE_ASSERT(sheet->paper_cells >= torn);
    sheet->paper_cells -= torn;
    return torn;
}

/* ---- Tick of the sheet ---------------------------------------------------------------------- */

/* Returns true if the tension at the centre of the sheet is too low to damage any cell, even
 * beside a tear. */
static bool is_calm(const struct sheet *sheet, const struct paper_grade *grade, float centre_n_m)
{
    CORE_ASSERT(centre_n_m >= 0.0f);
    const float wettest = grade->wet_n_m * (1.0f - SHEET_SOFTENING);
    const float weakest = sheet->strength_min * (sheet->touched ? wettest : grade->dry_n_m);
    const float factor =
        sheet->paper_cells < sheet->paper_cells_new ? TEAR_FACTOR_WORST : STANDING_FACTOR_WORST;
    return factor * centre_n_m < LOAD_RATIO_MIN * weakest;
}

struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count)
{
    CORE_ASSERT(load_count <= SHEET_LOAD_MAX);
    CORE_ASSERT(f_is_finite(pressure_pa));
    const struct paper_grade *grade = sheet_grade(sheet->grade);
    const float borne_pa = pressure_pa * sheet_left(sheet);
    struct strain strain; /* Work area of 9 KiB. Every value is written before it is read. */
    strain.grade = grade;
    strain.centre_n_m = sheet_tension_centre(grade, borne_pa, sheet->radius_m);
    strain.edge_n_m = sheet_tension_edge(grade, borne_pa, sheet->radius_m);
    strain.cell_m = sheet_cell_m(sheet);
    strain.load_count = load_count;
    const float belly = sheet_belly(grade, pressure_pa, sheet->radius_m);
    const float goal = pressure_pa > 0.0f ? -belly : belly; /* A pressure toward the poi's up axis
                                                               makes the paper bulge up. An upward
                                                               bulge is a negative sag. */
    sheet->sag_m += (goal - sheet->sag_m) * (CORE_TICK_S / (SAG_TAU_S + CORE_TICK_S));
    paper_wetting_tick(sheet, wet);
    if (load_count == 0 && is_calm(sheet, grade, strain.centre_n_m)) {
        memset(sheet->stress, 0, sizeof sheet->stress);
        return (struct sheet_events){ .tension_max_n_m = strain.centre_n_m };
    }
    for (uint32_t i = 0; i < load_count; i++) {
        const float pull = f_abs(loads[i].force_n) / F_TAU;
        strain.footprints[i] =
            (struct footprint){ .x_m = loads[i].x_m,
                                .z_m = loads[i].z_m,
                                .own_m = 0.5f * loads[i].diameter_m,
                                .reach_m = f_max(pull / FOOT_TENSION_MIN_N_M, strain.cell_m),
                                .pull_n_m_m = pull };
    }
    struct sheet_events events = { 0 };
    strain.map = tear_map_of(sheet);
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        const float tension_n_m = strain_row(&strain, sheet, row);
        events.tension_max_n_m = f_max(events.tension_max_n_m, tension_n_m);
        if (!sheet->ideal) {
            gather_row(&strain, sheet, row);
        }
    }
    events.cells_torn = wear_tick(&strain, sheet);
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        strain_show(&strain, sheet, row);
    }
    return events;
}

/* ---- Queries --------------------------------------------------------------------------------- */

bool sheet_holds(const struct sheet *sheet, float x_m, float z_m)
{
    if (sheet->paper_cells == 0 || x_m * x_m + z_m * z_m >= sheet->radius_m * sheet->radius_m) {
        return false;
    }
    /* A point near the ring may lie in a cell that counts as outside. In this case, the nearest
     * cell toward the centre is tested. */
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
    return sheet->state[(r * SHEET_SIDE + c)] == CELL_PAPER;
}

/* Range of the load, as a fraction of the strength, in which the danger rises from 0 to 1. Paper
 * bears WARN_LOAD_FROM for 8 s, and WARN_LOAD_TO for a quarter of a second. */
#define WARN_LOAD_FROM 0.60f
#define WARN_LOAD_TO 0.85f
/* Range of the damage in which the danger rises from 0 to 1. */
#define WARN_DAMAGE_FROM 0.20f
#define WARN_DAMAGE_TO 0.80f

float sheet_warning(const struct sheet *sheet)
{
    float damage = 0.0f;
    uint8_t stress = 0;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        const bool is_paper = sheet->state[i] == CELL_PAPER;
        damage = is_paper ? f_max(damage, sheet->damage[i]) : damage;
        stress = is_paper && sheet->stress[i] > stress ? sheet->stress[i] : stress;
    }
    return f_max(f_smoothstep(WARN_LOAD_FROM, WARN_LOAD_TO, (float)stress / 255.0f),
                 f_smoothstep(WARN_DAMAGE_FROM, WARN_DAMAGE_TO, damage));
}

float sheet_left(const struct sheet *sheet)
{
    CORE_ASSERT(sheet->paper_cells <= sheet->paper_cells_new);
    return sheet->paper_cells_new > 0 ? (float)sheet->paper_cells / (float)sheet->paper_cells_new
                                      : 0.0f;
}

float sheet_hole_m2(const struct sheet *sheet)
{
    return (1.0f - sheet_left(sheet)) * F_PI * sheet->radius_m * sheet->radius_m;
}
