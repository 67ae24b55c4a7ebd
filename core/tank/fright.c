/* fright.c -- senses, alarm, habit and latency. */
#include "core/tank/fright.h"

#include "core/base/rng.h"
#include "core/tank/escape.h"
#include "core/tank/flow.h"
#include "core/tank/surface.h"

#define ALARM_FADE_PER_S 0.6f
#define ALARM_AFTER 0.2f /* What a start leaves of it. */
#define FRIGHT_S 0.12f   /* A stimulus of strength 1 gives an alarm of 1 in so long. */
#define STRENGTH_MAX 12.0f

/* Eyes: an image of 20 (timid) to 30 degrees (bold) that grows by 260 degrees a second. */
#define SEEN_RAD (20.0f * F_DEG)
#define SEEN_SPREAD_RAD (10.0f * F_DEG)
#define GROWTH_RAD_S 4.5f
#define GROWTH_SPAN_RAD_S 6.5f
#define IN_AIR_SHARE 0.25f /* Seen through a rippled surface. */

/* Ear and lateral line. Asa et al.: fish of 1.6 g hear sounds 15 dB fainter than those of
 * 23.6 g do: 5.6 times less pressure at 2.5 times less length. */
#define PUSH_M2_S2 0.005f /* A paper that rises at 0.1 m/s under a fish is not felt; ... */
#define PUSH_SPAN_M2_S2 0.016f /* ... at 0.15 m/s it is, and fast. */
#define WAKE_SHARE 0.5f
#define LENGTH_M 0.05f
#define LINE_THICKNESS 0.07f /* Of an edge-on disc's image, per diameter: its ring. */

#define GULPING_LATE 1.5f /* Who gulps answers half again as late. */

#define THRESHOLD 0.45f /* The timid's; the bold's is twice that. */
#define THRESHOLD_MAX 0.95f
#define HABIT_STEP 0.25f /* Of what is missing to full habit; full doubles the threshold. */
#define HABIT_FADE_S 60.0f
#define HABIT_NONE 1e-3f

/* A disc that moves within this reach of its rim makes a fish think in every tick: there it is
 * seen at 21 degrees. The water that it pushes is felt beyond only at more than 1 m/s, and no
 * farther than in proportion to that. */
#define ALERT_M 0.20f
#define ALERT_M_S 0.05f

static float boldness(const struct fish *fish)
{
    return (float)(fish->look >> 3 & 31u) / 31.0f;
}

float fright_threshold(const struct fish *fish)
{
    const float bears = THRESHOLD * (1.0f + boldness(fish)) * (1.0f + fish->habit);
    return f_min(THRESHOLD_MAX, surface_nerve(fish) * bears);
}

struct fright_view fright_view(const struct obstacle *disc, vec3 eye_m)
{
    const vec3 to = v3_sub(eye_m, disc->centre_m);
    const float distance_m = f_max(v3_length(to), 0.2f * disc->radius_m);
    const vec3 toward = v3_scale(to, 1.0f / distance_m);
    const float face = f_max(f_abs(v3_dot(toward, disc->normal)), LINE_THICKNESS);
    const float half_m = disc->radius_m * f_sqrt(face); /* Of the circle of the same area. */
    const float closing_m_s = v3_dot(obstacle_goes_m_s(disc), toward);
    return (struct fright_view){
        .size_rad = 2.0f * f_atan2(half_m, distance_m),
        .growth_rad_s =
            2.0f * half_m * closing_m_s / (half_m * half_m + distance_m * distance_m),
    };
}

/* What a disc leaves behind comes after it in a wake, more slowly than it was pushed ahead. */
static float push_m2_s2(const struct obstacle *disc, vec3 point_m)
{
    const float ahead = v3_dot(disc->velocity_m_s, v3_sub(point_m, disc->centre_m));
    return (ahead < 0.0f ? WAKE_SHARE : 1.0f) * flow_push_m2_s2(disc, point_m);
}

struct fright fright_of_disc(const struct obstacle *disc, const struct fish *fish)
{
    const struct fright_view view = fright_view(disc, fish->position_m);
    const int large = view.size_rad > SEEN_RAD + SEEN_SPREAD_RAD * boldness(fish);
    const float clear = disc->centre_m.y > 0.0f ? IN_AIR_SHARE : 1.0f;
    const float keen = LENGTH_M / f_max(fish->length_m, 0.2f * LENGTH_M);
    const float push = keen * push_m2_s2(disc, fish->position_m);
    const float seen = large ? clear * (view.growth_rad_s - GROWTH_RAD_S) / GROWTH_SPAN_RAD_S : 0;
    const float felt = (push - PUSH_M2_S2) / PUSH_SPAN_M2_S2;
    const float most = f_clamp(f_max(seen, felt), 0.0f, STRENGTH_MAX);
    return (struct fright){
        .cause = most <= 0.0f ? FRIGHT_NONE : felt >= seen ? FRIGHT_PRESSURE : FRIGHT_LOOM,
        .alarm_per_s = most / FRIGHT_S,
    };
}

/* What nerves take over each cause. A shadow's alarm takes up to 4 ticks to grow (shade.c), and a
 * start begins with the nearest tick: from the shadow on it is 67 to 150 ms. */
static float nerves_s(enum fright_cause cause, struct rng_key key)
{
    switch (cause) {
    case FRIGHT_LOOM:
        return rng_range(key, 0.060f, 0.150f);
    case FRIGHT_SHADOW:
        return rng_range(key, 0.063f, 0.115f);
    default:
        return rng_range(key, 0.008f, 0.015f);
    }
}

static float latency_s(const struct fish *fish, enum fright_cause cause, uint32_t index,
                       const struct surroundings *around)
{
    const struct rng_key key = { around->seed, around->tick, index, RNG_STARTLE_LATENCY };
    const float late = fish->gait == GAIT_SURFACE ? GULPING_LATE : 1.0f;
    return late * nerves_s(cause, key);
}

/* A blow to the water overtakes what the eye still works on. */
static void startle(struct fish *fish, enum fright_cause cause, vec3 from_m, uint32_t index,
                    const struct surroundings *around)
{
    const float wait_s = latency_s(fish, cause, index, around);
    if (fish->startle == FRIGHT_NONE || wait_s < fish->startle_s) {
        fish->startle = (uint8_t)cause;
        fish->startle_from_m = from_m;
        fish->startle_s = wait_s;
    }
}

void fright_alarm(struct fish *fish, enum fright_cause cause, vec3 from_m, float alarm,
                  uint32_t index, const struct surroundings *around)
{
    const int waits_by_ear = fish->startle == FRIGHT_PRESSURE;
    fish->alarm = f_min(1.0f, fish->alarm + alarm);
    if (alarm > 0.0f && fish->gait != GAIT_ESCAPE && fish->refractory_s <= 0.0f &&
        !waits_by_ear && (fish->startle == FRIGHT_NONE || cause == FRIGHT_PRESSURE) &&
        fish->alarm > fright_threshold(fish)) {
        startle(fish, cause, from_m, index, around);
    }
}

static void wait(struct fish *fish, uint32_t index, const struct surroundings *around)
{
    const vec3 from_m = fish->startle_from_m;
    fish->startle_s -= around->dt_s;
    if (fish->startle_s > 0.5f * around->dt_s || surface_ducks(fish)) {
        return; /* The tick that is nearest to the moment; with its snout in the air, later. */
    }
    fish->alarm = ALARM_AFTER;
    fish->habit += HABIT_STEP * (1.0f - fish->habit);
    escape_start(fish, from_m, index, around);
}

static void sense_shades(struct fish *fish, uint32_t index, const struct surroundings *around)
{
    for (uint32_t i = 0; i < around->shade_count; i++) {
        const struct shade *shade = &around->shades[i];
        const float alarm = shade_alarm(shade, around->law, fish->position_m, around->dt_s);
        const vec3 from_m = v3(shade->cast.x_m, fish->position_m.y, shade->cast.z_m);
        fright_alarm(fish, FRIGHT_SHADOW, from_m, alarm, index, around);
    }
}

/* Cheap; 0 only where fright_of_disc() is nothing. */
static int disturbs(const struct obstacle *disc, const struct fish *fish)
{
    const vec3 off = v3_sub(disc->centre_m, fish->position_m);
    const float reach_m = disc->radius_m + ALERT_M;
    const vec3 goes_m_s = obstacle_goes_m_s(disc);
    const float square_m2_s2 = v3_dot(goes_m_s, goes_m_s);
    return disc->kind == OBSTACLE_DISC && square_m2_s2 > ALERT_M_S * ALERT_M_S &&
           v3_dot(off, off) < reach_m * reach_m * f_max(1.0f, square_m2_s2);
}

void fright_tick(struct fish *fish, uint32_t index, const struct surroundings *around)
{
    if (!around->law->escapes) {
        return;
    }
    fish->alarm = f_max(0.0f, fish->alarm - ALARM_FADE_PER_S * around->dt_s);
    fish->habit = fish->habit < HABIT_NONE ? 0.0f
                                           : fish->habit * (1.0f - around->dt_s / HABIT_FADE_S);
    fish->refractory_s = f_max(0.0f, fish->refractory_s - around->dt_s);
    if (fish->startle != FRIGHT_NONE) {
        wait(fish, index, around);
    }
    sense_shades(fish, index, around);
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        const struct obstacle *disc = &around->obstacles[i];
        if (disturbs(disc, fish)) {
            const struct fright fright = fright_of_disc(disc, fish);
            fright_alarm(fish, fright.cause, disc->centre_m, fright.alarm_per_s * around->dt_s,
                         index, around);
        }
    }
}

int fright_alert(const struct fish *fish, const struct surroundings *around)
{
    if (fish->gait == GAIT_ESCAPE || fish->startle != FRIGHT_NONE || fish->alarm > 0.0f) {
        return 1;
    }
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        if (disturbs(&around->obstacles[i], fish)) {
            return 1;
        }
    }
    return 0;
}
