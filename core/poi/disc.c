/* disc.c -- computes the forces of the water on a thin disc.
 *
 * alpha is the angle between the plane of the disc and its velocity. At a small alpha, the normal
 * force coefficient C_N is that of a wing of low aspect ratio. At a large alpha, C_N is that of a
 * disc perpendicular to the flow. */
#include "core/poi/disc.h"

#include "core/base/fmath.h"
#include "core/base/physics.h"

/* C_N of a disc that moves along its normal. Published values are 1.12 to 1.17. */
#define CN_BROADSIDE 1.17f
/* C_N divided by sin(alpha) at a small alpha. A circular wing has 1.79 per radian at very small
 * angles, and more at larger angles. */
#define CN_PER_SINE 2.0f
#define NU_M2_S 1.0e-6f     /* Kinematic viscosity of water at 20 C. */
#define ENTRY_HALF_M 0.005f /* Half the range of heights over which a level disc submerges. */
/* Depth from which the water surface has no effect on the added mass: 1.5 times the radius of the
 * poi. */
#define OPEN_DEPTH_M 0.06f

float disc_immersed(float radius_m, float centre_y_m, float up_y)
{
    const float slope = f_sqrt(f_max(0.0f, 1.0f - up_y * up_y));
    const float half = f_max(radius_m * slope, ENTRY_HALF_M);
    const float t = f_clamp(-centre_y_m / half, -1.0f, 1.0f);
    const float asin_t = 0.5f * F_PI - f_acos(t);
    return f_clamp(0.5f + (t * f_sqrt(1.0f - t * t) + asin_t) / F_PI, 0.0f, 1.0f);
}

float disc_added_mass_kg(float radius_m, float centre_y_m, float immersed)
{
    const float open = (8.0f / 3.0f) * WATER_KG_M3 * radius_m * radius_m * radius_m;
    const float depth = f_clamp(-centre_y_m / OPEN_DEPTH_M, 0.0f, 1.0f);
    return open * immersed * (0.5f + 0.5f * depth);
}

float disc_normal_n_s_m(float radius_m, float normal_m_s, float plane_m_s)
{
    const float half_rho_area = 0.5f * WATER_KG_M3 * F_PI * radius_m * radius_m;
    const float square = normal_m_s * normal_m_s + plane_m_s * plane_m_s;
    const float speed = f_sqrt(square);
    /* The force is F = rho / 2 * A * min(1.17 * V^2, 2 * |v_n| * V). A is the area, V is the speed,
     * and v_n is the speed along the normal. The result is F / |v_n|. The code divides by |v_n|
     * only if |v_n| is not small. */
    const float slender = CN_PER_SINE * speed;
    const float normal = f_abs(normal_m_s);
    if (CN_PER_SINE * normal <= CN_BROADSIDE * speed) {
        return half_rho_area * slender;
    }
    return half_rho_area * CN_BROADSIDE * square / normal;
}

float disc_edge_n_s_m(float radius_m, float plane_m_s)
{
    const float speed = f_abs(plane_m_s);
    if (speed < 1e-4f) {
        return 0.0f;
    }
    const float reynolds = speed * 2.0f * radius_m / NU_M2_S;
    const float friction = 1.328f / f_sqrt(reynolds);
    return friction * 0.5f * WATER_KG_M3 * 2.0f * F_PI * radius_m * radius_m * speed;
}

/* The result is `added_kg` times the ratio of the added moment of inertia, (16/45) * rho * a^5, to
 * the added mass, (8/3) * rho * a^3. */
float disc_turn_added_kg_m2(float radius_m, float added_kg)
{
    return 2.0f / 15.0f * added_kg * radius_m * radius_m;
}

/* The torque is the integral of the drag over the disc. The integral of |x|^3 over a disc of radius
 * a is (8/15) * a^5. */
float disc_turn_n_m_s(float radius_m, float rate_rad_s)
{
    const float square = radius_m * radius_m;
    const float integral = 8.0f / 15.0f * square * square * radius_m;
    return 0.5f * WATER_KG_M3 * CN_BROADSIDE * integral * f_abs(rate_rad_s);
}

/* The pressure is computed from the mean square of the speed. The mean of x^2 over a disc of radius
 * a is a^2 / 4. */
float disc_turn_pa(float radius_m, float rate_rad_s)
{
    const float square_m2_s2 = 0.25f * radius_m * radius_m * rate_rad_s * rate_rad_s;
    return 0.5f * WATER_KG_M3 * CN_BROADSIDE * square_m2_s2;
}
