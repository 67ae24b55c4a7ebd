/* governor.h -- the quality governor, which adapts the drawing quality to the machine.
 *
 * The governor lowers the quality if frames are late or the machine is hot, so that the game never
 * waits for a picture. The governor raises the quality again when frames are on time.
 *
 * A screen shows a frame at its next refresh. A frame's duration therefore shows whether drawing
 * was too slow, but not how much time was left. For that reason the governor tries a finer quality
 * step between two games. After each failed trial the governor waits longer before the next one. */
#ifndef KINGYO_PLATFORM_RENDER_GOVERNOR_H
#define KINGYO_PLATFORM_RENDER_GOVERNOR_H

#include <stdbool.h>
#include <stdint.h>

#define GOVERNOR_LOOK_S 2u /* Duration in seconds of the frames that are judged together. */
/* Number of seconds with frames on time after which a finer quality step is tried. */
#define GOVERNOR_PATIENCE_S 30u
/* Maximum wait in seconds before a trial, about half an hour. Each failed trial doubles the
 * wait. */
#define GOVERNOR_PATIENCE_MAX_S 1920u
/* Temperature distance in m°C. A machine is hot if it is less than this distance below its
 * throttling temperature. */
#define GOVERNOR_HOT_MDEG 3000
/* Temperature distance in m°C. A hot machine is cool again if it is more than this distance below
 * its throttling temperature. */
#define GOVERNOR_COOL_MDEG 8000

struct governor {
    uint64_t turn_ns;       /* Refresh period of the screen in ns, the shortest possible frame
                               duration. */
    uint64_t last_ns;       /* Time of the previous frame in ns. 0 means no previous frame. */
    uint64_t sum_ns, count; /* Total duration in ns, and number, of the frames that are judged
                               together. */
    uint32_t stalls;        /* Consecutive frames that took too long for drawing to be the cause. */
    uint32_t timely_s;      /* Consecutive seconds with frames on time. */
    /* Seconds with frames on time that are required before the next trial. */
    uint32_t patience_s;
    uint8_t step;      /* Quality step that frames need in order to be on time. */
    uint8_t heat;      /* Quality step that keeps the machine cool, at most QUALITY_STEP_MAX. */
    uint8_t is_trying; /* 1 while a finer step is on trial, otherwise 0. The step may be too slow to
                          draw. */
};

/* Initializes the governor. `refresh_hz` is the screen's refresh rate. A value of 0 or above 60
 * counts as 60 Hz, which is enough for the game. */
void governor_begin(struct governor *governor, uint32_t refresh_hz);

/* Updates the governor. Call after each frame. `may_refine` is true between two games. A frame
 * longer than a quarter of a second is a stall and does not count as drawing time, unless it is at
 * least the third stall in a row. Returns the step of quality_lower() for the next frame. */
uint32_t governor_frame(struct governor *governor, uint64_t now_ns, bool may_refine);

/* Updates the quality step `heat`. Call every few seconds. `margin_mdeg` is the margin in m°C below
 * the temperature at which the machine throttles itself. */
void governor_set_temperature(struct governor *governor, int32_t margin_mdeg);

#endif
