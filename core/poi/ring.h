/* ring.h -- the mechanics of the ring of a poi (the paper scoop): the forces of the water, the
 * loads on ring and paper, the hand spring and the wrist.
 *
 * A disc is the model of the ring and its paper in the water. The functions disc_*() return forces
 * as coefficients (force divided by speed). A caller adds a coefficient to the left side of an
 * implicit integration step. Drag then slows a poi at any speed but never reverses its motion. In
 * the formulas, rho is the density of water, and a is the radius of the disc.
 *
 * The hand spring pulls the ring toward the hand of the player, and the wrist of the player rotates
 * the ring. Forces are in newtons and in world axes unless a comment names other axes. */
#ifndef KINGYO_CORE_POI_RING_H
#define KINGYO_CORE_POI_RING_H

#include "core/poi/poi.h"

/* Returns the fraction [0, 1] of the disc's area that is below the still water surface at y = 0.
 * `up_y` is the vertical component of the disc's unit normal. A level disc submerges over a range
 * of 10 mm in height, because its paper sags and traps air. */
float disc_immersed(float radius_m, float centre_y_m, float up_y);

/* Returns the added mass of water for a motion along the disc's normal. The added mass is (8/3) *
 * rho * a^3 in deep water, and half of this value at the surface. */
float disc_added_mass_kg(float radius_m, float centre_y_m, float immersed);

/* Returns the force along the normal divided by the speed along the normal, in N s/m, for a fully
 * immersed disc. The force coefficient is C_N = min(1.17, 2 * sin(alpha)), where alpha is the angle
 * between the plane of the disc and its velocity. `normal_m_s` and `plane_m_s` are speeds relative
 * to the water. */
float disc_normal_n_s_m(float radius_m, float normal_m_s, float plane_m_s);

/* Returns the skin friction divided by the speed along the disc's plane, in N s/m. The friction is
 * that of laminar flow along a plate, on both faces of the disc. */
float disc_edge_n_s_m(float radius_m, float plane_m_s);

/* Returns the added moment of inertia (kg m^2) of a disc that rotates about one of its diameters.
 * `added_kg` is the added mass for a motion of the disc along its normal. */
float disc_turn_added_kg_m2(float radius_m, float added_kg);

/* Returns the drag torque divided by the angular speed, in N m s, of an immersed disc that rotates
 * about one of its diameters. Each point of the disc has the force coefficient C_N of a motion
 * along the normal. */
float disc_turn_n_m_s(float radius_m, float rate_rad_s);

/* Returns the water pressure (Pa) on an immersed disc that rotates about one of its diameters. The
 * pressure is computed from the mean square of the normal speed over the disc. */
float disc_turn_pa(float radius_m, float rate_rad_s);

/* Updates the velocity of the ring for one tick (1/120 s). A spring with a force of at most 20 N
 * pulls the ring toward `target_m`. `axes` are the poi's axes, and `immersed` is the fraction [0,
 * 1] of the disc that is in the water. Stores the water forces in `poi`. Does not change the
 * position. */
void hand_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed);

/* Returns the force of the hand on the ring, in world axes: the force of the spring and of its
 * damping at the present position and velocity of the ring. The result is therefore also valid for
 * a blocked ring. `axes` are the poi's axes. */
vec3 hand_spring_force_n(const struct poi *poi, const struct basis *axes);

/* Returns the effective mass of the ring for motion along each of its axes (right, up, back). The
 * effective mass consists of the ring, the carried water and fish, and the added mass of water. */
vec3 hand_spring_mass_kg(const struct poi *poi);

/* Returns the weight of the ring with its carried water and fish, multiplied by the fraction of the
 * disc that is above the water. */
vec3 poi_weight_n(const struct poi *poi);

/* Returns the sum of the drag, the friction and the slam force of the water on the ring in this
 * tick, at the present velocity of the ring. `axes` are the poi's axes. */
vec3 poi_water_n(const struct poi *poi, const struct basis *axes);

/* Returns the downward pull of the meniscus: the water surface that clings to both faces of a ring
 * leaving the water. For a level ring of radius a, the pull is 2 * pi * a * sigma per face, where
 * sigma is the surface tension. For a steep ring, the pull is small. `up_y` is the vertical
 * component of the ring's unit normal. */
float poi_meniscus_n(const struct poi *poi, float up_y);

/* Returns the sum of all slap forces along the poi's normal. A negative force presses the paper
 * down. */
float poi_kick_n(const struct poi *poi);

/* Updates the low-pass filtered acceleration of the ring. Returns the pressure of all loads on the
 * paper, positive toward the poi's up axis. */
float poi_paper_pa(struct poi *poi, const struct basis *axes);

/* Updates the progress and the direction of the automatic tip over the bowl. A poi is tipped while
 * it carries fish, and for half a second after the last fish left. The poi rotates back if it
 * carries no fish or if `has_wrist` is 1. */
void poi_wrist_tip(struct poi *poi, const struct bowl *bowl, int has_wrist);

/* Returns `target` rotated toward the bowl by the progress of the tip that poi_wrist_tip() stored
 * in `poi`. */
struct poi_target poi_wrist_target(const struct poi *poi, const struct bowl *bowl,
                                   struct poi_target target);

/* Rotates the ring toward `goal` for one tick. The wrist is a critically damped spring with a lag
 * of 25 ms in air. Under water, the added inertia and the drag of the water act against the
 * rotation. */
void poi_wrist_turn(struct poi *poi, struct angles goal);

#endif
