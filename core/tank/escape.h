/* escape.h -- the C-start: a fish bends into a C, flips back with a thrust, and dashes off.
 *
 * Stage 1, about 20 ms: the head turns 60 to 120 degrees, mostly away from what startled it, while
 * the body hardly moves from its place. Stage 2, as long again: the tail flips back, the body turns
 * on to its final course and is thrown forward at 15 to 40 m/s^2, up to 8 to 10 lengths a second.
 * Then a dash that decays, over within a second (Eaton et al. 1977; Mirjany et al. 2011). */
#ifndef KINGYO_CORE_TANK_ESCAPE_H
#define KINGYO_CORE_TANK_ESCAPE_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

enum escape_stage {
    ESCAPE_NONE = 0, /* Not in GAIT_ESCAPE. */
    ESCAPE_BEND,     /* Stage 1. */
    ESCAPE_FLIP,     /* Stage 2. */
    ESCAPE_DASH,
};

enum escape_stage escape_stage(const struct fish *fish);

/* Whether turn and bend still follow the start's path, to the tick: both stages and the recoil. */
int escape_on_path(const struct fish *fish);

/* How long each of the stages 1 and 2 takes a fish of this length: 20 ms at 5 cm, more by the root
 * of the length, rounded to ticks (16.7 ms; 25 ms from 5.5 cm). */
float escape_stage_s(float length_m);

/* Begins a C-start from what is at `from_m`. Side, angle and course are drawn; near walls more fish
 * turn toward it, because away is barred. */
void escape_start(struct fish *fish, vec3 from_m, uint32_t index,
                  const struct surroundings *around);

/* One that was thrown or fell into the water: no C, it dashes off along its nose. */
void escape_dash(struct fish *fish, uint32_t index, const struct surroundings *around);

/* Each tick of an escape, before the move: gives the move its orders (heading, bend, speed). */
void escape_tick(struct fish *fish, const struct surroundings *around);

/* Speed along the nose that the escape asks for, m/s. */
float escape_speed_m_s(const struct fish *fish);

/* Whether its tail drives it on. */
int escape_beats(const struct fish *fish);

#endif
