/* kiosk.h -- runs the frame loop. Each frame samples the devices, runs the ticks that are due and
 * presents the result.
 *
 * The caller owns `struct kiosk` (about 1.5 MB: static storage). No function allocates memory after
 * kiosk_init(). No function blocks, except that the display waits for the screen and
 * kiosk_close_store() waits for the store.
 *
 * A poi is the paper scoop and the controller that moves it. A slot is the place of one of up to
 * four controllers. A tick is 1/120 s. The scene is the data that the renderer draws. The ledger is
 * the append-only list of money events and rounds. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/core.h"
#include "platform/hal.h"
#include "platform/kiosk/frame_pacer.h"
#include "platform/kiosk/offline_flush.h"
#include "platform/kiosk/operator_view.h"
#include "platform/kiosk/output_devices.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/kiosk/sampler.h"

struct session_recorder;
struct score_playback;
struct system_health;
struct update_link;

struct kiosk_config {
    struct core_config core;
    /* True if the core's bot controls the poi, regardless of the connected devices. */
    bool bot[POI_MAX];
    /* Clock that only measures durations. Its time has no effect on the core. */
    struct hal_clock stopwatch;
    /* Messages for the operator's menu. Must outlive the kiosk. Null means no messages. */
    const struct operator_notes *notes;
    /* System health monitor. Must outlive the kiosk. Null means no monitor. */
    struct system_health *machine;
    /* Session recorder. Must outlive the kiosk. Null means no recording. */
    struct session_recorder *sessions;
    /* Score playback. Must outlive the kiosk. Null means no playback. */
    struct score_playback *playback;
    /* Link to the update service. Must outlive the kiosk. Null means that there is none. */
    struct update_link *update;
    struct kiosk_tap tap; /* Callbacks of a recorder. Each callback may be null. */
    /* Source of the input of each tick. If source.next is null, the devices provide the input. */
    struct kiosk_source source;
};

enum kiosk_end {
    KIOSK_RUNS = 0,
    /* The user pressed the quit key twice or closed the window, or the desktop session ended. */
    KIOSK_QUIT,
    KIOSK_DISPLAY_LOST, /* The display was lost permanently. */
    KIOSK_SOURCE_END,   /* The input source, for example a replay, has no more ticks. */
    KIOSK_FLOAT,        /* The core rejected a tick with CORE_ERR_FLOAT. */
    /* The operator requested a restart, or a store (ledger database) became available after program
     * start. */
    KIOSK_RESTART,
};

/* Faults per device type since program start. The kiosk continued after each fault. */
struct kiosk_faults {
    uint32_t poi, shade, display, audio, storage, buttons, switches;
};

/* Returns the sum of the faults of all device types. */
uint32_t kiosk_fault_count(const struct kiosk_faults *faults);

/* Progress of passing ledger entries and edits of the growth lab to the store, which may be busy,
 * fail or be absent. An entry or edit is passed again in each attempt until the store accepts
 * it. */
struct saving {
    /* Id of the newest ledger entry that is settled: the store accepted the entry, or no store
     * exists. */
    uint32_t accepted_id;
    /* Id of the newest edit that is settled: the store accepted the edit, or no store exists. */
    uint32_t accepted_edit_id;
    uint32_t refused_seen; /* Number of failed writes that were already counted as faults. */
    /* Time until which no data are passed to the store, because a previous attempt failed. */
    uint64_t retry_ns;
    bool is_offline; /* True if an entry settled because no store exists. */
};

struct kiosk {
    struct kiosk_config config;
    struct core core;
    /* Input of the next tick. Presses and coins remain until one tick has used them. */
    struct input input;
    struct output output;
    /* Strongest force on each poi during the ticks of the frame; see output_merge_force(). */
    struct poi_force felt[POI_MAX];
    struct scene scene;
    struct frame_pacer pace;
    struct poi_sampler samplers[POI_MAX];
    struct fan_sampler shades[SHADE_MAX];
    uint64_t sampled_ns; /* Time of the last device poll in nanoseconds. */
    /* Time of the next attempt to reopen a lost display. 0 means that the display is open. */
    uint64_t display_retry_ns;
    struct output_dimmer dimmer;
    struct output_camera camera;
    /* Value that was last sent to the pois: true if a dip scoops fish, false if the poi is only a
     * pointer. */
    bool scoops;
    struct view view; /* Camera view that was last sent to the display and the pois. */
    /* View of the camera at rest, from the last frame with ticks. The scene has the view of the
     * moving camera, also in frames without ticks. */
    struct view rest_view;
    /* Display settings (rotation, margins, brightness) that were last sent to the display and the
     * pois. */
    struct display_settings display_settings;
    struct saving saving;
    struct offline_flush late;
    struct output_audio voice;
    struct output_lines switches;
    /* Time at which a requested restart happens at the latest. Until then the restart waits for the
     * store. 0 means no request. */
    uint64_t restart_ns;
    /* Time until which a second press of the quit key ends the kiosk. 0 means no first press. */
    uint64_t quit_until_ns;
    /* Number of commands in `output` that the kiosk has already executed. output.command_count is
     * the number of all commands. */
    uint32_t sent_commands;
    /* Id of the round whose replay the operator wants to see. 0 means no request. */
    uint32_t wanted_replay_id;
    /* True if the operator has acknowledged the quarantined files but the health monitor has not
     * accepted the acknowledgement yet. */
    bool has_acknowledged;
    struct scene_machine machine; /* Newest result of the health monitor. */
    /* Reason why the frame loop must end (enum kiosk_end). KIOSK_RUNS while the loop continues. */
    uint8_t end;

    uint64_t frames;
    struct kiosk_faults faults;
    /* Number of frames at whose start a library had changed the floating-point control register.
     * The kiosk then restored the register. */
    uint32_t float_resets;
    struct operator_view_lines lines; /* Statistics of the button and coin lines. */
    /* Time between the starts of two consecutive frames, measured with `stopwatch`. */
    struct frame_timing frame_time;
    /* Duration of each call of kiosk_frame(), measured with `stopwatch`. */
    struct frame_timing work_time;
    /* Waiting time of each controller report: from the arrival of the report to the tick that uses
     * the report. */
    struct frame_timing report_wait;
    /* Total time in nanoseconds that was spent in ticks and in filling the scene. */
    uint64_t core_ns;
    uint64_t frame_begin_ns;
};

/* Initializes the kiosk and opens the pois, the fans and the sound card. The board must have opened
 * all other devices. Sets the calling thread's floating-point control register. Returns CORE_OK or
 * the error of core_init(). After an error the caller must not use `kiosk`. */
enum core_error kiosk_init(struct kiosk *kiosk, const struct hal *hal,
                           const struct kiosk_config *config);

/* Runs one displayed frame. Sets the calling thread's floating-point control register before the
 * ticks. Returns KIOSK_RUNS, or the reason why the frame loop ends. After a value other than
 * KIOSK_RUNS, the caller must not call the function again. */
enum kiosk_end kiosk_frame(struct kiosk *kiosk, const struct hal *hal);

/* Closes the store and counts its last faults. Call after the last frame. May block on the store.
 * Returns the number of lost ledger entries. An entry is lost if the store accepted it but did not
 * write it, or if the store refused it until the end. Without a store, no entry counts as lost. */
uint32_t kiosk_close_store(struct kiosk *kiosk, const struct hal *hal);

/* Sends the results of a frame with ticks to all devices except the display: plays sounds, sets
 * outputs, executes commands, sends forces and stores data. Counts faults. Sets kiosk->end if the
 * kiosk must restart. Defined in kiosk_outputs.c. */
void kiosk_send_results(struct kiosk *kiosk, const struct hal *hal);

/* Adds the number of writes that failed in the store's thread since the last call to the faults of
 * the store. Defined in kiosk_outputs.c. */
void kiosk_count_refused(struct kiosk *kiosk, const struct hal *hal);
