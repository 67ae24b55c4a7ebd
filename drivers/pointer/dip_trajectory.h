/* dip_trajectory.h -- the trajectory of a ring that dips into the water and comes up again. Pure.
 *
 * For controllers without a vertical axis: a button starts the stroke, and this module computes
 * the height. A new stroke starts from the ring's current height, velocity and acceleration, so
 * it has no jerk. */
#ifndef KINGYO_DRIVERS_POINTER_DIP_TRAJECTORY_H
#define KINGYO_DRIVERS_POINTER_DIP_TRAJECTORY_H

#include <stdint.h>

#include "core/base/fmath.h"

#define DIP_HOVER_M 0.035f    /* Above the water: clear of ripples, close enough to aim. */
#define DIP_DEPTH_M (-0.050f) /* Below the surface: where the fish swim in a tank of 10 .. 20 cm. */
#define DIP_DOWN_S 0.30f
#define DIP_UP_S 0.46f /* Slower than down, because wet paper carries water. */

#define DIP_SLANT_MAX_RAD (28.0f * F_DEG)
#define DIP_SLANT_AT_M_S 0.40f

/* The current stroke: a quintic polynomial from the ring's state at its start. */
struct dip {
    uint64_t start_ns;
    float duration_s; /* Duration of the stroke; 0 before the first one. */
    float from_m, from_m_s, from_m_s2, to_m;
};

struct dip_state {
    float height_m, speed_m_s, acceleration_m_s2;
};

/* Initializes a ring that hovers. */
void dip_init(struct dip *dip);

/* Starts a stroke down or up at `time_ns`. */
void dip_begin(struct dip *dip, uint64_t time_ns, int down);

/* Returns the state at `time_ns`, which must not be before the stroke's start. */
struct dip_state dip_at(const struct dip *dip, uint64_t time_ns);

/* Returns the slant of the ring in radians (>= 0), proportional to its vertical speed. The far
 * edge leads into the water and out of it. The ring also moves away from the player on its way
 * down, so the slanted paper moves more edge-on and displaces less water. A flat poi lasts four
 * dips, a slanted one eight. */
float dip_slant_rad(float speed_m_s);

#endif
