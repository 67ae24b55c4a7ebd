/* disc.h -- computes the forces of the water on a thin tilted disc.
 *
 * The poi is the paper scoop, and the disc is a model of its ring and paper. Forces are returned as
 * coefficients (force divided by speed). A caller adds a coefficient to the left side of an
 * implicit integration step. Drag then slows a poi at any speed but never reverses its motion. In
 * the formulas, rho is the density of water, and a is the radius of the disc. */
#ifndef KINGYO_CORE_POI_DISC_H
#define KINGYO_CORE_POI_DISC_H

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

#endif
