/* gait.h -- chooses the gait of a fish, its duration and its cost in stamina, and computes the
 * rhythm of tail beats and glides.
 *
 * A gait is a way of swimming that lasts for seconds: burst (fast), swim, or rest. Within the gait
 * "swim" a fish alternates between tail beats and glides, which biologists call burst-and-coast
 * swimming. This rhythm has nothing to do with the gait "burst".
 *
 * In burst-and-coast swimming a fish kicks with its tail, turns during the kick, and glides. Koi
 * and goldfish beat their tail for about one beat and then glide. The drag coefficient of a
 * straight body is a quarter of that of a waving body: 0.060 against 0.242 (Wu et al. 2007, koi).
 * Gliding saves nearly half of the energy.
 *
 * The fish turn during the kick, not during the glide. The first stage of a kick lasts about
 * equally long for every angle, so the turning rate determines the angle (Wu et al. 2007, turns of
 * koi).
 *
 * The functions implement sections 2.1, 3.2, 3.3 and 3.6 of the 2013 thesis on goldfish behavior,
 * in which stamina H is 0 to 100. All section and equation numbers are those of the 2013 thesis.
 * The rules below were chosen where the thesis contradicts itself or gives no value.
 *
 * - Eqs. 3.1 to 3.3 give the probability of each gait, and s = d * (0.8 + H / 5) gives the speed s,
 *   where d is one body length per second. Both are wrong unless H / 100 replaces H. With H = 90,
 *   eq. 3.2 gives the probability -3.5, and with H = 100 the speed is 20.8 * d. The code uses
 *   stamina h = H / 100, which is always in [0, 1]. The costs and ranges of stamina in the thesis
 *   refer to 0 to 100.
 *
 * - Eq. 3.2 leaves a probability of 0.1 for swimming at H = 0, but the text excludes swimming at H
 *   = 0. The code follows the text.
 *
 * - Eq. 2.3 gives no base of the logarithm and no unit. log10 of the length in centimetres gives
 *   the printed 0.163 s (0.1639, truncated).
 *
 * - In section 2.1 a fish reaches 95 % of the final speed v_t at the end of the run-up
 *   (acceleration), after the time T_d. The section does not give the speed v during the run-up.
 *   The code uses v = v_t * (1 - exp(-3 * t / T_d)) at time t, because exp(-3) is 0.05. Section 3.3
 *   uses the same time T_d for swimming.
 *
 * - Section 3.3 changes the heading with the gait but gives no angle. struct behavior_params holds
 *   the standard deviation of the angle.
 *
 * - Section 3.6 gives depths in 20 cm of water. In the code the depths are fractions of the water
 *   depth. In section 3.6 a fish reaches its depth by pitching, but a tired fish rests nine tenths
 *   of its time. In the code a fish therefore climbs and dives in every gait (swim.h). */
#pragma once

#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

/* Probabilities of the next gait at a given stamina; their sum is 1. */
struct gait_chance {
    float burst, swim, rest;
};

struct gait_chance gait_chance(float stamina);

/* Returns the fraction of time that a fish of constant stamina spends in each gait. The fractions
 * are the probabilities of the gaits, weighted by their mean durations. */
struct gait_chance gait_shares(float stamina);

/* Enters a gait and chooses its duration, a new heading around the old heading, and a new depth
 * offset at random. `index` is the index of the fish, which is a part of the random key. */
void gait_enter(struct fish *fish, enum fish_gait gait, uint32_t index,
                const struct perception *around);

/* Advances the gait of the fish `index` by `around->dt_s`: changes the stamina, chooses the next
 * gait at the end of the current gait, and sets the depth goal. */
void gait_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the speed goal along the fish's forward axis, m/s. The speed depends on the gait, the
 * stamina and the length, and on whether the fish beats its tail or glides. */
float gait_speed_m_s(const struct fish *fish, const struct perception *around);

/* Returns the time constant, s, with which a fish of this length accelerates to a higher speed.
 * After three time constants the fish has reached 95 % of that speed. Three time constants equal
 * the time T_d in eq. 2.3 of the 2013 thesis. */
float gait_run_up_s(float length_m);

/* Returns the largest speed of a swimming fish, m/s. The limit includes the velocity that other
 * fish and the flow of the water add. The result is the top speed in section 3.3 of the 2013
 * thesis, 7.5 cm/s for a rested fish of 5 cm. */
float gait_speed_max_m_s(const struct fish *fish, const struct behavior_params *params);

/* Returns true if the tail drives the fish, false if the fish glides or rests. */
bool gait_beats(const struct fish *fish, const struct perception *around);

/* Returns the depth that a fish with this stamina prefers, as a y coordinate < 0, m. Fish with much
 * stamina stay near the floor (2013 thesis, section 3.6). The depth is a fraction of
 * `water_depth_m`. */
float gait_depth_m(float stamina, float water_depth_m);

/* Factor by which a fish turns faster than normal during a kick, the turn at the beginning of a
 * tail beat (`haste` in fish.h). With this factor, a turn by any angle is 90 % complete after 0.16
 * s. */
#define GAIT_KICK_HASTE 6.0f

/* Returns true if the tail drives the fish in this tick, false if the fish glides. The cycle of
 * beat and glide lasts 0.7 to 1.2 s, depending on the fish. */
bool gait_cycle_beats(const struct fish *fish, uint32_t tick);

/* Returns true while the fish kicks. A kick is the first part of a tail beat, in which the fish
 * turns. */
bool gait_cycle_kicks(const struct fish *fish, uint32_t tick);

/* Turns the heading of a swimming fish once per kick by a random angle. The standard deviation of
 * the angle is `kick_rad` of the behavior parameters. */
void gait_cycle_turn(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the speed goal of a fish during its tail beats, divided by its mean speed `mean_m_s` > 0.
 * The result is above 1, because the fish slows down in the glides between the tail beats. */
float gait_cycle_share(const struct fish *fish, float mean_m_s);

/* Returns the distance of a glide during which the speed falls to 1 / e, m. The distance is 2 *
 * m / (rho * S * C), which equals 1.3 body lengths. m is the mass of the fish plus the added
 * mass of the water, rho the density of the water, S the wetted surface and C = 0.060 the drag
 * coefficient. */
float gait_glide_m(float length_m);
