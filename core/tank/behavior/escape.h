/* escape.h -- the C-start: a fish bends into a C, flips back with a thrust, and dashes off.
 *
 * Stage 1, about 20 ms: the head turns 60 to 120 degrees, mostly away from the startling stimulus,
 * while the body hardly moves. Stage 2, the same time: the tail flips back, and the body turns to
 * its final course. The body accelerates forward at 15 to 40 m/s^2 up to 8 to 10 lengths per
 * second. A dash follows and decays within a second (Eaton et al. 1977; Mirjany et al. 2011). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_ESCAPE_H
#define KINGYO_CORE_TANK_BEHAVIOR_ESCAPE_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

enum escape_stage {
    ESCAPE_NONE = 0, /* The gait is not GAIT_ESCAPE. */
    ESCAPE_BEND,     /* Stage 1. */
    ESCAPE_FLIP,     /* Stage 2. */
    ESCAPE_DASH,
};

enum escape_stage escape_stage(const struct fish *fish);

/* Returns 1 while turn and bend follow the path of the start: both stages and the recoil. */
int escape_on_path(const struct fish *fish);

/* Returns the duration of stage 1 and of stage 2 for a fish of this length, s. The duration is
 * 20 ms at 5 cm, in proportion to the square root of the length, rounded to ticks (16.7 ms; 25 ms
 * from 5.5 cm). */
float escape_stage_s(float length_m);

/* Begins a C-start away from a stimulus at `from_m`. Side, angle and course are drawn. Near a wall
 * more fish turn toward the stimulus, because the way out is blocked. */
void escape_start(struct fish *fish, vec3 from_m, uint32_t index, const struct perception *around);

/* Starts a dash along the nose without a C-bend, for a fish that was thrown or fell into the
 * water. */
void escape_dash(struct fish *fish, uint32_t index, const struct perception *around);

/* Advances an escape by one tick, before the move: sets heading, bend and speed goals. */
void escape_tick(struct fish *fish, const struct perception *around);

/* Returns the speed along the nose that the escape demands, m/s. */
float escape_speed_m_s(const struct fish *fish);

/* Returns 1 while the tail drives the fish. */
int escape_beats(const struct fish *fish);

#endif
