/* burst_coast.c -- the burst-and-coast rhythm of a cruising fish, and the effect of drag. */
#include "core/tank/behavior/burst_coast.h"

#include "core/base/physics.h"
#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/fish_behavior.h"
#include "core/tank/behavior/gait.h"

/* Beat and glide last a whole number of decision periods (FISH_BEHAVIOR_TICKS). A fish that checks
 * its rhythm once per decision therefore keeps the rhythm exactly. */

/* Shortest cycle of beat and glide, 0.7 s. The cycle of an individual fish is up to 0.5 s
 * longer. */
#define CYCLE_TICKS_MIN 84u
#define BEAT_SHARE 0.45f
#define KICK_TICKS (5u * FISH_BEHAVIOR_TICKS) /* Duration of a kick, 0.17 s. */
#define KICK_MAX_RAD (80.0f * F_DEG)

/* Drag coefficient of a gliding koi, relative to its wetted surface. The coefficient is 0.242 while
 * the tail beats. */
#define COAST_DRAG 0.060f
/* Mass of a fish divided by the cube of its length: 2.9 g at 5 cm, as in fish_mass_kg(). */
#define MASS_KG_PER_M3 23.1f
/* Mass of the water that moves along with a slender body, as a fraction of the fish's mass. */
#define ADDED_MASS 0.10f
/* Wetted surface of a fish divided by its squared length, including both sides of the fins. */
#define SURFACE_PER_LENGTH2 0.65f
#define GLIDE_LENGTHS                                                                              \
    (2.0f * (1.0f + ADDED_MASS) * MASS_KG_PER_M3 / (WATER_KG_M3 * SURFACE_PER_LENGTH2 * COAST_DRAG))

/* Returns the duration of the fish's cycle of beat and glide. Each fish has its own duration. */
static uint32_t cycle_ticks(const struct fish *fish)
{
    return CYCLE_TICKS_MIN + FISH_BEHAVIOR_TICKS * (fish->look >> 10 & 15u);
}

static uint32_t beat_ticks(uint32_t cycle)
{
    return FISH_BEHAVIOR_TICKS * (uint32_t)(BEAT_SHARE * (float)cycle / (float)FISH_BEHAVIOR_TICKS);
}

static uint32_t ticks_into(const struct fish *fish, uint32_t tick)
{
    return (tick + (fish->look >> 14 & 255u)) % cycle_ticks(fish);
}

int burst_coast_beats(const struct fish *fish, uint32_t tick)
{
    return ticks_into(fish, tick) < beat_ticks(cycle_ticks(fish));
}

int burst_coast_kicks(const struct fish *fish, uint32_t tick)
{
    return ticks_into(fish, tick) < KICK_TICKS;
}

/* Turns the fish at its first decision during a beat. The random key contains the first tick of the
 * beat, so the turn does not depend on the tick of the decision. */
void burst_coast_turn(struct fish *fish, uint32_t index, const struct perception *around)
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

float burst_coast_glide_m(float length_m)
{
    return GLIDE_LENGTHS * length_m;
}

/* Returns ln(1 + x) / x with an error below 1e-3 for x up to 1. The result is the distance of a
 * glide with drag divided by the distance of a glide without drag. */
static float glided(float x)
{
    return (6.0f + x) / (6.0f + 4.0f * x);
}

float burst_coast_share(const struct fish *fish, float mean_m_s)
{
    const uint32_t cycle = cycle_ticks(fish), beat = beat_ticks(cycle);
    const float glide_m = burst_coast_glide_m(fish->length_m);
    const float run_up_s = gait_run_up_s(fish->length_m);
    const float beat_s = (float)beat * CORE_TICK_S;
    const float glide_s = (float)(cycle - beat) * CORE_TICK_S;
    float share = 1.25f;
    for (int round = 0; round < 3; round++) { /* Each round computes `share` from its previous
                                                 estimate. The dependence is weak, so three rounds
                                                 suffice. */
        const float x = share * mean_m_s * glide_s / glide_m;
        const float lost = x / (1.0f + x); /* Fraction of its initial speed that the fish loses in
                                              the glide. */
        share = (beat_s + glide_s) / (beat_s - lost * run_up_s + glide_s * glided(x));
    }
    return share;
}
