/* bowl.c -- fish in a bowl swim rounds, each at its own depth, width and pace. */
#include "core/poi/bowl.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/tank/loose.h"

#define SURFACE_M 0.012f  /* The bowl's own water stands so far under its mouth. */
#define ROUND_RAD_S 1.6f  /* A lap in about four seconds. */
#define SETTLE_PER_S 3.0f /* How soon a newcomer joins its round. */
#define HULL_GAP_M 0.004f

void bowl_init(struct bowl *bowl, vec3 position_m)
{
    memset(bowl, 0, sizeof *bowl);
    bowl->present = 1;
    bowl->position_m = position_m;
}

static float draw(uint32_t seed, uint32_t fish, uint32_t which)
{
    return rng_unit((struct rng_key){ seed, which, fish, RNG_BOWL_ROUND });
}

static float draw_pour(uint32_t seed, uint32_t fish, uint32_t which)
{
    return rng_unit((struct rng_key){ seed, which, fish, RNG_BOWL_POUR });
}

float bowl_hull_radius_m(float below_m)
{
    const float share = f_clamp(below_m / BOWL_DEPTH_M, 0.0f, 1.0f);
    return BOWL_RADIUS_M * f_sqrt(1.0f - share * share);
}

/* Where on its round a fish is: y below the mouth, radius such that snout and tail clear the hull.
 */
static vec3 place_on_round(const struct fish *fish, uint32_t index, uint32_t seed, float angle_rad)
{
    const float half = 0.5f * fish->height_m;
    const float top = SURFACE_M + half;
    const float bottom = f_max(top, 0.8f * BOWL_DEPTH_M - half);
    const float below = f_lerp(top, bottom, draw(seed, index, 1));
    const float hull = bowl_hull_radius_m(below + half) - HULL_GAP_M;
    const float reach = f_sqrt(f_max(0.0f, hull * hull - 0.25f * fish->length_m * fish->length_m));
    const float radius = reach * (0.45f + 0.5f * draw(seed, index, 2));
    return v3(radius * f_cos(angle_rad), -below, radius * f_sin(angle_rad));
}

static void swim(struct fish *fish, uint32_t index, const struct bowl *bowl, uint32_t seed,
                 uint32_t tick)
{
    const float way = draw(seed, index, 3) < 0.5f ? -1.0f : 1.0f;
    const float pace = way * ROUND_RAD_S * (0.7f + 0.6f * draw(seed, index, 4));
    /* Time within an hour keeps the angle's float exact enough; the leap once an hour is smoothed.
     */
    const float seconds = (float)(tick % (CORE_TICK_HZ * 3600u)) * CORE_TICK_S;
    const float angle = f_wrap_angle(F_TAU * draw(seed, index, 5) + pace * seconds);
    const vec3 goal = v3_add(bowl->position_m, place_on_round(fish, index, seed, angle));
    const vec3 before = fish->position_m;
    fish->position_m = v3_lerp(before, goal, SETTLE_PER_S * CORE_TICK_S);
    fish->velocity_m_s = v3_scale(v3_sub(fish->position_m, before), 1.0f / CORE_TICK_S);
    const vec3 v = fish->velocity_m_s;
    const float heading =
        v.x * v.x + v.z * v.z > 1e-6f ? f_atan2(-v.x, -v.z) : fish->angles.yaw_rad;
    const float turn = f_wrap_angle(heading - fish->angles.yaw_rad);
    fish->angles.yaw_rad = f_wrap_angle(fish->angles.yaw_rad + 0.08f * turn);
    fish->angles.pitch_rad *= 0.95f;
    fish->angles.roll_rad *= 0.95f;
    fish->bend_rad += (-0.25f * way - fish->bend_rad) * 0.05f;
    fish->tail_amplitude += (0.7f - fish->tail_amplitude) * 0.05f;
    fish->tail_beat_hz = 2.0f;
    fish->tail_phase_rad += F_TAU * fish->tail_beat_hz * CORE_TICK_S;
    fish->tail_phase_rad -= fish->tail_phase_rad >= F_TAU ? F_TAU : 0.0f;
}

void bowl_tick(const struct bowl *bowl, uint32_t bowl_index, struct tank *tank, uint32_t tick)
{
    if (!bowl->present || bowl->fish_count == 0) {
        return;
    }
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *fish = &tank->fish[i];
        if (fish->gait == GAIT_BOWL && fish->holder == bowl_index) {
            swim(fish, i, bowl, tank->seed, tick);
        }
    }
}

/* On a ring round the hull, under water, inside the walls. */
static vec3 pouring_place(const struct bowl *bowl, const struct tank *tank, uint32_t index)
{
    const float length_m = tank->fish[index].length_m;
    const float angle = F_TAU * draw_pour(tank->seed, index, 1);
    const float away = BOWL_RADIUS_M + length_m * (0.6f + 0.8f * draw_pour(tank->seed, index, 2));
    const float room_x = 0.5f * (tank->size_m.x - length_m),
                room_z = 0.5f * (tank->size_m.z - length_m);
    const float half = 0.5f * tank->fish[index].height_m;
    const float deep = f_max(half, tank->size_m.y - half - 0.005f);
    return v3(f_clamp(bowl->position_m.x + away * f_cos(angle), -room_x, room_x),
              -f_lerp(half, deep, draw_pour(tank->seed, index, 3)),
              f_clamp(bowl->position_m.z + away * f_sin(angle), -room_z, room_z));
}

void bowl_pour_back(struct bowl *bowl, uint32_t bowl_index, struct tank *tank)
{
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        struct fish *fish = &tank->fish[i];
        if (fish->gait == GAIT_BOWL && fish->holder == bowl_index) {
            fish->position_m = pouring_place(bowl, tank, i);
            fish->alarm = 0.0f;
            loose_begin(tank, fish, v3(0.0f, 0.0f, 0.0f));
        }
    }
    bowl->fish_count = 0;
}

uint64_t bowl_hash(uint64_t hash, const struct bowl *bowl)
{
    hash = hash_u32(hash, bowl->present);
    hash = hash_vec3(hash, bowl->position_m);
    return hash_u32(hash, bowl->fish_count);
}

struct obstacle bowl_obstacle(const struct bowl *bowl)
{
    return (struct obstacle){
        .kind = OBSTACLE_BOWL,
        .centre_m = bowl->position_m,
        .normal = v3(0.0f, 1.0f, 0.0f),
        .radius_m = BOWL_RADIUS_M,
        .depth_m = BOWL_DEPTH_M,
    };
}
