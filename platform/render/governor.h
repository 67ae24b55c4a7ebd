/* governor.h -- the quality governor, which adapts the drawing quality to the machine.
 *
 * The governor lowers the quality when frames are late or the machine is hot, so that the game
 * never waits for its picture. The governor raises the quality again when there is time.
 *
 * A screen shows a frame at its next refresh, so a frame's duration shows whether drawing was
 * too slow but not how much time was left. The governor therefore tries a finer step between two
 * games, and waits longer after each failed trial. */
#ifndef KINGYO_PLATFORM_RENDER_GOVERNOR_H
#define KINGYO_PLATFORM_RENDER_GOVERNOR_H

#include <stdbool.h>
#include <stdint.h>

#define GOVERNOR_LOOK_S 2u      /* Seconds of frames that make one judgement. */
#define GOVERNOR_PATIENCE_S 30u /* Seconds on time after which a finer step is tried. */
/* Upper limit of the wait, about half an hour. Each failed trial doubles the wait. */
#define GOVERNOR_PATIENCE_MAX_S 1920u
/* A machine is hot if its temperature is less than this below its throttling point, in m°C. */
#define GOVERNOR_HOT_MDEG 3000
/* A machine is cool again if its temperature is more than this below its throttling point, in
 * m°C. */
#define GOVERNOR_COOL_MDEG 8000

struct governor {
    uint64_t turn_ns; /* Refresh period of the screen, the shortest possible frame duration. */
    uint64_t last_ns; /* Time of the previous frame; 0: none. */
    uint64_t sum_ns, count; /* Total duration and number of the frames in the current judgement. */
    uint32_t stalls;        /* Consecutive frames that took too long to be caused by drawing. */
    uint32_t timely_s;      /* Seconds on time in a row. */
    uint32_t patience_s;
    uint8_t step;      /* Quality step needed for frames to be on time. */
    uint8_t heat;      /* Quality step needed for the machine to stay cool, <= QUALITY_STEP_MAX. */
    uint8_t is_trying; /* The step was lowered on trial and may be too low. */
};

/* Initializes the governor. `refresh_hz` is the screen's rate; 0 or more than 60 counts as 60,
 * which is enough for the game. */
void governor_begin(struct governor *governor, uint32_t refresh_hz);

/* Call after each frame. `may_refine` is true between two games. A frame longer than a quarter of a
 * second is a stall and is not counted as drawing, except from the third stall in a row on. Returns
 * the step of quality_lower() to draw with. */
uint32_t governor_frame(struct governor *governor, uint64_t now_ns, bool may_refine);

/* Call every few seconds. `margin_mdeg` is the distance to the temperature at which the machine
 * throttles itself, in m°C. */
void governor_set_temperature(struct governor *governor, int32_t margin_mdeg);

#endif
