/* gait.h -- the choice of gait (burst, swim or rest), the duration of a gait and its cost in
 * stamina.
 *
 * The functions implement sections 2.1, 3.2, 3.3 and 3.6 of the 2013 thesis, in which stamina H is
 * 0 to 100. The rules below were chosen where the thesis contradicts itself or gives no value.
 *
 * - Eqs. 3.1 to 3.3 and the speed s = d (0.8 + H / 5) are correct only with H / 100 instead of H.
 * At H = 90, eq. 3.2 gives -3.5, and a rested fish would swim at 20.8 d. Costs and bands of stamina
 * are of 100, as printed. In this code, stamina h = H / 100 is always in [0, 1].
 *
 * - Eq. 3.2 leaves a probability of 0.1 for swimming at H = 0, but the text excludes swimming at H
 * = 0. The code follows the text.
 *
 * - Eq. 2.3 gives no base of the logarithm and no unit. log10 of the length in centimetres gives
 * the printed 0.163 s (0.1639, truncated).
 *
 * - Section 2.1 gives the end of the run-up, 95 % of the speed, but not its shape. The code uses v
 * = v_t (1 - exp(-3 t / T_d)), because exp(-3) is 0.05. Section 3.3 uses the same time for
 * swimming.
 *
 * - Section 3.3 changes the heading with the gait but gives no amount. struct behavior_params holds
 * the amount.
 *
 * - Section 3.6 gives depths in 20 cm of water. In the code the depths are shares of the water
 * depth. In section 3.6 a fish reaches its depth by pitching, but a tired fish rests nine tenths of
 * its time. In the code a fish therefore climbs and dives in every gait (swim.h). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_GAIT_H
#define KINGYO_CORE_TANK_BEHAVIOR_GAIT_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

/* Probabilities of the next gait at a given stamina; their sum is 1. */
struct gait_chance {
    float burst, swim, rest;
};

struct gait_chance gait_chance(float stamina);

/* Returns the share of time in each gait at a constant stamina: the probabilities weighted by the
 * mean durations. */
struct gait_chance gait_shares(float stamina);

/* Enters a gait and chooses its duration, a new heading around the old heading, and a new depth
 * offset at random. `index` is the index of the fish, which is a part of the random key. */
void gait_enter(struct fish *fish, enum fish_gait gait, uint32_t index,
                const struct perception *around);

/* Advances the gait of the fish `index` by `around->dt_s`: changes the stamina, chooses the next
 * gait at the end of the current gait, and sets the depth goal. */
void gait_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the speed goal along the fish's forward axis, m/s. The speed depends on gait, stamina,
 * length and the phase of beat and glide. */
float gait_speed_m_s(const struct fish *fish, const struct perception *around);

/* Returns the time constant of the run-up for a fish of this length, s. A fish reaches 95 % of its
 * speed after the time T_d of the 2013 thesis (eq. 2.3), three time constants. */
float gait_run_up_s(float length_m);

/* Returns the largest speed of a swimming fish including all pushes, m/s: the top speed of the 2013
 * thesis, 7.5 cm/s for a rested fish of 5 cm (section 3.3). */
float gait_speed_max_m_s(const struct fish *fish, const struct behavior_params *params);

/* Returns 1 if the tail drives the fish, 0 if the fish glides or rests. */
int gait_beats(const struct fish *fish, const struct perception *around);

/* Returns the preferred y coordinate for a stamina, < 0. Fish with much stamina stay near the floor
 * (section 3.6). The depth is a share of `water_depth_m`. */
float gait_depth_m(float stamina, float water_depth_m);

#endif
