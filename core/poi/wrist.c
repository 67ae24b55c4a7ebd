/* wrist.c -- rotates the ring: the wrist is a damped spring about three axes, and the ring tips
 * over the bowl automatically. */
#include "core/poi/wrist.h"

#include "core/poi/disc.h"
#include "core/poi/pose.h"

/* Natural angular frequency of the wrist spring in air, which causes a lag of 25 ms. */
#define TURN_RAD_S 80.0f
/* Moment of inertia of a poi of 7 g about the hand, which is 13 cm away. */
#define TURN_KG_M2 1.2e-4f
/* Torsional stiffness of the wrist, in N m per radian. */
#define TURN_N_M (TURN_KG_M2 * TURN_RAD_S * TURN_RAD_S)

/* Largest angle of the automatic tip. At this angle, a fish rolls over the ring. */
#define TIP_RAD (55.0f * F_DEG)
#define TIP_PER_S 3.0f
/* Limit below which the ring tips fully. The limit is compared with the horizontal distance between
 * the centres of the ring and the bowl's mouth, divided by the sum of their radii. */
#define TIP_NEAR 0.45f
/* Limit above which the ring does not tip. The limit is compared with the horizontal distance
 * between the centres of the ring and the bowl's mouth, divided by the sum of their radii. */
#define TIP_FAR 0.95f
#define TIP_FALL_M 0.040f /* Distance from the ring's centre at which a fish falls off the ring. */
/* Limit below which the ring tips fully. The limit is compared with the distance between the
 * landing point of a fish and the centre of the bowl's mouth, divided by the radius of the
 * mouth. */
#define TIP_HIT 0.65f
#define TIP_BACK_SHARE 0.4f
/* Number of ticks for which the poi stays tipped after its last fish left. A fish that still rolls
 * over the ring then falls into the bowl. */
#define TIP_LADEN_TICKS (CORE_TICK_HZ / 2u)
/* Height of the ring's lowest edge above the bowl's mouth while the poi is tipped. */
#define TIP_EDGE_M 0.010f

/* ---- Automatic tip over the bowl ------------------------------------------------------------ */

/* Returns the target in [0, 1] for the progress of the tip: 0 means level, 1 means fully tipped.
 * The target is 1 if the ring is over the mouth of its bowl and above the water, and if a fish that
 * fell off would land in the mouth. `way` is the horizontal vector from the centre of the ring to
 * the centre of the bowl's mouth. */
static float over_bowl(const struct poi *poi, const struct bowl *bowl, vec3 way)
{
    if (!bowl->present) {
        return 0.0f;
    }
    const float near = v3_length(way) / (BOWL_RADIUS_M + POI_RADIUS_M);
    const vec3 fall = v3_muladd(way, poi->tip_toward, -TIP_FALL_M);
    const float miss = v3_length(fall) / BOWL_RADIUS_M;
    const float goal = f_min(1.0f - f_smoothstep(TIP_NEAR, TIP_FAR, near),
                             1.0f - f_smoothstep(TIP_HIT, 1.0f, miss));
    return goal * (1.0f - f_smoothstep(0.0f, 0.5f, poi->immersed));
}

/* Returns the horizontal direction of the tip for a bowl in the direction `way`. The function
 * prefers roll to pitch, because a wrist rolls a handle more easily than it raises the handle. The
 * tip never lowers the handle, because the handle would then pass through the bowl. If the bowl is
 * between the ring and the hand, the poi therefore only rolls. */
static vec3 rather_sideways(vec3 way, float yaw_rad)
{
    const vec3 right = v3(f_cos(yaw_rad), 0.0f, -f_sin(yaw_rad));
    const vec3 back = v3(f_sin(yaw_rad), 0.0f, f_cos(yaw_rad));
    const float aside = v3_dot(way, right), behind = f_min(v3_dot(way, back), 0.0f);
    const vec3 mix = v3_muladd(v3_scale(right, aside), back, TIP_BACK_SHARE * behind);
    return v3_length(mix) > 1e-3f ? v3_normalize_or(mix, right) : right;
}

void wrist_tip(struct poi *poi, const struct bowl *bowl, int has_wrist)
{
    const vec3 way =
        v3(bowl->position_m.x - poi->position_m.x, 0.0f, bowl->position_m.z - poi->position_m.z);
    if (poi->tip < 0.02f) {
        poi->tip_toward = rather_sideways(way, poi->angles.yaw_rad);
    }
    poi->laden_ticks = poi->carried_count > 0 ? TIP_LADEN_TICKS
                       : poi->laden_ticks > 0 ? (uint8_t)(poi->laden_ticks - 1u)
                                              : 0u;
    const float goal = has_wrist || poi->laden_ticks == 0 ? 0.0f : over_bowl(poi, bowl, way);
    const float step = TIP_PER_S * CORE_TICK_S;
    poi->tip += f_clamp(goal - poi->tip, -step, step);
}

/* The function also lifts the ring while the poi is tipped, because the fish would otherwise slide
 * out below the bowl's mouth. */
struct poi_target wrist_target(const struct poi *poi, const struct bowl *bowl,
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
    target.position_m.y = f_max(target.position_m.y, edge + POI_OUTER_RADIUS_M * f_sin(turn_rad));
    return target;
}

/* ---- Rotation of the ring -------------------------------------------------------------------- */

/* Added inertia and drag coefficient of the water for a rotation about one axis. Both members are 0
 * for a rotation about the disc's normal. */
struct turn_water {
    float kg_m2, n_m_s;
};

static struct turn_water turn_water(const struct poi *poi, float along, float rate_rad_s)
{
    const float share = poi_whole(poi) * f_max(0.0f, 1.0f - along * along);
    return (struct turn_water){
        .kg_m2 = share * disc_turn_added_kg_m2(POI_RADIUS_M, poi->added_kg),
        .n_m_s = share * poi->immersed * disc_turn_n_m_s(POI_RADIUS_M, rate_rad_s),
    };
}

/* Rotates one angle toward `goal` by one implicit integration step of a critically damped spring.
 * The implicit step is stable at any stiffness. */
static void turn_angle(float *angle, float *speed, float goal, struct turn_water water)
{
    const float error = f_wrap_angle(goal - *angle), dt = CORE_TICK_S;
    const float mass = TURN_KG_M2 + water.kg_m2;
    const float damping = 2.0f * f_sqrt(TURN_N_M * mass) + water.n_m_s;
    *speed = (mass * *speed + dt * TURN_N_M * error) / (mass + dt * damping + dt * dt * TURN_N_M);
    *angle = f_wrap_angle(*angle + dt * *speed);
}

void wrist_turn(struct poi *poi, struct angles goal)
{
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
