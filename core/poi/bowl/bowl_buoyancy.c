/* bowl_buoyancy.c -- moves the bowls: integrates the forces on each bowl by the backward Euler
 * method, axis by axis.
 *
 * The backward Euler method is stable at any stiffness. */
#include "core/poi/bowl/bowl.h"

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/poi/ring.h"

/* Stiffness of the mooring spring, which returns a displaced bowl to its home position in about two
 * seconds. */
#define MOORING_N_M 2.0f
#define DRAG_N_S_M 1.6f /* Coefficient of the linear drag of the water on the hull. */
/* Coefficient of the quadratic drag of the water on the hull: half the density of water times a
 * drag coefficient of 0.6 times an area of 50 cm^2. */
#define DRAG_N_S2_M2 1.5f
/* Added mass: the water that moves along with the bowl, as a fraction of the mass of the bowl with
 * its content. */
#define ALONG_SHARE 0.5f
/* Highest horizontal speed of the bowl. The value is lower than the speed at which a ring slides
 * off the hull. */
#define SPEED_MAX_M_S 0.5f
/* Coefficient of damping for vertical motion: a quarter of the critical damping. */
#define HEAVE_DAMP_N_S_M 5.0f
/* Largest mass of the bowl including its water and fish. With this mass, the mouth is 4 mm above
 * the water of the tank. Additional water spills out of the bowl. */
#define LOAD_KG_MAX 0.710f
#define MOUTH_MIN_M 0.002f
/* Largest height of a ripple that lifts the bowl. Higher ripples break at the hull and lift the
 * bowl no further. */
#define RIPPLE_MAX_M 0.006f
#define HEEL_RAD_S 13.0f /* Natural angular frequency of the tilt: the bowl rocks at about 2 Hz. */
/* Damping ratio of the tilt, with which the bowl comes to rest after a few swings. */
#define HEEL_DAMP 0.22f
/* Largest tilt (8 degrees). At a larger tilt, water would flow into the mouth. */
#define HEEL_MAX 0.14f
/* Tilt in radians caused by a horizontal push whose force equals the weight of the bowl. */
#define HEEL_SHARE 0.25f
#define WALL_GAP_M 0.001f
/* Number of passes in which overlapping bowls are separated. Four passes are enough for a row of
 * four bowls at a wall. */
#define PART_ROUNDS 4u
#define TOUCH_M 0.0015f
/* Largest horizontal force of a ring on the hull. A larger force would make the bowl jump. */
#define PUSH_N_MAX 4.0f
/* Largest downward force of a ring on the bowl's mouth. This force sinks the bowl by 5 mm. */
#define PRESS_N_MAX 0.8f

static float load_kg(const struct bowl *bowl)
{
    return BOWL_HULL_KG + bowl->water_kg + bowl->fish_kg;
}

/* ---- Forces of a ring on a bowl ------------------------------------------------------------- */

/* Returns the force of a poi's ring on the hull: the force of the poi's hand spring, within limits.
 * Returns 0 if the ring does not touch the hull. */
static vec3 ring_push_on_hull(const struct bowl *bowl, const struct poi *poi)
{
    const vec3 none = { 0.0f, 0.0f, 0.0f };
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 away = v3_flat(v3_sub(poi->position_m, bowl->position_m));
    const float far = v3_length(away);
    if (far > BOWL_RADIUS_M + poi_outer_radius_m(poi) + TOUCH_M) {
        return none;
    }
    const vec3 out = v3_normalize_or(away, v3(-1.0f, 0.0f, 0.0f));
    const float low = poi_half_extent_m(poi, axes.up.y), mouth = bowl->position_m.y;
    const float apart = bowl_hull_radius_m(mouth - poi->position_m.y) +
                        poi_half_extent_m(poi, v3_dot(axes.up, out));
    const vec3 hand_n = poi_spring_n(poi, &axes);
    if (far > apart + TOUCH_M || poi->position_m.y + low <= mouth - BOWL_DEPTH_M) {
        return none;
    }
    if (poi->position_m.y - low >= mouth - TOUCH_M) {
        const bool rests = poi->position_m.y - low <= mouth + TOUCH_M;
        return v3(0.0f, rests ? f_clamp(hand_n.y, -PRESS_N_MAX, 0.0f) : 0.0f, 0.0f);
    }
    /* A ring whose centre is above the mouth slides along the bowl's rim and exerts no force. */
    const float most_n = poi->position_m.y < mouth ? PUSH_N_MAX : 0.0f;
    return v3_scale(out, f_clamp(v3_dot(hand_n, out), -most_n, 0.0f));
}

/* ---- Forces of the water on a bowl ---------------------------------------------------------- */

static void heel(float *at, float *rate_rad_s, float goal)
{
    const float w = HEEL_RAD_S, dt = CORE_TICK_S;
    *rate_rad_s = (*rate_rad_s + dt * w * w * (goal - *at)) /
                  (1.0f + 2.0f * HEEL_DAMP * w * dt + w * w * dt * dt);
    *at += dt * *rate_rad_s;
    if (f_abs(*at) > HEEL_MAX) {
        *at = f_clamp(*at, -HEEL_MAX, HEEL_MAX);
        *rate_rad_s = 0.0f;
    }
}

/* ---- Contact with walls and other bowls ------------------------------------------------------ */

static void stop_at(float *place, float *speed, float room)
{
    CORE_ASSERT(room > 0.0f);
    if (f_abs(*place) > room) {
        *place = f_clamp(*place, -room, room);
        *speed = *place > 0.0f ? f_min(*speed, 0.0f) : f_max(*speed, 0.0f);
    }
}

/* Separates two bowls that overlap. Each bowl moves by half of the overlap. If the bowls approach
 * each other, both get their mean speed along the line between their centres. */
static void keep_apart(struct bowl *a, struct bowl *b)
{
    CORE_ASSERT(a != b);
    const vec3 way = v3_flat(v3_sub(b->position_m, a->position_m));
    const float deep_m = 2.0f * BOWL_RADIUS_M - v3_length(way);
    if (deep_m <= 0.0f) {
        return;
    }
    const vec3 out = v3_normalize_or(way, v3(1.0f, 0.0f, 0.0f));
    const float closing = v3_dot(v3_sub(a->velocity_m_s, b->velocity_m_s), out);
    a->position_m = v3_muladd(a->position_m, out, -0.5f * deep_m);
    b->position_m = v3_muladd(b->position_m, out, 0.5f * deep_m);
    if (closing > 0.0f) {
        a->velocity_m_s = v3_muladd(a->velocity_m_s, out, -0.5f * closing);
        b->velocity_m_s = v3_muladd(b->velocity_m_s, out, 0.5f * closing);
    }
}

/* Integrates the forces of the water, of the mooring and of the rings (`push_n`) on a bowl. */
static void float_on(struct bowl *bowl, const struct tank *tank, vec3 push_n)
{
    CORE_ASSERT(bowl->present);
    /* Computes the mean height and the slope of the water surface under the hull. */
    const float arm_m = 0.7f * BOWL_RADIUS_M, x = bowl->position_m.x, z = bowl->position_m.z;
    const float left = water_height_m(&tank->water, tank->size_m, x - arm_m, z);
    const float right = water_height_m(&tank->water, tank->size_m, x + arm_m, z);
    const float far = water_height_m(&tank->water, tank->size_m, x, z - arm_m);
    const float near = water_height_m(&tank->water, tank->size_m, x, z + arm_m);
    const float swell_m = f_clamp(0.25f * (left + right + far + near), -RIPPLE_MAX_M, RIPPLE_MAX_M);
    const float slope_x = 0.5f * (right - left) / arm_m, slope_z = 0.5f * (near - far) / arm_m;
    const float heel_per_n = HEEL_SHARE / (GRAVITY_M_S2 * load_kg(bowl));
    /* Water above LOAD_KG_MAX spills out of the bowl. */
    bowl->water_kg = f_max(0.0f, bowl->water_kg - f_max(0.0f, load_kg(bowl) - LOAD_KG_MAX));
    /* Integrates the forces of the mooring, the water and the rings for the horizontal motion. */
    const float kg = (1.0f + ALONG_SHARE) * load_kg(bowl);
    const float weight_n = GRAVITY_M_S2 * load_kg(bowl);
    const vec3 speed = v3_flat(bowl->velocity_m_s);
    const float drag = DRAG_N_S_M + DRAG_N_S2_M2 * v3_length(speed);
    const float home_x = MOORING_N_M * (bowl->home_m.x - x);
    const float home_z = MOORING_N_M * (bowl->home_m.z - z);
    const float wave_x = -weight_n * slope_x, wave_z = -weight_n * slope_z;
    const vec3 next =
        v3(ring_axis_m_s(kg, speed.x, push_n.x + home_x + wave_x, drag, MOORING_N_M), 0.0f,
           ring_axis_m_s(kg, speed.z, push_n.z + home_z + wave_z, drag, MOORING_N_M));
    const vec3 held = v3_limit(next, SPEED_MAX_M_S);
    bowl->velocity_m_s.x = held.x;
    bowl->velocity_m_s.z = held.z;
    /* Integrates the forces for the vertical motion and the tilt. */
    const float freeboard_m = bowl->position_m.y - swell_m;
    const float radius_m = bowl_hull_radius_m(freeboard_m);
    const float stiffness = WATER_KG_M3 * GRAVITY_M_S2 * F_PI * radius_m * radius_m;
    const float lift_n = GRAVITY_M_S2 * (WATER_KG_M3 * bowl_room_m3(freeboard_m) - load_kg(bowl));
    bowl->velocity_m_s.y =
        ring_axis_m_s(kg, bowl->velocity_m_s.y, lift_n + push_n.y, HEAVE_DAMP_N_S_M, stiffness);
    heel(&bowl->heel_x, &bowl->heel_x_rad_s, heel_per_n * push_n.x - slope_x);
    heel(&bowl->heel_z, &bowl->heel_z_rad_s, heel_per_n * push_n.z - slope_z);
    bowl->position_m = v3_muladd(bowl->position_m, bowl->velocity_m_s, CORE_TICK_S);
}

void bowl_buoyancy_tick(const struct stall *stall, const struct poi *pois, const uint8_t *live,
                        uint32_t poi_count)
{
    CORE_ASSERT(stall->bowl_count <= POI_MAX);
    CORE_ASSERT(poi_count <= POI_MAX);
    for (uint32_t i = 0; i < stall->bowl_count; i++) {
        struct bowl *bowl = &stall->bowls[i];
        bowl->before_m = bowl->position_m;
        if (bowl->present) {
            vec3 push_n = { 0.0f, 0.0f, 0.0f };
            for (uint32_t k = 0; k < poi_count; k++) {
                push_n = live[k] ? v3_add(push_n, ring_push_on_hull(bowl, &pois[k])) : push_n;
            }
            float_on(bowl, stall->tank, push_n);
        }
    }
    for (uint32_t round = 0; round < PART_ROUNDS; round++) {
        for (uint32_t i = 0; i < stall->bowl_count; i++) {
            struct bowl *bowl = &stall->bowls[i];
            const float inset_m = BOWL_RADIUS_M + WALL_GAP_M;
            if (!bowl->present) {
                continue;
            }
            stop_at(&bowl->position_m.x, &bowl->velocity_m_s.x,
                    0.5f * stall->tank->size_m.x - inset_m);
            stop_at(&bowl->position_m.z, &bowl->velocity_m_s.z,
                    0.5f * stall->tank->size_m.z - inset_m);
            if (bowl->position_m.y < MOUTH_MIN_M) {
                bowl->position_m.y = MOUTH_MIN_M;
                bowl->velocity_m_s.y = f_max(bowl->velocity_m_s.y, 0.0f);
            }
        }
        for (uint32_t i = 1; i < stall->bowl_count; i++) {
            for (uint32_t k = 0; k < i; k++) {
                if (stall->bowls[i].present && stall->bowls[k].present) {
                    keep_apart(&stall->bowls[k], &stall->bowls[i]);
                }
            }
        }
    }
}
