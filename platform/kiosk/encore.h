/* encore.h -- a score is shown again: its replay comes from the store, is played fast up to its
 * round and then as it was, and in the end the judge says whether it is genuine.
 *
 * The stall itself goes on behind it. Any button, and a dip, ends it. The caller owns `struct
 * encore` (4.5 MB: static storage) and leaves it zero. */
#ifndef KINGYO_PLATFORM_KIOSK_ENCORE_H
#define KINGYO_PLATFORM_KIOSK_ENCORE_H

#include "core/scene.h"
#include "platform/hal.h"
#include "platform/kiosk/chapters.h"
#include "platform/kiosk/judge.h"

#define ENCORE_END_TICKS (10u * CORE_TICK_HZ) /* The verdict stands so long. */
#define ENCORE_SEEK_NS 10000000ull /* Of a frame, while it seeks: 40 ticks and more of a desktop. */
#define ENCORE_SEEK_TICKS 240u     /* And at most so many, or seconds read: a clock may stop. */

struct encore {
    uint8_t state;       /* enum scene_encore */
    uint8_t is_asked;    /* The store is looking for it. */
    uint8_t is_open;     /* The judge reads it, ... */
    uint8_t has_play;    /* ... and has read it: there is something to see. */
    uint32_t round_id;
    uint32_t end_ticks;  /* Since the verdict. */
    float hand_y_m[POI_MAX]; /* To see a dip. */
    struct ledger_entry kept; /* The round's, as it is on disk. */
    struct judge judge;
    uint8_t bytes[CHAPTERS_SIZE];
};

/* Begins, in place of what is shown. The store may be writing yet: it is asked until it answers. */
void encore_ask(struct encore *encore, uint32_t round_id);

/* What hands do while it is on: 1 when that ends it. `pressed`: buttons. */
int encore_heeds(struct encore *encore, uint32_t pressed, const struct poi_input poi[POI_MAX]);

/* Once a frame: what `tick_count` ticks do to it. Its sounds take the place of those in `output`;
 * once its round runs, its picture that of `scene`. */
void encore_frame(struct encore *encore, const struct hal *hal, const struct hal_clock *stopwatch,
                  const struct ranking *ranking, uint32_t tick_count);
void encore_show(const struct encore *encore, struct scene *scene, struct output *output);

void encore_end(struct encore *encore);

#endif
