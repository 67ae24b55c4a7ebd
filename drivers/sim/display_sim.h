/* display_sim.h -- a simulated display that stores the last scene and can fail.
 *
 * The caller owns the state, initializes it with zero, and sets the faults. */
#ifndef KINGYO_DRIVERS_SIM_DISPLAY_SIM_H
#define KINGYO_DRIVERS_SIM_DISPLAY_SIM_H

#include "platform/hal.h"

struct display_sim {
    struct scene scene;                       /* Scene presented last. */
    struct display_settings display_settings; /* Image geometry set last. */
    uint32_t present_count;
    uint32_t full_screen_count; /* Number of full-screen toggles. */
    uint32_t gone_at;           /* Permanently lost from this present on; 0: never. */
    uint8_t away;               /* 1 if the display is unplugged and open() must fail. */
    uint8_t needs_open;         /* 1 after it was unplugged, until open() succeeds. */
    uint32_t open_count;
    uint32_t fail_at; /* Number of the present that fails with HAL_ERR_IO; 0: none. */
    uint8_t quit;     /* 1 if the next poll must report that the window was closed. */
    uint8_t opened;
};

struct hal_display display_sim_device(struct display_sim *sim);

#endif
