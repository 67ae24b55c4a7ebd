/* gait.h -- the choice of gait (burst, swim or rest), its duration and its cost in stamina.
 *
 * Implements sections 2.1, 3.2, 3.3 and 3.6 of the 2013 thesis, in which stamina H runs from 0 to
 * 100. The following rules were chosen where the thesis contradicts itself:
 *
 * - Eqs. 3.1 to 3.3 and the speed s = d (0.8 + H / 5) hold only for H / 100. At H = 90 eq. 3.2
 * gives -3.5, and a rested fish would swim at 20.8 d. Costs and bands are of 100, as printed. In
 * this code stamina h = H / 100 is always in [0, 1].
 *
 * - Eq. 3.2 leaves 0.1 for swimming at H = 0, but the text excludes swimming there. The code
 * follows the text.
 *
 * - Eq. 2.3 gives no base of the logarithm and no unit. With log10 of centimetres it gives the
 * printed 0.163 s (0.1639, truncated).
 *
 * - Section 2.1 gives the end of the run-up, 95 %, but not its shape. The code uses v = v_t (1 -
 * exp(-3 t / T_d)), since exp(-3) is 0.05. Section 3.3 uses the same time for swimming.
 *
 * - Section 3.3 changes the heading with the gait but not by how much; struct behavior_params gives
 * the amount.
 *
 * - Section 3.6 counts depths in 20 cm of water; in the code they are shares of any depth. The
 * section lets a fish reach its depth by pitching, but a tired fish rests nine tenths of its time.
 * In the code climbing therefore needs no gait (swim.h). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_GAIT_H
#define KINGYO_CORE_TANK_BEHAVIOR_GAIT_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

/* Chances of the next gait at stamina h, with the sum 1. */
struct gait_chance {
    float burst, swim, rest;
};

struct gait_chance gait_chance(float stamina);

/* Returns the share of time spent in each gait at a constant stamina: the chances times the mean
 * durations. */
struct gait_chance gait_shares(float stamina);

/* Enters a gait: draws its duration, a new heading around the old one, and a new depth offset.
 * `index` is that of the fish and the key of its draws, also in the functions below. */
void gait_enter(struct fish *fish, enum fish_gait gait, uint32_t index,
                const struct perception *around);

/* Advances the gait by `around->dt_s`: charges stamina, chooses the next gait when the time is up,
 * and sets the depth goal for the stamina. */
void gait_tick(struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the speed along the nose that the gait demands, m/s, by gait, stamina, length and phase
 * of beat and glide. */
float gait_speed_m_s(const struct fish *fish, const struct perception *around);

/* Returns the time constant of the run-up: 95 % of the speed is reached after the thesis' T_d (eq.
 * 2.3). */
float gait_run_up_s(float length_m);

/* Returns the largest sum of the fish's speed and all pushes while it swims: the thesis' top speed,
 * 7.5 cm/s for a rested 5 cm fish (section 3.3). */
float gait_speed_max_m_s(const struct fish *fish, const struct behavior_params *params);

/* Returns 1 if the tail drives the fish, 0 if it glides. Koi and goldfish beat and coast in
 * turn. */
int gait_beats(const struct fish *fish, const struct perception *around);

/* Returns the preferred y for a stamina, < 0: lively fish stay low (section 3.6). Bands are
 * fractions of the depth. */
float gait_depth_m(float stamina, float water_depth_m);

#endif
