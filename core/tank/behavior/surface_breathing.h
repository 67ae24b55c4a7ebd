/* surface_breathing.h -- surface breathing (hanaage): a fish short of oxygen breathes the film of
 * the surface.
 *
 * The fish swims up, puts its mouth through the surface at 35 to 50 degrees, opens and closes it
 * about 80 times per minute and drifts. The surface film is near saturation whatever the oxygen
 * below. The behavior parameters select the trigger: the oxygen of the water in living tanks,
 * stamina alone in the 2013 thesis (section 3.6). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_SURFACE_BREATHING_H
#define KINGYO_CORE_TANK_BEHAVIOR_SURFACE_BREATHING_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

/* Returns the chance that a fish rises or stays up at one decision: 1 / (1 + exp((C - 1.8) /
 * 0.25)), C in mg/L. For a tired fish (stamina 0) C counts 0.2 mg/L less, for a fresh fish 0.2 mg/L
 * more. */
float surface_chance(float oxygen_mg_l, float stamina);

/* Returns 1 if the fish rises now; called at a choice of gait. The draw depends on (seed, tick,
 * fish). Returns 0 if stamina alone is the trigger. */
int surface_calls(const struct fish *fish, uint32_t index, const struct perception *around);

/* Starts the rise. The fish swims, whatever its gait was (the thesis' tired fish rests, and a
 * resting fish would never come up). */
void surface_rise(struct fish *fish, uint32_t index, const struct perception *around);

/* Stages a gulping fish. Its longest bout begins at once if its back is at the surface; otherwise
 * it rises first. */
void surface_stage(struct fish *fish, const struct behavior_params *params);

/* Advances surface breathing by `around->dt_s`: the stamina loss in bad water, the rise, the gulps
 * and the dive. Returns 1 during any of these stages, in which the fish chooses no other gait. */
int surface_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Sets the goals of a fish at the surface; called after swim_resolve(). The nose ends 2 mm above
 * the surface and bobs. The fish climbs and sinks at most at 3 cm/s, unless it is startled. */
void surface_resolve(struct fish *fish, const struct perception *around);

/* Returns 1 while the mouth is in the film. */
int surface_breathes(const struct fish *fish);

/* Returns the phase of a gulp from one opening of the mouth to the next, (0, 1]; 0 while the mouth
 * is not in the film. */
float surface_gulp(const struct fish *fish, uint32_t tick);

/* Returns the opening of the mouth, [0, 1]. */
float surface_gape(const struct fish *fish, uint32_t tick);

/* Returns 1 if a gulp began in the `dt_s` before `tick`, which makes a ring on the water. */
int surface_gulps(const struct fish *fish, uint32_t tick, float dt_s);

/* Sends a startled fish with its snout in the air quickly under water first. Returns 1 while it
 * must wait for that, otherwise 0. */
int surface_ducks(struct fish *fish);

/* Returns the factor on the startle threshold: gulping fish notice a stimulus late. */
float surface_nerve(const struct fish *fish);

#endif
