/* surface.h -- gulping (hanaage): a fish that is short of air breathes the film of the surface.
 *
 * It swims up, puts its mouth through the surface at 35 to 50 degrees, opens and shuts it about 80
 * times a minute and drifts. The surface's film is near saturation whatever is below it. What sends
 * it up is its tank's law: in living tanks the water's oxygen, in the 2013 thesis (section 3.6) its
 * stamina alone. */
#ifndef KINGYO_CORE_TANK_SURFACE_H
#define KINGYO_CORE_TANK_SURFACE_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

/* Chance that a fish, asked, goes up or stays up: 1 / (1 + exp((C - 1.8) / 0.25)), C in mg/L. A
 * tired fish (stamina 0) counts as if there were 0.2 mg/L less, a fresh one 0.2 more. */
float surface_chance(float oxygen_mg_l, float stamina);

/* Asked when it chooses a gait; drawn from (seed, tick, fish). Never where stamina alone counts. */
int surface_calls(const struct fish *fish, uint32_t index, const struct surroundings *around);

/* Sends it up: it swims, whatever it did (the thesis' tired fish rests, and a resting fish would
 * never come up). */
void surface_rise(struct fish *fish, uint32_t index, const struct surroundings *around);

/* Staged as a gulper: its longest bout begins where its back is at the surface already, else it
 * comes up first. */
void surface_stage(struct fish *fish, const struct law *law);

/* `around->dt_s` later: what bad water costs it, its way up, its gulps and its way down. Returns
 * whether it is about one of these: then it chooses no other gait. */
int surface_tick(struct fish *fish, uint32_t index, const struct surroundings *around);

/* After swim_resolve(): the orders of a fish that is up for air. Its nose ends 2 mm above the
 * surface, bobbing; it climbs and sinks by 3 cm/s at most, but for a fright. */
void surface_resolve(struct fish *fish, const struct surroundings *around);

/* Whether its mouth is in the film. */
int surface_breathes(const struct fish *fish);

/* Where it is in a gulp, from one opening of its mouth to the next: (0, 1]. 0 while its mouth is
 * not in the film. */
float surface_gulp(const struct fish *fish, uint32_t tick);

/* How far its mouth is open now, [0, 1]. */
float surface_gape(const struct fish *fish, uint32_t tick);

/* Whether a gulp began in the `dt_s` before `tick`: it rings the water. */
int surface_gulps(const struct fish *fish, uint32_t tick, float dt_s);

/* Frightened with its snout in the air it must get under first: sends it down, in haste, and
 * returns 1; 0 when there is nothing to wait for. */
int surface_ducks(struct fish *fish);

/* What it takes to frighten it, as a share of what it takes below: gulpers notice late. */
float surface_nerve(const struct fish *fish);

#endif
