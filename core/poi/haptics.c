/* haptics.c -- computes the force and the torque that act on the player's hand at the handle of the
 * poi. */
#include "core/poi/haptics.h"

#include "core/poi/disc.h"
#include "core/poi/hand_spring.h"
#include "core/poi/load.h"

static vec3 clamp_vector(vec3 v, float most)
{
    return v3(f_clamp(v.x, -most, most), f_clamp(v.y, -most, most), f_clamp(v.z, -most, most));
}

/* Returns the sum of all forces on the ring except the force of the hand. The fish count as if they
 * were at the centre of the ring. */
static vec3 burden_n(const struct poi *poi, const struct basis *axes)
{
    const vec3 down_n = v3(0.0f, -poi->meniscus_n, 0.0f);
    const vec3 kick_n = v3_scale(axes->up, load_kick_n(poi));
    return v3_add(v3_add(load_weight_n(poi), load_water_n(poi, axes)), v3_add(down_n, kick_n));
}

static int is_held_up(const struct poi *poi)
{
    return poi->stopped || poi->reaction;
}

/* Returns the total force that caused the change of velocity in this tick. The accelerated mass
 * consists of the ring and the carried and displaced water and fish. */
static vec3 moved_n(const struct poi *poi, const struct basis *axes)
{
    const vec3 mass_kg = hand_spring_mass_kg(poi);
    const vec3 gain = vec_basis_to_body(axes, v3_sub(poi->velocity_m_s, poi->before_m_s));
    const vec3 took = v3(mass_kg.x * gain.x, mass_kg.y * gain.y, mass_kg.z * gain.z);
    return v3_scale(vec_basis_to_world(axes, took), (float)CORE_TICK_HZ);
}

/* Returns the force of the hand on the ring. For a freely moving ring, the force is computed from
 * the motion. For a blocked ring, the force is that of the stretched hand spring. */
static vec3 hand_n(const struct poi *poi, const struct basis *axes)
{
    return is_held_up(poi) ? hand_spring_force_n(poi, axes)
                           : v3_sub(moved_n(poi, axes), burden_n(poi, axes));
}

/* Returns the torque of the contact force if the ring is blocked, otherwise 0. A wall, the floor, a
 * bowl or fish push at the point of the ring that is nearest to them. */
static vec3 push_torque_n_m(const struct poi *poi, const struct basis *axes, vec3 hand)
{
    if (!is_held_up(poi)) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    const vec3 others_n = v3_add(hand, burden_n(poi, axes));
    const vec3 push = v3_limit(v3_sub(moved_n(poi, axes), others_n), POI_FORCE_N_MAX);
    const vec3 flat = v3_muladd(push, axes->up, -v3_dot(push, axes->up));
    const vec3 toward = v3_normalize_or(flat, v3(0.0f, 0.0f, 0.0f));
    return v3_cross(v3_scale(toward, -POI_OUTER_RADIUS_M), push);
}

/* Returns the torque of the fish that lie or slap at a distance from the centre of the ring. */
static vec3 fish_torque_n_m(const struct poi *poi, const struct basis *axes)
{
    vec3 torque = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t i = 0; i < poi->load_count; i++) {
        const struct sheet_load *load = &poi->loads[i];
        const vec3 place_m = vec_basis_to_world(axes, v3(load->x_m, 0.0f, load->z_m));
        torque = v3_add(torque, v3_cross(place_m, v3_scale(axes->up, load->force_n)));
    }
    return torque;
}

static vec3 turn_torque_n_m(const struct poi *poi)
{
    const float rate_rad_s = v3_length(poi->spin_rad_s);
    const float per_rad_s = disc_turn_n_m_s(POI_RADIUS_M, rate_rad_s);
    return v3_scale(poi->spin_rad_s, -poi_whole(poi) * poi->immersed * per_rad_s);
}

void haptics_feel(const struct poi *poi, struct poi_force *force)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 hand = hand_n(poi, &axes);
    const vec3 felt_n = v3_scale(hand, -1.0f);
    const vec3 torque = v3_add(v3_cross(v3_scale(axes.back, -POI_GRIP_M), felt_n),
                               push_torque_n_m(poi, &axes, hand));
    const vec3 own = v3_add(fish_torque_n_m(poi, &axes), turn_torque_n_m(poi));
    const float drag = v3_length(load_water_n(poi, &axes)) / POI_DRAG_N_FULL;
    *force = (struct poi_force){
        .force_n = clamp_vector(felt_n, POI_FORCE_N_MAX),
        .torque_n_m = clamp_vector(v3_add(torque, own), POI_TORQUE_N_M_MAX),
        .drag = f_clamp(drag, 0.0f, 1.0f),
        .slap = f_clamp(-load_kick_n(poi) / POI_SLAP_N_FULL, 0.0f, 1.0f),
        .tear = f_clamp((float)poi->strain.cells_torn / POI_TEAR_CELLS_FULL, 0.0f, 1.0f),
    };
}
