/* sensor_sim.h -- a simulated six-axis sensor with realistic noise and selectable faults.
 *
 * Reports have a fixed rate, and each report contains the pose `pose` plus noise. At most one fault
 * is active at a time, in an interval that the caller sets. The faults are those of cables, radio
 * links and sensors, and not those of the player. The caller owns the state and moves the pose. */
#pragma once

#include "platform/hal.h"

#define SENSOR_SIM_HELD_MAX 64u

enum sensor_fault {
    SENSOR_FINE = 0,
    SENSOR_GONE,   /* The sensor is unplugged: poll() and open() fail. */
    SENSOR_SILENT, /* The sensor is connected, but no reports arrive. */
    /* No reports arrive until the end of the fault. All delayed reports then arrive together. */
    SENSOR_HELD_BACK,
    SENSOR_STUCK,   /* Every report has identical bits. */
    SENSOR_JUMPED,  /* The position is displaced by one meter. */
    SENSOR_FLIPPED, /* The pose is rotated by 180 degrees. */
    /* One field is NaN or infinite. The field changes from report to report. */
    SENSOR_NOT_A_NUMBER,
    SENSOR_GARBAGE, /* All fields have random bits. */
    SENSOR_TWICE,   /* Each report arrives twice. */
    SENSOR_FAULT_COUNT,
};

struct sensor_sim {
    struct hal_clock clock;
    struct poi_target pose; /* True pose, which the caller moves. */
    uint64_t period_ns;     /* Time between two reports. */
    uint8_t fault;          /* The selected fault (enum sensor_fault). */
    /* Start and end of the fault. The fault is active if the time is at least `from_ns` and less
     * than `to_ns`. */
    uint64_t from_ns, to_ns;

    uint64_t next_ns; /* Time of the next report. */
    /* Number of reports so far. The number of a report also selects its noise. */
    uint32_t count;
    uint32_t open_count;    /* Number of open() calls. */
    struct poi_target last; /* Pose of the last report. */
    /* Reports that SENSOR_HELD_BACK delays, oldest first. */
    struct poi_target held[SENSOR_SIM_HELD_MAX];
    uint32_t held_count;
    struct view view;      /* Camera view from set_view(). */
    struct poi_force felt; /* Force feedback that was set last. */
};

/* Initializes a sensor without faults at the middle of the water. The sensor sends `rate_hz` (1 or
 * more) reports per second. */
void sensor_sim_init(struct sensor_sim *sim, struct hal_clock clock, uint32_t rate_hz);

/* Returns the poi device of the simulated sensor. */
struct hal_poi sensor_sim_device(struct sensor_sim *sim);
