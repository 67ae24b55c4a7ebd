/* display_sim.h -- a display that keeps the last scene instead of showing it, and can vanish.
 *
 * The caller owns the state; zero it, then set the faults wanted. */
#ifndef KINGYO_DRIVERS_DISPLAY_SIM_H
#define KINGYO_DRIVERS_DISPLAY_SIM_H

#include "platform/hal.h"

struct display_sim {
    struct scene scene;         /* As last presented, ... */
    struct showing showing;     /* ... and how it lay on the screen. */
    uint32_t present_count;
    uint32_t full_screen_count; /* Times it was toggled. */
    uint32_t gone_at;           /* From this present on it is gone for good; 0: it stays. */
    uint8_t away;               /* Set: it is pulled out, and no open finds it. */
    uint8_t needs_open;         /* It was away. */
    uint32_t open_count;
    uint32_t fail_at;           /* This one present fails with HAL_ERR_IO; 0: none. */
    uint8_t quit;               /* The next poll reports that the window was closed. */
    uint8_t opened;
};

struct hal_display display_sim_device(struct display_sim *sim);

#endif
