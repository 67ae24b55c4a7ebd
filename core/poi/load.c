/* load.c -- computes the forces on the ring and on its paper from the motion of the ring in this
 * tick. */
#include "core/poi/load.h"

#include "core/base/physics.h"
#include "core/poi/disc.h"

/* Time constant of the low-pass filter for the acceleration. A pointing device reports whole
 * pixels, which causes a jitter of half a pixel at 8 to 30 Hz. Without the filter, this jitter
 * would act on the paper as water pressure. The filter has two stages, because a single stage would
 * need twice the delay. */
#define FEEL_TAU_S 0.050f
/* Upper limit of the filtered acceleration. The force of a sudden stop at a wall acts on the ring
 * and not on the paper. */
#define FEEL_M_S2_MAX 6.0f

#define SIGMA_N_M 0.072f
/* Height to which a rising plate lifts the water surface before the surface separates from the
 * plate: 2 * sqrt(sigma / (rho * g)), where sigma is the surface tension. */
#define CLING_M 0.0054f

vec3 load_weight_n(const struct poi *poi)
{
    const float mass_kg = POI_MASS_KG + poi->water_kg + poi->carried_kg;
    return v3(0.0f, -GRAVITY_M_S2 * mass_kg * (1.0f - poi->immersed), 0.0f);
}

vec3 load_water_n(const struct poi *poi, const struct basis *axes)
{
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    const vec3 water_n =
        v3(-poi->edge_n_s_m * v.x, poi->slam_n - poi->drag_n_s_m * v.y, -poi->edge_n_s_m * v.z);
    return vec_basis_to_world(axes, water_n);
}

/* Returns the fraction [0, 1] of the ring's edge to which the meniscus still clings: the part that
 * is above the water by at most CLING_M. */
static float clinging_share(float centre_y_m, float up_y)
{
    const float half_m = f_max(POI_RADIUS_M * f_sqrt(f_max(0.0f, 1.0f - up_y * up_y)), 1e-4f);
    const float low = f_clamp(-centre_y_m / half_m, -1.0f, 1.0f);
    const float high = f_clamp((CLING_M - centre_y_m) / half_m, -1.0f, 1.0f);
    return (f_acos(low) - f_acos(high)) / F_PI;
}

float load_meniscus_n(const struct poi *poi, float up_y)
{
    const float face_n = F_TAU * POI_RADIUS_M * SIGMA_N_M;
    return poi->clings ? 2.0f * face_n * clinging_share(poi->position_m.y, up_y) : 0.0f;
}

float load_kick_n(const struct poi *poi)
{
    float kick_n = 0.0f;
    for (uint32_t i = 0; i < poi->slap_count; i++) {
        kick_n += poi->loads[i].force_n;
    }
    return kick_n;
}

/* Updates the filtered acceleration from the actual motion of the ring. If the hand pulls at a
 * blocked ring, the acceleration is therefore 0. */
static void feel_jolt(struct poi *poi)
{
    const vec3 gain_m_s = v3_sub(poi->velocity_m_s, poi->before_m_s);
    const vec3 jolt_m_s2 = v3_limit(v3_scale(gain_m_s, 1.0f / CORE_TICK_S), 8.0f * FEEL_M_S2_MAX);
    const float share = CORE_TICK_S / (FEEL_TAU_S + CORE_TICK_S);
    poi->jolt_m_s2 = v3_lerp(poi->jolt_m_s2, jolt_m_s2, share);
    const vec3 felt = v3_lerp(poi->acceleration_m_s2, poi->jolt_m_s2, share);
    poi->acceleration_m_s2 = v3_limit(felt, FEEL_M_S2_MAX);
}

/* Returns the water pressure that a rotation about a diameter of the disc causes, computed from the
 * mean square of the normal speed. The pressure has opposite directions on the two halves of the
 * disc, but the strain of the paper depends only on its magnitude. */
static float turning_pa(const struct poi *poi)
{
    const float rate_rad_s = v3_length(poi->spin_rad_s);
    return poi->immersed * disc_turn_pa(POI_RADIUS_M, rate_rad_s);
}

/* Returns the force on the paper along the normal. The force consists of the weight of paper, water
 * and fish in air, of their inertia at the acceleration `lift_m_s2`, and of the half of the
 * meniscus force that acts on the lower face. */
static float burden_n(const struct poi *poi, float area_m2, float up_y, float lift_m_s2)
{
    const float paper_kg = sheet_grade(poi->sheet.grade)->areal_kg_m2 * area_m2;
    const float burden_kg = (paper_kg + poi->water_kg + poi->carried_kg) * (1.0f - poi->immersed);
    return burden_kg * (GRAVITY_M_S2 * up_y + lift_m_s2) + 0.5f * poi->meniscus_n * up_y;
}

float load_paper_pa(struct poi *poi, const struct basis *axes)
{
    feel_jolt(poi);
    const float area_m2 = poi_whole(poi) * F_PI * POI_RADIUS_M * POI_RADIUS_M;
    const float lift_m_s2 = v3_dot(poi->acceleration_m_s2, axes->up);
    const float drag_n = -poi->drag_n_s_m * v3_dot(poi->velocity_m_s, axes->up);
    const float water_n = poi->slam_n + drag_n - poi->added_kg * lift_m_s2;
    const float even_pa = (water_n - burden_n(poi, area_m2, axes->up.y, lift_m_s2)) / area_m2;
    return even_pa + (even_pa < 0.0f ? -1.0f : 1.0f) * turning_pa(poi);
}
