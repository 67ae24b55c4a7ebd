/* touch_sim.h -- a simulated touch screen: plays raw finger events through the real decoder.
 *
 * Faults are injected below the decoder: unplugging at any event, doubled events, lost lift
 * events, jumps, random positions, and silence followed by a burst. The caller owns the state
 * and the events. */
#ifndef KINGYO_DRIVERS_SIM_TOUCH_SIM_H
#define KINGYO_DRIVERS_SIM_TOUCH_SIM_H

#include "drivers/pointer/touch_fingers.h"
#include "platform/hal.h"

#define TOUCH_SIM_NEVER UINT32_MAX

struct touch_sim {
    struct hal_clock clock;
    const struct touch_event *events; /* Events sorted by time; must outlive the device. */
    uint32_t event_count;
    uint32_t next; /* Index of the next event to play. */
    /* Index of the event before which the screen is unplugged, or TOUCH_SIM_NEVER. */
    uint32_t unplug_at;
    uint64_t replug_ns;            /* Time from which open() finds the screen again. */
    uint32_t double_every;         /* Every n-th event arrives twice; 0: none. */
    uint32_t mute_every;           /* Every n-th event is lost if it is a lift; 0: none. */
    uint32_t jump_at;              /* Index of the event at the far corner, or TOUCH_SIM_NEVER. */
    uint32_t spoil_from, spoil_to; /* Range of events with random bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Events of this time arrive together at its end. */
    uint8_t gone;
    uint32_t open_count;
    struct touch_fingers fingers;
    struct pointer_report report;
    struct pointer_poi pointer;
};

/* Initializes a window of `width` x `height` pixels without events and faults. */
void touch_sim_init(struct touch_sim *sim, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height);

struct hal_poi touch_sim_device(struct touch_sim *sim);

#endif
