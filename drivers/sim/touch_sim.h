/* touch_sim.h -- a simulated touch screen that passes raw finger events through the real decoder.
 *
 * The faults change the input of the decoder: unplugging before a selected event, doubled events,
 * lost lift events, jumps, random positions, and silence followed by a burst. The caller owns the
 * state and the events. */
#ifndef KINGYO_DRIVERS_SIM_TOUCH_SIM_H
#define KINGYO_DRIVERS_SIM_TOUCH_SIM_H

#include "drivers/pointer/touch_fingers.h"
#include "platform/hal.h"

#define TOUCH_SIM_NEVER UINT32_MAX

struct touch_sim {
    struct hal_clock clock;
    const struct touch_event *events; /* Events to play, sorted by time. The array must outlive the
                                         device. */
    uint32_t event_count;
    uint32_t next; /* Index of the next event to play. */
    /* Index of the event before which the screen is unplugged; TOUCH_SIM_NEVER means never. */
    uint32_t unplug_at;
    uint64_t replug_ns;            /* Time from which open() finds the screen again. */
    uint32_t double_every;         /* Interval n of doubled events: every n-th event arrives twice.
                                      0 means that no event is doubled. */
    uint32_t mute_every;           /* Interval n of lost events: every n-th event is lost if it
                                      lifts a finger. 0 means that no event is lost. */
    uint32_t jump_at;              /* Index of the event that jumps to the top right corner;
                                      TOUCH_SIM_NEVER means that there is no such event. */
    uint32_t spoil_from, spoil_to; /* Index of the first event with random bits, and index after the
                                      last event with random bits. */
    uint64_t silent_from_ns, silent_to_ns; /* Start and end of the time without events. The events
                                              of this time arrive together at its end. */
    uint8_t gone;                          /* 1 while the screen is unplugged, otherwise 0. */
    uint32_t open_count;
    struct touch_fingers fingers;
    struct pointer_report report;
    struct pointer_poi pointer;
};

/* Initializes a touch screen for a window of `width` x `height` pixels, without events and
 * faults. */
void touch_sim_init(struct touch_sim *sim, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height);

/* Returns the poi device of the simulated touch screen. */
struct hal_poi touch_sim_device(struct touch_sim *sim);

#endif
