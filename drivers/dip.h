/* dip.h -- lets a ring down into the water and brings it up again along one smooth stroke. Pure.
 *
 * For hands without an axis of height: a button says when, this says how. Whatever the ring does
 * when the button changes, it goes on from there without a jerk. */
#ifndef KINGYO_DRIVERS_DIP_H
#define KINGYO_DRIVERS_DIP_H

#include <stdint.h>

#include "core/base/fmath.h"

#define DIP_HOVER_M 0.035f    /* Over the water: clear of ripples, near enough to aim. */
#define DIP_DEPTH_M (-0.050f) /* Under it: where the fish of a 10 .. 20 cm tank cruise. */
#define DIP_DOWN_S 0.30f
#define DIP_UP_S 0.46f        /* Slower than down: a wet sheet carries the pool on it. */

#define DIP_SLANT_MAX_RAD (28.0f * F_DEG)
#define DIP_SLANT_AT_M_S 0.40f

/* The present stroke: a quintic from where the ring was when the button changed. */
struct dip {
    uint64_t start_ns;
    float duration_s; /* 0 before the first. */
    float from_m, from_m_s, from_m_s2, to_m;
};

struct dip_state {
    float height_m, speed_m_s, acceleration_m_s2;
};

/* A ring that hovers. */
void dip_init(struct dip *dip);

/* From `time_ns` on it goes down, or up. */
void dip_begin(struct dip *dip, uint64_t time_ns, int down);

/* At a time that is not before the stroke's start. */
struct dip_state dip_at(const struct dip *dip, uint64_t time_ns);

/* The far edge leads into the water and out of it, in proportion to the ring's speed. A hand also
 * runs away from the player as it goes down, so this turns the paper toward its own course, and
 * less water is pushed by it: what a practised hand does. A poi that goes in flat lasts four dips;
 * with this, eight. Radians >= 0. */
float dip_slant_rad(float speed_m_s);

#endif
