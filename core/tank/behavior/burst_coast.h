/* burst_coast.h -- burst and coast: a cruising fish kicks, turns during the kick, and glides.
 *
 * Koi and goldfish beat their tail for about one beat and then coast. A straight body has a quarter
 * of the drag of a waving body: 0.060 against 0.242 (Wu et al. 2007, koi), which saves nearly half
 * of the energy. They turn during the kick, not during the glide. The first stage of a kick lasts
 * about equally long for every angle, so the turning rate sets the angle (Wu et al. 2007, turns of
 * koi). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_BURST_COAST_H
#define KINGYO_CORE_TANK_BEHAVIOR_BURST_COAST_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

#define BURST_COAST_KICK_HASTE 6.0f /* A turn is 90 % complete after 0.16 s at any angle. */

/* Returns 1 if the tail drives the fish in this tick of its own rhythm, which is 0.7 to 1.2 s
 * long. */
int burst_coast_beats(const struct fish *fish, uint32_t tick);

/* Returns 1 at the beginning of a beat, during the turn of the kick. */
int burst_coast_kicks(const struct fish *fish, uint32_t tick);

/* Turns the course of a swimming fish once per kick by a random angle with the standard deviation
 * `kick_rad` of the behavior parameters. */
void burst_coast_turn(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the speed goal during a beat as a multiple of the mean speed over beat and glide;
 * `mean_m_s` > 0. */
float burst_coast_share(const struct fish *fish, float mean_m_s);

/* Returns the distance of a glide while the speed falls to 1 / e, m: 2 m / (rho S C), with the
 * added mass of the water, the wetted surface S and C = 0.060. The distance is 1.3 lengths. */
float burst_coast_glide_m(float length_m);

#endif
