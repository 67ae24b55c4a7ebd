/* contact_solver.h -- the contact solver: separates bodies, and reverts those that cannot be
 * separated.
 *
 * Every tick has two steps. First, rounds of small pushes separate the bodies that the fish's own
 * motion brought together. Pushes resolve nearly all contacts and look natural. Second, the
 * penetration check tests every pair that could touch. A fish that is still deeper than
 * SOLVER_FREE_M in another fish, a wall, the ring or a hull goes back to its pose of the previous
 * tick. If a fish cannot move out of the way, the poi reacts instead. The check repeats until no
 * penetration is too deep. The check ends, because the poses of the previous tick were free of each
 * other: at worst all bodies revert.
 *
 * If more pairs could touch than the contact list holds, the fish with unlisted contacts keep still
 * for the tick.
 *
 * A crowd that starts with overlaps (a staged scene) is separated over its first ticks. Meanwhile a
 * pair may stay as deep as in the previous tick, but no deeper. */
#ifndef KINGYO_CORE_TANK_COLLISION_CONTACT_SOLVER_H
#define KINGYO_CORE_TANK_COLLISION_CONTACT_SOLVER_H

#include "core/tank/collision/broad_phase.h"
#include "core/tank/collision/obstacle.h"

#define TANK_OBSTACLE_MAX 8u /* A poi and a bowl of each player. */

#define SOLVER_FREE_M 0.0003f /* Largest penetration that counts as apart. */
/* Value of place.push_max_m: a larger push would look like a jump. */
#define SOLVER_PUSH_M 0.002f
/* Value of place.push_max_m while no poi stirs the water: 6 cm/s. */
#define SOLVER_CALM_PUSH_M 0.0005f

/* Inner faces of the tank, within which bodies are kept. */
struct tank_bounds {
    vec3 low_m, high_m;
};

/* The tank as the contact solver sees it. */
struct solver_context {
    struct fish *fish;
    struct tank_bounds bounds;
    struct obstacle *obstacles; /* Obstacles, which may react; see ring_contact.h. */
    uint32_t obstacle_count;
    float push_max_m; /* Largest distance by which others push a body in a tick, beyond its own
                         motion. */
    uint8_t lanes;    /* 0, 4 or 8, as in simd_is_built(): affects speed only. */
};

enum solver_result { /* Result of the penetration check of this substep for a fish. */
                     SOLVER_MOVED = 0,
                     SOLVER_REVERTED =
                         1, /* The fish is back at its pose at the start of the substep. */
                     SOLVER_PRESSED =
                         2, /* The fish moves, and obstacle 0 was in its way; + k for obstacle k. */
                     SOLVER_CARRIED =
                         SOLVER_PRESSED + TANK_OBSTACLE_MAX, /* The fish moves along with
                                                                obstacle 0; + k for obstacle k. */
};

/* Scratch memory of one tick; all columns are indexed by fish. */
struct contact_solver {
    vec3 began_m[TANK_FISH_MAX + 1u]; /* Positions at the start of the tick; SIMD code reads one
                                         float beyond the last. */
    vec3 step_began_m[TANK_FISH_MAX]; /* Positions at the start of a later substep of the tick. */
    struct angles began_angles[TANK_FISH_MAX + 1u];
    float step_max_m[TANK_FISH_MAX];     /* Largest distance from the previous position at which a
                                            body may end. */
    uint8_t result[TANK_FISH_MAX];       /* enum solver_result */
    uint16_t fresh_round[TANK_FISH_MAX]; /* 0, or one more than the round of the penetration
                                            check that last moved the fish. */
    uint16_t reaction_round[TANK_OBSTACLE_MAX]; /* 0, or one more than the round in which the
                                                   obstacle last reacted. */
    uint32_t beside_count;
    fish_index beside[TANK_FISH_MAX]; /* Fish that could touch an obstacle in this substep. */
    struct course {                   /* Intended motion of an obstacle. */
        vec3 from_m, step_m;
        uint8_t turned;
    } course[TANK_OBSTACLE_MAX];
    uint32_t station, substep_count;
    uint8_t reverts_angles;  /* 1 if a fish has its previous angles again. */
    uint32_t reverted_count; /* Fish reverted in this tick, in all its substeps. */
};

/* Begins a tick, before any fish moves: stores the poses to which fish may revert. */
void contact_solver_begin(struct contact_solver *solver, const struct fish *fish,
                          uint32_t fish_count);

/* Returns the number of substeps of this tick, after the fish moved. The number is 1 unless a poi
 * is fast. A fast poi needs more substeps so that it pushes a crowd at its own speed, and so that
 * no fish is on its other side before contact. */
uint32_t contact_solver_substep_count(struct contact_solver *solver,
                                      const struct solver_context *place);

/* Begins a substep: obstacles advance, and fish take the positions from the previous substep. */
void contact_solver_substep(struct contact_solver *solver, struct broad_phase *broad_phase,
                            const struct solver_context *place, uint32_t station);

/* Moves bodies out of obstacles and within bounds, so that the broad-phase query uses their real
 * positions. */
void contact_solver_project(struct contact_solver *solver, struct broad_phase *broad_phase,
                            const struct solver_context *place);

/* Separates bodies as far as the rounds can. Walls, floor and surface always hold. */
void contact_solver_relax(struct contact_solver *solver, struct broad_phase *broad_phase,
                          const struct solver_context *place);

/* Ends a substep: separates bodies as contact_solver_relax() does, then reverts those that cannot
 * be separated. */
void contact_solver_finish(struct contact_solver *solver, struct broad_phase *broad_phase,
                           const struct solver_context *place);

/* Ends a tick. Reverted fish get their previous angles and stop turning. An obstacle that reacted
 * loses the speed that it could not use. */
void contact_solver_end(struct contact_solver *solver, const struct broad_phase *broad_phase,
                        const struct solver_context *place);

/* Moves all fish to their bodies. */
void contact_solver_write_back(const struct broad_phase *broad_phase, struct fish *fish);

#endif
