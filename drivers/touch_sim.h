/* touch_sim.h -- a touch screen made of memory: plays raw finger events through the real decoder.
 *
 * Faults are injected below the decoder, where panels are: unplugged at any event, events told
 * twice, liftings that are not told, leaps over the glass, any bits for places, silence and the
 * burst after it. The caller owns the state and the events. */
#ifndef KINGYO_DRIVERS_TOUCH_SIM_H
#define KINGYO_DRIVERS_TOUCH_SIM_H

#include "drivers/touch_fingers.h"
#include "platform/hal.h"

#define TOUCH_SIM_NEVER UINT32_MAX

struct touch_sim {
    struct hal_clock clock;
    const struct touch_event *events; /* Sorted by time; must outlive the device. */
    uint32_t event_count;
    uint32_t next;                 /* First event that has not arrived yet. */
    uint32_t unplug_at;            /* Before this event the cable is pulled; TOUCH_SIM_NEVER. */
    uint64_t replug_ns;            /* From this time on open() finds it again. */
    uint32_t double_every;         /* Every n-th event arrives twice; 0: none does. */
    uint32_t mute_every;           /* Every n-th event does not arrive if it is a lifting. */
    uint32_t jump_at;              /* This event is told from the far corner; TOUCH_SIM_NEVER. */
    uint32_t spoil_from, spoil_to; /* These events say any bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Nothing arrives in between; it comes all at once. */
    uint8_t gone;
    uint32_t open_count;
    struct touch_fingers fingers;
    struct pointer_report report;
    struct pointer_poi pointer;
};

/* A window of `width` x `height` pixels, no events and no faults. */
void touch_sim_init(struct touch_sim *sim, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height);

struct hal_poi touch_sim_device(struct touch_sim *sim);

#endif
