/* burst_coast.h -- burst and coast: a cruising fish kicks with its tail, turns during the kick, and
 * glides.
 *
 * Koi and goldfish beat their tail for about one beat and then coast. The drag coefficient of a
 * straight body is a quarter of that of a waving body: 0.060 against 0.242 (Wu et al. 2007, koi).
 * Coasting saves nearly half of the energy. The fish turn during the kick, not during the glide.
 * The first stage of a kick lasts about equally long for every angle, so the turning rate
 * determines the angle (Wu et al. 2007, turns of koi). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_BURST_COAST_H
#define KINGYO_CORE_TANK_BEHAVIOR_BURST_COAST_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

/* Value of `haste` in struct fish during a kick. With this value, a turn by any angle is 90 %
 * complete after 0.16 s. */
#define BURST_COAST_KICK_HASTE 6.0f

/* Returns 1 if the tail drives the fish in this tick, 0 if the fish glides. The cycle of beat and
 * glide lasts 0.7 to 1.2 s, depending on the fish. */
int burst_coast_beats(const struct fish *fish, uint32_t tick);

/* Returns 1 during the kick at the beginning of a beat, otherwise 0. The fish turns during the
 * kick. */
int burst_coast_kicks(const struct fish *fish, uint32_t tick);

/* Turns the heading of a swimming fish once per kick by a random angle. The standard deviation of
 * the angle is `kick_rad` of the behavior parameters. */
void burst_coast_turn(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the speed goal during a beat divided by `mean_m_s`, the mean speed over beat and glide.
 * `mean_m_s` must be > 0. */
float burst_coast_share(const struct fish *fish, float mean_m_s);

/* Returns the distance of a glide during which the speed falls to 1 / e, m. The distance is 2 *
 * m / (rho * S * C), which equals 1.3 body lengths. m is the mass of the fish plus the added
 * mass of the water, rho the density of the water, S the wetted surface and C = 0.060 the drag
 * coefficient. */
float burst_coast_glide_m(float length_m);

#endif
