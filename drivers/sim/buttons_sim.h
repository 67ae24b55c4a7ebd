/* buttons_sim.h -- simulated buttons and coins that follow a script of events. */
#ifndef KINGYO_DRIVERS_SIM_BUTTONS_SIM_H
#define KINGYO_DRIVERS_SIM_BUTTONS_SIM_H

#include "platform/hal.h"

/* An event of the script. The events are sorted by time. */
struct button_event {
    uint64_t time_ns;
    uint32_t pressed;  /* Buttons that the event presses, as bits of enum input_button. */
    uint32_t released; /* Buttons that the event releases, as bits of enum input_button. */
    uint32_t coin_count[COIN_LINE_COUNT];
    uint8_t quit, full_screen;
};

struct buttons_sim {
    struct hal_clock clock;
    const struct button_event *events; /* Script, owned by the caller; must outlive the device. */
    uint32_t event_count;
    uint32_t next; /* Index of the next event to play. */
    uint32_t held;
};

/* Returns the simulated button device. */
struct hal_buttons buttons_sim_device(struct buttons_sim *sim);

#endif
