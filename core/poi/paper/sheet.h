/* sheet.h -- simulates the paper of a poi (paper scoop) as cells with wetness, strength and damage.
 *
 * A square of SHEET_SIDE x SHEET_SIDE cells covers the ring, and cells outside the ring are
 * CELL_OUTSIDE. Column 0 is the left edge (-x of the poi), and row 0 is the far edge (-z). The
 * stress is concentrated along the ring, beside holes, and along the line between wet and dry
 * paper. A tear starts where the stress exceeds the strength of the paper for long enough. A tear
 * grows from cell to cell, by up to SHEET_STEPS_MAX cells in one tick (1/120 s). */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/scene.h"

#define SHEET_CELL_COUNT (SHEET_SIDE * SHEET_SIDE)
/* Largest number of loads in one tick: a body and a slapping tail of each of 16 fish. */
#define SHEET_LOAD_MAX 32u
/* Number of substeps of a tick in which paper tears. A tear therefore grows at 2.4 m/s or less. */
#define SHEET_STEPS_MAX 8u
#define SHEET_DAMAGE_TAU_S 0.05f /* Time after which paper at its ultimate tension tears. */
/* Exponent of the paper's lifetime. At the fraction s of its ultimate tension, paper lasts for
 * SHEET_DAMAGE_TAU_S / s^10, which is 51 s for s = 0.5. */
#define SHEET_DAMAGE_EXPONENT 10
/* Fraction of its wet strength that paper loses within SHEET_SOAK_TICKS. */
#define SHEET_SOFTENING 0.25f
/* Number of ticks (one minute) for which wet paper becomes softer. */
#define SHEET_SOAK_TICKS (60u * CORE_TICK_HZ)

enum sheet_cell_state {
    CELL_OUTSIDE = 0, /* The cell is outside the ring. */
    CELL_PAPER = 1,
    CELL_HOLE = 2,
};

/* Properties of a paper grade. A line tension is a force per width of paper. */
struct paper_grade {
    float areal_kg_m2;
    float dry_n_m, wet_n_m; /* Ultimate line tension of dry paper and of wet paper. */
    float stiffness_n_m;    /* Stiffness of wet paper: Young's modulus times thickness. */
};

/* Load on a round patch of the paper: the footprint of a body or a slapping tail. */
struct sheet_load {
    float x_m, z_m;   /* Centre of the patch, in the plane of the poi. */
    float diameter_m; /* Diameter of the patch, greater than 0. */
    float force_n;    /* Force along the poi's normal, with either sign. */
};

/* Part of the poi's plane that is under water. A point (px, pz) of the plane is under water if x *
 * px + z * pz < limit_m. */
struct sheet_wetting {
    float x, z, limit_m;
};

struct sheet {
    uint8_t grade; /* Paper grade, SHEET_GRADE_MIN .. SHEET_GRADE_MAX. */
    bool touched;  /* True if any cell has ever been under water. */
    bool soaked;   /* True if all cells are completely wet. */
    /* True for an ideal test sheet without variation and stress concentration
     * (sheet_idealise()). */
    bool ideal;
    float radius_m;
    /* Unit vector of the main fibre direction; tears tend to follow the fibres. */
    float fibre_x, fibre_z;
    float wetness[SHEET_CELL_COUNT]; /* Wetness of each cell in [0, 1]. */
    /* Number of ticks for which each cell has been wet and has become softer, at most
     * SHEET_SOAK_TICKS. */
    uint16_t soak_ticks[SHEET_CELL_COUNT];
    /* Damage of each cell in [0, 1]; the cell becomes a hole at 1. */
    float damage[SHEET_CELL_COUNT];
    /* Strength of each cell relative to the grade's strength, near 1. */
    float strength[SHEET_CELL_COUNT];
    float strength_min;              /* Lowest value in `strength`. */
    uint8_t state[SHEET_CELL_COUNT]; /* State of each cell (enum sheet_cell_state). */
    /* Load of each cell divided by its strength in the last tick, including stress concentration.
     * 255 means a ratio of 1 or more. Used for display only. */
    uint8_t stress[SHEET_CELL_COUNT];
    uint32_t paper_cells;     /* Number of cells that are still CELL_PAPER. */
    uint32_t paper_cells_new; /* Number of cells that were CELL_PAPER in the new sheet. */
    /* Depth of the sag at the centre, which follows the pressure; negative if the paper bulges up.
     * Used for display and for the carried water. */
    float sag_m;
};

/* Effect of one tick on the paper. */
struct sheet_events {
    uint32_t cells_torn; /* Number of cells that became holes, including cells of loose paper. */
    /* Highest tension due to the membrane and the footprints, without stress concentration. */
    float tension_max_n_m;
};

/* Returns the length of a cell's side. */
static inline float sheet_cell_m(const struct sheet *sheet)
{
    return 2.0f * sheet->radius_m / (float)SHEET_SIDE;
}

/* Returns the centre coordinate of a row (z) or of a column (x) in the plane of the poi. `line` is
 * the index of the row or column and must be less than SHEET_SIDE. */
static inline float sheet_line_m(const struct sheet *sheet, uint32_t line)
{
    return ((float)line + 0.5f) * sheet_cell_m(sheet) - sheet->radius_m;
}

/* Returns the properties of a grade. Asserts that SHEET_GRADE_MIN <= `grade` <= SHEET_GRADE_MAX. */
const struct paper_grade *sheet_grade(uint8_t grade);

/* Returns the line tension (N/m) at the centre of a circular membrane with a clamped edge (Hencky's
 * solution for Poisson's ratio 0.3). The sign of the pressure has no effect. */
float sheet_tension_centre(const struct paper_grade *grade, float pressure_pa, float radius_m);

/* Returns the line tension (N/m) at the edge of the circular membrane whose tension at the centre
 * is sheet_tension_centre(). */
float sheet_tension_edge(const struct paper_grade *grade, float pressure_pa, float radius_m);

/* Returns the depth (m) of the sag at the centre of the circular membrane whose tension at the
 * centre is sheet_tension_centre(). */
float sheet_belly(const struct paper_grade *grade, float pressure_pa, float radius_m);

/* Initializes a dry sheet without holes. `seed` selects the random weak spots, fibre direction and
 * strength of the sheet. */
void sheet_init(struct sheet *sheet, uint8_t grade, float radius_m, uint32_t seed);

/* Changes `sheet` into an ideal sheet for which the membrane formula is exact. Its strength is 1
 * everywhere. The ring, tears, and the line between wet and dry paper cause no stress
 * concentration. Used for measurements only, not in a game. */
void sheet_idealise(struct sheet *sheet);

/* Advances the sheet by one tick: sag, wetness, damage and tears. `pressure_pa` is the pressure
 * along the normal on all paper, positive toward the poi's up axis. Holes reduce the total load in
 * proportion to their area. Asserts that `load_count` <= SHEET_LOAD_MAX and that the pressure is
 * finite. */
struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count);

/* Returns true if there is paper at a point of the poi's plane. Outside the ring, the result is
 * false. Between the ring and the outermost cells, there is paper as long as the nearest cell
 * is paper. */
bool sheet_holds(const struct sheet *sheet, float x_m, float z_m);

/* Returns the danger that the paper tears, from 0 (none) to 1 (imminent). The danger rises with the
 * highest load of a cell, and with the greatest damage. */
float sheet_warning(const struct sheet *sheet);

/* Returns the fraction [0, 1] of the paper's cells that are not torn. */
float sheet_left(const struct sheet *sheet);

/* Returns the area of the holes, from 0 to the area of the disc. The area is computed as a fraction
 * of the disc's area, because the total area of the square cells is larger than the disc. */
float sheet_hole_m2(const struct sheet *sheet);
