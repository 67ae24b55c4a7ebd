/* surface_breathing.h -- surface breathing (hanaage): a fish short of oxygen breathes the film of
 * water at the surface.
 *
 * The fish swims up and puts its mouth through the surface at an angle of 35 to 50 degrees. The
 * fish then drifts, and opens and closes its mouth about 80 times per minute. One opening and
 * closing is a gulp, and a series of gulps is a bout.
 *
 * The surface film is nearly saturated with oxygen, even if the water below contains little.
 *
 * The behavior parameters select the cause of a rise to the surface. Living fish rise because of
 * low oxygen. The fish of the 2013 thesis on goldfish behavior (section 3.6) rise because of low
 * stamina. */
#pragma once

#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

/* Returns the probability that a fish rises to the surface, or stays there, when it chooses its
 * next gait. The probability is 1 / (1 + exp((C - M) / 0.25)) for an oxygen concentration of C
 * mg/L. At the concentration M the probability is one half. M depends on the stamina: 2.0 mg/L at
 * stamina 0, 1.8 at stamina 0.5 and 1.6 at stamina 1. */
float surface_chance(float oxygen_mg_l, float stamina);

/* Returns true if the fish rises to the surface instead of entering another gait. The caller calls
 * the function when the fish chooses its gait. The decision is random with the probability
 * surface_chance(). The random number depends on the seed, the tick and the index of the fish.
 * Always returns false if params->air_by_oxygen is false, because low stamina then causes the
 * rise. */
bool surface_calls(const struct fish *fish, uint32_t index, const struct perception *around);

/* Begins the rise to the surface in GAIT_SWIM. In the 2013 thesis a tired fish rests, but a resting
 * fish would never reach the surface. */
void surface_rise(struct fish *fish, uint32_t index, const struct perception *around);

/* Sets the state of a fish that tank_stage_all() places in GAIT_SURFACE, the gait of a fish that
 * breathes at the surface. If the top of the body is at the surface, the fish immediately begins a
 * series of gulps (a bout) of the longest duration. Otherwise the fish rises first. */
void surface_stage(struct fish *fish, const struct behavior_params *params);

/* Advances surface breathing by `around->dt_s`: the loss of stamina in water with little oxygen,
 * the rise, the gulps and the dive. Returns true while the fish rises, gulps or dives, because the
 * fish then chooses no other gait. */
bool surface_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Sets the goals of a fish that breathes at the surface; called at the end of swim_resolve(). The
 * goal of the snout is 2 mm above the surface, with a small motion up and down. The fish climbs and
 * sinks at 3 cm/s at most, unless it is startled. */
void surface_resolve(struct fish *fish, const struct perception *around);

/* Returns true while the mouth of a gulping fish is in the surface film, which is rich in
 * oxygen. */
bool surface_breathes(const struct fish *fish);

/* Returns the phase (0, 1] of the current gulp, which lasts from one opening of the mouth to the
 * next. Returns 0 while the mouth is not in the surface film. */
float surface_gulp(const struct fish *fish, uint32_t tick);

/* Returns the opening of the mouth: 0 is closed, 1 is fully open. */
float surface_gape(const struct fish *fish, uint32_t tick);

/* Returns true if a gulp (one opening and closing of the mouth) began in the last `dt_s` seconds
 * before `tick`. The caller then makes a ring-shaped wave. */
bool surface_gulps(const struct fish *fish, uint32_t tick, float dt_s);

/* Starts the dive of a startled fish whose body stands out of the water. Returns true if the fish
 * must be under water before it can escape by a C-start. */
bool surface_ducks(struct fish *fish);

/* Returns the factor by which the startle threshold of the fish is multiplied. The factor is above
 * 1 for a gulping fish, which notices a stimulus late, and 1 for any other fish. */
float surface_nerve(const struct fish *fish);
