/* sensor_sim.h -- a simulated six-axis sensor with realistic noise and selectable faults.
 *
 * Reports have a fixed rate, and each contains the pose `hand` plus noise. At most one fault is
 * active at a time, in an interval that the caller sets. The faults are those of cables, radios
 * and sensors while the user does nothing wrong. The caller owns the state and moves the pose. */
#ifndef KINGYO_DRIVERS_SIM_SENSOR_SIM_H
#define KINGYO_DRIVERS_SIM_SENSOR_SIM_H

#include "platform/hal.h"

#define SENSOR_SIM_HELD_MAX 64u

enum sensor_fault {
    SENSOR_FINE = 0,
    SENSOR_GONE,         /* Unplugged: poll() and open() fail. */
    SENSOR_SILENT,       /* Connected, but no reports arrive. */
    SENSOR_HELD_BACK,    /* No reports until the end of the fault, then all at once. */
    SENSOR_STUCK,        /* Identical bits in each report. */
    SENSOR_JUMPED,       /* Displaced by one meter. */
    SENSOR_FLIPPED,      /* Rotated by 180 degrees. */
    SENSOR_NOT_A_NUMBER, /* NaN or infinite in one field after another. */
    SENSOR_GARBAGE,      /* Random bits in all fields. */
    SENSOR_TWICE,        /* Each report arrives twice. */
    SENSOR_FAULT_COUNT,
};

struct sensor_sim {
    struct hal_clock clock;
    struct poi_target hand;  /* True pose, which the caller moves. */
    uint64_t period_ns;      /* Time between two reports. */
    uint8_t fault;           /* The selected fault, enum sensor_fault. */
    uint64_t from_ns, to_ns; /* Fault active from the first time until before the second. */

    uint64_t next_ns; /* Time of the next report. */
    uint32_t count;   /* Reports so far; also selects the noise. */
    uint32_t open_count;
    struct poi_target last; /* Pose in the last report. */
    /* Reports that SENSOR_HELD_BACK delays, oldest first. */
    struct poi_target held[SENSOR_SIM_HELD_MAX];
    uint32_t held_count;
    struct view view;      /* Camera view set by look(). */
    struct poi_force felt; /* Force feedback set last. */
};

/* Initializes a sensor without faults at `rate_hz` >= 1 reports a second, at the middle of the
 * water. */
void sensor_sim_init(struct sensor_sim *sim, struct hal_clock clock, uint32_t rate_hz);

struct hal_poi sensor_sim_device(struct sensor_sim *sim);

#endif
