/* bowl_fish.c -- moves the fish in a bowl. Each fish is modelled as an upright oval capsule that
 * circles the bowl's centre. */
#include "core/poi/bowl/bowl.h"

#include "core/base/panic.h"
#include "core/base/rng.h"

/* Mean angular speed of a circling fish: one lap in about four seconds. */
#define ROUND_RAD_S 1.6f
/* Rate at which a fish in a bowl approaches the depth and the radius of the circle on which it
 * swims. */
#define SETTLE_PER_S 2.0f
/* Fraction by which SETTLE_PER_S is reduced in a full bowl, in which other fish are in the way. */
#define SETTLE_CROWD 0.9f
#define HULL_GAP_M 0.003f
/* Mass of the fish in a bowl above which all fish circle at the same angular speed. */
#define CROWD_KG 0.080f
/* Half the length of the axis of the capsule that models a fish, in body lengths. The capsule
 * excludes the thin snout and tail fin. */
#define SPINE_HALF 0.32f
#define GIRTH 0.40f     /* Radius of the capsule as a fraction of the body width. */
#define PART_SHARE 0.6f /* Fraction of the overlap of two fish that is removed in each tick. */
/* Largest distance by which overlapping fish are moved apart in one tick. The value equals 14
 * cm/s. */
#define PART_MAX_M 0.0012f
#define CROSSED 0.3f
#define ENDS 0.45f /* Distance of the snout and the tail from the fish's centre, in body lengths. */
#define SPEED_MAX_M_S 0.22f

/* ---- Circling in the bowl -------------------------------------------------------------------- */

/* Moves the fish for one tick along its circle and toward the depth and the radius of the
 * circle. The circle is random. On the circle, the snout and the tail of the fish stay inside
 * the hull. A circle near the water surface can have a larger radius, because the bowl is wider
 * at the top. `way` is the direction around the bowl: 1 or -1. */
static void swim_in_bowl(struct fish *fish, uint32_t index, const struct bowl *bowl, float way,
                         float level_m, uint32_t seed)
{
    CORE_ASSERT(way == 1.0f || way == -1.0f);
    CORE_ASSERT(level_m >= 0.0f && level_m <= BOWL_DEPTH_M);
    const float half = 0.5f * fish->height_m, end = ENDS * fish->length_m;
    const float top = level_m + half, bottom = f_max(top, 0.92f * BOWL_DEPTH_M - half);
    const float deep = bowl_draw(RNG_BOWL_ROUND, seed, index, 1),
                wide = bowl_draw(RNG_BOWL_ROUND, seed, index, 2);
    const float below_m = f_lerp(top, bottom, deep * (0.5f + 0.5f * deep));
    const float hull = f_max(0.0f, bowl_hull_radius_m(below_m + half) - HULL_GAP_M);
    const float reach = f_sqrt(f_max(0.0f, hull * hull - end * end));
    const float goal_m = reach * f_sqrt(0.04f + 0.96f * wide);
    /* `crowd` in [0, 1] grows with the mass of the fish in the bowl. If `crowd` is 1, all fish
     * circle at the same angular speed, because a faster fish would collide with other fish. */
    const float crowd = f_smoothstep(0.0f, CROWD_KG, bowl->fish_kg);
    const float spread = 0.5f * (1.0f - crowd);
    const float rad_s =
        ROUND_RAD_S * (1.0f + spread * (2.0f * bowl_draw(RNG_BOWL_ROUND, seed, index, 4) - 1.0f));
    const vec3 at = v3_sub(fish->position_m, bowl->position_m);
    const float radius_m = f_max(f_sqrt(at.x * at.x + at.z * at.z), 1e-4f);
    const vec3 out = v3(at.x / radius_m, 0.0f, at.z / radius_m);
    const vec3 on = v3(-way * out.z, 0.0f, way * out.x);
    const float along = rad_s * f_max(radius_m, 0.01f);
    const float settle = SETTLE_PER_S * (1.0f - SETTLE_CROWD * crowd);
    vec3 speed = v3_scale(on, along);
    speed = v3_muladd(speed, out, settle * (goal_m - radius_m));
    speed.y = settle * (-below_m - at.y);
    speed = v3_limit(speed, SPEED_MAX_M_S);
    fish->position_m = v3_muladd(fish->position_m, speed, CORE_TICK_S);
    fish->speed_m_s = along;
    const float turn = f_wrap_angle(f_atan2(-on.x, -on.z) - fish->angles.yaw_rad);
    fish->angles.yaw_rad = f_wrap_angle(fish->angles.yaw_rad + 0.08f * turn);
    fish->angles.pitch_rad *= 0.95f;
    fish->angles.roll_rad *= 0.95f;
    fish->bend_rad += (-0.25f * way - fish->bend_rad) * 0.05f;
    fish->tail_amplitude += (0.7f - fish->tail_amplitude) * 0.05f;
    fish->tail_beat_hz = 2.0f;
    fish->tail_phase_rad += F_TAU * fish->tail_beat_hz * CORE_TICK_S;
    fish->tail_phase_rad -= fish->tail_phase_rad >= F_TAU ? F_TAU : 0.0f;
}

/* ---- Separation of fish ---------------------------------------------------------------------- */

/* Returns the shortest vector from the capsule axis of `a` to the capsule axis of `b`. `on_a`
 * and `on_b` are the horizontal unit vectors along the bodies, toward the snouts. A fish is
 * higher than wide. The vertical component is therefore multiplied by the smaller ratio of width
 * to height of the two fish, which makes the cross-section of the capsules circular. */
static vec3 axis_gap(const struct fish *a, vec3 on_a, const struct fish *b, vec3 on_b)
{
    const vec3 d = v3_sub(b->position_m, a->position_m);
    const float ha = SPINE_HALF * a->length_m, hb = SPINE_HALF * b->length_m;
    const float c = on_a.x * on_b.x + on_a.z * on_b.z;
    const float da = d.x * on_a.x + d.z * on_a.z, db = d.x * on_b.x + d.z * on_b.z;
    const float denominator = f_max(1.0f - c * c, 1e-4f);
    float sa = f_clamp((da - c * db) / denominator, -ha, ha);
    const float sb = f_clamp(c * sa - db, -hb, hb);
    sa = f_clamp(c * sb + da, -ha, ha);
    return v3(d.x + sb * on_b.x - sa * on_a.x,
              d.y * f_min(a->width_m / a->height_m, b->width_m / b->height_m),
              d.z + sb * on_b.z - sa * on_a.z);
}

static void separate_bowl_fish(struct fish *a, vec3 on_a, struct fish *b, vec3 on_b)
{
    CORE_ASSERT(a != b);
    const vec3 d = v3_sub(b->position_m, a->position_m);
    const float girths = GIRTH * (a->width_m + b->width_m);
    const float reach_m = SPINE_HALF * (a->length_m + b->length_m) + 2.0f * girths;
    if (v3_dot(d, d) >= reach_m * reach_m) {
        return;
    }
    const vec3 way = axis_gap(a, on_a, b, on_b);
    const float square = v3_dot(way, way);
    if (square >= girths * girths) {
        return;
    }
    /* If the axes of two fish cross, their distance is 0. The fish are then separated along the
     * vector between their centres. */
    const float deep = 1.0f - f_sqrt(square) / girths;
    const vec3 out = v3_normalize_or(v3_muladd(way, d, CROSSED * deep), v3(0.0f, 1.0f, 0.0f));
    const float step_m = f_min(PART_SHARE * deep * girths, PART_MAX_M);
    a->position_m = v3_muladd(a->position_m, out, -0.5f * step_m);
    b->position_m = v3_muladd(b->position_m, out, 0.5f * step_m);
}

/* Keeps a fish below the water surface in the bowl, and keeps its snout and tail inside the
 * hull. */
static void stay_in_hull(struct fish *fish, const struct bowl *bowl, float level_m)
{
    const float half = 0.5f * fish->height_m;
    const float high = level_m + half, low = f_max(BOWL_DEPTH_M - half - HULL_GAP_M, high);
    vec3 at = v3_sub(fish->position_m, bowl->position_m);
    at.y = f_clamp(at.y, -low, -high);
    const vec3 along = v3(ENDS * fish->length_m * f_sin(fish->angles.yaw_rad), 0.0f,
                          ENDS * fish->length_m * f_cos(fish->angles.yaw_rad));
    const float hull = f_max(bowl_hull_radius_m(-at.y + 0.5f * half) - HULL_GAP_M, 0.0f);
    for (int end = -1; end <= 1; end += 2) {
        const vec3 tip = v3_muladd(at, along, (float)end);
        const float far = f_sqrt(tip.x * tip.x + tip.z * tip.z);
        if (far > hull) {
            const float back = (far - hull) / far;
            at.x -= back * tip.x;
            at.z -= back * tip.z;
        }
    }
    fish->position_m = v3_add(bowl->position_m, at);
}

/* ---- Tick of the bowl's fish ---------------------------------------------------------------- */

void bowl_fish_tick(struct bowl *bowl, uint32_t bowl_index, struct tank *tank)
{
    CORE_ASSERT(bowl_index < POI_MAX);
    fish_index mine[BOWL_FISH_MAX];
    vec3 from_m[BOWL_FISH_MAX];
    const vec3 moved_m = v3_sub(bowl->position_m, bowl->before_m);
    if (!bowl->present || bowl->fish_count == 0) {
        return;
    }
    uint32_t count = 0;
    bowl->fish_kg = 0.0f;
    for (uint32_t i = 0; i < tank->fish_count; i++) {
        const struct fish *fish = &tank->fish[i];
        if (fish->gait == GAIT_BOWL && fish->holder == bowl_index && count < BOWL_FISH_MAX) {
            mine[count++] = (fish_index)i;
            bowl->fish_kg += fish_mass_kg(fish->length_m);
        }
    }
    const float way = bowl_index % 2u == 0 ? 1.0f : -1.0f; /* Direction around the bowl, which is
                                                              the same for all fish in one bowl. */
    const float level_m = bowl_level_m(bowl);
    for (uint32_t i = 0; i < count; i++) {
        struct fish *fish = &tank->fish[mine[i]];
        fish->position_m = v3_add(fish->position_m, moved_m);
        from_m[i] = fish->position_m;
        swim_in_bowl(fish, mine[i], bowl, way, level_m, tank->seed);
    }
    vec3 spine[BOWL_FISH_MAX];
    for (uint32_t i = 0; i < count; i++) {
        spine[i] = v3_heading(tank->fish[mine[i]].angles.yaw_rad);
        for (uint32_t k = 0; k < i; k++) {
            separate_bowl_fish(&tank->fish[mine[k]], spine[k], &tank->fish[mine[i]], spine[i]);
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        /* A speed limit makes a new fish sink gradually to its circle. */
        struct fish *fish = &tank->fish[mine[i]];
        stay_in_hull(fish, bowl, level_m);
        const vec3 step =
            v3_limit(v3_sub(fish->position_m, from_m[i]), SPEED_MAX_M_S * CORE_TICK_S);
        fish->position_m = v3_add(from_m[i], step);
        fish->velocity_m_s = v3_scale(v3_add(step, moved_m), (float)CORE_TICK_HZ);
    }
}
