/* swim.h -- how a fish moves: turns at a bounded rate, beats and glides, holds its depth. */
#ifndef KINGYO_CORE_TANK_SWIM_H
#define KINGYO_CORE_TANK_SWIM_H

#include "core/tank/fish.h"

/* Gives the heading a slow, smooth wander of its own; drawn from (seed, tick, fish). */
void swim_wander(struct fish *fish, uint32_t seed, uint32_t tick, uint32_t index);

/* Bends the heading away from a surface that faces it: `normal` (unit, horizontal) points into the
 * surface, `gap_m` is from the fish's centre to it. */
void swim_shun(struct fish *fish, vec3 normal, float gap_m);

/* Walls of a tank of `size_m`. */
void swim_shun_walls(struct fish *fish, vec3 size_m);

/* Turns, speeds up or glides, climbs, and moves one tick. `speed_goal_m_s` is what the gait asks. */
void swim_move(struct fish *fish, float speed_goal_m_s, float run_up_s);

/* A fish out of the water (dropped from a poi): falls, and gets away once it is in. Returns whether
 * it was in the air. */
int swim_fall(struct fish *fish);

/* After pushes: true velocity from the true move, then tail and body follow it. `beats` is 0 while
 * it glides. */
void swim_settle(struct fish *fish, vec3 moved_m, int beats);

#endif
