/* poi_fan.h -- the fan of our own poi. Pure.
 *
 * While the FAN key is down, the tracked controller moves the fan over the water, and the poi
 * waits in place. */
#ifndef KINGYO_DRIVERS_HID_POI_FAN_H
#define KINGYO_DRIVERS_HID_POI_FAN_H

#include <stdint.h>

#include "platform/hal.h"

#define POI_FAN_BACK_S 0.5f /* Time of the poi's return to the controller. */

struct poi_fan {
    struct poi_target hand;  /* Newest pose of the controller. */
    struct poi_target waits; /* Pose at which the poi waits, or from which it returns. */
    uint8_t held;
    float swing;      /* [0, 1]: 0 out of sight, 1 at the controller's position. */
    float back;       /* [0, 1]: 1 when the poi has returned to the controller. */
    uint64_t time_ns; /* Time to which `swing` and `back` were computed. */
};

/* Initializes the state with the poi at the controller. */
void poi_fan_init(struct poi_fan *fan);

/* Sets the controller's pose, and whether FAN is held, at `time_ns`, which must never decrease. */
void poi_fan_move(struct poi_fan *fan, const struct poi_target *hand, int held, uint64_t time_ns);

/* Return the pose of the poi, and the shadow of the fan. */
struct poi_target poi_fan_pose(const struct poi_fan *fan);
struct shade_input poi_fan_shade(struct poi_fan *fan, uint64_t time_ns);

#endif
