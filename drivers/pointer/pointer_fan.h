/* pointer_fan.h -- turns pointer reports into the position of a fan (uchiwa).
 *
 * While POINTER_FAN is pressed, the fan is over the water under the pointer. The fan enters from
 * the player's side and leaves in the same direction along a smooth path, so that it never appears
 * or jumps suddenly. Pure: uses no device, clock or library. */
#ifndef KINGYO_DRIVERS_POINTER_POINTER_FAN_H
#define KINGYO_DRIVERS_POINTER_POINTER_FAN_H

#include "drivers/pointer/pointer_poi.h"

/* Radius of the fan's shadow: the value of the 2013 thesis, and the size of a small uchiwa. */
#define POINTER_FAN_RADIUS_M 0.10f
/* Time in which the fan moves from beyond the tank's near edge to the pointer, or back. */
#define POINTER_FAN_SWING_S 0.40f

struct pointer_fan {
    struct view view;
    float ndc_x, ndc_y, aspect; /* Pointer position (-1 to 1 across the window) and aspect ratio of
                                   the window at the last report that had POINTER_FAN pressed. */
    uint8_t held;
    float swing;      /* Progress of the fan's entry: 0 means that the fan is out of sight, 1 means
                         that it is under the pointer. */
    uint64_t time_ns; /* Time for which `swing` was computed last. */
};

/* Initializes a fan that is out of sight. `view` is copied. */
void pointer_fan_init(struct pointer_fan *fan, const struct view *view);

/* Processes one report. Returns 1, or 0 if pointer_report_is_usable() rejects the report; the state
 * is then unchanged. */
int pointer_fan_report(struct pointer_fan *fan, const struct pointer_report *report);

/* Returns the fan's shadow on the water at `time_ns`, which must not decrease from call to call.
 * The position is finite. */
struct shade_input pointer_fan_shade(struct pointer_fan *fan, uint64_t time_ns);

#endif
