/* kiosk.h -- the frame loop: sample the devices, run the owed ticks, present. One direction.
 *
 * The caller owns `struct kiosk` (about 1.5 MB: put it in static storage). After kiosk_init nothing
 * here allocates, and no call waits but the display's, for the screen. */
#ifndef KINGYO_PLATFORM_KIOSK_KIOSK_H
#define KINGYO_PLATFORM_KIOSK_KIOSK_H

#include <stdint.h>

#include "core/core.h"
#include "platform/hal.h"
#include "platform/kiosk/dressing.h"
#include "platform/kiosk/file_notes.h"
#include "platform/kiosk/hands.h"
#include "platform/kiosk/late.h"
#include "platform/kiosk/lighting.h"
#include "platform/kiosk/pace.h"
#include "platform/kiosk/saving.h"
#include "platform/kiosk/shades.h"
#include "platform/kiosk/switches.h"
#include "platform/kiosk/timing.h"
#include "platform/kiosk/voice.h"

struct chapters;
struct encore;
struct machine;

/* Sees each tick's input before the tick, and with it the state after the tick: the recorder.
 * Must not change either. */
struct kiosk_tap {
    void (*before)(void *self, const struct input *input); /* May be null. */
    void (*tick)(void *self, const struct input *input, const struct core *core);
    void *self;
};

/* Gives each tick's input in place of the devices: the replayer. */
struct kiosk_source {
    int (*next)(void *self, struct input *out); /* 1, or 0 when there is no more. */
    void *self;
};

struct kiosk_config {
    struct core_config core;
    uint8_t bot[POI_MAX];       /* These are the core's bot's, whatever device there is. */
    struct hal_clock stopwatch; /* Real time, for the figures only; never reaches the core. */
    const struct file_notes *notes; /* For the operator's menu; outlives the kiosk. Null: none. */
    struct machine *machine;    /* That is looked after; outlives the kiosk. Null: nobody does. */
    struct chapters *chapters;  /* For the replays of scores; outlives the kiosk. Null: none. */
    struct encore *encore;      /* To show scores again; outlives the kiosk. Null: none can be. */
    struct kiosk_tap tap;       /* Null function: none. */
    struct kiosk_source source; /* Null function: the devices play. */
};

enum kiosk_end {
    KIOSK_RUNS = 0,
    KIOSK_QUIT,         /* A quit key pressed twice, a closed window, the session's end. */
    KIOSK_DISPLAY_LOST, /* Nothing can be shown any more. */
    KIOSK_SOURCE_END,   /* The replay is over. */
    KIOSK_FLOAT,        /* The core refused a tick with CORE_ERR_FLOAT. */
    KIOSK_RESTART,      /* It is to begin anew: the operator wants it, or a store that came late. */
};

/* What went wrong and was survived, since the start. */
struct kiosk_faults {
    uint32_t poi, shade, display, audio, storage, buttons, switches;
};

/* Of all devices together. */
uint32_t kiosk_fault_count(const struct kiosk_faults *faults);

struct kiosk {
    struct kiosk_config config;
    struct core core;
    struct input input;    /* Of the next tick; edges wait in it until one tick has seen them. */
    struct output output;
    struct poi_force felt[POI_MAX]; /* By all ticks of the frame; see output_feel(). */
    struct scene scene;
    struct pace pace;
    struct poi_hand hands[POI_MAX];
    struct shade_hand shades[SHADE_MAX];
    uint64_t sampled_ns;   /* When the devices were last asked. */
    uint64_t display_retry_ns; /* When a display that went is looked for again; 0: none did. */
    struct lighting lighting;
    struct view view;      /* Of the tank, ... */
    struct showing showing; /* ... and on the screen, as display and pois were told last. */
    struct saving saving;
    struct late late;
    struct voice voice;
    struct switches switches;
    uint64_t restart_ns;       /* When a restart waits no longer for the store; 0: none is asked
                                  for. */
    uint64_t quit_until_ns;    /* Until then the quit key is asked for once more; 0: it is not. */
    uint32_t told_orders;      /* Of output.order_count, those that were told. */
    uint32_t wanted_replay_id; /* The operator wants to see this round; 0: none. */
    uint8_t has_acknowledged;  /* He has seen what was set aside, and the machine is to be told. */
    struct scene_machine machine; /* As it was looked at last. */
    uint8_t end;           /* enum kiosk_end */

    uint64_t frames;
    struct kiosk_faults faults;
    uint32_t float_resets;    /* Frames before which the floating-point control had to be set back,
                                 because a library had changed it. */
    struct line_book lines;   /* Of the buttons and coins. */
    struct timing frame_time; /* Begin to begin, on the stopwatch. */
    struct timing work_time;  /* Begin to end of kiosk_frame. */
    struct timing report_wait; /* From a poi's report to the tick that uses it. */
    uint64_t core_ns;         /* Spent in ticks and scene. */
    uint64_t frame_begin_ns;
};

/* A fresh stall. Opens the poi; the board has opened the rest. Sets the calling thread's
 * floating-point control. Returns CORE_OK or core_init()'s error: then `kiosk` is not to be used.
 */
enum core_error kiosk_init(struct kiosk *kiosk, const struct hal *hal,
                           const struct kiosk_config *config);

/* Whether the quit key was pressed, so that a second press ends the kiosk. */
int kiosk_asks_to_quit(const struct kiosk *kiosk);

/* One displayed frame. Sets the calling thread's floating-point control before the ticks. Returns
 * enum kiosk_end; after anything but KIOSK_RUNS call it no more. */
enum kiosk_end kiosk_frame(struct kiosk *kiosk, const struct hal *hal);

/* After the last frame: closes the store, which may wait for it, and counts its last faults.
 * Returns how many finished rounds are lost: not written, or never taken by a store that was
 * there. */
uint32_t kiosk_close_store(struct kiosk *kiosk, const struct hal *hal);

#endif
