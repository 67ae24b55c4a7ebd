/* poi.c -- the ring: hand, water, walls. */
#include "core/poi/poi.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/poi/disc.h"
#include "core/poi/pose.h"
#include "core/poi/yield.h"

_Static_assert(OBSTACLE_PAPER_SIDE == SHEET_SIDE && OBSTACLE_PAPER_HOLDS == CELL_PAPER,
               "fish read the sheet's own cells");

/* The hand. One stiffness; damping grows with the water that has to move along, so that the spring
 * is critically damped along the normal under water and lags a moving hand by damping / stiffness:
 * 25 ms in air, 56 ms broadside under water. */
#define HAND_N_M 215.0f
#define HAND_LAG_AIR_S 0.0250f
#define HAND_N_MAX 20.0f     /* What a wrist gives; the poi yields beyond it. */
/* Who pushes against what yields slowly feels it and slows down with it. Free again, the poi goes
 * at the pace of the hand, now or a moment ago, and catches up at leisure: the spring alone would
 * shoot it off at 3.7 m/s. What moves freely is behind by its speed times the lag: it may go at
 * pace (1 + 4 lag), which is more than it ever goes: pace exp(lag / 0.3 s). */
#define CATCH_UP_PER_S 4.0f /* Of the way that it is behind, ... */
#define CATCH_UP_M_S 1.0f   /* ... at most. */
#define PACE_TAU_S 0.30f    /* A hand's pace is forgotten in this time. */
#define PACE_MAX_M_S 4.0f   /* No arm is faster; a report may be. */
#define EDGE_ADDED_KG 0.010f /* Water that the ring drags along its plane. */
#define TURN_RAD_S 80.0f     /* Wrist: lags by 25 ms. */
#define GRIP_M 0.130f        /* Ring centre to the hand, along the handle. */

#define TIP_RAD (55.0f * F_DEG) /* Steep enough for a fish to roll over the ring. */
#define TIP_PER_S 3.0f
#define TIP_NEAR 0.45f /* Ring to mouth, centre to centre, in sums of their radii: full turn ...   \
                        */
#define TIP_FAR 0.95f  /* ... and none. */
#define TIP_FALL_M 0.040f /* A fish leaves the ring so far from its centre; */
#define TIP_HIT 0.65f     /* well within the mouth, in its radii, the turn is full. */
#define TIP_BACK_SHARE 0.4f
#define TIP_EDGE_M 0.010f /* The lower edge then keeps so far over the mouth. */

/* What paper feels of acceleration is what lasts: a pointer's whole-pixel grain, half a pixel at 8
 * to 30 Hz, must not become blows of water. Two poles: one would need twice the delay for it. */
#define FEEL_TAU_S 0.050f
#define FEEL_M_S2_MAX 6.0f /* A stop at a wall is the ring's, not the paper's. */

#define FILM_KG 0.003f       /* Water that wet paper keeps, ... */
#define DRAIN_TAU_S 0.15f    /* divided by the sine of the tilt, for what is more; */
#define SEEP_TAU_S 6.0f      /* level, it seeps through. */
#define UNDER_POOL_KG 0.015f /* Upside down the 3 mm ring is a bowl. */

void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed)
{
    CORE_ASSERT(v3_is_finite(position_m));
    memset(poi, 0, sizeof *poi);
    poi->seed = seed;
    poi->position_m = poi->before_m = poi->hand_m = position_m;
    sheet_init(&poi->sheet, grade, POI_RADIUS_M, seed);
    poi->immersed = disc_immersed(POI_RADIUS_M, position_m.y, 1.0f);
}

/* ---- The wrist ------------------------------------------------------------------------------ */

/* [0, 1]: how far the ring is over the mouth of its bowl, clear of the water, and turned so that a
 * fish would fall into the mouth. */
static float over_bowl(const struct poi *poi, const struct bowl *bowl, vec3 way)
{
    if (!bowl->present) {
        return 0.0f;
    }
    const float near = v3_length(way) / (BOWL_RADIUS_M + POI_RADIUS_M);
    const vec3 fall = v3_mad(way, poi->tip_toward, -TIP_FALL_M);
    const float miss = v3_length(fall) / BOWL_RADIUS_M;
    const float goal = f_min(1.0f - f_smoothstep(TIP_NEAR, TIP_FAR, near),
                             1.0f - f_smoothstep(TIP_HIT, 1.0f, miss));
    return goal * (1.0f - f_smoothstep(0.0f, 0.5f, poi->immersed));
}

/* A wrist rolls a handle more easily than it raises it, and never lowers it: the handle would go
 * through the bowl. Toward a bowl between ring and hand it only rolls. */
static vec3 rather_sideways(vec3 way, float yaw_rad)
{
    const vec3 right = v3(f_cos(yaw_rad), 0.0f, -f_sin(yaw_rad));
    const vec3 back = v3(f_sin(yaw_rad), 0.0f, f_cos(yaw_rad));
    const float aside = v3_dot(way, right), behind = f_min(v3_dot(way, back), 0.0f);
    const vec3 mix = v3_mad(v3_scale(right, aside), back, TIP_BACK_SHARE * behind);
    return v3_length(mix) > 1e-3f ? v3_normalize_or(mix, right) : right;
}

static void tip_over(struct poi *poi, const struct bowl *bowl, int has_wrist)
{
    const vec3 way =
        v3(bowl->position_m.x - poi->position_m.x, 0.0f, bowl->position_m.z - poi->position_m.z);
    if (poi->tip < 0.02f) {
        poi->tip_toward = rather_sideways(way, poi->angles.yaw_rad);
    }
    const float goal = has_wrist ? 0.0f : over_bowl(poi, bowl, way);
    const float step = TIP_PER_S * CORE_TICK_S;
    poi->tip += f_clamp(goal - poi->tip, -step, step);
}

/* The hand's target, tipped toward the bowl. The wrist that turns the ring also lifts it, or the
 * fish would slide out below the bowl's mouth. */
static struct poi_target tipped(const struct poi *poi, const struct bowl *bowl,
                                struct poi_target target)
{
    if (poi->tip <= 0.0f) {
        return target;
    }
    const vec3 axis = v3_cross(v3(0.0f, 1.0f, 0.0f), poi->tip_toward);
    const float eased = f_smoothstep(0.0f, 1.0f, poi->tip);
    const float turn_rad = TIP_RAD * eased;
    const struct basis held = basis_from_angles(target.angles);
    const struct basis turned = pose_turn(&held, axis, turn_rad);
    target.angles = pose_angles(&turned);
    const float edge = (bowl->position_m.y + TIP_EDGE_M) * eased;
    target.position_m.y = f_max(target.position_m.y, edge + POI_OUTER_RADIUS_M * f_sin(turn_rad));
    return target;
}

/* Critically damped, implicit: stable at any stiffness. */
static void turn_angle(float *angle, float *speed, float goal)
{
    const float error = f_wrap_angle(goal - *angle);
    const float w = TURN_RAD_S, dt = CORE_TICK_S;
    *speed = (*speed + dt * w * w * error) / (1.0f + 2.0f * w * dt + w * w * dt * dt);
    *angle = f_wrap_angle(*angle + dt * *speed);
}

static void turn(struct poi *poi, struct angles goal)
{
    turn_angle(&poi->angles.yaw_rad, &poi->angular_velocity_rad_s.x, goal.yaw_rad);
    turn_angle(&poi->angles.pitch_rad, &poi->angular_velocity_rad_s.y, goal.pitch_rad);
    turn_angle(&poi->angles.roll_rad, &poi->angular_velocity_rad_s.z, goal.roll_rad);
}

/* ---- Hand against water --------------------------------------------------------------------- */

struct pull {
    vec3 hand_n;    /* On the ring, world. */
    vec3 water_n;   /* On the ring, world: drag and slam, without added mass. */
    vec3 weight_n;  /* Of ring, riders and water, as far as they are in air; world. */
};

/* One axis of the ring: mass m, drag D v, spring k (bounded) and damper c, backward Euler. */
static float axis_speed(float mass_kg, float speed_m_s, float spring_n, float stiffness_n_m,
                        float damping_n_s_m, float other_n)
{
    const float dt = CORE_TICK_S;
    return (mass_kg * speed_m_s + dt * (spring_n + other_n)) /
           (mass_kg + dt * damping_n_s_m + dt * dt * stiffness_n_m);
}

/* A spring stretched beyond HAND_N_MAX pulls with that and no more. */
static vec3 spring_force(vec3 stretch_m, float *stiffness_n_m)
{
    const vec3 full = v3_scale(stretch_m, HAND_N_M);
    const int capped = v3_dot(full, full) > HAND_N_MAX * HAND_N_MAX;
    *stiffness_n_m = capped ? 0.0f : HAND_N_M;
    return v3_limit(full, HAND_N_MAX);
}

/* Water that starts to move with a disc that goes under: v dm/dt. Leaving, it is left behind. */
static float slam_n(const struct poi *poi, float immersed, float added_kg, float normal_m_s)
{
    if (immersed <= poi->immersed) {
        return 0.0f;
    }
    const float share = (immersed - poi->immersed) / f_max(immersed, 1e-3f);
    return -normal_m_s * added_kg * share / CORE_TICK_S;
}

/* How fast the hand goes, or went of late. */
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

static struct pull pull_ring(struct poi *poi, vec3 target_m, const struct basis *axes,
                             float immersed)
{
    const vec3 v = basis_to_body(axes, poi->velocity_m_s);
    const float plane = f_sqrt(v.x * v.x + v.z * v.z);
    const float whole = 0.15f + 0.85f * sheet_left(&poi->sheet); /* A torn poi is a ring. */
    const float added = whole * disc_added_mass_kg(POI_RADIUS_M, poi->position_m.y, immersed);
    const float drag_n = whole * immersed * disc_normal_n_s_m(POI_RADIUS_M, v.y, plane);
    const float drag_p = immersed * disc_edge_n_s_m(POI_RADIUS_M, plane);
    const float air = 1.0f - immersed;
    const float load_kg = POI_MASS_KG + poi->water_kg + poi->riders_kg;
    const vec3 weight = basis_to_body(axes, v3(0.0f, -GRAVITY_M_S2 * load_kg * air, 0.0f));
    const float slam = slam_n(poi, immersed, added, v.y);

    float k;
    const vec3 spring = basis_to_body(axes, spring_force(v3_sub(target_m, poi->position_m), &k));
    const float c_plane = HAND_N_M * HAND_LAG_AIR_S;
    const float c_normal = f_max(c_plane, 2.0f * f_sqrt(HAND_N_M * (POI_MASS_KG + added)));
    const float m_plane = load_kg + EDGE_ADDED_KG * immersed, m_normal = load_kg + added;
    const vec3 free =
        v3(axis_speed(m_plane, v.x, spring.x, k, c_plane + drag_p, weight.x),
           axis_speed(m_normal, v.y, spring.y, k, c_normal + drag_n, weight.y + slam),
           axis_speed(m_plane, v.z, spring.z, k, c_plane + drag_p, weight.z));
    const vec3 next = v3_limit(free, poi->pace_m_s + catch_up_m_s(poi, target_m));
    const vec3 gain = v3_scale(v3_sub(next, v), 1.0f / CORE_TICK_S);
    const vec3 hand = v3(m_plane * gain.x + drag_p * next.x - weight.x,
                         m_normal * gain.y + drag_n * next.y - weight.y - slam,
                         m_plane * gain.z + drag_p * next.z - weight.z);
    const vec3 water = v3(-drag_p * next.x, slam - drag_n * next.y, -drag_p * next.z);
    poi->velocity_m_s = basis_to_world(axes, next);
    poi->drag_n_s_m = drag_n;
    poi->slam_n = slam;
    poi->added_kg = added;
    return (struct pull){ .hand_n = basis_to_world(axes, hand),
                          .water_n = basis_to_world(axes, water),
                          .weight_n = basis_to_world(axes, weight) };
}

/* About the hand: what the water and weights do at the ring's centre, and by how much more the fish
 * that lie and slap elsewhere on the paper turn it. */
static vec3 torque_on_hand(const struct poi *poi, const struct pull *pull, const struct basis *axes)
{
    const vec3 at_ring = v3_add(pull->water_n, pull->weight_n);
    vec3 torque = v3_cross(v3_scale(axes->back, -GRIP_M), at_ring);
    for (uint32_t i = 0; i < poi->load_count; i++) {
        const struct sheet_load *load = &poi->loads[i];
        const vec3 place = basis_to_world(axes, v3(load->x_m, 0.0f, load->z_m));
        torque = v3_add(torque, v3_cross(place, v3_scale(axes->up, load->force_n)));
    }
    return torque;
}

/* ---- Paper ---------------------------------------------------------------------------------- */

/* Of the ring's true way: a hand that pulls at a ring that cannot move does not jolt it. */
static void feel_jolt(struct poi *poi)
{
    const vec3 gain_m_s = v3_sub(poi->velocity_m_s, poi->before_m_s);
    const vec3 jolt_m_s2 = v3_limit(v3_scale(gain_m_s, 1.0f / CORE_TICK_S), 8.0f * FEEL_M_S2_MAX);
    const float share = CORE_TICK_S / (FEEL_TAU_S + CORE_TICK_S);
    poi->jolt_m_s2 = v3_lerp(poi->jolt_m_s2, jolt_m_s2, share);
    const vec3 felt = v3_lerp(poi->acceleration_m_s2, poi->jolt_m_s2, share);
    poi->acceleration_m_s2 = v3_limit(felt, FEEL_M_S2_MAX);
}

/* What bears on the paper, toward +up: drag and slam, water that must be accelerated along, and out
 * of the tank the weight of water and fish. */
static float pressure(const struct poi *poi, vec3 up)
{
    const float whole = f_max(0.15f, sheet_left(&poi->sheet));
    const float area = whole * F_PI * POI_RADIUS_M * POI_RADIUS_M;
    const float lift = v3_dot(poi->acceleration_m_s2, up);
    const float water = poi->slam_n - poi->drag_n_s_m * v3_dot(poi->velocity_m_s, up);
    const float paper_kg = sheet_grade(poi->sheet.grade)->areal_kg_m2 * area;
    const float burden_kg = (paper_kg + poi->water_kg + poi->riders_kg) * (1.0f - poi->immersed);
    const float force =
        water - poi->added_kg * lift - burden_kg * (GRAVITY_M_S2 * up.y + lift);
    return force / area;
}

static void carry_water(struct poi *poi, vec3 up)
{
    const float tilt_sine = f_sqrt(f_max(0.0f, 1.0f - up.y * up.y));
    const float left = sheet_left(&poi->sheet);
    if (poi->immersed > 0.05f) {
        const float belly =
            0.5f * F_PI * POI_RADIUS_M * POI_RADIUS_M * f_max(0.0f, poi->sheet.sag_m);
        const float pool = up.y > 0.0f ? belly * WATER_KG_M3 * up.y * up.y : UNDER_POOL_KG;
        poi->water_kg = left * (FILM_KG + f_min(pool, UNDER_POOL_KG));
        return;
    }
    const float film = left * FILM_KG;
    const float holes = 1.0f - left;
    const float more = f_max(0.0f, poi->water_kg - film);
    const float rate = tilt_sine / DRAIN_TAU_S + 8.0f * holes + 1.0f / SEEP_TAU_S;
    poi->water_kg = f_min(poi->water_kg, film) + more / (1.0f + rate * CORE_TICK_S);
}

static void strain_paper(struct poi *poi)
{
    const struct basis axes = basis_from_angles(poi->angles);
    const struct sheet_wetting wet = { axes.right.y, axes.back.y, -poi->position_m.y };
    feel_jolt(poi);
    poi->pressure_pa = pressure(poi, axes.up);
    poi->strain = poi->spared
                      ? sheet_tick(&poi->sheet, 0.0f, wet, NULL, 0)
                      : sheet_tick(&poi->sheet, poi->pressure_pa, wet, poi->loads, poi->load_count);
    carry_water(poi, axes.up);
}

/* ---- Public --------------------------------------------------------------------------------- */

static void note_splash(struct poi *poi, float immersed)
{
    poi->splash_m_s = 0.0f;
    if (poi->immersed <= 0.0f && immersed > 0.0f) {
        poi->splash_m_s = v3_length(poi->velocity_m_s) + 0.01f;
        poi->dips++;
    } else if (poi->immersed > 0.0f && immersed <= 0.0f) {
        poi->splash_m_s = -v3_length(poi->velocity_m_s) - 0.01f;
    }
}

void poi_tick(struct poi *poi, const struct poi_grip *grip, const struct tank *tank,
              const struct bowl *bowl, struct poi_force *force)
{
    CORE_ASSERT(v3_is_finite(grip->target.position_m));
    CORE_ASSERT(f_is_finite(grip->target.angles.yaw_rad));
    CORE_ASSERT(f_is_finite(grip->target.angles.pitch_rad));
    CORE_ASSERT(f_is_finite(grip->target.angles.roll_rad));
    poi->before_m = poi->position_m;
    poi->before_m_s = poi->velocity_m_s;
    poi->before_angles = poi->angles;
    tip_over(poi, bowl, grip->has_wrist);
    const struct poi_target target = tipped(poi, bowl, grip->target);
    feel_pace(poi, target.position_m);
    turn(poi, target.angles);

    const struct basis axes = basis_from_angles(poi->angles);
    const vec3 before_m = poi->position_m;
    const float immersed = disc_immersed(POI_RADIUS_M, before_m.y, axes.up.y);
    const struct pull pull = pull_ring(poi, target.position_m, &axes, immersed);
    note_splash(poi, immersed);
    poi->immersed = immersed;
    poi->position_m = v3_mad(before_m, poi->velocity_m_s, CORE_TICK_S);
    poi_yield(poi, tank, bowl, before_m, axes.up);

    force->force_n = v3_scale(pull.hand_n, -1.0f);
    force->torque_n_m = torque_on_hand(poi, &pull, &axes);
}

void poi_stir(const struct poi *poi, struct water *water, vec3 tank_size_m)
{
    const float depth = -poi->position_m.y;
    const float heave = poi->velocity_m_s.y * CORE_TICK_S;
    if (poi->immersed > 0.0f && poi->immersed < 1.0f) {
        const float sweep = v3_length(poi->velocity_m_s) * CORE_TICK_S;
        const float press = f_clamp(0.5f * sweep - 0.5f * heave, -0.004f, 0.004f);
        water_press(water, tank_size_m, poi->position_m, POI_OUTER_RADIUS_M, press);
    } else if (poi->immersed >= 1.0f) {
        const float press = -0.5f * heave * f_exp(-depth / 0.03f);
        water_press(water, tank_size_m, poi->position_m, POI_OUTER_RADIUS_M,
                    f_clamp(press, -0.003f, 0.003f));
    }
}

struct obstacle poi_obstacle(const struct poi *poi)
{
    const struct angles now = poi->angles, before = poi->before_angles;
    const struct basis axes = basis_from_angles(now);
    return (struct obstacle){
        .kind = OBSTACLE_DISC,
        .centre_m = poi->position_m,
        .normal = axes.up,
        .velocity_m_s = poi->velocity_m_s,
        .radius_m = POI_OUTER_RADIUS_M,
        .step_m = v3_sub(poi->position_m, poi->before_m),
        .axes = axes,
        .axes_before = basis_from_angles(before),
        .turned = now.yaw_rad != before.yaw_rad || now.pitch_rad != before.pitch_rad ||
                  now.roll_rad != before.roll_rad,
        .paper = poi->sheet.paper_cells > 0 ? poi->sheet.state : NULL,
        .paper_radius_m = poi->sheet.radius_m,
    };
}

void poi_give_way(struct poi *poi, const struct obstacle *ring)
{
    poi->gave = ring->gave;
    if (ring->gave & OBSTACLE_GAVE_PLACE) {
        poi->position_m = ring->centre_m;
        poi->velocity_m_s = ring->velocity_m_s;
    }
    if (ring->gave & OBSTACLE_GAVE_TURN) {
        poi->angles = poi->before_angles;
        poi->angular_velocity_rad_s = v3(0.0f, 0.0f, 0.0f);
    }
    strain_paper(poi);
}

/* Thin paper takes a third of the light, holes take none. A tilted ring casts an ellipse; the round
 * shadow of the same area stands for it. */
struct shade_cast poi_shade(const struct poi *poi)
{
    const float flat = f_abs(basis_from_angles(poi->angles).up.y);
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
    hash = hash_u32(hash, poi->rider_count);
    return hash_u32(hash, poi->dips);
}

uint64_t poi_hash(uint64_t hash, const struct poi *poi)
{
    const float values[] = { poi->splash_m_s,  poi->water_kg,  poi->tip,
                             poi->pressure_pa, poi->riders_kg, poi->before_angles.yaw_rad,
                             poi->before_angles.pitch_rad, poi->before_angles.roll_rad,
                             poi->pace_m_s, poi->drag_n_s_m, poi->slam_n, poi->added_kg };
    hash = poi_hash_quick(hash, poi);
    hash = hash_u32(hash, poi->seed);
    hash = hash_u32(hash, poi->spared);
    hash = hash_vec3(hash, poi->before_m);
    hash = hash_vec3(hash, poi->hand_m);
    hash = hash_vec3(hash, poi->before_m_s);
    hash = hash_u32(hash, poi->gave);
    hash = hash_vec3(hash, poi->angular_velocity_rad_s);
    hash = hash_vec3(hash, poi->acceleration_m_s2);
    hash = hash_vec3(hash, poi->jolt_m_s2);
    hash = hash_vec3(hash, poi->tip_toward);
    hash = hash_floats(hash, values, sizeof values / sizeof values[0]);
    hash = hash_u32(hash, poi->slap_tick);
    hash = hash_u32(hash, poi->tear_tick);
    hash = hash_u32(hash, poi->strain.cells_torn);
    hash = hash_float(hash, poi->strain.tension_max_n_m);
    hash = hash_u32(hash, poi->load_count);
    for (uint32_t i = 0; i < poi->rider_count; i++) {
        hash = rider_hash(hash, &poi->riders[i]);
    }
    for (uint32_t i = 0; i < poi->load_count; i++) {
        const struct sheet_load *load = &poi->loads[i];
        hash = hash_vec3(hash, v3(load->x_m, load->diameter_m, load->z_m));
        hash = hash_float(hash, load->force_n);
    }
    return sheet_hash(hash, &poi->sheet);
}
