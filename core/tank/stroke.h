/* stroke.h -- beat and coast: how a cruising fish kicks, turns as it kicks, and glides.
 *
 * Koi and goldfish beat their tail for about a beat and then coast, for a straight body has a
 * quarter of the drag of one that waves: 0.060 against 0.242 (Wu et al. 2007, koi), which saves
 * nearly half. They turn with the kick, not in the glide: its first stage lasts about as long for
 * every angle, so the angle is set by the rate of turning (Wu et al. 2007, turns of koi).
 */
#ifndef KINGYO_CORE_TANK_STROKE_H
#define KINGYO_CORE_TANK_STROKE_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

#define STROKE_KICK_HASTE 6.0f /* A turn is 90 % done after 0.16 s, whatever its angle. */

/* Whether its tail drives it in this tick of its own rhythm, 0.7 to 1.2 s long. */
int stroke_beats(const struct fish *fish, uint32_t tick);

/* Whether it has just begun to beat: the time of a kick's turn. */
int stroke_kicks(const struct fish *fish, uint32_t tick);

/* Turns the course of a fish that swims, once a kick, by what it draws; a bell of the law's
 * `kick_rad`. */
void stroke_turn(struct fish *fish, uint32_t index, const struct surroundings *around);

/* What it beats up to, as a multiple of the speed that it keeps in the mean over beats and glides;
 * `mean_m_s` > 0. */
float stroke_share(const struct fish *fish, float mean_m_s);

/* How far it glides while its speed falls to 1 / e, m: 2 m / (rho S C), with the added mass of its
 * water, the wetted surface S and C = 0.060: 1.3 lengths. */
float stroke_glide_m(float length_m);

#endif
