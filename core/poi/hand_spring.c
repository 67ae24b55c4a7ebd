/* hand_spring.c -- moves the ring by one implicit integration step of the spring between hand and
 * ring. */
#include "core/poi/hand_spring.h"

#include "core/base/physics.h"
#include "core/poi/disc.h"
#include "core/poi/load.h"

/* Stiffness of the spring between the player's hand and the ring. The damping increases with the
 * added mass of water, so that the spring is critically damped along the normal under water. The
 * ring lags behind a moving hand by damping / stiffness: 25 ms in air, and 56 ms for motion along
 * the normal under water. */
#define HAND_N_M 215.0f
#define HAND_LAG_AIR_S 0.0250f
/* Largest force of the spring. A human wrist can exert about this force. */
#define HAND_N_MAX 20.0f

/* The following constants limit the speed of the ring. A hand that pushes against a slow obstacle
 * moves ahead of the ring and stretches the spring. Without a limit, the spring would accelerate
 * the ring to 3.7 m/s when the obstacle disappears. The limit is the recent speed of the hand
 * (pace_m_s) plus CATCH_UP_PER_S times the distance to the target. A freely moving ring never
 * reaches this limit, because its speed is at most pace_m_s * exp(lag / 0.3 s). */
/* Additional allowed speed of the ring per metre of distance to its target, in 1/s. */
#define CATCH_UP_PER_S 4.0f
/* Upper limit of the additional speed of the ring while the ring catches up with its target. */
#define CATCH_UP_M_S 1.0f
/* Time constant with which the stored recent speed of the hand decreases. */
#define PACE_TAU_S 0.30f
/* Upper limit of the stored recent speed of the hand. No arm is faster, but a wrong input report
 * may contain a higher speed. */
#define PACE_MAX_M_S 4.0f
#define EDGE_ADDED_KG 0.010f /* Added mass of water for motion of the ring along its plane. */

/* Returns the speed of the ring on one axis after one backward Euler step. The spring force, the
 * damping and the additional force `other_n` act on the mass. A stiffness of 0 means that the
 * spring force is constant. */
static float axis_speed(float mass_kg, float speed_m_s, float spring_n, float stiffness_n_m,
                        float damping_n_s_m, float other_n)
{
    const float dt = CORE_TICK_S;
    return (mass_kg * speed_m_s + dt * (spring_n + other_n)) /
           (mass_kg + dt * damping_n_s_m + dt * dt * stiffness_n_m);
}

/* Returns the spring force, limited to HAND_N_MAX. Writes the stiffness of the spring to
 * `stiffness_n_m`, or 0 if the limit applies. */
static vec3 spring_force(vec3 stretch_m, float *stiffness_n_m)
{
    const vec3 full = v3_scale(stretch_m, HAND_N_M);
    const int capped = v3_dot(full, full) > HAND_N_MAX * HAND_N_MAX;
    *stiffness_n_m = capped ? 0.0f : HAND_N_M;
    return v3_limit(full, HAND_N_MAX);
}

/* Returns the slam force, with which water resists a disc that submerges: the normal speed times
 * the increase of the added mass per second. Returns 0 if the disc is leaving the water. */
static float slam_n(const struct poi *poi, float immersed, float added_kg, float normal_m_s)
{
    if (immersed <= poi->immersed) {
        return 0.0f;
    }
    const float share = (immersed - poi->immersed) / f_max(immersed, 1e-3f);
    return -normal_m_s * added_kg * share / CORE_TICK_S;
}

/* Updates `pace_m_s`, the recent speed of the hand, and `hand_m`, the position of the hand. */
static void feel_pace(struct poi *poi, vec3 hand_m)
{
    const float now_m_s = v3_length(v3_sub(hand_m, poi->hand_m)) * (float)CORE_TICK_HZ;
    const float late_m_s = poi->pace_m_s * (1.0f - CORE_TICK_S / PACE_TAU_S);
    poi->pace_m_s = f_min(f_max(now_m_s, late_m_s), PACE_MAX_M_S);
    poi->hand_m = hand_m;
}

static float catch_up_m_s(const struct poi *poi, vec3 target_m)
{
    const float behind_m = v3_length(v3_sub(target_m, poi->position_m));
    return f_min(CATCH_UP_PER_S * behind_m, CATCH_UP_M_S);
}

static float damping_plane_n_s_m(void)
{
    return HAND_N_M * HAND_LAG_AIR_S;
}

static float damping_normal_n_s_m(const struct poi *poi)
{
    const float critical = 2.0f * f_sqrt(HAND_N_M * (POI_MASS_KG + poi->added_kg));
    return f_max(damping_plane_n_s_m(), critical);
}

vec3 hand_spring_mass_kg(const struct poi *poi)
{
    const float load_kg = POI_MASS_KG + poi->water_kg + poi->carried_kg;
    const float plane_kg = load_kg + EDGE_ADDED_KG * poi->immersed;
    return v3(plane_kg, load_kg + poi->added_kg, plane_kg);
}

/* Computes the water forces on a ring with the velocity `v` in the ring's own axes. Water passes
 * through the holes of torn paper, so that only the ring and the remaining paper cause drag. */
static void meet_water(struct poi *poi, vec3 v, float immersed)
{
    const float plane_m_s = f_sqrt(v.x * v.x + v.z * v.z);
    const float whole = poi_whole(poi);
    poi->added_kg = whole * disc_added_mass_kg(POI_RADIUS_M, poi->position_m.y, immersed);
    poi->drag_n_s_m = whole * immersed * disc_normal_n_s_m(POI_RADIUS_M, v.y, plane_m_s);
    poi->edge_n_s_m = immersed * disc_edge_n_s_m(POI_RADIUS_M, plane_m_s);
    poi->slam_n = slam_n(poi, immersed, poi->added_kg, v.y);
}

/* Returns the velocity of the ring after this tick, in the ring's axes and before the speed limit.
 * `v` is the present velocity, `k` is the stiffness of the spring, and `burden_n` is the sum of the
 * weight, the meniscus force and the slaps. */
static vec3 free_m_s(const struct poi *poi, vec3 v, vec3 spring_n, float k, vec3 burden_n)
{
    const vec3 mass_kg = hand_spring_mass_kg(poi);
    const float c_plane = damping_plane_n_s_m() + poi->edge_n_s_m;
    const float c_normal = damping_normal_n_s_m(poi) + poi->drag_n_s_m;
    const float normal_n = burden_n.y + poi->slam_n;
    return v3(axis_speed(mass_kg.x, v.x, spring_n.x, k, c_plane, burden_n.x),
              axis_speed(mass_kg.y, v.y, spring_n.y, k, c_normal, normal_n),
              axis_speed(mass_kg.z, v.z, spring_n.z, k, c_plane, burden_n.z));
}

void hand_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed)
{
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    feel_pace(poi, target_m);
    meet_water(poi, v, immersed);
    poi->immersed = immersed;
    poi->meniscus_n = load_meniscus_n(poi, axes->up.y);
    const vec3 down_n = v3_add(load_weight_n(poi), v3(0.0f, -poi->meniscus_n, 0.0f));
    vec3 burden_n = vec_basis_to_body(axes, down_n);
    burden_n.y += load_kick_n(poi);
    float k;
    const vec3 spring_n =
        vec_basis_to_body(axes, spring_force(v3_sub(target_m, poi->position_m), &k));
    const vec3 free = free_m_s(poi, v, spring_n, k, burden_n);
    const vec3 next = v3_limit(free, poi->pace_m_s + catch_up_m_s(poi, target_m));
    poi->velocity_m_s = vec_basis_to_world(axes, next);
}

vec3 hand_spring_force_n(const struct poi *poi, const struct basis *axes)
{
    float k;
    const vec3 spring_n = spring_force(v3_sub(poi->hand_m, poi->position_m), &k);
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    const float plane = damping_plane_n_s_m(), normal = damping_normal_n_s_m(poi);
    const vec3 damper_n = v3(-plane * v.x, -normal * v.y, -plane * v.z);
    return v3_add(spring_n, vec_basis_to_world(axes, damper_n));
}
