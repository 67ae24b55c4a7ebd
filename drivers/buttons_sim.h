/* buttons_sim.h -- buttons and coins pressed by a script, on the time of a given clock. */
#ifndef KINGYO_DRIVERS_BUTTONS_SIM_H
#define KINGYO_DRIVERS_BUTTONS_SIM_H

#include "platform/hal.h"

/* One thing that happens. Scripts are sorted by time. */
struct button_event {
    uint64_t time_ns;
    uint32_t pressed;    /* enum input_button bits that go down ... */
    uint32_t released;   /* ... and bits that come up. */
    uint32_t coin_count[COIN_LINE_COUNT];
    uint8_t quit, full_screen;
};

struct buttons_sim {
    struct hal_clock clock;
    const struct button_event *events; /* The caller's; must outlive the device. */
    uint32_t event_count;
    uint32_t next;                     /* First event that has not happened yet. */
    uint32_t held;
};

struct hal_buttons buttons_sim_device(struct buttons_sim *sim);

#endif
