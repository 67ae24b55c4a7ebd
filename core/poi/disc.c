/* disc.c -- computes the forces of the water on a thin disc, and the loads on the ring and its
 * paper from the motion of the ring in one tick.
 *
 * alpha is the angle between the plane of the disc and its velocity. The normal force coefficient
 * C_N is the force along the normal of the disc, divided by rho / 2 * A * V^2. rho is the density
 * of water, A is the area of the disc, and V is its speed. At a small alpha, C_N is the coefficient
 * of a wing of low aspect ratio. At a large alpha, C_N is the coefficient of a disc perpendicular
 * to the flow. */
#include "core/poi/ring.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "core/base/physics.h"

/* Normal force coefficient C_N of a disc that moves along its normal. Published values are 1.12 to
 * 1.17. */
#define CN_BROADSIDE 1.17f
/* Normal force coefficient C_N divided by sin(alpha), at a small angle alpha between the disc and
 * its velocity. A circular wing has 1.79 per radian at very small angles, and more at larger
 * angles. */
#define CN_PER_SINE 2.0f
#define NU_M2_S 1.0e-6f     /* Kinematic viscosity of water at 20 C. */
#define ENTRY_HALF_M 0.005f /* Half the range of heights over which a level disc submerges. */
/* Depth from which the water surface has no effect on the added mass: 1.5 times the radius of the
 * poi. */
#define OPEN_DEPTH_M 0.06f

float disc_immersed(float radius_m, float centre_y_m, float up_y)
{
    CORE_ASSERT(radius_m > 0.0f);
    const float slope = f_sqrt(f_max(0.0f, 1.0f - up_y * up_y));
    const float half = f_max(radius_m * slope, ENTRY_HALF_M);
    const float t = f_clamp(-centre_y_m / half, -1.0f, 1.0f);
    const float asin_t = 0.5f * F_PI - f_acos(t);
    return f_clamp(0.5f + (t * f_sqrt(1.0f - t * t) + asin_t) / F_PI, 0.0f, 1.0f);
}

float disc_added_mass_kg(float radius_m, float centre_y_m, float immersed)
{
    CORE_ASSERT(radius_m > 0.0f);
    CORE_ASSERT(immersed >= 0.0f && immersed <= 1.0f);
    const float open = (8.0f / 3.0f) * WATER_KG_M3 * radius_m * radius_m * radius_m;
    const float depth = f_clamp(-centre_y_m / OPEN_DEPTH_M, 0.0f, 1.0f);
    return open * immersed * (0.5f + 0.5f * depth);
}

float disc_normal_n_s_m(float radius_m, float normal_m_s, float plane_m_s)
{
    CORE_ASSERT(radius_m > 0.0f);
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
    CORE_ASSERT(radius_m > 0.0f);
    const float speed = f_abs(plane_m_s);
    if (speed < 1e-4f) {
        return 0.0f;
    }
    const float reynolds = speed * 2.0f * radius_m / NU_M2_S;
    const float friction = 1.328f / f_sqrt(reynolds);
    return friction * 0.5f * WATER_KG_M3 * 2.0f * F_PI * radius_m * radius_m * speed;
}

/* The torque is the integral of the drag over a disc of radius a. The drag is proportional to the
 * square of x, the distance from the axis of rotation. The integral of |x|^3 over the disc is
 * (8/15) * a^5. */
float disc_turn_n_m_s(float radius_m, float rate_rad_s)
{
    const float square = radius_m * radius_m;
    const float integral = 8.0f / 15.0f * square * square * radius_m;
    return 0.5f * WATER_KG_M3 * CN_BROADSIDE * integral * f_abs(rate_rad_s);
}

/* ---- Loads on the ring and its paper --------------------------------------------------------- */

/* Time constant of the low-pass filter for the ring's acceleration. The time constant is longer
 * than a period of pointer jitter divided by 2 pi, so that the filter attenuates the jitter. A
 * pointing device reports whole pixels, which causes a jitter of half a pixel at 8 to 30 Hz.
 * Without the filter, this jitter would act on the paper as water pressure.
 *
 * The filter has two stages with this time constant each, because one stage with the same
 * attenuation would need about twice the delay. */
#define FEEL_TAU_S 0.050f
/* Upper limit of the filtered acceleration, from which the load on the paper is computed. The limit
 * keeps this load low when the ring stops suddenly at a wall, because the wall's force acts on the
 * ring and not on the paper. */
#define FEEL_M_S2_MAX 6.0f

#define SIGMA_N_M 0.072f
/* Height to which a rising plate lifts the water surface before the surface separates from the
 * plate: 2 * sqrt(sigma / (rho * g)), where sigma is the surface tension. */
#define CLING_M 0.0054f

vec3 poi_weight_n(const struct poi *poi)
{
    CORE_ASSERT(poi->immersed >= 0.0f && poi->immersed <= 1.0f);
    const float mass_kg = POI_MASS_KG + poi->water_kg + poi->carried_kg;
    return v3(0.0f, -GRAVITY_M_S2 * mass_kg * (1.0f - poi->immersed), 0.0f);
}

vec3 poi_water_n(const struct poi *poi, const struct basis *axes)
{
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    const vec3 water_n =
        v3(-poi->edge_n_s_m * v.x, poi->slam_n - poi->drag_n_s_m * v.y, -poi->edge_n_s_m * v.z);
    return vec_basis_to_world(axes, water_n);
}

float poi_meniscus_n(const struct poi *poi, float up_y)
{
    if (!poi->clings) {
        return 0.0f;
    }
    /* The meniscus clings to the fraction `share` of the ring's edge: the part that is above the
     * water by at most CLING_M. */
    const float y_m = poi->position_m.y;
    const float half_m = f_max(poi_radius_m(poi) * f_sqrt(f_max(0.0f, 1.0f - up_y * up_y)), 1e-4f);
    const float low = f_clamp(-y_m / half_m, -1.0f, 1.0f);
    const float high = f_clamp((CLING_M - y_m) / half_m, -1.0f, 1.0f);
    const float share = (f_acos(low) - f_acos(high)) / F_PI;
    return 2.0f * (F_TAU * poi_radius_m(poi) * SIGMA_N_M) * share;
}

float poi_kick_n(const struct poi *poi)
{
    CORE_ASSERT(poi->slap_count <= poi->load_count && poi->load_count <= SHEET_LOAD_MAX);
    float kick_n = 0.0f;
    for (uint32_t i = 0; i < poi->slap_count; i++) {
        kick_n += poi->loads[i].force_n;
    }
    return kick_n;
}

float poi_paper_pa(struct poi *poi, const struct basis *axes)
{
    /* Updates the filtered acceleration from the actual motion of the ring. Therefore the
     * acceleration is 0 if the hand pulls at a blocked ring. */
    const vec3 gain_m_s = v3_sub(poi->velocity_m_s, poi->before_m_s);
    const vec3 jolt_m_s2 = v3_limit(v3_scale(gain_m_s, 1.0f / CORE_TICK_S), 8.0f * FEEL_M_S2_MAX);
    const float share = CORE_TICK_S / (FEEL_TAU_S + CORE_TICK_S);
    poi->jolt_m_s2 = v3_lerp(poi->jolt_m_s2, jolt_m_s2, share);
    const vec3 felt = v3_lerp(poi->acceleration_m_s2, poi->jolt_m_s2, share);
    poi->acceleration_m_s2 = v3_limit(felt, FEEL_M_S2_MAX);
    const float area_m2 = poi_whole(poi) * F_PI * poi_radius_m(poi) * poi_radius_m(poi);
    const float lift_m_s2 = v3_dot(poi->acceleration_m_s2, axes->up);
    const float drag_n = -poi->drag_n_s_m * v3_dot(poi->velocity_m_s, axes->up);
    const float water_n = poi->slam_n + drag_n - poi->added_kg * lift_m_s2;
    /* In addition to the water forces `water_n`, three forces act on the paper along its normal.
     * The first force is the weight of the paper, the water and the fish, multiplied by the
     * fraction of the disc that is in air. The second force is the inertia of the same mass at the
     * acceleration `lift_m_s2`. The third force is the half of the meniscus force that acts on the
     * lower face. */
    const float paper_kg = sheet_grade(poi->sheet.grade)->areal_kg_m2 * area_m2;
    const float carried_kg_in_air =
        (paper_kg + poi->water_kg + poi->carried_kg) * (1.0f - poi->immersed);
    const float even_pa = (water_n - (carried_kg_in_air * (GRAVITY_M_S2 * axes->up.y + lift_m_s2) +
                                      0.5f * poi->meniscus_n * axes->up.y)) /
                          area_m2;
    /* A rotation about a diameter of the disc causes water pressure in opposite directions on the
     * two halves of the disc. The strain of the paper depends only on the magnitude of that
     * pressure, which is computed from the mean square of the normal speed. The normal speed is
     * proportional to x, the distance from the axis of rotation. The mean of x^2 over a disc of
     * radius a is a^2 / 4. */
    const float rate_rad_s = v3_length(poi->spin_rad_s);
    const float square_m2_s2 =
        0.25f * poi_radius_m(poi) * poi_radius_m(poi) * rate_rad_s * rate_rad_s;
    const float turn_pa = 0.5f * WATER_KG_M3 * CN_BROADSIDE * square_m2_s2;
    return even_pa + (even_pa < 0.0f ? -1.0f : 1.0f) * (poi->immersed * turn_pa);
}
