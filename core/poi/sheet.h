/* sheet.h -- the paper of a poi: cells that each carry wetness, strength and damage.
 *
 * A square of SHEET_SIDE x SHEET_SIDE cells spans the ring; cells outside the ring do not exist.
 * Column 0 is the left edge (-x of the poi), row 0 the far edge (-z). A tear starts where tension,
 * raised at a wet edge, the ring or a hole, meets weak paper, and grows from cell to cell: in a
 * tick in which paper tears, up to SHEET_STEPS_MAX cells far. */
#ifndef KINGYO_CORE_POI_SHEET_H
#define KINGYO_CORE_POI_SHEET_H

#include <stdint.h>

#include "core/scene.h"

#define SHEET_CELL_COUNT (SHEET_SIDE * SHEET_SIDE)
#define SHEET_LOAD_MAX 32u /* Footprints a tick: a body and a tail of 16 fish. */
#define SHEET_STEPS_MAX 8u /* Of a tick in which paper tears: a tear runs at 2.4 m/s at most. */
#define SHEET_DAMAGE_TAU_S 0.05f /* Paper lives so long at its ultimate tension; at a share of it */
#define SHEET_DAMAGE_EXPONENT 10 /* so long over that share to this power: 51 s at half. */
#define SHEET_SOFTENING 0.25f /* Of its wet strength paper loses so much more ... */
#define SHEET_SOAK_TICKS (60u * CORE_TICK_HZ) /* ... in the minute after it got wet. */
#define SHEET_GRADE_MIN 4u /* Strong. */
#define SHEET_GRADE_MAX 7u /* Weak. */

enum sheet_cell_state {
    CELL_OUTSIDE = 0, /* Beyond the ring. */
    CELL_PAPER = 1,
    CELL_HOLE = 2,
};

/* What a mill sells under a number. Line tensions are forces per width of paper. */
struct paper_grade {
    float areal_kg_m2;
    float dry_n_m, wet_n_m; /* Ultimate line tension. */
    float stiffness_n_m;    /* Wet, Young's modulus times thickness. */
};

/* A round patch that presses on the paper: a body, a tail, a snout. */
struct sheet_load {
    float x_m, z_m;   /* Of its centre, in the poi's plane. */
    float diameter_m; /* > 0 */
    float force_n;    /* Along the normal, either sign. */
};

/* Which half-plane of the poi's plane is under water: cells with x * cx + z * cz < limit_m get wet.
 */
struct sheet_wetting {
    float x, z, limit_m;
};

struct sheet {
    uint8_t grade;   /* SHEET_GRADE_MIN .. SHEET_GRADE_MAX */
    uint8_t touched; /* Some cell has been under water. */
    uint8_t soaked;  /* All are wet through. */
    uint8_t ideal;   /* A laboratory's: uniform, and stress gathers nowhere (sheet_idealise). */
    float radius_m;
    float fibre_x, fibre_z;           /* Unit: the way most fibres run; tears like to follow it. */
    float wetness[SHEET_CELL_COUNT];  /* [0, 1] */
    uint16_t soak_ticks[SHEET_CELL_COUNT]; /* Since it got wet, <= SHEET_SOAK_TICKS. */
    float damage[SHEET_CELL_COUNT];   /* [0, 1); a hole at 1. */
    float strength[SHEET_CELL_COUNT]; /* This specimen's factor on the grade's strength, near 1. */
    float strength_min;               /* Of all cells. */
    uint8_t state[SHEET_CELL_COUNT];  /* enum sheet_cell_state */
    uint8_t stress[SHEET_CELL_COUNT]; /* Load over strength in the last tick, raised where stress
                                         gathers: 255 is 1 or more. For the eye alone. */
    uint32_t paper_cells;             /* CELL_PAPER left ... */
    uint32_t paper_cells_new;         /* ... and at the start. */
    float sag_m; /* From the last pressure; for the eye and for pooling water. */
};

/* What one tick did to the paper. */
struct sheet_events {
    uint32_t cells_torn;   /* And what hung loose after that. */
    float tension_max_n_m; /* Of membrane and footprints, without stress concentration. */
};

/* Side of a cell. */
static inline float sheet_cell_m(const struct sheet *sheet)
{
    return 2.0f * sheet->radius_m / (float)SHEET_SIDE;
}

/* The middle of a row (z) or column (x), < SHEET_SIDE, in the poi's plane. */
static inline float sheet_line_m(const struct sheet *sheet, uint32_t line)
{
    return ((float)line + 0.5f) * sheet_cell_m(sheet) - sheet->radius_m;
}

/* `grade` in SHEET_GRADE_MIN .. SHEET_GRADE_MAX, else it asserts. */
const struct paper_grade *sheet_grade(uint8_t grade);

/* Clamped circular membrane (Hencky, nu = 0.3) under |pressure|: line tension at its centre and at
 * its edge (N/m), and the depth of its belly (m). */
float sheet_tension_centre(const struct paper_grade *grade, float pressure_pa, float radius_m);
float sheet_tension_edge(const struct paper_grade *grade, float pressure_pa, float radius_m);
float sheet_belly(const struct paper_grade *grade, float pressure_pa, float radius_m);

/* A dry, whole sheet; weak spots, fibre and strength are this `seed`'s own. */
void sheet_init(struct sheet *sheet, uint8_t grade, float radius_m, uint32_t seed);

/* Makes it the sheet of which the membrane's formula speaks: strength 1 everywhere, and neither the
 * ring, nor a wet line, nor a tear raises the stress. For measuring; nobody plays with one. */
void sheet_idealise(struct sheet *sheet);

/* One tick. `pressure_pa` acts along the normal on all paper, positive toward +up; a hole takes its
 * area off that load and no more. `load_count` <= SHEET_LOAD_MAX. */
struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count);

/* Whether a point of the poi's plane has paper under it; false outside the ring. Slivers between
 * the ring and the outermost cells hold as long as the cell beside them does. */
int sheet_holds(const struct sheet *sheet, float x_m, float z_m);

float sheet_left(const struct sheet *sheet); /* [0, 1] of the area. */

/* Of its holes, from 0 to the disc's own area: the ring cuts its outermost cells, so that all cells
 * as squares are more than the paper. */
float sheet_hole_m2(const struct sheet *sheet);
uint64_t sheet_hash(uint64_t hash, const struct sheet *sheet);

#endif
