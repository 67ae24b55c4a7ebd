/* poi.c -- moves the ring of a poi (the paper scoop) in one tick. A spring between hand and ring
 * moves the centre of the ring, and a damped spring about three axes (the wrist) rotates the ring.
 * Both springs are integrated implicitly.
 *
 * A poi whose input has no angles tips over its bowl automatically. */
#include "core/poi/poi.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/poi/pose.h"
#include "core/poi/ring.h"

/* Stiffness of the spring between the player's hand and the ring. The damping increases with the
 * added mass of water, so that the spring is critically damped along the normal under water. The
 * ring lags behind a moving hand by damping / stiffness: 25 ms in air, and 56 ms for motion along
 * the normal under water. */
#define HAND_N_M 215.0f
#define HAND_LAG_AIR_S 0.0250f
#define PLANE_N_S_M (HAND_N_M * HAND_LAG_AIR_S) /* Damping for motion along the ring's plane. */
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

static float damping_normal_n_s_m(const struct poi *poi)
{
    const float critical = 2.0f * f_sqrt(HAND_N_M * (POI_MASS_KG + poi->added_kg));
    return f_max(PLANE_N_S_M, critical);
}

vec3 poi_mass_kg(const struct poi *poi)
{
    CORE_ASSERT(poi->water_kg >= 0.0f && poi->carried_kg >= 0.0f);
    const float load_kg = POI_MASS_KG + poi->water_kg + poi->carried_kg;
    const float plane_kg = load_kg + EDGE_ADDED_KG * poi->immersed;
    return v3(plane_kg, load_kg + poi->added_kg, plane_kg);
}

void poi_spring_tick(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed)
{
    CORE_ASSERT(v3_is_finite(target_m));
    CORE_ASSERT(immersed >= 0.0f && immersed <= 1.0f);
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    /* Updates `pace_m_s`, the recent speed of the hand, and `hand_m`, the position of the hand. */
    const float now_m_s = v3_length(v3_sub(target_m, poi->hand_m)) * (float)CORE_TICK_HZ;
    const float late_m_s = poi->pace_m_s * (1.0f - CORE_TICK_S / PACE_TAU_S);
    poi->pace_m_s = f_min(f_max(now_m_s, late_m_s), PACE_MAX_M_S);
    poi->hand_m = target_m;
    /* Water passes through the holes of torn paper, so that only the ring and the remaining paper
     * cause drag. */
    const float plane_m_s = f_sqrt(v.x * v.x + v.z * v.z);
    const float whole = poi_whole(poi);
    poi->added_kg = whole * disc_added_mass_kg(poi_radius_m(poi), poi->position_m.y, immersed);
    poi->drag_n_s_m = whole * immersed * disc_normal_n_s_m(poi_radius_m(poi), v.y, plane_m_s);
    poi->edge_n_s_m = immersed * disc_edge_n_s_m(poi_radius_m(poi), plane_m_s);
    /* The slam force, with which water resists a disc that submerges, is the normal speed times the
     * increase of the added mass per second. The force is 0 if the disc is leaving the water. */
    const float entered = (immersed - poi->immersed) / f_max(immersed, 1e-3f);
    poi->slam_n = immersed > poi->immersed ? -v.y * poi->added_kg * entered / CORE_TICK_S : 0.0f;
    poi->immersed = immersed;
    poi->meniscus_n = poi_meniscus_n(poi, axes->up.y);
    const vec3 down_n = v3_add(poi_weight_n(poi), v3(0.0f, -poi->meniscus_n, 0.0f));
    vec3 carried_n = vec_basis_to_body(axes, down_n);
    carried_n.y += poi_kick_n(poi);
    /* If the spring force has reached its limit HAND_N_MAX, the force no longer depends on the
     * distance, so the stiffness counts as 0. */
    const vec3 stretch_m = v3_sub(target_m, poi->position_m);
    const vec3 full_n = v3_scale(stretch_m, HAND_N_M);
    const float stiffness = v3_dot(full_n, full_n) > HAND_N_MAX * HAND_N_MAX ? 0.0f : HAND_N_M;
    const vec3 spring_n = vec_basis_to_body(axes, v3_limit(full_n, HAND_N_MAX));
    const vec3 mass_kg = poi_mass_kg(poi);
    const float plane = PLANE_N_S_M + poi->edge_n_s_m;
    const float normal = damping_normal_n_s_m(poi) + poi->drag_n_s_m;
    const vec3 free_m_s = v3(
        ring_axis_m_s(mass_kg.x, v.x, spring_n.x + carried_n.x, plane, stiffness),
        ring_axis_m_s(mass_kg.y, v.y, spring_n.y + (carried_n.y + poi->slam_n), normal, stiffness),
        ring_axis_m_s(mass_kg.z, v.z, spring_n.z + carried_n.z, plane, stiffness));
    const float catch_up_m_s = f_min(CATCH_UP_PER_S * v3_length(stretch_m), CATCH_UP_M_S);
    poi->velocity_m_s = vec_basis_to_world(axes, v3_limit(free_m_s, poi->pace_m_s + catch_up_m_s));
}

vec3 poi_spring_n(const struct poi *poi, const struct basis *axes)
{
    const vec3 full_n = v3_scale(v3_sub(poi->hand_m, poi->position_m), HAND_N_M);
    const vec3 v = vec_basis_to_body(axes, poi->velocity_m_s);
    const vec3 damper_n =
        v3(-PLANE_N_S_M * v.x, -damping_normal_n_s_m(poi) * v.y, -PLANE_N_S_M * v.z);
    return v3_add(v3_limit(full_n, HAND_N_MAX), vec_basis_to_world(axes, damper_n));
}

/* ---- Wrist ----------------------------------------------------------------------------------- */

/* Natural angular frequency of the wrist spring in air, which causes a lag of 25 ms. */
#define TURN_RAD_S 80.0f
/* Moment of inertia of a poi of 7 g about the hand, which is 13 cm away. */
#define TURN_KG_M2 1.2e-4f
/* Torsional stiffness of the wrist, in N m per radian. */
#define TURN_N_M (TURN_KG_M2 * TURN_RAD_S * TURN_RAD_S)

/* Largest angle of the automatic tip. At this angle, a fish rolls over the ring. */
#define TIP_RAD (55.0f * F_DEG)
#define TIP_PER_S 3.0f
/* Distance below which the ring tips fully: the horizontal distance between the centres of the ring
 * and the bowl's mouth, divided by the sum of their radii. */
#define TIP_NEAR 0.45f
/* Distance above which the ring does not tip: the horizontal distance between the centres of the
 * ring and the bowl's mouth, divided by the sum of their radii. */
#define TIP_FAR 0.95f
#define TIP_FALL_M 0.040f /* Distance from the ring's centre at which a fish falls off the ring. */
/* Distance below which the ring tips fully: the distance from the centre of the bowl's mouth to the
 * point where a fish would land, divided by the radius of the mouth. */
#define TIP_HIT 0.65f
#define TIP_BACK_SHARE 0.4f
/* Number of ticks for which the poi stays tipped after its last fish left. A fish that still rolls
 * over the ring then falls into the bowl. */
#define TIP_LADEN_TICKS (CORE_TICK_HZ / 2u)
/* Height of the ring's lowest edge above the bowl's mouth while the poi is tipped. */
#define TIP_EDGE_M 0.010f

/* ---- Automatic tip over the bowl ------------------------------------------------------------ */

/* Returns the horizontal direction of the tip (the automatic tilt of the poi over its bowl) for a
 * bowl in the direction `way`. The function prefers roll to pitch, because a wrist rolls a handle
 * more easily than it raises the handle. The tip never lowers the handle, because the handle would
 * then pass through the bowl. If the bowl is between the ring and the hand, the poi therefore only
 * rolls. */
static vec3 rather_sideways(vec3 way, float yaw_rad)
{
    const vec3 right = v3(f_cos(yaw_rad), 0.0f, -f_sin(yaw_rad));
    const vec3 back = v3(f_sin(yaw_rad), 0.0f, f_cos(yaw_rad));
    const float aside = v3_dot(way, right), behind = f_min(v3_dot(way, back), 0.0f);
    const vec3 mix = v3_muladd(v3_scale(right, aside), back, TIP_BACK_SHARE * behind);
    return v3_length(mix) > 1e-3f ? v3_normalize_or(mix, right) : right;
}

/* Updates the progress and the direction of the automatic tip over the bowl. A poi is tipped while
 * it carries fish, and for half a second after the last fish left. The poi rotates back if it
 * carries no fish or if the input controls its angles. */
static void tip_over_bowl(struct poi *poi, const struct bowl *bowl, bool has_wrist)
{
    CORE_ASSERT(poi->tip >= 0.0f && poi->tip <= 1.0f);
    const vec3 way = v3_flat(v3_sub(bowl->position_m, poi->position_m));
    if (poi->tip < 0.02f) {
        poi->tip_toward = rather_sideways(way, poi->angles.yaw_rad);
    }
    poi->laden_ticks = poi->carried_count > 0 ? TIP_LADEN_TICKS
                       : poi->laden_ticks > 0 ? (uint8_t)(poi->laden_ticks - 1u)
                                              : 0u;
    /* The goal of the tip is 1 if the ring is over the mouth of its bowl and above the water,
     * and if a fish that fell off would land in the mouth. */
    float goal = 0.0f;
    if (!has_wrist && poi->laden_ticks > 0 && bowl->present) {
        const float near = v3_length(way) / (BOWL_RADIUS_M + poi_radius_m(poi));
        const vec3 fall = v3_muladd(way, poi->tip_toward, -TIP_FALL_M);
        const float miss = v3_length(fall) / BOWL_RADIUS_M;
        goal = f_min(1.0f - f_smoothstep(TIP_NEAR, TIP_FAR, near),
                     1.0f - f_smoothstep(TIP_HIT, 1.0f, miss)) *
               (1.0f - f_smoothstep(0.0f, 0.5f, poi->immersed));
    }
    const float step = TIP_PER_S * CORE_TICK_S;
    poi->tip += f_clamp(goal - poi->tip, -step, step);
}

/* Returns the pose `target` after the automatic tip, which tilts the poi over its bowl. The angle
 * of the tip grows with its progress, `poi->tip`. While the poi is tipped, the returned pose is
 * also higher, because the fish would otherwise slide out below the bowl's mouth. */
static struct poi_target tipped_target(const struct poi *poi, const struct bowl *bowl,
                                       struct poi_target target)
{
    if (poi->tip <= 0.0f) {
        return target;
    }
    const vec3 axis = v3_cross(v3(0.0f, 1.0f, 0.0f), poi->tip_toward);
    const float eased = f_smoothstep(0.0f, 1.0f, poi->tip);
    const float turn_rad = TIP_RAD * eased;
    const struct basis held = vec_basis_from_angles(target.angles);
    const struct basis turned = pose_turn(&held, axis, turn_rad);
    target.angles = pose_angles(&turned);
    const float edge = (bowl->position_m.y + TIP_EDGE_M) * eased;
    target.position_m.y =
        f_max(target.position_m.y, edge + poi_outer_radius_m(poi) * f_sin(turn_rad));
    return target;
}

/* ---- Rotation of the ring -------------------------------------------------------------------- */

/* Added moment of inertia and drag coefficient that the water causes for a rotation about one axis.
 * Both members are 0 for a rotation about the disc's normal. */
struct turn_water {
    float kg_m2, n_m_s;
};

static struct turn_water turn_water(const struct poi *poi, float along, float rate_rad_s)
{
    const float share = poi_whole(poi) * f_max(0.0f, 1.0f - along * along);
    return (struct turn_water){
        /* The added moment of inertia, (16/45) * rho * a^5, is the added mass, (8/3) * rho * a^3,
         * times (2/15) * a^2. */
        .kg_m2 = share * (2.0f / 15.0f * poi->added_kg * poi_radius_m(poi) * poi_radius_m(poi)),
        .n_m_s = share * poi->immersed * disc_turn_n_m_s(poi_radius_m(poi), rate_rad_s),
    };
}

/* Rotates one angle toward `goal` by one implicit integration step of a critically damped spring.
 * The implicit step is stable at any stiffness. */
static void turn_angle(float *angle, float *speed, float goal, struct turn_water water)
{
    CORE_ASSERT(water.kg_m2 >= 0.0f && water.n_m_s >= 0.0f);
    const float error = f_wrap_angle(goal - *angle), dt = CORE_TICK_S;
    const float mass = TURN_KG_M2 + water.kg_m2;
    const float damping = 2.0f * f_sqrt(TURN_N_M * mass) + water.n_m_s;
    *speed = (mass * *speed + dt * TURN_N_M * error) / (mass + dt * damping + dt * dt * TURN_N_M);
    *angle = f_wrap_angle(*angle + dt * *speed);
}

/* Rotates the ring toward `goal` for one tick. The wrist is a critically damped spring with a
 * lag of 25 ms in air. Under water, the added inertia and the drag of the water act against the
 * rotation. */
static void turn_ring(struct poi *poi, struct angles goal)
{
    CORE_ASSERT(v3_is_finite(v3(goal.yaw_rad, goal.pitch_rad, goal.roll_rad)));
    const struct basis before = vec_basis_from_angles(poi->angles);
    vec3 *rate = &poi->angular_velocity_rad_s;
    const vec3 side = v3(f_cos(poi->angles.yaw_rad), 0.0f, -f_sin(poi->angles.yaw_rad));
    turn_angle(&poi->angles.yaw_rad, &rate->x, goal.yaw_rad, turn_water(poi, before.up.y, rate->x));
    turn_angle(&poi->angles.pitch_rad, &rate->y, goal.pitch_rad,
               turn_water(poi, v3_dot(before.up, side), rate->y));
    turn_angle(&poi->angles.roll_rad, &rate->z, goal.roll_rad, turn_water(poi, 0.0f, rate->z));
    const vec3 up = vec_basis_from_angles(poi->angles).up;
    poi->spin_rad_s = v3_scale(v3_cross(before.up, up), (float)CORE_TICK_HZ);
}

/* ---- Tick of the poi ------------------------------------------------------------------------- */

/* Immersed fraction of the disc above which a dip counts as a scoop. With this fraction, the centre
 * of a level disc is 3 mm under water. */
#define SCOOP_IMMERSED 0.2f

void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed)
{
    poi_init_sized(poi, grade, POI_RADIUS_M, position_m, seed);
}

void poi_init_sized(struct poi *poi, uint8_t grade, float radius_m, vec3 position_m, uint32_t seed)
{
    CORE_ASSERT(v3_is_finite(position_m));
    CORE_ASSERT(radius_m >= POI_RADIUS_M && radius_m <= POI_RADIUS_MAX_M);
    memset(poi, 0, sizeof *poi);
    poi->seed = seed;
    poi->position_m = poi->before_m = poi->hand_m = position_m;
    sheet_init(&poi->sheet, grade, radius_m, seed);
    poi->immersed = disc_immersed(poi_radius_m(poi), position_m.y, 1.0f);
}

void poi_tick(struct poi *poi, const struct poi_grip *grip, const struct tank *tank,
              const struct bowl *bowl)
{
    poi->before_m = poi->position_m;
    poi->before_m_s = poi->velocity_m_s;
    poi->before_angles = poi->angles;
    tip_over_bowl(poi, bowl, grip->has_wrist);
    const struct poi_target target = tipped_target(poi, bowl, grip->target);
    turn_ring(poi, target.angles);
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const float was_immersed = poi->immersed;
    poi_spring_tick(poi, target.position_m, &axes,
                    disc_immersed(poi_radius_m(poi), poi->position_m.y, axes.up.y));
    poi->clings = poi->immersed > 0.0f || poi->meniscus_n > 0.0f;
    poi->splash_m_s = 0.0f;
    if (was_immersed <= 0.0f && poi->immersed > 0.0f) {
        poi->splash_m_s = v3_length(poi->velocity_m_s) + 0.01f;
    } else if (was_immersed > 0.0f && poi->immersed <= 0.0f) {
        poi->splash_m_s = -v3_length(poi->velocity_m_s) - 0.01f;
    }
    /* A dip (an entry into the water) counts as a scoop only if more than SCOOP_IMMERSED of the
     * disc gets under water while a player controls the poi. */
    if (poi->immersed <= 0.0f) {
        poi->is_in = false;
    } else if (!poi->is_in && poi->immersed > SCOOP_IMMERSED) {
        poi->is_in = true;
        poi->dips += !poi->damage_immune;
    }
    const vec3 free_m = v3_muladd(poi->before_m, poi->velocity_m_s, CORE_TICK_S);
    poi->position_m = free_m;
    poi_constrain(poi, tank, bowl);
    const vec3 off_m = v3_sub(poi->position_m, free_m);
    poi->stopped = v3_dot(off_m, off_m) > 0.0f;
}
