/* gait.c -- chooses the gait by stamina, and computes the resulting speeds and the rhythm of tail
 * beats and glides. */
#include "core/tank/behavior/gait.h"

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/behavior/surface_breathing.h"

/* Stamina that a burst costs per second. Section 3.2 of the 2013 thesis on goldfish behavior gives
 * changes per second of -1 (burst), -0.2 (swim) and +0.1 (rest) for stamina from 0 to 100. In this
 * code the stamina is in [0, 1]. */
#define BURST_COST_PER_S 0.010f
#define SWIM_COST_PER_S 0.002f
#define REST_GAIN_PER_S 0.001f
#define BURST_MIN_S 1.0f
#define BURST_MAX_S 3.0f
/* Shortest and longest duration of the two steady gaits, swimming and resting. */
#define STEADY_MIN_S 5.0f
#define STEADY_MAX_S 20.0f
/* Stamina that an escape costs per second: twice the cost of a burst (design value). */
#define ESCAPE_COST_PER_S 0.020f
static const float stamina_per_s[GAIT_COUNT] = {
    [GAIT_REST] = REST_GAIN_PER_S,    [GAIT_SWIM] = -SWIM_COST_PER_S,
    [GAIT_BURST] = -BURST_COST_PER_S, [GAIT_ESCAPE] = -ESCAPE_COST_PER_S,
    [GAIT_SURFACE] = REST_GAIN_PER_S, [GAIT_HELD] = REST_GAIN_PER_S,
    [GAIT_BOWL] = REST_GAIN_PER_S,
};

struct gait_chance gait_chance(float stamina)
{
    if (stamina <= 0.0f) {
        return (struct gait_chance){ 0.0f, 0.0f, 1.0f };
    }
    const float tired = 1.0f - stamina;
    return (struct gait_chance){
        .burst = 0.1f - tired / 10.0f,                      /* Probability that the next gait is a
                                                               burst (2013 thesis, eq. 3.1). */
        .swim = 0.5f - 2.0f * tired / 5.0f,                 /* Probability that the next gait is
                                                               swimming (2013 thesis, eq. 3.2). */
        .rest = 0.4f + tired / 10.0f + 2.0f * tired / 5.0f, /* Probability that the next gait is
                                                               resting (2013 thesis, eq. 3.3). */
    };
}

struct gait_chance gait_shares(float stamina)
{
    CORE_ASSERT(stamina >= 0.0f);
    const struct gait_chance chance = gait_chance(stamina);
    const float burst_s = chance.burst * 0.5f * (BURST_MIN_S + BURST_MAX_S);
    const float swim_s = chance.swim * 0.5f * (STEADY_MIN_S + STEADY_MAX_S);
    const float rest_s = chance.rest * 0.5f * (STEADY_MIN_S + STEADY_MAX_S);
    const float all_s = burst_s + swim_s + rest_s;
    return (struct gait_chance){ burst_s / all_s, swim_s / all_s, rest_s / all_s };
}

float gait_depth_m(float stamina, float water_depth_m)
{
    CORE_ASSERT(water_depth_m > 0.0f);
    /* The 2013 thesis gives depths of 18, 13, 8 and 3 cm in 20 cm of water for four ranges of the
     * stamina. `share` is the depth as a fraction of the water depth. */
    const float share = stamina >= 0.75f   ? 0.90f
                        : stamina >= 0.50f ? 0.65f
                        : stamina >= 0.25f ? 0.40f
                                           : 0.15f;
    return -share * water_depth_m;
}

/* Depth below the surface at which a calm fish (fish_is_calm()) keeps its back. At this depth, a
 * poi (paper scoop) can dip into the water near the fish without touching the fish. If the fish
 * were nearer to the surface, the ring of the poi would push the fish down. */
#define CALM_DEPTH_M 0.020f

/* Returns the preferred depth of the fish for its present stamina (2013 thesis, section 3.6). */
static float preferred_depth_m(const struct fish *fish, const struct temper *temper,
                               float water_depth_m)
{
    const float margin_m = 0.6f * fish->height_m;
    if (fish_is_calm(fish, temper)) {
        return -margin_m - CALM_DEPTH_M;
    }
    return f_clamp(gait_depth_m(fish->stamina, water_depth_m) + fish->depth_stray * water_depth_m,
                   margin_m - water_depth_m, -margin_m);
}

void gait_enter(struct fish *fish, enum fish_gait gait, uint32_t index,
                const struct perception *around)
{
    CORE_ASSERT(gait <= GAIT_BURST);
    const struct behavior_params *params = around->params;
    const struct rng_key time = perception_key(around, index, RNG_FISH_DURATION);
    fish->gait = (uint8_t)gait;
    /* Changes the heading by a random angle, for which the 2013 thesis gives no value. The angle of
     * a fish that begins to swim or to rest has a normal distribution, because real fish rarely
     * turn far. A burst begins with a sharp turn of 60 to 120 degrees. */
    const float bell = rng_normal(perception_key(around, index, RNG_FISH_TURN));
    float turn_rad = bell * (gait == GAIT_SWIM ? params->turn_swim_rad : params->turn_rest_rad);
    if (gait == GAIT_BURST) {
        const float sharp =
            rng_range(perception_key(around, index, RNG_FISH_SHARP_TURN), 60.0f, 120.0f) * F_DEG;
        turn_rad = bell < 0.0f ? -sharp : sharp;
    }
    fish->gait_left_s = gait == GAIT_BURST ? rng_range(time, BURST_MIN_S, BURST_MAX_S)
                                           : rng_range(time, STEADY_MIN_S, STEADY_MAX_S);
    fish->heading_rad = f_wrap_angle(fish->heading_rad + turn_rad);
    fish->depth_stray =
        params->depth_stray * rng_normal(perception_key(around, index, RNG_FISH_DEPTH));
    fish->depth_goal_m = preferred_depth_m(fish, &around->temper, around->size_m.y);
}

void gait_tick(struct fish *fish, uint32_t index, const struct perception *around)
{
    CORE_ASSERT(fish_swims(fish));
    fish->stamina = f_clamp(fish->stamina + stamina_per_s[fish->gait] * around->dt_s, 0.0f, 1.0f);
    if (surface_tick(fish, index, around)) {
        return;
    }
    fish->gait_left_s -= around->dt_s;
    if (fish->gait_left_s <= 0.0f) {
        if (fish->gait == GAIT_ESCAPE) {
            /* After an escape the fish swims for 1 to 3 s instead of stopping immediately. */
            gait_enter(fish, GAIT_SWIM, index, around);
            fish->gait_left_s =
                rng_range(perception_key(around, index, RNG_ESCAPE_CALM), 1.0f, 3.0f);
        } else if (surface_calls(fish, index, around)) {
            surface_rise(fish, index, around);
        } else {
            const struct gait_chance chance = gait_chance(fish->stamina);
            const float draw = rng_unit(perception_key(around, index, RNG_FISH_GAIT));
            gait_enter(fish,
                       draw < chance.burst                 ? GAIT_BURST
                       : draw < chance.burst + chance.swim ? GAIT_SWIM
                                                           : GAIT_REST,
                       index, around);
        }
    }
    if (fish->gait == GAIT_REST || fish->gait == GAIT_SWIM || fish->gait == GAIT_BURST) {
        fish->depth_goal_m = preferred_depth_m(fish, &around->temper, around->size_m.y);
    }
}

bool gait_beats(const struct fish *fish, const struct perception *around)
{
    if (fish->gait == GAIT_SWIM) {
        return !around->params->glides || gait_cycle_beats(fish, around->tick);
    }
    return fish->gait == GAIT_BURST || (fish->gait == GAIT_ESCAPE && escape_beats(fish));
}

/* Returns the basic speed of a fish, m/s, which follows from its length and stamina. Each gait
 * multiplies the basic speed by its own factor. Section 3.3 of the 2013 thesis gives s = d * (0.8 +
 * H / 5) for a stamina H from 0 to 100, where d is one body length per second. The code uses H /
 * 100 instead of H, because otherwise a rested fish would swim at 20.8 * d. The result is one body
 * length per second at full stamina. */
static float able_m_s(const struct fish *fish)
{
    return fish->length_m * (0.8f + 0.2f * fish->stamina);
}

float gait_speed_m_s(const struct fish *fish, const struct perception *around)
{
    const struct behavior_params *params = around->params;
    const float keen = (float)(fish->look >> 22 & 255u) / 255.0f;
    switch (fish->gait) {
    case GAIT_BURST:
        return able_m_s(fish) * params->burst_speed;
    case GAIT_SWIM: {
        /* A fish that alternates between tail beats and glides has two speed goals. The speed goal
         * is above the mean speed during a beat, and 0 during a glide. */
        const float mean_m_s = able_m_s(fish) * params->swim_speed;
        return !params->glides                        ? mean_m_s
               : gait_cycle_beats(fish, around->tick) ? mean_m_s * gait_cycle_share(fish, mean_m_s)
                                                      : 0.0f;
    }
    case GAIT_ESCAPE:
        return escape_speed_m_s(fish);
    default:
        return able_m_s(fish) * params->drift_speed * keen;
    }
}

float gait_speed_max_m_s(const struct fish *fish, const struct behavior_params *params)
{
    return able_m_s(fish) * params->swim_speed_max;
}

float gait_run_up_s(float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    const float log10_length_cm = f_log(100.0f * length_m) * 0.434294482f;
    /* The formula of the 2013 thesis gives the time to reach 95 % of the speed. Dividing this time
     * by 3 gives the time constant, because 1 - exp(-3) is 0.95. The lower limit of 0.02 s is for
     * fry below 1 cm, for which the logarithm is negative. */
    return f_max(0.02f, (0.1772f * log10_length_cm + 0.040f) / 3.0f);
}

/* ---- Rhythm of tail beats and glides (burst-and-coast swimming) ------------------------------ */

/* The tail beats and the glide after them each last a whole number of decision periods
 * (FISH_BEHAVIOR_TICKS). The rhythm of an undisturbed fish is computed once per decision. Therefore
 * each change between beat and glide is delayed by the same number of ticks, and the durations of
 * beat and glide stay exact. */

/* Shortest duration of a cycle, which consists of tail beats and the glide after them: 84 ticks of
 * 1/120 s, or 0.7 s. The cycle of an individual fish is up to 0.5 s longer. */
#define CYCLE_TICKS_MIN 84u
#define BEAT_SHARE 0.45f
/* Duration of a kick, the turn at the beginning of a tail beat: 5 decisions of 4 ticks each, or
 * 0.17 s. */
#define KICK_TICKS (5u * FISH_BEHAVIOR_TICKS)
#define KICK_MAX_RAD (80.0f * F_DEG)

/* Drag coefficient of a gliding koi, relative to its wetted surface. The coefficient is 0.242 while
 * the tail beats. */
#define COAST_DRAG 0.060f
/* Mass of a fish divided by the cube of its length. fish_mass_kg() gives 2.9 g for a fish of 5 cm,
 * and 0.0029 kg / (0.05 m)^3 is 23.1 kg/m^3. */
#define MASS_KG_PER_M3 23.1f
/* Mass of the water that moves along with a slender body, as a fraction of the fish's mass. */
#define ADDED_MASS 0.10f
/* Wetted surface of a fish divided by its squared length, including both sides of the fins. */
#define SURFACE_PER_LENGTH2 0.65f
#define GLIDE_LENGTHS                                                                              \
    (2.0f * (1.0f + ADDED_MASS) * MASS_KG_PER_M3 / (WATER_KG_M3 * SURFACE_PER_LENGTH2 * COAST_DRAG))

/* Returns the duration of the fish's cycle of tail beats and glide, in ticks. Each fish has its own
 * duration. */
static uint32_t cycle_ticks(const struct fish *fish)
{
    return CYCLE_TICKS_MIN + FISH_BEHAVIOR_TICKS * (fish->look >> 10 & 15u);
}

static uint32_t beat_ticks(uint32_t cycle)
{
    CORE_ASSERT(cycle >= CYCLE_TICKS_MIN);
    return FISH_BEHAVIOR_TICKS * (uint32_t)(BEAT_SHARE * (float)cycle / (float)FISH_BEHAVIOR_TICKS);
}

static uint32_t ticks_into(const struct fish *fish, uint32_t tick)
{
    return (tick + (fish->look >> 14 & 255u)) % cycle_ticks(fish);
}

bool gait_cycle_beats(const struct fish *fish, uint32_t tick)
{
    return ticks_into(fish, tick) < beat_ticks(cycle_ticks(fish));
}

bool gait_cycle_kicks(const struct fish *fish, uint32_t tick)
{
    return ticks_into(fish, tick) < KICK_TICKS;
}

/* Turns the fish once per kick, at its first decision during a tail beat. The random key contains
 * the first tick of the beat, so the turn does not depend on the tick of the decision. */
void gait_cycle_turn(struct fish *fish, uint32_t index, const struct perception *around)
{
    const uint32_t into = ticks_into(fish, around->tick);
    if (around->params->kick_rad <= 0.0f || fish->gait != GAIT_SWIM ||
        (float)into * CORE_TICK_S > around->dt_s - 0.5f * CORE_TICK_S) {
        return;
    }
    const struct rng_key key = { around->seed, around->tick - into, index, RNG_FISH_KICK };
    const float turn_rad = around->params->kick_rad * rng_normal(key);
    fish->heading_rad =
        f_wrap_angle(fish->heading_rad + f_clamp(turn_rad, -KICK_MAX_RAD, KICK_MAX_RAD));
}

float gait_glide_m(float length_m)
{
    CORE_ASSERT(length_m > 0.0f);
    return GLIDE_LENGTHS * length_m;
}

float gait_cycle_share(const struct fish *fish, float mean_m_s)
{
    CORE_ASSERT(mean_m_s > 0.0f);
    const uint32_t cycle = cycle_ticks(fish), beat = beat_ticks(cycle);
    const float glide_m = gait_glide_m(fish->length_m);
    const float run_up_s = gait_run_up_s(fish->length_m);
    const float beat_s = (float)beat * CORE_TICK_S;
    const float glide_s = (float)(cycle - beat) * CORE_TICK_S;
    float share = 1.25f;
    /* `share` is the speed goal during a beat divided by the mean speed. Each iteration computes
     * `share` from its previous estimate. Three iterations suffice, because the result depends only
     * weakly on the estimate. */
    for (int round = 0; round < 3; round++) {
        const float x = share * mean_m_s * glide_s / glide_m;
        const float lost = x / (1.0f + x); /* Fraction of its initial speed that the fish loses in
                                              the glide. */
        /* (6 + x) / (6 + 4 * x) equals ln(1 + x) / x with an error below 1e-3 for x up to 1. The
         * quotient is the distance of a glide with drag divided by the distance of a glide without
         * drag. */
        share = (beat_s + glide_s) /
                (beat_s - lost * run_up_s + glide_s * ((6.0f + x) / (6.0f + 4.0f * x)));
    }
    return share;
}
