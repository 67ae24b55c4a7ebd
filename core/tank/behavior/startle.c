/* startle.c -- computes the startle response of a fish: stimuli, alarm, habituation and latency. */
#include "core/tank/behavior/startle.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/shade.h"
#include "core/tank/water.h"

#define ALARM_FADE_PER_S 0.6f
/* Alarm of a fish after it began a C-start (escape). 1 is the full alarm. */
#define ALARM_AFTER 0.2f
/* Time in which a stimulus of strength 1 raises the alarm of a fish by 1. A visual stimulus has the
 * strength 1 at GROWTH_SPAN_RAD_S, and a pressure stimulus at PUSH_SPAN_M2_S2. */
#define STARTLE_RISE_S 0.12f
#define STRENGTH_MAX 12.0f

/* Limits above which an approaching object startles a fish. The visual angle of the object must
 * exceed SEEN_RAD (20 degrees) for the most timid fish, and up to SEEN_SPREAD_RAD (10 degrees) more
 * for a bolder fish. The visual angle must also grow faster than GROWTH_RAD_S. */
#define SEEN_RAD (20.0f * F_DEG)
#define SEEN_SPREAD_RAD (10.0f * F_DEG)
#define GROWTH_RAD_S 4.5f
#define GROWTH_SPAN_RAD_S 6.5f
/* Factor on the strength of a visual stimulus from an object in the air, which the fish sees
 * through the rippled surface. */
#define IN_AIR_SHARE 0.25f

/* Smallest pressure, divided by the water density, that fish detect. A poi (paper scoop) that rises
 * at 0.1 m/s causes a smaller pressure, so that fish do not detect the poi by pressure. */
#define PUSH_M2_S2 0.005f
/* Pressure above PUSH_M2_S2, divided by the water density, that counts as a stimulus of strength 1.
 * The paper of a poi that rises at 0.15 m/s causes such a stimulus. */
#define PUSH_SPAN_M2_S2 0.016f
#define WAKE_SHARE 0.5f
/* Length of a fish whose sensitivity to pressure is 1. Smaller fish are more sensitive: fish of 1.6
 * g hear sounds that are 15 dB fainter than fish of 23.6 g do (Asa et al.). These fish differ in
 * length by a factor of 2.5, and 15 dB is a factor of 5.6 in pressure. */
#define LENGTH_M 0.05f
/* Apparent height of a poi (paper scoop) divided by its apparent width if the fish sees the poi
 * edge-on, as a line. The value equals RING_TUBE_PER_RADIUS, because only the ring is visible. */
#define LINE_THICKNESS 0.07f

#define GULPING_LATE 1.5f /* Factor on the startle latency of a gulping fish, which reacts late. */

/* Alarm threshold of the most timid fish. The boldest fish has twice this threshold. */
#define THRESHOLD 0.45f
#define THRESHOLD_MAX 0.95f
/* Increase of the habituation of a fish per C-start (escape), as a fraction of the difference
 * between the present habituation and full habituation. Full habituation doubles the startle
 * threshold. */
#define HABIT_STEP 0.25f
#define HABIT_FADE_S 60.0f
#define HABIT_NONE 1e-3f

/* Distance from the rim of a moving poi (paper scoop) within which a fish is alert, so that it
 * decides in every tick. A poi at this distance has a visual angle of about 20 degrees, the limit
 * SEEN_RAD. For a poi that is faster than 1 m/s, the distance is multiplied by the speed in m/s. */
#define ALERT_M 0.20f
#define ALERT_M_S 0.05f

/* Addition to `threshold_gain` (struct temper) for a calm fish, which is a small fish that stays
 * near the surface (fish_is_calm()). */
#define CALM_GAIN 1.0f

static float boldness(const struct fish *fish)
{
    return (float)(fish->look >> 3 & 31u) / 31.0f;
}

float startle_threshold(const struct fish *fish)
{
    CORE_ASSERT(fish->habit >= 0.0f && fish->habit <= 1.0f);
    const float bears = THRESHOLD * (1.0f + boldness(fish)) * (1.0f + fish->habit);
    return f_min(THRESHOLD_MAX, surface_nerve(fish) * bears);
}

struct startle_view startle_view(const struct obstacle *disc, vec3 eye_m)
{
    CORE_ASSERT(disc->radius_m > 0.0f);
    const vec3 to = v3_sub(eye_m, disc->centre_m);
    const float distance_m = f_max(v3_length(to), 0.2f * disc->radius_m);
    const vec3 toward = v3_scale(to, 1.0f / distance_m);
    const float face = f_max(f_abs(v3_dot(toward, disc->normal)), LINE_THICKNESS);
    const float half_m = disc->radius_m * f_sqrt(face); /* Radius of a circle that looks as large to
                                                           the fish as the disc (the poi). */
    const float closing_m_s = v3_dot(obstacle_goes_m_s(disc), toward);
    return (struct startle_view){
        .size_rad = 2.0f * f_atan2(half_m, distance_m),
        .growth_rad_s = 2.0f * half_m * closing_m_s / (half_m * half_m + distance_m * distance_m),
    };
}

struct startle_stimulus startle_of_disc(const struct obstacle *disc, const struct fish *fish)
{
    CORE_ASSERT(disc->kind == OBSTACLE_DISC);
    const struct startle_view view = startle_view(disc, fish->position_m);
    const bool large = view.size_rad > SEEN_RAD + SEEN_SPREAD_RAD * boldness(fish);
    const float clear = disc->centre_m.y > 0.0f ? IN_AIR_SHARE : 1.0f;
    const float keen = LENGTH_M / f_max(fish->length_m, 0.2f * LENGTH_M);
    /* A poi (paper scoop) is a disc for the fish. Behind a moving disc the pressure is lower than
     * ahead of the disc, by the factor WAKE_SHARE. */
    const float ahead = v3_dot(disc->velocity_m_s, v3_sub(fish->position_m, disc->centre_m));
    const float push =
        keen * ((ahead < 0.0f ? WAKE_SHARE : 1.0f) * water_push_m2_s2(disc, fish->position_m));
    const float seen = large ? clear * (view.growth_rad_s - GROWTH_RAD_S) / GROWTH_SPAN_RAD_S : 0;
    const float felt = (push - PUSH_M2_S2) / PUSH_SPAN_M2_S2;
    const float most = f_clamp(f_max(seen, felt), 0.0f, STRENGTH_MAX);
    return (struct startle_stimulus){
        .cause = most <= 0.0f   ? STARTLE_NONE
                 : felt >= seen ? STARTLE_PRESSURE
                                : STARTLE_LOOM,
        .alarm_per_s = most / STARTLE_RISE_S,
    };
}

/* Shortest and longest latency of the nerves, for each cause of a startle. The latency is the time
 * from the moment in which a stimulus startles a fish to the C-start (escape). For a shadow the
 * longest latency is only 115 ms, because a shadow must first fall on the fish for up to 33 ms
 * (shade.c), and a living fish escapes within 150 ms after the shadow appears. */
static const struct {
    float min_s, max_s;
} nerves[] = {
    [STARTLE_LOOM] = { 0.060f, 0.150f },
    [STARTLE_PRESSURE] = { 0.008f, 0.015f },
    [STARTLE_SHADOW] = { 0.063f, 0.115f },
};

void startle_alarm(struct fish *fish, enum startle_cause cause, vec3 from_m, float alarm,
                   uint32_t index, const struct perception *around)
{
    CORE_ASSERT(alarm >= 0.0f);
    CORE_ASSERT(cause <= STARTLE_SHADOW);
    if (alarm == 0.0f) {
        return; /* The usual case: nothing alarms the fish. */
    }
    const bool waits_by_ear = fish->startle == STARTLE_PRESSURE;
    const struct temper *temper = &around->temper;
    const float calm = fish_is_calm(fish, temper) ? CALM_GAIN : 0.0f;
    alarm *= 1.0f / (1.0f + temper->threshold_gain + calm);
    fish->alarm = f_min(1.0f, fish->alarm + alarm);
    if (fish->gait == GAIT_ESCAPE || fish->refractory_s > 0.0f || waits_by_ear ||
        (fish->startle != STARTLE_NONE && cause != STARTLE_PRESSURE) ||
        fish->alarm <= startle_threshold(fish)) {
        return;
    }
    /* The fish is startled and will escape after a latency. If the fish is already startled, only
     * the shorter remaining latency counts. Therefore an earlier visual stimulus does not delay the
     * C-start after a pressure stimulus. */
    const struct rng_key key = perception_key(around, index, RNG_STARTLE_LATENCY);
    const float late = fish->gait == GAIT_SURFACE ? GULPING_LATE : 1.0f;
    const float wait_s = (1.0f + temper->latency_gain) * late *
                         rng_range(key, nerves[cause].min_s, nerves[cause].max_s);
    if (fish->startle == STARTLE_NONE || wait_s < fish->startle_s) {
        fish->startle = (uint8_t)cause;
        fish->startle_from_m = from_m;
        fish->startle_s = wait_s;
    }
}

/* Returns true if a poi (paper scoop), which is a disc for the fish, could startle the fish. The
 * test costs less time than startle_of_disc(), and returns false only if startle_of_disc() would
 * return no alarm. */
static bool disturbs(const struct obstacle *disc, const struct fish *fish,
                     const struct temper *temper)
{
    const vec3 off = v3_sub(disc->centre_m, fish->position_m);
    const float reach_m = disc->radius_m + ALERT_M * (1.0f - temper->reach_loss);
    const vec3 goes_m_s = obstacle_goes_m_s(disc);
    const float square_m2_s2 = v3_dot(goes_m_s, goes_m_s);
    return disc->kind == OBSTACLE_DISC && square_m2_s2 > ALERT_M_S * ALERT_M_S &&
           v3_dot(off, off) < reach_m * reach_m * f_max(1.0f, square_m2_s2);
}

void startle_tick(struct fish *fish, uint32_t index, const struct perception *around)
{
    if (!around->params->escapes) {
        return;
    }
    fish->alarm = f_max(0.0f, fish->alarm - ALARM_FADE_PER_S * around->dt_s);
    fish->habit =
        fish->habit < HABIT_NONE ? 0.0f : fish->habit * (1.0f - around->dt_s / HABIT_FADE_S);
    fish->refractory_s = f_max(0.0f, fish->refractory_s - around->dt_s);
    if (fish->startle != STARTLE_NONE) {
        /* A startled fish escapes in the tick nearest to the end of its latency. A fish at the
         * surface first dives until its body is under water. */
        fish->startle_s -= around->dt_s;
        if (fish->startle_s <= 0.5f * around->dt_s && !surface_ducks(fish)) {
            fish->alarm = ALARM_AFTER;
            fish->habit += HABIT_STEP * (1.0f - fish->habit);
            escape_start(fish, fish->startle_from_m, index, around);
        }
    }
    for (uint32_t i = 0; i < around->shade_count; i++) {
        const struct shade *shade = &around->shades[i];
        const float alarm = shade_alarm(shade, around->params, fish->position_m, around->dt_s);
        const vec3 from_m = v3(shade->cast.x_m, fish->position_m.y, shade->cast.z_m);
        startle_alarm(fish, STARTLE_SHADOW, from_m, alarm, index, around);
    }
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        const struct obstacle *disc = &around->obstacles[i];
        if (disturbs(disc, fish, &around->temper)) {
            const struct startle_stimulus stimulus = startle_of_disc(disc, fish);
            startle_alarm(fish, stimulus.cause, disc->centre_m, stimulus.alarm_per_s * around->dt_s,
                          index, around);
        }
    }
}

bool startle_alert(const struct fish *fish, const struct perception *around)
{
    if (fish->gait == GAIT_ESCAPE || fish->startle != STARTLE_NONE || fish->alarm > 0.0f) {
        return true;
    }
    for (uint32_t i = 0; i < around->obstacle_count; i++) {
        if (disturbs(&around->obstacles[i], fish, &around->temper)) {
            return true;
        }
    }
    return false;
}
