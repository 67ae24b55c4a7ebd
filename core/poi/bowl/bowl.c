/* bowl.c -- computes the hull and the content of a bowl, and returns the fish of a full bowl to the
 * tank. */
#include "core/poi/bowl/bowl.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/base/rng.h"
#include "core/tank/tank.h"

#define FREEBOARD_MIN_M 0.002f
/* Moment of inertia of the bowl about its centre, including the added mass of water. */
#define ROCK_KG_M2 0.0012f

void bowl_init(struct bowl *bowl, vec3 position_m)
{
    CORE_ASSERT(v3_is_finite(position_m));
    memset(bowl, 0, sizeof *bowl);
    position_m.y = f_clamp(position_m.y, FREEBOARD_MIN_M, 0.5f * BOWL_DEPTH_M);
    bowl->present = true;
    bowl->home_m = bowl->position_m = bowl->before_m = position_m;
    bowl->water_kg = WATER_KG_M3 * bowl_room_m3(position_m.y) - BOWL_HULL_KG;
}

float bowl_hull_radius_m(float below_m)
{
    const float share = f_clamp(below_m / BOWL_DEPTH_M, 0.0f, 1.0f);
    return BOWL_RADIUS_M * f_sqrt(1.0f - share * share);
}

/* Computes the volume as the integral of pi * r^2 over the depth, from `below_m` to the bottom of
 * the hull, where r is the radius of the hull at each depth. */
float bowl_room_m3(float below_m)
{
    const float share = f_clamp(below_m / BOWL_DEPTH_M, 0.0f, 1.0f);
    const float left = 2.0f / 3.0f - share + share * share * share / 3.0f;
    return F_PI * BOWL_RADIUS_M * BOWL_RADIUS_M * BOWL_DEPTH_M * left;
}

/* Computes the distance from the bowl's mouth down to the water surface by Newton's method. The
 * derivative of the volume with respect to this distance, which the method needs, is the area of
 * the water surface. */
float bowl_level_m(const struct bowl *bowl)
{
    CORE_ASSERT(bowl->water_kg >= 0.0f && bowl->fish_kg >= 0.0f);
    const float wanted_m3 = (bowl->water_kg + bowl->fish_kg) / WATER_KG_M3;
    float below_m = 0.25f * BOWL_DEPTH_M;
    for (int i = 0; i < 4; i++) {
        const float radius_m = f_max(bowl_hull_radius_m(below_m), 0.1f * BOWL_RADIUS_M);
        below_m += (bowl_room_m3(below_m) - wanted_m3) / (F_PI * radius_m * radius_m);
        below_m = f_clamp(below_m, 0.0f, BOWL_DEPTH_M);
    }
    return below_m;
}

bool bowl_is_full(const struct bowl *bowl)
{
    return bowl->fish_count >= BOWL_FISH_MAX || bowl->fish_kg >= BOWL_FISH_KG_MAX;
}

void bowl_take(struct bowl *bowl, uint32_t bowl_index, struct tank *tank, struct fish *fish,
               vec3 velocity_m_s)
{
    CORE_ASSERT(bowl_index < POI_MAX);
    CORE_ASSERT(bowl->present);
    if (bowl_is_full(bowl)) {
        bowl_empty(bowl, bowl_index, tank);
    }
    const float kg = fish_mass_kg(fish->length_m);
    /* The momentum of the fish moves the bowl and rotates the bowl about its centre. */
    const float all_kg = BOWL_HULL_KG + bowl->water_kg + bowl->fish_kg + kg;
    const vec3 gain_m_s = v3_sub(velocity_m_s, bowl->velocity_m_s);
    const vec3 arm_m = v3_sub(fish->position_m, bowl->position_m);
    const float blow = -kg * gain_m_s.y / ROCK_KG_M2;
    bowl->velocity_m_s = v3_muladd(bowl->velocity_m_s, gain_m_s, kg / all_kg);
    bowl->heel_x_rad_s += blow * arm_m.x;
    bowl->heel_z_rad_s += blow * arm_m.z;
    fish->gait = GAIT_BOWL;
    fish->holder = (uint8_t)bowl_index;
    fish->angles.roll_rad = f_clamp(fish->angles.roll_rad, -0.5f, 0.5f);
    bowl->fish_kg += kg;
    bowl->fish_count++;
}

/* ---- Returning the fish to the tank --------------------------------------------------------- */

void bowl_empty(struct bowl *bowl, uint32_t bowl_index, struct tank *tank)
{
    CORE_ASSERT(bowl_index < POI_MAX);
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *fish = &tank->fish[i];
        if (fish->gait != GAIT_BOWL || fish->holder != bowl_index) {
            continue;
        }
        /* Selects a random place beside the hull, under water and inside the tank walls. */
        const float length_m = fish->length_m, half = 0.5f * fish->height_m;
        const float angle = F_TAU * bowl_draw(RNG_BOWL_POUR, tank->seed, i, 1);
        const float away =
            BOWL_RADIUS_M + length_m * (0.6f + 0.8f * bowl_draw(RNG_BOWL_POUR, tank->seed, i, 2));
        const float room_x = 0.5f * (tank->size_m.x - length_m);
        const float room_z = 0.5f * (tank->size_m.z - length_m);
        const float deep = f_max(half, tank->size_m.y - half - 0.005f);
        fish->position_m = v3(f_clamp(bowl->position_m.x + away * f_cos(angle), -room_x, room_x),
                              -f_lerp(half, deep, bowl_draw(RNG_BOWL_POUR, tank->seed, i, 3)),
                              f_clamp(bowl->position_m.z + away * f_sin(angle), -room_z, room_z));
        fish->alarm = 0.0f;
        reentry_begin(tank, fish, v3(0.0f, 0.0f, 0.0f));
    }
    bowl->fish_count = 0;
    bowl->fish_kg = 0.0f;
}

/* ---- Obstacle and angles --------------------------------------------------------------------- */

struct obstacle bowl_obstacle(const struct bowl *bowl)
{
    return (struct obstacle){
        .kind = OBSTACLE_BOWL,
        .centre_m = bowl->position_m,
        .normal = v3(0.0f, 1.0f, 0.0f),
        .velocity_m_s = bowl->velocity_m_s,
        .radius_m = BOWL_RADIUS_M,
        .depth_m = BOWL_DEPTH_M,
        .step_m = v3_sub(bowl->position_m, bowl->before_m),
    };
}

void bowl_apply_reaction(struct bowl *bowl, const struct obstacle *hull)
{
    CORE_ASSERT(hull->kind == OBSTACLE_BOWL);
    if (hull->reaction & REACTION_POSITION) {
        bowl->position_m = hull->centre_m;
        bowl->velocity_m_s = hull->velocity_m_s;
    }
}

struct angles bowl_angles(const struct bowl *bowl)
{
    return (struct angles){ .pitch_rad = bowl->heel_z, .roll_rad = bowl->heel_x };
}
