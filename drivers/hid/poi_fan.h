/* poi_fan.h -- the fan of Kingyo's poi controller, a tracked controller (poi_report.h).
 *
 * While the FAN key is pressed, the controller moves the fan over the water, and the poi (the paper
 * scoop) stands still. Pure: uses no device and no clock. */
#ifndef KINGYO_DRIVERS_HID_POI_FAN_H
#define KINGYO_DRIVERS_HID_POI_FAN_H

#include <stdint.h>

#include "platform/hal.h"

/* Time in which the poi returns to the controller's position after FAN is released. */
#define POI_FAN_BACK_S 0.5f

struct poi_fan {
    struct poi_target hand;  /* Newest pose of the controller. */
    struct poi_target waits; /* Pose at which the poi stands still, or from which it returns to the
                                controller. */
    uint8_t held;            /* 1 while the FAN key is pressed, otherwise 0. */
    float swing;             /* Progress of the fan's entry: 0 means that the fan is out of sight, 1
                                means that it is at the controller's position. */
    float back;              /* Progress of the poi's return: 0 means that the poi is at `waits`, 1
                                means that it is at the controller's position. */
    uint64_t time_ns;        /* Time for which `swing` and `back` were computed last. */
};

/* Initializes the state with the poi at the controller's position. */
void poi_fan_init(struct poi_fan *fan);

/* Sets the controller's pose `hand` at `time_ns`, which must not decrease. `held` is 1 if the FAN
 * key is pressed. */
void poi_fan_move(struct poi_fan *fan, const struct poi_target *hand, int held, uint64_t time_ns);

/* Returns the pose of the poi. */
struct poi_target poi_fan_pose(const struct poi_fan *fan);
/* Returns the shadow of the fan on the water at `time_ns`. */
struct shade_input poi_fan_shade(struct poi_fan *fan, uint64_t time_ns);

#endif
