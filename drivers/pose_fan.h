/* pose_fan.h -- our own poi as a fan: while its FAN key is down, the hand that it tracks holds the
 * fan over the water, and the poi waits where it was. Pure. */
#ifndef KINGYO_DRIVERS_POSE_FAN_H
#define KINGYO_DRIVERS_POSE_FAN_H

#include <stdint.h>

#include "platform/hal.h"

#define POSE_FAN_BACK_S 0.5f /* From where the poi waited to where the hand is by then. */

struct pose_fan {
    struct poi_target hand;   /* Newest of the tracked hand. */
    struct poi_target waits;  /* Where the poi waits, or set off from. */
    uint8_t held;
    float swing;              /* [0, 1]: 0 out of sight, 1 where the hand is ... */
    float back;               /* [0, 1]: 1 once the poi is back in the hand ... */
    uint64_t time_ns;         /* ... at this time. */
};

/* A hand that holds its poi. */
void pose_fan_init(struct pose_fan *fan);

/* The hand is at `hand` by now, and holds the fan or not; time never goes back. */
void pose_fan_move(struct pose_fan *fan, const struct poi_target *hand, int held, uint64_t time_ns);

/* Where the poi is, and where the fan's shadow. */
struct poi_target pose_fan_poi(const struct pose_fan *fan);
struct shade_input pose_fan_shade(struct pose_fan *fan, uint64_t time_ns);

#endif
