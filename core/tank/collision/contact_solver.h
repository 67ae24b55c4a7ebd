/* contact_solver.h -- the contact solver: separates the bodies of fish, and reverts bodies that
 * cannot be separated.
 *
 * A body is the oriented box of a fish. A contact is a pair of bodies that could touch in this
 * tick. An obstacle is a poi (the paper scoop) or a bowl. To revert a body means to put the body
 * back to its pose at the start of the tick.
 *
 * Every tick has two steps.
 *
 * First, rounds of small pushes separate the bodies that the motion of the fish brought together.
 * Pushes resolve nearly all contacts and look natural.
 *
 * Second, the penetration check tests every contact. A fish that is still deeper than SOLVER_FREE_M
 * in another fish, a wall, a ring or a hull is reverted. If a fish cannot move out of the way of a
 * poi, the check undoes a part of the poi's motion.
 *
 * The check repeats until no penetration is too deep. The check ends, because the poses at the
 * start of the tick did not overlap: in the worst case all bodies are reverted.
 *
 * A tick in which a poi moves fast is divided into substeps, so that the poi cannot jump over a
 * fish. Each substep does both steps, and a reverted body returns to its pose at the start of the
 * substep.
 *
 * If there are more contacts than the contact list holds, the fish with unlisted contacts keep
 * their pose for the tick.
 *
 * If fish overlap at the start (a staged scene), the solver separates them over the first ticks.
 * Until then a pair may stay as deep as in the previous tick, but not deeper. */
#pragma once

#include "core/tank/collision/broad_phase.h"
#include "core/tank/collision/obstacle.h"

/* Largest number of obstacles: a poi and a bowl for each of four players. */
#define TANK_OBSTACLE_MAX 8u

/* Two bodies that penetrate each other by at most this depth count as separate. */
#define SOLVER_FREE_M 0.0003f
/* Usual value of `push_max_m`, the largest push of a body in a tick. A larger push would look like
 * a jump of the fish. */
#define SOLVER_PUSH_M 0.002f
/* Value of `push_max_m`, the largest push of a body in a tick, while no poi (paper scoop) moves in
 * the water. With ticks of 1/120 s, the push is a speed of 6 cm/s. */
#define SOLVER_CALM_PUSH_M 0.0005f

/* Inner faces of the tank, within which the solver keeps the bodies. */
struct tank_bounds {
    vec3 low_m, high_m;
};

/* Input of the contact solver: the fish, the tank and the obstacles. */
struct solver_context {
    struct fish *fish;
    struct tank_bounds bounds;
    /* Pois and bowls (obstacle.h). The solver may undo a part of their motion. */
    struct obstacle *obstacles;
    uint32_t obstacle_count;
    /* Largest distance in a tick by which the solver may push a body. The body's own motion does
     * not count. */
    float push_max_m;
    /* Number of SIMD lanes: 4, 8, or 0 for the default (4). The number affects only speed. */
    uint8_t lanes;
};

/* Result of the contact solver for a fish in this substep. */
enum solver_result {
    SOLVER_MOVED = 0,
    /* The fish is back at its pose at the start of the substep. */
    SOLVER_REVERTED = 1,
    /* An obstacle pushed the fish out of its way. SOLVER_PRESSED + k stands for obstacle k, so
     * SOLVER_PRESSED itself stands for obstacle 0. */
    SOLVER_PRESSED = 2,
    /* An obstacle carries the fish, so the fish moves along with the obstacle. SOLVER_CARRIED + k
     * stands for obstacle k. */
    SOLVER_CARRIED = SOLVER_PRESSED + TANK_OBSTACLE_MAX,
};

/* Scratch memory of the contact solver for one tick. The arrays are indexed by fish or by
 * obstacle. */
struct contact_solver {
    /* Position of each fish at the start of the tick. SIMD code reads one float more than the last
     * position. */
    vec3 began_m[TANK_FISH_MAX + 1u];
    /* Position of each fish at the start of the present substep. The first substep uses `began_m`
     * instead. */
    vec3 step_began_m[TANK_FISH_MAX];
    struct angles began_angles[TANK_FISH_MAX + 1u];
    /* Largest distance of each body from its position at the start of the substep. The solver may
     * not move the body farther away. */
    float step_max_m[TANK_FISH_MAX];
    /* Result of the substep for each fish (enum solver_result). */
    uint8_t result[TANK_FISH_MAX];
    /* Number of the last round (one pass of the penetration check) in which each fish was moved,
     * counted from 1. 0 means that the fish was moved in no round. */
    uint16_t fresh_round[TANK_FISH_MAX];
    /* Number of the last round (one pass of the penetration check) that undid motion of each
     * obstacle, counted from 1. 0 means that no round undid motion. */
    uint16_t reaction_round[TANK_OBSTACLE_MAX];
    uint32_t beside_count;
    fish_index beside[TANK_FISH_MAX]; /* Fish that could touch an obstacle in this substep. */
    struct course {                   /* Intended motion of an obstacle in the whole tick. */
        vec3 from_m, step_m;
        bool turned;
    } course[TANK_OBSTACLE_MAX];
    uint32_t substep, substep_count;
    /* True if at least one fish must return to its angles at the start of the tick. */
    bool reverts_angles;
    /* Number of times that a fish was moved back to its previous pose in this tick, in all
     * substeps. */
    uint32_t reverted_count;
};

/* Begins a tick before any fish moves. Stores the poses of all fish, because the solver may return
 * a fish to its stored pose. */
void contact_solver_begin(struct contact_solver *solver, const struct fish *fish,
                          uint32_t fish_count);

/* Returns the number of substeps of this tick; called after the fish moved. The number is 1 unless
 * a poi is fast. With more substeps, a fast poi pushes a group of fish at its own speed. With a
 * single substep, a fast poi could pass a fish without contact. */
uint32_t contact_solver_substep_count(struct contact_solver *solver,
                                      const struct solver_context *place);

/* Begins the substep with the number `substep`, counted from 0: advances the obstacles, and stores
 * the positions of the fish at the end of the previous substep. */
void contact_solver_substep(struct contact_solver *solver, struct broad_phase *broad_phase,
                            const struct solver_context *place, uint32_t substep);

/* Moves bodies out of obstacles and into the tank before the broad-phase query, so that the query
 * uses the corrected positions. */
void contact_solver_project(struct contact_solver *solver, struct broad_phase *broad_phase,
                            const struct solver_context *place);

/* Pushes overlapping bodies apart in several rounds, and keeps the bodies within walls, floor and
 * surface. */
void contact_solver_relax(struct contact_solver *solver, struct broad_phase *broad_phase,
                          const struct solver_context *place);

/* Ends a substep. Pushes overlapping bodies apart as contact_solver_relax() does. Bodies that could
 * not be separated then return to their poses at the start of the substep. */
void contact_solver_finish(struct contact_solver *solver, struct broad_phase *broad_phase,
                           const struct solver_context *place);

/* Ends a tick. A fish that was reverted in the first substep, the only one with rotation, gets back
 * its angles from the start of the tick and stops turning. If the solver undid a part of an
 * obstacle's motion, the obstacle loses the corresponding part of its velocity. */
void contact_solver_end(struct contact_solver *solver, const struct broad_phase *broad_phase,
                        const struct solver_context *place);

/* Moves all swimming fish to the positions of their bodies. */
void contact_solver_write_back(const struct broad_phase *broad_phase, struct fish *fish);
