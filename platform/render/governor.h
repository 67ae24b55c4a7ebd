/* governor.h -- draws less when frames come late or the machine gets hot, so that the game never
 * has to wait for its picture; and finer again when there is time.
 *
 * A screen shows a frame at its next turn, so that a frame's time says whether drawing was too slow
 * and not how fast it was. Whether a finer picture is possible is found out by trying: between two
 * games, and ever more rarely where it failed. */
#ifndef KINGYO_PLATFORM_RENDER_GOVERNOR_H
#define KINGYO_PLATFORM_RENDER_GOVERNOR_H

#include <stdbool.h>
#include <stdint.h>

#define GOVERNOR_LOOK_S 2u        /* Frames of so long make one judgement. */
#define GOVERNOR_PATIENCE_S 30u   /* On time for so long, a finer picture is tried; ... */
#define GOVERNOR_PATIENCE_MAX_S 1920u /* ... each try that fails doubles it, up to half an hour. */
#define GOVERNOR_HOT_MDEG 3000  /* So near to where it slows itself down a machine is hot, */
#define GOVERNOR_COOL_MDEG 8000 /* and so far from it cool again. */

struct governor {
    uint64_t turn_ns;     /* Of the screen: the best that a frame can be. */
    uint64_t last_ns;     /* The frame before; 0: none. */
    uint64_t sum_ns, count; /* Of the frames that are looked at. */
    uint32_t stalls;      /* Frames in a row that took too long to be drawing. */
    uint32_t timely_s;    /* On time in a row. */
    uint32_t patience_s;
    uint8_t step;         /* enough for frames to be on time ... */
    uint8_t heat;         /* ... and for the machine to stay cool: <= QUALITY_STEP_MAX. */
    uint8_t is_trying;    /* The step was lowered and may be too low. */
};

/* `refresh_hz`: of the screen; 0 or more than 60: 60, which is all that the game needs. */
void governor_begin(struct governor *governor, uint32_t refresh_hz);

/* After each frame; `may_refine` between two games. One that took longer than a quarter of a second
 * was a stall and says nothing of drawing, but the third in a row. Returns the step of
 * quality_lower() to draw with. */
uint32_t governor_frame(struct governor *governor, uint64_t now_ns, bool may_refine);

/* Every few seconds: how far the machine is from the heat at which it would slow itself down. */
void governor_heat(struct governor *governor, int32_t margin_mdeg);

#endif
