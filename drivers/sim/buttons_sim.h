/* buttons_sim.h -- simulated buttons and coins from a script of timestamps. */
#ifndef KINGYO_DRIVERS_SIM_BUTTONS_SIM_H
#define KINGYO_DRIVERS_SIM_BUTTONS_SIM_H

#include "platform/hal.h"

/* A scripted event. Scripts are sorted by time. */
struct button_event {
    uint64_t time_ns;
    uint32_t pressed;  /* enum input_button bits that are pressed by the event. */
    uint32_t released; /* enum input_button bits that are released by the event. */
    uint32_t coin_count[COIN_LINE_COUNT];
    uint8_t quit, full_screen;
};

struct buttons_sim {
    struct hal_clock clock;
    const struct button_event *events; /* Owned by the caller; must outlive the device. */
    uint32_t event_count;
    uint32_t next; /* Index of the next event to play. */
    uint32_t held;
};

struct hal_buttons buttons_sim_device(struct buttons_sim *sim);

#endif
