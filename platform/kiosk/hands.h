/* hands.h -- the controllers of the pois, as the frame loop sees them.
 *
 * Devices are polled once a frame; each tick of the frame gets a pose of its own on the way there
 * (resample.h). What a device says is passed on as it is, nonsense too: the core judges it. */
#ifndef KINGYO_PLATFORM_KIOSK_HANDS_H
#define KINGYO_PLATFORM_KIOSK_HANDS_H

#include <stdint.h>

#include "core/input.h"
#include "platform/hal.h"
#include "platform/kiosk/resample.h"
#include "platform/kiosk/timing.h"

/* How often a controller reports: counted over a second, shown for the next one. */
struct report_pace {
    uint64_t begin_ns;        /* Of the second that is counted. */
    uint64_t last_ns;         /* When the last report arrived; 0: none ever did. */
    uint64_t gap_ns;          /* The longest between two, in this second, ... */
    uint32_t count;
    uint32_t shown_count;     /* ... and in the last whole one. */
    uint64_t shown_gap_ns;
};

/* One player's controller. */
struct poi_hand {
    struct report_pace pace;
    struct resampler path;
    uint64_t retry_ns;  /* When a lost one is looked for again. */
    uint64_t newest_ns; /* When its newest reading arrived. */
    uint8_t link;       /* enum poi_link, but never BOT. */
    uint8_t has_wrist, trembles; /* As its newest reading says. */
    uint8_t was_seen;   /* It gave a reading once. */
    uint64_t waiting_ns[HAL_POI_SAMPLES_MAX]; /* When reports came that no tick has used yet; */
    uint32_t waiting_count;                   /* more than fit are not timed. */
};

/* Looks for the device. Returns whether that was a fault. */
uint32_t poi_hand_open(struct poi_hand *hand, const struct hal_poi *device, uint64_t now_ns);

/* Takes the readings since the last frame; a lost device is looked for once a second. Returns how
 * many faults it met: failed calls, and readings with numbers that are none. */
uint32_t poi_hand_sample(struct poi_hand *hand, const struct hal_poi *device, uint64_t now_ns);

/* For tick `index` of the `tick_count` >= 1 ticks of the frame that began at `now_ns`. A controller
 * that never gave a reading is not here yet; one that gave some and stopped is away, and its target
 * stays what it was. A way that took much longer than the frame's ticks do is not walked: it is
 * passed on as that of a hand whose reports were late (core/game/trust.h), which is caught up with
 * gently. */
void poi_hand_at(const struct poi_hand *hand, uint32_t index, uint32_t tick_count, uint64_t now_ns,
                 struct poi_input *out);

/* The frame's first tick begins: adds to `wait` how long each report has waited for it. */
void poi_hand_time(struct poi_hand *hand, uint64_t now_ns, struct timing *wait);

/* After the frame's last tick: the way is done. */
void poi_hand_end(struct poi_hand *hand);

#endif
