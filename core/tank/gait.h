/* gait.h -- burst, swim or rest: what a fish does next, for how long, and what it costs.
 *
 * The 2013 thesis, sections 2.1, 3.2, 3.3 and 3.6, where stamina H runs from 0 to 100. Where it is
 * at odds with itself:
 * - Eqs. 3.1 to 3.3 and the speed s = d (0.8 + H / 5) hold only for H / 100: at H = 90 eq. 3.2
 *   gives -3.5, and a rested fish would swim at 20.8 d. Costs and bands are of 100, as printed.
 *   Here stamina h = H / 100 lies in [0, 1] throughout.
 * - Eq. 3.2 leaves 0.1 for swimming at H = 0, the text says that it is not chosen then: the text.
 * - Eq. 2.3 has no base of the logarithm and no unit: decadic, of centimetres, it gives the 0.163 s
 *   that is printed (0.1639, cut).
 * - 2.1 says what the run-up leads to, 95 %, and not how: v = v_t (1 - exp(-3 t / T_d)), since
 *   exp(-3) is 0.05. 3.3 uses the same time for swimming.
 * - 3.3 changes the heading with the gait and does not say by how much: struct law does.
 * - 3.6 counts depths in 20 cm of water: they are shares of any depth. It lets a fish get there by
 *   pitching, but a tired one rests nine tenths of its time: climbing needs no gait (swim.h). */
#ifndef KINGYO_CORE_TANK_GAIT_H
#define KINGYO_CORE_TANK_GAIT_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

/* Chances of the next gait at stamina h; they sum to 1. */
struct gait_chance {
    float burst, swim, rest;
};

struct gait_chance gait_chance(float stamina);

/* Shares of its time that it spends so, at a stamina that stays: chances times mean durations. */
struct gait_chance gait_shares(float stamina);

/* Enters a gait: its duration, a new heading about the old one, a new stray from its depth. `index`
 * is the fish's, here and below: what it draws its numbers by. */
void gait_enter(struct fish *fish, enum fish_gait gait, uint32_t index,
                const struct surroundings *around);

/* `around->dt_s` later: pays stamina, chooses anew when the time is up, and wants the depth of its
 * stamina. */
void gait_tick(struct fish *fish, uint32_t index, const struct surroundings *around);

/* Speed along the nose that the gait asks for now, m/s: by gait, stamina, length, and where in the
 * cycle of beats and glide the fish is. */
float gait_speed_m_s(const struct fish *fish, const struct surroundings *around);

/* Time constant of the run-up: 95 % of the speed is there after the thesis' T_d (eq. 2.3). */
float gait_run_up_s(float length_m);

/* The most that its speed and all that pushes it along may come to while it swims: the thesis' top
 * speed, 7.5 cm/s of a rested 5 cm fish (section 3.3). */
float gait_speed_max_m_s(const struct fish *fish, const struct law *law);

/* Whether its tail drives (else it glides): koi and goldfish beat and coast in turn. */
int gait_beats(const struct fish *fish, const struct surroundings *around);

/* Wanted y for a stamina, < 0: lively fish keep low (section 3.6). Bands are fractions of the
 * depth. */
float gait_depth_m(float stamina, float water_depth_m);

#endif
