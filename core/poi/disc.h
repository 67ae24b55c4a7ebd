/* disc.h -- the forces of the water on a thin tilted disc.
 *
 * Coefficients are force per speed, so that a caller can add them to the left side of an implicit
 * step. Drag then slows a poi and can never throw it back, at any speed. */
#ifndef KINGYO_CORE_POI_DISC_H
#define KINGYO_CORE_POI_DISC_H

/* Returns the share [0, 1] of a disc's area under the still surface. `up_y` is the vertical
 * component of its unit normal. A level disc submerges over 10 mm, because its paper sags and takes
 * air along. */
float disc_immersed(float radius_m, float centre_y_m, float up_y);

/* Returns the added mass along the normal: (8/3) rho a^3 in open water, half of it at the
 * surface. */
float disc_added_mass_kg(float radius_m, float centre_y_m, float immersed);

/* Returns normal force / normal speed for a fully immersed disc (N s/m). C_N = min(1.17, 2 sin
 * alpha), alpha the angle between its plane and its velocity; both speeds are relative to the
 * water. */
float disc_normal_n_s_m(float radius_m, float normal_m_s, float plane_m_s);

/* Returns friction / speed along the plane (N s/m), both faces, laminar plate. */
float disc_edge_n_s_m(float radius_m, float plane_m_s);

/* Coefficients of a disc that rotates about its own diameter: added inertia (kg m^2) for `added_kg`
 * along its normal; torque / rate under water (N m s); and the pressure from the mean square of its
 * speed. The water is (16/45) rho a^5, with C_N of a broadside disc at each point. */
float disc_turn_added_kg_m2(float radius_m, float added_kg);
float disc_turn_n_m_s(float radius_m, float rate_rad_s);
float disc_turn_pa(float radius_m, float rate_rad_s);

#endif
