/* hal_sim.h -- simulated devices of struct hal that need no decoder: clock, buttons, display and
 * audio.
 *
 * The caller owns each state, initializes it with zero, and sets the faults. The state must not
 * move while its device is used. */
#pragma once

#include <stdbool.h>

#include "platform/hal.h"

/* ---- Clock: a test or the demonstration advances the time ------------------------------------ */

struct clock_sim {
    uint64_t now_ns; /* Current time. The owner may increase it and must not decrease it. */
};

/* Returns the simulated clock. */
struct hal_clock sim_clock_device(struct clock_sim *sim);

/* ---- Buttons: buttons and coins follow a script of events ------------------------------------ */

/* An event of the button script. The events of a script are sorted by time. */
struct button_event {
    uint64_t time_ns;
    uint32_t pressed;  /* Buttons that the event presses, as bits of enum input_button. */
    uint32_t released; /* Buttons that the event releases, as bits of enum input_button. */
    uint32_t coin_count[COIN_LINE_COUNT];
    bool quit, full_screen;
};

struct buttons_sim {
    struct hal_clock clock;
    /* Script of button events, owned by the caller. The script must outlive the device. */
    const struct button_event *events;
    uint32_t event_count;
    uint32_t next; /* Index of the next script event to play. */
    uint32_t held;
};

/* Returns the simulated button device. */
struct hal_buttons sim_buttons_device(struct buttons_sim *sim);

/* ---- Display: stores the last scene (the input of the renderer) and can fail ----------------- */

struct display_sim {
    struct scene scene;                       /* Scene of the last successful present(). */
    struct display_settings display_settings; /* Image geometry from the last set_transform(). */
    uint32_t present_count;
    uint32_t full_screen_count; /* Number of full-screen toggles. */
    /* The display is permanently lost after this number of present() calls. 0 means never. */
    uint32_t gone_at;
    bool away;       /* True while the display is unplugged and open() fails. */
    bool needs_open; /* True after the display was unplugged, until open() succeeds. */
    uint32_t open_count;
    /* Ordinal number (from 1) of the present() call that fails with HAL_ERR_IO. 0 means that no
     * call fails. */
    uint32_t fail_at;
    bool quit;   /* True if the next poll() reports that the window was closed. */
    bool opened; /* True between a successful open() and close(). */
};

/* Returns the simulated display. */
struct hal_display sim_display_device(struct display_sim *sim);

/* ---- Audio: counts the played sounds --------------------------------------------------------- */

struct audio_sim {
    uint32_t played[SOUND_COUNT];
    float gain;                 /* Gain of the last played sound. */
    struct sound_levels levels; /* Levels of the last set_levels(). */
    bool fails;                 /* True if every play() returns HAL_ERR_IO. */
    /* True if every play() returns HAL_ERR_GONE and every open() returns HAL_ERR_ABSENT. */
    bool gone;
    uint32_t open_count;
};

/* Returns the simulated audio device. */
struct hal_audio sim_audio_device(struct audio_sim *sim);
