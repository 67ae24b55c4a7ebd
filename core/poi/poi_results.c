/* poi_results.c -- applies the reaction of the fish to a poi (the paper scoop), returns the poi
 * as an obstacle for fish and as a shade on the water, and computes the force feedback. */
#include "core/poi/poi.h"

#include "core/base/panic.h"
#include "core/poi/ring.h"

_Static_assert(OBSTACLE_PAPER_SIDE == SHEET_SIDE && OBSTACLE_PAPER_HOLDS == CELL_PAPER,
               "fish read the sheet's own cells");

struct obstacle poi_obstacle(const struct poi *poi)
{
    const struct angles now = poi->angles, before = poi->before_angles;
    const struct basis axes = vec_basis_from_angles(now);
    /* Computes the fraction [0, 1] of the ring's speed that fish blocked in the last tick. */
    const float goal_m_s = v3_length(poi->velocity_m_s), real_m_s = v3_length(poi->before_m_s);
    const float stalled = poi->reaction && real_m_s < goal_m_s ? 1.0f - real_m_s / goal_m_s : 0.0f;
    return (struct obstacle){
        .kind = OBSTACLE_DISC,
        .centre_m = poi->position_m,
        .normal = axes.up,
        .velocity_m_s = poi->velocity_m_s,
        .stalled = stalled,
        .radius_m = poi_outer_radius_m(poi),
        .step_m = v3_sub(poi->position_m, poi->before_m),
        .axes = axes,
        .axes_before = vec_basis_from_angles(before),
        .turned = now.yaw_rad != before.yaw_rad || now.pitch_rad != before.pitch_rad ||
                  now.roll_rad != before.roll_rad,
        .paper = poi->sheet.paper_cells > 0 ? poi->sheet.state : NULL,
        .paper_radius_m = poi->sheet.radius_m,
        .open = 1.0f - poi_whole(poi),
    };
}

void poi_apply_reaction(struct poi *poi, const struct obstacle *ring)
{
    CORE_ASSERT(ring->kind == OBSTACLE_DISC);
    poi->reaction = ring->reaction;
    if (ring->reaction & REACTION_POSITION) {
        poi->position_m = ring->centre_m;
        poi->velocity_m_s = ring->velocity_m_s;
    }
    if (ring->reaction & REACTION_ROTATION) {
        poi->angles = poi->before_angles;
        poi->angular_velocity_rad_s = poi->spin_rad_s = v3(0.0f, 0.0f, 0.0f);
    }
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const struct sheet_wetting wet = { axes.right.y, axes.back.y, -poi->position_m.y };
    poi->pressure_pa = poi_paper_pa(poi, &axes);
    poi->strain = poi->damage_immune
                      ? sheet_tick(&poi->sheet, 0.0f, wet, NULL, 0)
                      : sheet_tick(&poi->sheet, poi->pressure_pa, wet, poi->loads, poi->load_count);
    carried_water_tick(poi, axes.up.y);
}

/* Computes the shade of a poi. Thin paper absorbs a third of the light, and holes absorb no light.
 * A tilted ring casts an elliptical shade, which the function approximates by a circle of equal
 * area. */
struct shade_cast poi_shade(const struct poi *poi)
{
    const float flat = f_abs(vec_basis_from_angles(poi->angles).up.y);
    return (struct shade_cast){
        .present = poi->immersed <= 0.0f && poi->position_m.y > 0.0f,
        .x_m = poi->position_m.x,
        .z_m = poi->position_m.z,
        .radius_m = poi_outer_radius_m(poi) * f_sqrt(f_max(flat, 0.05f)),
        .dark = POI_PAPER_DARK * sheet_left(&poi->sheet),
    };
}

/* ---- Force feedback -------------------------------------------------------------------------- */

static vec3 clamp_vector(vec3 v, float most)
{
    return v3(f_clamp(v.x, -most, most), f_clamp(v.y, -most, most), f_clamp(v.z, -most, most));
}

void poi_haptics(const struct poi *poi, struct poi_force *force)
{
    CORE_ASSERT(poi->load_count <= SHEET_LOAD_MAX);
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 none = v3(0.0f, 0.0f, 0.0f);
    /* Total force that caused the change of velocity in this tick. The force accelerates the ring,
     * the carried water and fish, and the displaced water. */
    const vec3 mass_kg = poi_mass_kg(poi);
    const vec3 gain = vec_basis_to_body(&axes, v3_sub(poi->velocity_m_s, poi->before_m_s));
    const vec3 took = v3(mass_kg.x * gain.x, mass_kg.y * gain.y, mass_kg.z * gain.z);
    const vec3 moved_n = v3_scale(vec_basis_to_world(&axes, took), (float)CORE_TICK_HZ);
    /* Sum of all forces on the ring except the force of the hand. All forces of the fish count as
     * if they acted at the centre of the ring. */
    const vec3 water_n = poi_water_n(poi, &axes);
    const float kick_n = poi_kick_n(poi);
    const vec3 carried_n =
        v3_add(v3_add(poi_weight_n(poi), water_n),
               v3_add(v3(0.0f, -poi->meniscus_n, 0.0f), v3_scale(axes.up, kick_n)));
    /* For a freely moving ring, the force of the hand on the ring is computed from the motion. For
     * a blocked ring, the force is that of the stretched hand spring. */
    const bool is_blocked = poi->stopped || poi->reaction;
    const vec3 hand = is_blocked ? poi_spring_n(poi, &axes) : v3_sub(moved_n, carried_n);
    const vec3 felt_n = v3_scale(hand, -1.0f);
    /* A wall, the floor, a bowl or fish push on a blocked ring at the point of the ring that is
     * nearest to the obstacle. */
    vec3 push_torque = none;
    if (is_blocked) {
        const vec3 push = v3_limit(v3_sub(moved_n, v3_add(hand, carried_n)), POI_FORCE_N_MAX);
        const vec3 flat = v3_muladd(push, axes.up, -v3_dot(push, axes.up));
        push_torque =
            v3_cross(v3_scale(v3_normalize_or(flat, none), -poi_outer_radius_m(poi)), push);
    }
    const vec3 torque = v3_add(v3_cross(v3_scale(axes.back, -POI_GRIP_M), felt_n), push_torque);
    /* Torque of the fish that lie or slap at a distance from the centre of the ring. */
    vec3 fish_torque = none;
    for (uint32_t i = 0; i < poi->load_count; i++) {
        const struct sheet_load *load = &poi->loads[i];
        const vec3 place_m = vec_basis_to_world(&axes, v3(load->x_m, 0.0f, load->z_m));
        fish_torque = v3_add(fish_torque, v3_cross(place_m, v3_scale(axes.up, load->force_n)));
    }
    const float per_rad_s = disc_turn_n_m_s(poi_radius_m(poi), v3_length(poi->spin_rad_s));
    const vec3 own =
        v3_add(fish_torque, v3_scale(poi->spin_rad_s, -poi_whole(poi) * poi->immersed * per_rad_s));
    *force = (struct poi_force){
        .force_n = clamp_vector(felt_n, POI_FORCE_N_MAX),
        .torque_n_m = clamp_vector(v3_add(torque, own), POI_TORQUE_N_M_MAX),
        .drag = f_clamp(v3_length(water_n) / POI_DRAG_N_FULL, 0.0f, 1.0f),
        .slap = f_clamp(-kick_n / POI_SLAP_N_FULL, 0.0f, 1.0f),
        .tear = f_clamp((float)poi->strain.cells_torn / POI_TEAR_CELLS_FULL, 0.0f, 1.0f),
    };
}
