/* tear_clip.h -- records the last second of a poi (the paper scoop) and the cause of the first tear
 * of its paper.
 *
 * The result screen shows the recording in slow motion. The recording is used for display only: the
 * simulation never reads it, and no hash contains it. */
#pragma once

#include "core/poi/poi.h"

/* Ticks from one frame of the recording to the next. The slow motion shows each frame for
 * TEAR_CLIP_SHOWN_TICKS. Therefore the slow motion has two fifths of the real speed and 24 frames
 * per second. */
#define TEAR_CLIP_FRAME_TICKS 2u
/* Number of frames in a recording, which lasts one second. If a player moves the poi too fast, the
 * paper tears within half a second after the dip. */
#define TEAR_CLIP_FRAMES (CORE_TICK_HZ / TEAR_CLIP_FRAME_TICKS)
/* Number of frames (a quarter of a second) that are recorded after the first tear, while the hole
 * opens. */
#define TEAR_CLIP_FRAMES_AFTER 15u
/* Number of ticks for which the result screen shows one frame. */
#define TEAR_CLIP_SHOWN_TICKS 5u
/* Number of ticks after which the slow motion starts again. The last frame is shown for the rest of
 * this time. If the paper of several players tore, the result screen shows one player's slow motion
 * after another. The result screen is shown long enough for four players. */
#define TEAR_CLIP_LOOP_TICKS (3u * CORE_TICK_HZ)
_Static_assert(TEAR_CLIP_FRAMES *TEAR_CLIP_SHOWN_TICKS < TEAR_CLIP_LOOP_TICKS, "all frames fit");

/* One frame, quantised so that the frames of four players take 33 KiB. */
struct tear_frame {
    int16_t position[3]; /* Position of the ring's centre in units of 0.1 mm. */
    int16_t angles[3];   /* Yaw, pitch and roll in units of 0.1 mrad. */
    /* Load of each cell in four bits, with the even cells in the low bits. 0 means a hole or no
     * paper. */
    uint8_t load[TEAR_CELL_COUNT / 2u];
};

struct tear_clip {
    uint8_t cause; /* Cause of the first tear (enum tear_cause). */
    uint8_t count; /* Number of recorded frames, at most TEAR_CLIP_FRAMES. */
    uint8_t next;  /* Index at which the next frame is stored. The oldest frame is replaced. */
    /* Number of frames recorded since the first tear. The recording ends when the number reaches
     * TEAR_CLIP_FRAMES_AFTER. */
    uint8_t after;
    /* Damage that high loads have done to the paper minus the damage that moderate loads have done.
     * The unit is the damage of one tick at the strength of fresh wet paper. */
    float haste;
    struct tear_frame frames[TEAR_CLIP_FRAMES];
};

/* Returns the cause (enum tear_cause) for which the paper of `poi` tears in this tick, or TEAR_NONE
 * if no cell tore. `clip` is the recording of the poi up to this tick. Must be called between
 * poi_apply_reaction() and catch_tick(), which changes the loads on the paper. */
uint8_t tear_cause_of(const struct tear_clip *clip, const struct poi *poi);

/* Records one tick. `tick` is the number of the tick. Must be called between poi_apply_reaction()
 * and catch_tick(), as tear_cause_of(). */
void tear_clip_tick(struct tear_clip *clip, const struct poi *poi, uint32_t tick);

/* Writes to `out` the cause of the first tear, and the frame that the slow motion shows
 * `elapsed_ticks` after its start. Without a tear, `out` is empty. */
void tear_clip_show(const struct tear_clip *clip, uint32_t elapsed_ticks, struct scene_tear *out);
