/* kiosk.h -- the frame loop: sample the devices, run the due ticks, present the result.
 *
 * The caller owns `struct kiosk` (about 1.5 MB: static storage). After kiosk_init() nothing here
 * allocates memory. No call blocks, except the display's, which waits for the screen. */
#ifndef KINGYO_PLATFORM_KIOSK_KIOSK_H
#define KINGYO_PLATFORM_KIOSK_KIOSK_H

#include <stdint.h>

#include "core/core.h"
#include "platform/hal.h"
#include "platform/kiosk/audio_output.h"
#include "platform/kiosk/dimmer.h"
#include "platform/kiosk/fan_sampler.h"
#include "platform/kiosk/file_notes.h"
#include "platform/kiosk/frame_pacer.h"
#include "platform/kiosk/offline_flush.h"
#include "platform/kiosk/operator_view.h"
#include "platform/kiosk/output_lines.h"
#include "platform/kiosk/poi_sampler.h"
#include "platform/kiosk/saving.h"
#include "platform/kiosk/timing.h"

struct session_recorder;
struct score_playback;
struct system_health;

/* Callbacks with each tick's input before the tick, and with the state after the tick; used by the
 * recorder. They must not change either. */
struct kiosk_tap {
    void (*before)(void *self, const struct input *input); /* May be null. */
    void (*tick)(void *self, const struct input *input, const struct core *core);
    void *self;
};

/* Source of each tick's input in place of the devices; used by the replayer. */
struct kiosk_source {
    int (*next)(void *self, struct input *out); /* Returns 1, or 0 at the end. */
    void *self;
};

struct kiosk_config {
    struct core_config core;
    uint8_t bot[POI_MAX];           /* 1: the core's bot plays this poi, whatever devices exist. */
    struct hal_clock stopwatch;     /* Real time for statistics only; never reaches the core. */
    const struct file_notes *notes; /* Notes for the operator's menu; must outlive the kiosk. Null:
                                       none. */
    struct system_health *machine;  /* System health monitor; must outlive the kiosk. Null: none. */
    struct session_recorder *chapters; /* Session recorder; must outlive the kiosk. Null: none. */
    struct score_playback *playback;   /* Score playback; must outlive the kiosk. Null: none. */
    struct kiosk_tap tap;              /* Null functions: no callbacks. */
    struct kiosk_source source;        /* Null function: the devices are the source. */
};

enum kiosk_end {
    KIOSK_RUNS = 0,
    KIOSK_QUIT,         /* The quit key pressed twice, a closed window, or the end of the desktop
                           session. */
    KIOSK_DISPLAY_LOST, /* The display is lost for good. */
    KIOSK_SOURCE_END,   /* The replay is over. */
    KIOSK_FLOAT,        /* The core rejected a tick with CORE_ERR_FLOAT. */
    KIOSK_RESTART,      /* The kiosk must restart: by the operator, or because a store appeared
                           after the start. */
};

/* Faults since the start that the kiosk has survived. */
struct kiosk_faults {
    uint32_t poi, shade, display, audio, storage, buttons, switches;
};

/* Returns the sum over all devices. */
uint32_t kiosk_fault_count(const struct kiosk_faults *faults);

struct kiosk {
    struct kiosk_config config;
    struct core core;
    struct input input; /* Input of the next tick; edges stay in it until one tick has used them. */
    struct output output;
    struct poi_force
        felt[POI_MAX]; /* Forces of all ticks of the frame; see output_merge_force(). */
    struct scene scene;
    struct frame_pacer pace;
    struct poi_sampler hands[POI_MAX];
    struct fan_sampler shades[SHADE_MAX];
    uint64_t sampled_ns;       /* Time of the last device poll. */
    uint64_t display_retry_ns; /* Time of the next attempt to reopen a lost display; 0: not lost. */
    struct dimmer dimmer;
    struct view view; /* Camera view that display and pois were given last. */
    struct display_settings
        display_settings; /* Display transform that display and pois were given last. */
    struct saving saving;
    struct offline_flush late;
    struct audio_output voice;
    struct output_lines switches;
    uint64_t restart_ns;    /* Time at which a restart no longer waits for the store; 0: no
                               restart is requested. */
    uint64_t quit_until_ns; /* Time until which a second press of the quit key ends the kiosk; 0:
                               no first press. */
    uint32_t told_orders;   /* Value of output.command_count up to which commands were executed. */
    uint32_t wanted_replay_id;    /* Round that the operator wants to see; 0: none. */
    uint8_t has_acknowledged;     /* 1: the operator has acknowledged quarantined files, and the
                                     monitor must mark them. */
    struct scene_machine machine; /* Newest system health. */
    uint8_t end;                  /* enum kiosk_end */

    uint64_t frames;
    struct kiosk_faults faults;
    uint32_t float_resets; /* Frames before which the floating-point control had to be restored,
                              because a library had changed it. */
    struct operator_view_lines lines; /* Statistics of button and coin lines. */
    struct timing frame_time;         /* Time between the starts of two frames, on the stopwatch. */
    struct timing work_time;          /* Time from the start to the end of kiosk_frame(). */
    struct timing report_wait;        /* Time from a poi's report to the tick that uses it. */
    uint64_t core_ns;                 /* Time spent in ticks and scene. */
    uint64_t frame_begin_ns;
};

/* Initializes the kiosk and opens the pois; the board has opened the other devices. Sets the
 * calling thread's floating-point control. Returns CORE_OK or core_init()'s error; after an error
 * `kiosk` must not be used. */
enum core_error kiosk_init(struct kiosk *kiosk, const struct hal *hal,
                           const struct kiosk_config *config);

/* Returns 1 if the quit key was pressed, so that a second press ends the kiosk. */
int kiosk_asks_to_quit(const struct kiosk *kiosk);

/* Runs one displayed frame. Sets the calling thread's floating-point control before the ticks.
 * Returns enum kiosk_end; after any value except KIOSK_RUNS it must not be called again. */
enum kiosk_end kiosk_frame(struct kiosk *kiosk, const struct hal *hal);

/* Closes the store and counts its last faults. Call after the last frame. May block on the store.
 * Returns the number of finished rounds that are lost: not written, or never accepted by an
 * existing store. */
uint32_t kiosk_close_store(struct kiosk *kiosk, const struct hal *hal);

#endif
