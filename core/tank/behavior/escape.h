/* escape.h -- the C-start: a startled fish bends into a C, flips back with a thrust, and dashes
 * away.
 *
 * In stage 1, about 20 ms, the head turns by 60 to 120 degrees, mostly away from the stimulus,
 * while the body hardly moves. In stage 2, equally long, the tail flips back and the body turns to
 * its final course. The body accelerates forward at 15 to 40 m/s^2 up to 8 to 10 lengths per
 * second. A dash follows, which decays within a second (Eaton et al. 1977; Mirjany et al. 2011). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_ESCAPE_H
#define KINGYO_CORE_TANK_BEHAVIOR_ESCAPE_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

enum escape_stage {
    ESCAPE_NONE = 0, /* The gait is not GAIT_ESCAPE. */
    ESCAPE_BEND,     /* Stage 1: the fish bends into a C. */
    ESCAPE_FLIP,     /* Stage 2: the tail flips back. */
    ESCAPE_DASH,
};

enum escape_stage escape_stage(const struct fish *fish);

/* Returns 1 while the C-start determines the turn and the bend of the fish (stage 1, stage 2 and
 * the recoil), otherwise 0. */
int escape_on_path(const struct fish *fish);

/* Returns the duration of stage 1 for a fish of this length, s; stage 2 lasts equally long. The
 * duration is 20 ms at 5 cm and proportional to the square root of the length. The result is
 * rounded to whole ticks: 16.7 ms for a fish of 5 cm, and 25 ms for a fish of 5.5 cm. */
float escape_stage_s(float length_m);

/* Begins a C-start away from a stimulus at `from_m`. The side, the angle of the turn and the final
 * course are random. Near a wall more fish turn toward the stimulus, because the wall blocks the
 * way out. */
void escape_start(struct fish *fish, vec3 from_m, uint32_t index, const struct perception *around);

/* Begins a dash along the fish's forward axis without a C-bend, for a fish that was thrown or fell
 * into the water. */
void escape_dash(struct fish *fish, uint32_t index, const struct perception *around);

/* Advances an escape by `around->dt_s` before the fish moves. Sets the heading, the bend goal and
 * the speed. */
void escape_tick(struct fish *fish, const struct perception *around);

/* Returns the speed goal of an escape along the fish's forward axis, m/s. */
float escape_speed_m_s(const struct fish *fish);

/* Returns 1 while the tail drives an escaping fish, otherwise 0. */
int escape_beats(const struct fish *fish);

#endif
