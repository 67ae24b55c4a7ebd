/* pointer_fan.h -- turns pointer reports into the position of a fan (uchiwa).
 *
 * Pure, like pointer_poi.h. While POINTER_FAN is held, the fan is over the water under the
 * pointer. The fan enters from the player's side and leaves the same way along a smooth path, so
 * that it never appears or jumps suddenly. */
#ifndef KINGYO_DRIVERS_POINTER_POINTER_FAN_H
#define KINGYO_DRIVERS_POINTER_POINTER_FAN_H

#include "drivers/pointer/pointer_poi.h"

/* Size of the shadow in the 2013 thesis, and of a small uchiwa. */
#define POINTER_FAN_RADIUS_M 0.10f
#define POINTER_FAN_SWING_S 0.40f /* Time from beyond the near edge to the pointer, or back. */

struct pointer_fan {
    struct view view;
    float ndc_x, ndc_y, aspect; /* Pointer position at the last fan report, like in pointer_poi. */
    uint8_t held;
    float swing;      /* [0, 1]: 0 out of sight, 1 under the pointer. */
    uint64_t time_ns; /* Time to which `swing` was computed. */
};

/* Initializes a fan that is out of sight. `view` is copied. */
void pointer_fan_init(struct pointer_fan *fan, const struct view *view);

/* Processes one report. Returns 0 if the report is not usable, as pointer_poi_report(). */
int pointer_fan_report(struct pointer_fan *fan, const struct pointer_report *report);

/* Returns the fan's shadow on the water at `time_ns`, which must never decrease. The position is
 * always finite. */
struct shade_input pointer_fan_shade(struct pointer_fan *fan, uint64_t time_ns);

#endif
