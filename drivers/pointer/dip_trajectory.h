/* dip_trajectory.h -- the trajectory of a ring that dips into the water and comes up again.
 *
 * Used for controllers without a vertical axis: a button starts a stroke (one motion down or up),
 * and this module computes the height. A new stroke starts from the ring's current height, velocity
 * and acceleration, so that the motion is smooth. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_POINTER_DIP_TRAJECTORY_H
#define KINGYO_DRIVERS_POINTER_DIP_TRAJECTORY_H

#include <stdint.h>

#include "core/base/fmath.h"

/* Height of a hovering ring above the still water. The ring is above the ripples and low enough for
 * aiming. */
#define DIP_HOVER_M 0.035f
/* Height of a dipped ring; negative means under water. At this depth the fish swim in a tank that
 * is 10 to 20 cm deep. */
#define DIP_DEPTH_M (-0.050f)
#define DIP_DOWN_S 0.30f
/* Duration of the upward stroke; longer than the downward stroke, because wet paper carries
 * water. */
#define DIP_UP_S 0.46f

#define DIP_SLANT_MAX_RAD (28.0f * F_DEG)
#define DIP_SLANT_AT_M_S 0.40f

/* The current stroke: a quintic polynomial that starts from the ring's state at `start_ns`. */
struct dip {
    uint64_t start_ns;
    float duration_s; /* Duration of the stroke; 0 means that no stroke was started yet. */
    float from_m, from_m_s, from_m_s2, to_m;
};

struct dip_state {
    float height_m, speed_m_s, acceleration_m_s2;
};

/* Initializes a hovering ring. */
void dip_init(struct dip *dip);

/* Starts a stroke at `time_ns`: downward if `down` is 1, upward if it is 0. */
void dip_begin(struct dip *dip, uint64_t time_ns, int down);

/* Returns the state of the ring at `time_ns`. If `time_ns` is before the start of the stroke,
 * returns the state at the start. */
struct dip_state dip_at(const struct dip *dip, uint64_t time_ns);

/* Returns the slant of the ring in radians (0 or more), proportional to its vertical speed up to a
 * limit. The far edge enters and leaves the water first. The ring also moves away from the player
 * on its way down, so that the slanted paper moves more edge-on and displaces less water. The paper
 * lasts four dips with a flat ring and eight dips with a slanted ring. */
float dip_slant_rad(float speed_m_s);

#endif
