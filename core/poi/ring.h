/* ring.h -- computes the mechanics of the ring of a poi (the paper scoop): the forces of the water,
 * the loads on ring and paper, and the hand spring.
 *
 * A disc is the model of the ring and its paper in the water. The functions disc_*() return forces
 * as coefficients (force divided by speed). A caller adds a coefficient to the left side of an
 * implicit integration step. Drag then slows a poi at any speed but never reverses its motion. In
 * the formulas, rho is the density of water, and a is the radius of the disc.
 *
 * The hand spring pulls the ring toward the hand of the player. Forces are in newtons and in world
 * axes unless a comment names other axes. */
#pragma once

#include "core/base/panic.h"
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

/* Returns the drag torque divided by the angular speed, in N m s, of an immersed disc that rotates
 * about one of its diameters. Each point of the disc has the force coefficient C_N of a motion
 * along the normal. */
float disc_turn_n_m_s(float radius_m, float rate_rad_s);

/* Returns the speed of a body on one axis after one backward Euler step of one tick. The step is
 * stable at any stiffness. A stiffness of 0 means that the force is constant. */
static inline float ring_axis_m_s(float kg, float speed_m_s, float force_n, float damping_n_s_m,
                                  float stiffness_n_m)
{
    CORE_ASSERT(kg > 0.0f);
    const float dt = CORE_TICK_S;
    return (kg * speed_m_s + dt * force_n) / (kg + dt * damping_n_s_m + dt * dt * stiffness_n_m);
}

/* Updates the velocity of the ring for one tick (1/120 s). A spring with a force of at most 20 N
 * pulls the ring toward `target_m`. `axes` are the poi's axes, and `immersed` is the fraction [0,
 * 1] of the disc that is in the water. Stores the water forces in `poi`. Does not change the
 * position. */
void poi_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed);

/* Returns the force of the hand on the ring, in world axes: the force of the spring and of its
 * damping at the present position and velocity of the ring. The function does not use the
 * acceleration of the ring, so the result is also valid for a blocked ring. `axes` are the poi's
 * axes. */
vec3 poi_spring_n(const struct poi *poi, const struct basis *axes);

/* Returns the effective mass of the ring for motion along each of its axes (right, up, back). The
 * effective mass consists of the ring, the carried water and fish, and the added mass of water. */
vec3 poi_mass_kg(const struct poi *poi);

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
