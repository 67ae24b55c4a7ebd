/* surface_breathing.c -- surface breathing: a fish rises, gulps at the surface and dives. The rise
 * and the dive end when the body reaches a position, not after a time. */
#include "core/tank/behavior/surface_breathing.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/gait.h"

/* Oxygen concentration at which a fish rises to the surface with a probability of one half when it
 * chooses its gait. Goldfish begin to breathe at the surface when the oxygen falls to 3 to 5 kPa,
 * which equals 1.2 to 2 mg/L. */
#define CHANCE_HALF_MG_L 1.8f
#define CHANCE_WIDTH_MG_L 0.25f
/* Difference between the oxygen concentration at which an exhausted fish (stamina 0) rises to the
 * surface with a given probability, and the lower concentration at which a rested fish (stamina 1)
 * rises with the same probability. */
#define TIRED_MG_L 0.4f
/* Oxygen concentration below which a fish loses stamina. The rate of the loss grows up to
 * `stifle_per_s` (struct behavior_params) as the concentration falls to 0. */
#define STIFLE_MG_L 4.0f
/* Stamina below which a fish that follows the rules of the 2013 thesis on goldfish behavior gulps
 * at the surface (section 3.6 of the thesis). */
#define TIRED_BELOW 0.25f

#define NOSE_OUT_M 0.002f
/* Depth of the surface film. A mouth that is at most this deep is in the film. */
#define FILM_M 0.003f
/* A rising fish pitches up when its snout is nearer to the surface than this distance, in body
 * lengths. */
#define NEAR_LENGTHS 0.45f
/* Depth of the top of the body (near the snout) at which a rising fish has reached the surface and
 * begins to gulp. */
#define SNOUT_M 0.003f
#define PITCH_MIN (35.0f * F_DEG)
#define PITCH_SPREAD (15.0f * F_DEG)
#define NOD_RAD (5.0f * F_DEG)
#define CLIMB_MAX_M_S 0.03f
#define CLIMB_GAIN_PER_S 3.0f
/* Amplitude of the vertical speed goal with which a gulping fish bobs up and down. The fish really
 * moves by only half a millimetre, because its vertical speed follows the goal slowly. */
#define BOB_M_S 0.012f
#define DUCK_M_S 0.06f
#define DUCK_HASTE 8.0f
#define DIVE_PITCH (-14.0f * F_DEG)
/* Factors on the swimming speed of a fish that rises to the surface (RISE_SHARE), and of a fish at
 * the surface, which hardly moves (DRIFT_SHARE). */
#define RISE_SHARE 0.6f
#define DRIFT_SHARE 0.16f
#define NERVE 1.6f
/* Shortest duration of a gulp, one opening and closing of the mouth: 76 ticks of 1/120 s, or 0.63
 * s. The gulp of an individual fish is up to 0.26 s longer, so fish gulp 67 to 95 times per
 * minute. */
#define GULP_TICKS_MIN 76u
#define GAPE_SHARE 0.55f /* Fraction of a gulp during which the mouth is open. */

float surface_chance(float oxygen_mg_l, float stamina)
{
    CORE_ASSERT(stamina >= 0.0f && stamina <= 1.0f);
    const float half_mg_l = CHANCE_HALF_MG_L + TIRED_MG_L * (0.5f - stamina);
    return 1.0f / (1.0f + f_exp((oxygen_mg_l - half_mg_l) / CHANCE_WIDTH_MG_L));
}

bool surface_calls(const struct fish *fish, uint32_t index, const struct perception *around)
{
    return around->params->air_by_oxygen && rng_unit(perception_key(around, index, RNG_FISH_AIR)) <
                                                surface_chance(around->oxygen_mg_l, fish->stamina);
}

static float nose_m(const struct fish *fish)
{
    return fish->position_m.y + 0.5f * fish->length_m * f_sin(fish->angles.pitch_rad);
}

static float top_m(const struct fish *fish)
{
    const struct box box = fish_box(fish);
    return fish->position_m.y + box_extent_m(&box).y;
}

bool surface_breathes(const struct fish *fish)
{
    return fish->gait == GAIT_SURFACE && fish->air == AIR_GULPS && nose_m(fish) > -FILM_M;
}

static float own_pitch_rad(const struct fish *fish)
{
    return PITCH_MIN + PITCH_SPREAD * (float)(fish->look >> 5 & 15u) / 15.0f;
}

static uint32_t gulp_ticks(const struct fish *fish)
{
    return GULP_TICKS_MIN + (fish->look >> 17 & 31u);
}

static uint32_t gulp_phase(const struct fish *fish, uint32_t tick)
{
    return (tick + (fish->look >> 9 & 127u)) % gulp_ticks(fish);
}

float surface_gulp(const struct fish *fish, uint32_t tick)
{
    return surface_breathes(fish) ? (float)(gulp_phase(fish, tick) + 1u) / (float)gulp_ticks(fish)
                                  : 0.0f;
}

float surface_gape(const struct fish *fish, uint32_t tick)
{
    const float open = f_min(surface_gulp(fish, tick) / GAPE_SHARE, 1.0f);
    return 0.5f - 0.5f * f_cos(F_TAU * open);
}

bool surface_gulps(const struct fish *fish, uint32_t tick, float dt_s)
{
    return surface_breathes(fish) &&
           (float)gulp_phase(fish, tick) < dt_s * (float)CORE_TICK_HZ - 0.5f;
}

/* Begins a bout (a series of gulps) of random duration, and stores the duration in `gait_left_s`.
 * The time left decreases only while the mouth is in the surface film, the top FILM_M of the
 * water. */
static void begin_bout(struct fish *fish, uint32_t index, const struct perception *around)
{
    CORE_ASSERT(around->params->gulp_min_s <= around->params->gulp_max_s);
    const struct behavior_params *params = around->params;
    fish->gait_left_s = f_lerp(params->gulp_min_s, params->gulp_max_s,
                               rng_unit(perception_key(around, index, RNG_FISH_GULP)));
}

void surface_rise(struct fish *fish, uint32_t index, const struct perception *around)
{
    fish->gait = GAIT_SWIM;
    fish->air = AIR_RISES;
    begin_bout(fish, index, around);
}

void surface_stage(struct fish *fish, const struct behavior_params *params)
{
    CORE_ASSERT(params->gulp_max_s > 0.0f);
    const bool is_up = top_m(fish) > -SNOUT_M;
    fish->gait = is_up ? GAIT_SURFACE : GAIT_SWIM;
    fish->air = is_up ? AIR_GULPS : AIR_RISES;
    fish->gait_left_s = params->gulp_max_s;
}

bool surface_ducks(struct fish *fish)
{
    if (fish->gait != GAIT_SURFACE || top_m(fish) <= 0.0f) {
        return false;
    }
    fish->air = AIR_DUCKS;
    return true;
}

float surface_nerve(const struct fish *fish)
{
    return fish->air == AIR_GULPS ? NERVE : 1.0f;
}

bool surface_tick(struct fish *fish, uint32_t index, const struct perception *around)
{
    CORE_ASSERT(fish->air <= AIR_DUCKS);
    const bool was_up = fish->air != AIR_ENOUGH && fish->air != AIR_RISES;
    /* Ends the surface breathing of a fish that a poi (paper scoop) lifted out of the water. */
    if (was_up && fish->gait != GAIT_SURFACE) {
        fish->air = AIR_ENOUGH;
    }
    /* The stamina grows while the mouth is in the surface film, and falls in water with little
     * oxygen. */
    const struct behavior_params *params = around->params;
    const float lack = f_max(0.0f, 1.0f - around->oxygen_mg_l / STIFLE_MG_L);
    const float per_s =
        surface_breathes(fish) ? params->gulp_gain_per_s : -params->stifle_per_s * lack;
    fish->stamina = f_clamp(fish->stamina + per_s * around->dt_s, 0.0f, 1.0f);
    if (fish->air == AIR_ENOUGH && fish->gait != GAIT_ESCAPE && !around->params->air_by_oxygen &&
        fish->stamina < TIRED_BELOW) {
        surface_rise(fish, index, around);
    }
    switch (fish->air) {
    case AIR_RISES:
        if (top_m(fish) > -SNOUT_M) {
            fish->gait = GAIT_SURFACE;
            fish->air = AIR_GULPS;
        }
        return true;
    case AIR_GULPS:
        /* A bout (a series of gulps) continues until `gait_left_s` is 0. Then a living fish begins
         * another bout if the oxygen is low, and otherwise dives. A fish of the 2013 thesis dives
         * after one bout of 3 s, in which its stamina becomes full. */
        if (surface_breathes(fish)) {
            fish->gait_left_s -= around->dt_s;
        }
        if (fish->gait_left_s <= 0.0f) {
            if (surface_calls(fish, index, around)) {
                begin_bout(fish, index, around);
            } else {
                fish->air = AIR_DIVES;
            }
        }
        return true;
    case AIR_DIVES:
    case AIR_DUCKS:
        if (top_m(fish) <= 0.0f) {
            /* The fish is under water again and swims for a normal duration of GAIT_SWIM. */
            fish->air = AIR_ENOUGH;
            gait_enter(fish, GAIT_SWIM, index, around);
        }
        return true;
    default:
        return false;
    }
}

static void resolve_rise(struct fish *fish)
{
    const float pitch_rad = own_pitch_rad(fish);
    const float goal_m = NOSE_OUT_M - 0.5f * fish->length_m * f_sin(fish->angles.pitch_rad);
    const float off_m = goal_m - fish->position_m.y;
    const bool near = nose_m(fish) > -NEAR_LENGTHS * fish->length_m;
    fish->depth_goal_m = goal_m;
    fish->speed_goal_m_s *= near ? DRIFT_SHARE : RISE_SHARE;
    fish->climb_goal_m_s = f_clamp(CLIMB_GAIN_PER_S * off_m, -CLIMB_MAX_M_S, CLIMB_MAX_M_S);
    fish->pitch_goal_rad = near ? pitch_rad : f_min(fish->pitch_goal_rad, pitch_rad);
}

void surface_resolve(struct fish *fish, const struct perception *around)
{
    CORE_ASSERT(fish->air <= AIR_DUCKS);
    float turn;
    switch (fish->air) {
    case AIR_RISES:
        resolve_rise(fish);
        break;
    case AIR_GULPS:
        fish->speed_goal_m_s = around->params->swim_speed * fish->length_m;
        resolve_rise(fish);
        /* The pitch and the height of the fish oscillate slightly with every gulp. */
        turn = F_TAU * (float)gulp_phase(fish, around->tick) / (float)gulp_ticks(fish);
        fish->pitch_goal_rad = own_pitch_rad(fish) + NOD_RAD * f_sin(turn);
        fish->climb_goal_m_s =
            f_clamp(fish->climb_goal_m_s + BOB_M_S * f_cos(turn), -CLIMB_MAX_M_S, CLIMB_MAX_M_S);
        break;
    case AIR_DIVES:
    case AIR_DUCKS:
        fish->haste = fish->air == AIR_DUCKS ? DUCK_HASTE : 1.0f;
        fish->climb_goal_m_s = fish->air == AIR_DUCKS ? -DUCK_M_S : -CLIMB_MAX_M_S;
        fish->pitch_goal_rad = DIVE_PITCH;
        break;
    default:
        break;
    }
}
