/* shade.c -- tracks the age and the motion of shades, and computes how shades attract and startle
 * fish. */
#include "core/tank/shade.h"

#include "core/base/panic.h"
#include "core/tank/behavior/gait.h"

#define EDGE_TAU_S 0.10f
/* Strength with which a still shade attracts fish. The value is the factor S in eq. 3.5 of the 2013
 * thesis on goldfish behavior, converted to 1/s: 0.01 per frame at 60 frames per second. */
#define PULL_PER_S 0.60f
/* Lower limit of the speed of the intended velocity, which is the sum of the fish's own velocity
 * and the attraction of shades. Above the limit, the fish turns to the direction of this velocity.
 * Below the limit, the fish keeps its yaw, because the direction of a very slow velocity is nearly
 * random. */
#define HARDLY_M_S 0.005f
/* Speed, in body lengths per second, of a push by nearby fish that cancels the attraction of a
 * shade completely. The push must point away from the shade. A weaker push reduces the
 * attraction. */
#define FULL_LENGTHS_PER_S 0.1f
/* Width of the rim around a shade in which the shade already startles fish (design value). */
#define STARTLE_RIM_M 0.02f
/* Time in which the shade of a hand-held fan raises the alarm of a fish from 0 to 1. The nerve
 * latency (startle.h) begins afterwards. */
#define STARTLE_TIME_S 0.04f
/* A shade that takes this fraction of the light causes the full alarm. Darker shades cause no more
 * alarm. */
#define STARTLE_PLAIN_DARK 0.60f

void shade_tick(struct shade *shade, const struct shade_cast *cast, float dt_s)
{
    CORE_ASSERT(dt_s > 0.0f);
    if (!cast->present) {
        *shade = (struct shade){ 0 };
        return;
    }
    CORE_ASSERT(f_is_finite(cast->x_m) && f_is_finite(cast->z_m));
    CORE_ASSERT(f_is_finite(cast->radius_m) && f_is_finite(cast->dark));
    CORE_ASSERT(cast->radius_m > 0.0f);
    if (!shade->cast.present) {
        *shade = (struct shade){ .cast = *cast, .age_s = dt_s };
        return;
    }
    /* The speed of the fastest point of the shade's edge is the speed of the centre plus the change
     * of the radius per second. */
    const float x_m = cast->x_m - shade->cast.x_m, z_m = cast->z_m - shade->cast.z_m;
    const float edge_m_s =
        (f_sqrt(x_m * x_m + z_m * z_m) + f_abs(cast->radius_m - shade->cast.radius_m)) / dt_s;
    shade->edge_m_s = f_lerp(shade->edge_m_s, edge_m_s, f_min(1.0f, dt_s / EDGE_TAU_S));
    shade->cast = *cast;
    shade->age_s += dt_s;
    if (shade->edge_m_s > SHADE_MOVES_M_S) {
        shade->still_s = 0.0f;
    } else if (shade->edge_m_s <= SHADE_STILL_M_S) {
        shade->still_s += dt_s;
    }
}

float shade_distance_m(const struct shade_cast *cast, vec3 position_m)
{
    const float x_m = position_m.x - cast->x_m, z_m = position_m.z - cast->z_m;
    return f_sqrt(x_m * x_m + z_m * z_m);
}

bool shade_covers(const struct shade_cast *cast, vec3 position_m)
{
    return cast->present && shade_distance_m(cast, position_m) < cast->radius_m;
}

static bool is_gathering(const struct shade *shade, const struct behavior_params *params)
{
    return shade->cast.present && shade->still_s >= params->shade_dwell_s;
}

float shade_pull_m_s(const struct shade *shade, const struct behavior_params *params,
                     float distance_m)
{
    CORE_ASSERT(distance_m >= 0.0f);
    const float radius_m = shade->cast.radius_m;
    if (!is_gathering(shade, params)) {
        return 0.0f;
    }
    const float reach_m = f_max(0.0f, SHADE_FIELD_RADII * radius_m - distance_m);
    const float calm_m = SHADE_CALM_RADII * radius_m;
    const float fade = (distance_m - calm_m) / (SHADE_DEAD_RADII * radius_m - calm_m);
    return PULL_PER_S * reach_m * f_clamp(fade, 0.0f, 1.0f);
}

bool shade_draw(const struct shade *shades, uint32_t count, const struct behavior_params *params,
                const struct fish *fish, struct shade_course *course)
{
    /* Sum of the attractions of all shades as a horizontal velocity. */
    vec3 pull_m_s = { 0.0f, 0.0f, 0.0f };
    for (uint32_t i = 0; i < count; i++) {
        const struct shade_cast *cast = &shades[i].cast;
        if (!is_gathering(&shades[i], params)) {
            continue;
        }
        const float distance_m = shade_distance_m(cast, fish->position_m);
        const float toward_m_s = shade_pull_m_s(&shades[i], params, distance_m);
        if (toward_m_s > 0.0f) { /* shade_pull_m_s() returns 0 at the centre. Therefore `distance_m`
                                    is positive and the direction is defined. */
            const vec3 centre_m = v3(cast->x_m, 0.0f, cast->z_m);
            const vec3 to_m = v3_flat(v3_sub(centre_m, fish->position_m));
            pull_m_s = v3_muladd(pull_m_s, to_m, toward_m_s / distance_m);
        }
    }
    if (pull_m_s.x == 0.0f && pull_m_s.z == 0.0f) {
        return false;
    }
    const float yaw_rad = fish->angles.yaw_rad;
    const vec3 own = v3_heading(course->heading_rad);
    /* The attraction of a shade decreases if other fish push this fish away from the shade.
     * Therefore no fish presses into a shade that is full of fish. */
    CORE_ASSERT(fish->length_m > 0.0f);
    const vec3 toward = v3_normalize_or(pull_m_s, pull_m_s);
    const float against_m_s = -v3_dot(toward, fish->push_m_s);
    const float full_m_s = FULL_LENGTHS_PER_S * fish->length_m;
    const vec3 drawn =
        v3_muladd(v3_scale(pull_m_s, f_clamp(1.0f - against_m_s / full_m_s, 0.0f, 1.0f)), own,
                  course->speed_m_s);
    const vec3 wanted = v3_limit(drawn, f_max(course->speed_m_s, gait_speed_max_m_s(fish, params)));
    const float along_m_s = -f_sin(yaw_rad) * wanted.x - f_cos(yaw_rad) * wanted.z;
    course->heading_rad = v3_length(wanted) > HARDLY_M_S ? f_atan2(-wanted.x, -wanted.z) : yaw_rad;
    course->speed_m_s = f_max(0.0f, along_m_s);
    return true;
}

float shade_alarm(const struct shade *shade, const struct behavior_params *params, vec3 position_m,
                  float dt_s)
{
    CORE_ASSERT(dt_s >= 0.0f);
    const struct shade_cast *cast = &shade->cast;
    const bool is_sudden = shade->age_s <= SHADE_NEW_S || shade->edge_m_s > SHADE_MOVES_M_S;
    if (!params->shade_frights || !cast->present || !is_sudden ||
        shade_distance_m(cast, position_m) > cast->radius_m + STARTLE_RIM_M) {
        return 0.0f;
    }
    /* The alarm is proportional to the time since the fish's last decision, or to the age of the
     * shade if the shade is younger. A weak shade causes little alarm: the shade of the thin paper
     * of a poi (paper scoop) causes a twentieth of the alarm that the shade of a hand-held fan
     * causes. */
    const float share = f_clamp(
        (cast->dark - SHADE_SUDDEN_DARK) / (STARTLE_PLAIN_DARK - SHADE_SUDDEN_DARK), 0.0f, 1.0f);
    return (share * f_sqrt(share)) * f_min(dt_s, shade->age_s) / STARTLE_TIME_S;
}
