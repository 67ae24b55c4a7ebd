/* display_sim.h -- a simulated display that stores the last scene (the input of the renderer) and
 * can fail.
 *
 * The caller owns the state, initializes it with zero, and sets the faults. */
#ifndef KINGYO_DRIVERS_SIM_DISPLAY_SIM_H
#define KINGYO_DRIVERS_SIM_DISPLAY_SIM_H

#include "platform/hal.h"

struct display_sim {
    struct scene scene;                       /* Scene of the last successful present(). */
    struct display_settings display_settings; /* Image geometry from the last set_transform(). */
    uint32_t present_count;
    uint32_t full_screen_count; /* Number of full-screen toggles. */
    uint32_t gone_at;           /* Number of present() calls after which the display is permanently
                                   lost; 0 means never. */
    uint8_t away;               /* 1 while the display is unplugged and open() fails, otherwise
                                   0. */
    uint8_t needs_open;         /* 1 from the unplugging of the display until open() succeeds,
                                   otherwise 0. */
    uint32_t open_count;
    uint32_t fail_at; /* Number (from 1) of the present() call that fails with HAL_ERR_IO; 0 means
                         that no call fails. */
    uint8_t quit;     /* 1 if the next poll() reports that the window was closed, otherwise 0. */
    uint8_t opened;
};

/* Returns the simulated display. */
struct hal_display display_sim_device(struct display_sim *sim);

#endif
