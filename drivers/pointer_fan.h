/* pointer_fan.h -- turns what a pointer reports into where a hand holds a fan (uchiwa).
 *
 * Pure, as pointer_poi.h. While POINTER_FAN is held the fan is over the water under the pointer: it
 * swings in from the player's side and leaves there again, along one smooth path, so that nothing
 * ever jumps over the water that was not there before. */
#ifndef KINGYO_DRIVERS_POINTER_FAN_H
#define KINGYO_DRIVERS_POINTER_FAN_H

#include "drivers/pointer_poi.h"

#define POINTER_FAN_RADIUS_M 0.10f /* The 2013 thesis' shadow, and a small uchiwa's. */
#define POINTER_FAN_SWING_S 0.40f  /* From beyond the near edge to the pointer, or back. */

struct pointer_fan {
    struct view view;
    float ndc_x, ndc_y, aspect; /* The pointer when it last led the fan; as in pointer_poi. */
    uint8_t held;
    float swing;                /* [0, 1]: 0 out of sight, 1 under the pointer ... */
    uint64_t time_ns;           /* ... at this time. */
};

/* A fan out of sight. `view` is copied. */
void pointer_fan_init(struct pointer_fan *fan, const struct view *view);

/* Takes one report; as pointer_poi_report(). */
int pointer_fan_report(struct pointer_fan *fan, const struct pointer_report *report);

/* Where its shadow is on the water at `time_ns`, which never goes back; always finite. */
struct shade_input pointer_fan_shade(struct pointer_fan *fan, uint64_t time_ns);

#endif
