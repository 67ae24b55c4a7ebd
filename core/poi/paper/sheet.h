/* sheet.h -- the paper of a poi: cells with wetness, strength and damage.
 *
 * A square of SHEET_SIDE x SHEET_SIDE cells covers the ring; cells outside the ring do not exist.
 * Column 0 is the left edge (-x of the poi), row 0 the far edge (-z). A tear starts where tension,
 * raised at a wet edge, the ring or a hole, meets weak paper. The tear grows from cell to cell, up
 * to SHEET_STEPS_MAX cells in a tick. */
#ifndef KINGYO_CORE_POI_PAPER_SHEET_H
#define KINGYO_CORE_POI_PAPER_SHEET_H

#include <stdint.h>

#include "core/scene.h"

#define SHEET_CELL_COUNT (SHEET_SIDE * SHEET_SIDE)
#define SHEET_LOAD_MAX 32u /* Footprints per tick: a body and a tail of each of 16 fish. */
/* Substeps of a tick in which paper tears: a tear grows at 2.4 m/s at most. */
#define SHEET_STEPS_MAX 8u
#define SHEET_DAMAGE_TAU_S 0.05f /* Life of paper at its ultimate tension. */
/* The life at a lower tension is longer by the tension share to this power: 51 s at half. */
#define SHEET_DAMAGE_EXPONENT 10
/* Share of its wet strength that paper loses after SHEET_SOAK_TICKS. */
#define SHEET_SOFTENING 0.25f
/* The softening ends a minute after the paper became wet. */
#define SHEET_SOAK_TICKS (60u * CORE_TICK_HZ)
#define SHEET_GRADE_MIN 4u /* The strongest grade. */
#define SHEET_GRADE_MAX 7u /* The weakest grade. */

enum sheet_cell_state {
    CELL_OUTSIDE = 0, /* Outside the ring. */
    CELL_PAPER = 1,
    CELL_HOLE = 2,
};

/* Properties of a paper grade. Line tensions are forces per width of paper. */
struct paper_grade {
    float areal_kg_m2;
    float dry_n_m, wet_n_m; /* Ultimate line tension. */
    float stiffness_n_m;    /* Wet: Young's modulus times thickness. */
};

/* A round patch that presses on the paper: a body, a tail or a snout. */
struct sheet_load {
    float x_m, z_m;   /* Centre, in the plane of the poi. */
    float diameter_m; /* > 0 */
    float force_n;    /* Along the normal, either sign. */
};

/* The half-plane of the poi's plane that is under water: cells with x * cx + z * cz < limit_m get
 * wet. */
struct sheet_wetting {
    float x, z, limit_m;
};

struct sheet {
    uint8_t grade;   /* SHEET_GRADE_MIN .. SHEET_GRADE_MAX */
    uint8_t touched; /* 1 if any cell has been under water. */
    uint8_t soaked;  /* 1 if all cells are completely wet. */
    uint8_t ideal;   /* 1 for an ideal test sheet: uniform and without stress concentration
                        (sheet_idealise). */
    float radius_m;
    float fibre_x, fibre_z;          /* Unit vector of the main fibre direction, which tears tend
                                        to follow. */
    float wetness[SHEET_CELL_COUNT]; /* [0, 1] */
    uint16_t soak_ticks[SHEET_CELL_COUNT]; /* Ticks since the cell became wet, <=
                                              SHEET_SOAK_TICKS. */
    float damage[SHEET_CELL_COUNT];        /* [0, 1); the cell is a hole at 1. */
    float strength[SHEET_CELL_COUNT]; /* Factor of this specimen on the grade's strength, near 1. */
    float strength_min;               /* Least strength of all cells. */
    uint8_t state[SHEET_CELL_COUNT];  /* enum sheet_cell_state */
    uint8_t stress[SHEET_CELL_COUNT]; /* Load over strength in the last tick, with stress
                                         concentration: 255 is 1 or more. For display only. */
    uint32_t paper_cells;             /* Cells that are still CELL_PAPER. */
    uint32_t paper_cells_new;         /* Cells that were CELL_PAPER at the start. */
    float sag_m; /* Sag due to the last pressure, for display and for the pool of water. */
};

/* Effect of one tick on the paper. */
struct sheet_events {
    uint32_t cells_torn;   /* Torn cells, including paper that hung loose afterwards. */
    float tension_max_n_m; /* Tension of membrane and footprints, without stress concentration. */
};

/* Returns the side of a cell. */
static inline float sheet_cell_m(const struct sheet *sheet)
{
    return 2.0f * sheet->radius_m / (float)SHEET_SIDE;
}

/* Returns the centre of a row (z) or column (x), < SHEET_SIDE, in the plane of the poi. */
static inline float sheet_line_m(const struct sheet *sheet, uint32_t line)
{
    return ((float)line + 0.5f) * sheet_cell_m(sheet) - sheet->radius_m;
}

/* Returns the properties of a grade. Asserts SHEET_GRADE_MIN <= `grade` <= SHEET_GRADE_MAX. */
const struct paper_grade *sheet_grade(uint8_t grade);

/* Values of a clamped circular membrane (Hencky, nu = 0.3) under |pressure|: line tension at its
 * centre and at its edge (N/m), and the depth of its sag (m). */
float sheet_tension_centre(const struct paper_grade *grade, float pressure_pa, float radius_m);
float sheet_tension_edge(const struct paper_grade *grade, float pressure_pa, float radius_m);
float sheet_belly(const struct paper_grade *grade, float pressure_pa, float radius_m);

/* Initialises a dry, whole sheet; `seed` selects its weak spots, fibre direction and strength. */
void sheet_init(struct sheet *sheet, uint8_t grade, float radius_m, uint32_t seed);

/* Makes the sheet the ideal of the membrane formula: strength 1 everywhere, and no stress
 * concentration at ring, wet line or tear. For measurements only, not for play. */
void sheet_idealise(struct sheet *sheet);

/* Advances one tick. `pressure_pa` acts along the normal on all paper, positive toward +up; a hole
 * removes only the load of its own area. `load_count` <= SHEET_LOAD_MAX. */
struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count);

/* Returns 1 if a point of the poi's plane has paper under it, 0 outside the ring. Slivers between
 * the ring and the outermost cells hold as long as the cell beside them holds. */
int sheet_holds(const struct sheet *sheet, float x_m, float z_m);

float sheet_left(const struct sheet *sheet); /* Returns the share [0, 1] of the area that is
                                                left. */

/* Returns the area of the holes, from 0 to the area of the disc. The ring cuts its outermost cells,
 * so the sum of all square cells exceeds the paper. */
float sheet_hole_m2(const struct sheet *sheet);
uint64_t sheet_hash(uint64_t hash, const struct sheet *sheet);

#endif
