/* poi.c -- simulates one tick of the poi, returns the poi as an obstacle for fish and as a shade on
 * the water, and computes the force feedback. */
#include "core/poi/poi.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/ring.h"

/* Immersed fraction of the disc above which a dip counts as a scoop. With this fraction, the centre
 * of a level disc is 3 mm under water. */
#define SCOOP_IMMERSED 0.2f

_Static_assert(OBSTACLE_PAPER_SIDE == SHEET_SIDE && OBSTACLE_PAPER_HOLDS == CELL_PAPER,
               "fish read the sheet's own cells");

void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed)
{
    CORE_ASSERT(v3_is_finite(position_m));
    memset(poi, 0, sizeof *poi);
    poi->seed = seed;
    poi->position_m = poi->before_m = poi->hand_m = position_m;
    sheet_init(&poi->sheet, grade, POI_RADIUS_M, seed);
    poi->immersed = disc_immersed(POI_RADIUS_M, position_m.y, 1.0f);
}

void poi_tick(struct poi *poi, const struct poi_grip *grip, const struct tank *tank,
              const struct bowl *bowl)
{
    CORE_ASSERT(v3_is_finite(grip->target.position_m));
    CORE_ASSERT(f_is_finite(grip->target.angles.yaw_rad));
    CORE_ASSERT(f_is_finite(grip->target.angles.pitch_rad));
    CORE_ASSERT(f_is_finite(grip->target.angles.roll_rad));
    poi->before_m = poi->position_m;
    poi->before_m_s = poi->velocity_m_s;
    poi->before_angles = poi->angles;
    poi_wrist_tip(poi, bowl, grip->has_wrist);
    const struct poi_target target = poi_wrist_target(poi, bowl, grip->target);
    poi_wrist_turn(poi, target.angles);

    const struct basis axes = vec_basis_from_angles(poi->angles);
    const float was_immersed = poi->immersed;
    hand_spring_tick(poi, target.position_m, &axes,
                     disc_immersed(POI_RADIUS_M, poi->position_m.y, axes.up.y));
    poi->clings = poi->immersed > 0.0f || poi->meniscus_n > 0.0f;
    poi->splash_m_s = 0.0f;
    if (was_immersed <= 0.0f && poi->immersed > 0.0f) {
        poi->splash_m_s = v3_length(poi->velocity_m_s) + 0.01f;
    } else if (was_immersed > 0.0f && poi->immersed <= 0.0f) {
        poi->splash_m_s = -v3_length(poi->velocity_m_s) - 0.01f;
    }
    /* An entry into the water (dip) counts as a scoop if more than SCOOP_IMMERSED of the disc is
     * under water and a player controls the poi. */
    if (poi->immersed <= 0.0f) {
        poi->is_in = 0;
    } else if (!poi->is_in && poi->immersed > SCOOP_IMMERSED) {
        poi->is_in = 1;
        poi->dips += poi->damage_immune ? 0u : 1u;
    }
    const vec3 free_m = v3_muladd(poi->before_m, poi->velocity_m_s, CORE_TICK_S);
    poi->position_m = free_m;
    poi_constrain(poi, tank, bowl, poi->before_m, axes.up);
    const vec3 off_m = v3_sub(poi->position_m, free_m);
    poi->stopped = v3_dot(off_m, off_m) > 0.0f;
}

/* Returns the fraction [0, 1] of the ring's speed that fish blocked in the last tick, or 0 if no
 * fish blocked the ring. */
static float stalled(const struct poi *poi)
{
    const float wants_m_s = v3_length(poi->velocity_m_s), had_m_s = v3_length(poi->before_m_s);
    return poi->reaction && had_m_s < wants_m_s ? 1.0f - had_m_s / wants_m_s : 0.0f;
}

struct obstacle poi_obstacle(const struct poi *poi)
{
    const struct angles now = poi->angles, before = poi->before_angles;
    const struct basis axes = vec_basis_from_angles(now);
    return (struct obstacle){
        .kind = OBSTACLE_DISC,
        .centre_m = poi->position_m,
        .normal = axes.up,
        .velocity_m_s = poi->velocity_m_s,
        .stalled = stalled(poi),
        .radius_m = POI_OUTER_RADIUS_M,
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

/* Thin paper absorbs a third of the light, and holes absorb no light. A tilted ring casts an
 * elliptical shade. The function approximates the ellipse by a circle of equal area. */
struct shade_cast poi_shade(const struct poi *poi)
{
    const float flat = f_abs(vec_basis_from_angles(poi->angles).up.y);
    return (struct shade_cast){
        .present = poi->immersed <= 0.0f && poi->position_m.y > 0.0f,
        .x_m = poi->position_m.x,
        .z_m = poi->position_m.z,
        .radius_m = POI_OUTER_RADIUS_M * f_sqrt(f_max(flat, 0.05f)),
        .dark = POI_PAPER_DARK * sheet_left(&poi->sheet),
    };
}

uint64_t poi_hash_quick(uint64_t hash, const struct poi *poi)
{
    hash = hash_u32(hash, poi->link);
    hash = hash_vec3(hash, poi->position_m);
    hash = hash_vec3(hash, poi->velocity_m_s);
    hash = hash_vec3(hash, v3(poi->angles.yaw_rad, poi->angles.pitch_rad, poi->angles.roll_rad));
    hash = hash_float(hash, poi->immersed);
    hash = hash_u32(hash, poi->sheet.paper_cells);
    hash = hash_u32(hash, poi->carried_count);
    hash = hash_u32(hash, poi->is_in);
    return hash_u32(hash, poi->dips);
}

uint64_t poi_hash(uint64_t hash, const struct poi *poi)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    CORE_ASSERT(poi->load_count <= SHEET_LOAD_MAX);
    /* clang-format off */
    const float values[] = { poi->splash_m_s,  poi->water_kg,  poi->tip,
                             poi->pressure_pa, poi->carried_kg, poi->before_angles.yaw_rad,
                             poi->before_angles.pitch_rad, poi->before_angles.roll_rad,
                             poi->pace_m_s, poi->drag_n_s_m, poi->slam_n, poi->added_kg,
                             poi->edge_n_s_m, poi->meniscus_n, poi->film_kg, poi->pool_kg,
                             poi->drip_kg };
    /* clang-format on */
    hash = poi_hash_quick(hash, poi);
    hash = hash_u32(hash, poi->seed);
    hash = hash_u32(hash, poi->damage_immune);
    hash = hash_vec3(hash, poi->before_m);
    hash = hash_vec3(hash, poi->hand_m);
    hash = hash_vec3(hash, poi->before_m_s);
    hash = hash_u32(hash, poi->reaction);
    hash = hash_u32(hash, poi->stopped);
    hash = hash_u32(hash, poi->jam_ticks);
    hash = hash_u32(hash, poi->clings);
    hash = hash_u32(hash, poi->drops);
    hash = hash_u32(hash, poi->laden_ticks);
    hash = hash_vec3(hash, poi->angular_velocity_rad_s);
    hash = hash_vec3(hash, poi->spin_rad_s);
    hash = hash_vec3(hash, poi->acceleration_m_s2);
    hash = hash_vec3(hash, poi->jolt_m_s2);
    hash = hash_vec3(hash, poi->tip_toward);
    hash = hash_floats(hash, values, sizeof values / sizeof values[0]);
    hash = hash_u32(hash, poi->slap_tick);
    hash = hash_u32(hash, poi->tear_tick);
    hash = hash_u32(hash, poi->strain.cells_torn);
    hash = hash_float(hash, poi->strain.tension_max_n_m);
    hash = hash_u32(hash, poi->load_count);
    hash = hash_u32(hash, poi->slap_count);
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        hash = carried_fish_hash(hash, &poi->carried_fish[i]);
    }
    for (uint32_t i = 0; i < poi->load_count; i++) {
        const struct sheet_load *load = &poi->loads[i];
        hash = hash_vec3(hash, v3(load->x_m, load->diameter_m, load->z_m));
        hash = hash_float(hash, load->force_n);
    }
    return sheet_hash(hash, &poi->sheet);
}

/* ---- Force feedback -------------------------------------------------------------------------- */

static vec3 clamp_vector(vec3 v, float most)
{
    return v3(f_clamp(v.x, -most, most), f_clamp(v.y, -most, most), f_clamp(v.z, -most, most));
}

/* Returns the sum of all forces on the ring except the force of the hand. The fish count as if they
 * were at the centre of the ring. */
static vec3 burden_n(const struct poi *poi, const struct basis *axes)
{
    const vec3 down_n = v3(0.0f, -poi->meniscus_n, 0.0f);
    const vec3 kick_n = v3_scale(axes->up, poi_kick_n(poi));
    return v3_add(v3_add(poi_weight_n(poi), poi_water_n(poi, axes)), v3_add(down_n, kick_n));
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
    CORE_ASSERT(poi->load_count <= SHEET_LOAD_MAX);
    vec3 torque = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t i = 0; i < poi->load_count; i++) {
        const struct sheet_load *load = &poi->loads[i];
        const vec3 place_m = vec_basis_to_world(axes, v3(load->x_m, 0.0f, load->z_m));
        torque = v3_add(torque, v3_cross(place_m, v3_scale(axes->up, load->force_n)));
    }
    return torque;
}

void poi_haptics(const struct poi *poi, struct poi_force *force)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    /* For a freely moving ring, the force of the hand on the ring is computed from the motion. For
     * a blocked ring, the force is that of the stretched hand spring. */
    const vec3 hand = is_held_up(poi) ? hand_spring_force_n(poi, &axes)
                                      : v3_sub(moved_n(poi, &axes), burden_n(poi, &axes));
    const vec3 felt_n = v3_scale(hand, -1.0f);
    const vec3 torque = v3_add(v3_cross(v3_scale(axes.back, -POI_GRIP_M), felt_n),
                               push_torque_n_m(poi, &axes, hand));
    const float rate_rad_s = v3_length(poi->spin_rad_s);
    const float per_rad_s = disc_turn_n_m_s(POI_RADIUS_M, rate_rad_s);
    const vec3 own = v3_add(fish_torque_n_m(poi, &axes),
                            v3_scale(poi->spin_rad_s, -poi_whole(poi) * poi->immersed * per_rad_s));
    const float drag = v3_length(poi_water_n(poi, &axes)) / POI_DRAG_N_FULL;
    *force = (struct poi_force){
        .force_n = clamp_vector(felt_n, POI_FORCE_N_MAX),
        .torque_n_m = clamp_vector(v3_add(torque, own), POI_TORQUE_N_M_MAX),
        .drag = f_clamp(drag, 0.0f, 1.0f),
        .slap = f_clamp(-poi_kick_n(poi) / POI_SLAP_N_FULL, 0.0f, 1.0f),
        .tear = f_clamp((float)poi->strain.cells_torn / POI_TEAR_CELLS_FULL, 0.0f, 1.0f),
    };
}
