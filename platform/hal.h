/* hal.h -- the hardware abstraction layer (HAL): one table of functions per device.
 *
 * The frame loop (platform/kiosk/kiosk.h) is the only caller, always from the same thread. No
 * function blocks, unless its comment permits blocking. A driver exports one constructor that
 * returns its table of functions and a pointer to its state. A return value of 0 or more means
 * success. A negative enum hal_error is a run-time event that the caller counts before it
 * continues. An absent device gets a null driver (drivers/null.c). No function pointer is null,
 * unless its comment permits null.
 *
 * A poi is the paper scoop and the controller that moves it. A slot is the place of one of up to
 * four controllers. A tick is 1/120 s. The ledger is the append-only list of money events and
 * rounds. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/display_geometry.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define NS_PER_S 1000000000ull
#define NS_PER_MS 1000000ull

enum hal_error {
    HAL_OK = 0,
    HAL_ERR_IO = -1,     /* The call failed. The caller repeats the call in the next frame. */
    HAL_ERR_GONE = -2,   /* The device was unplugged. The caller retries with open(). */
    HAL_ERR_BUSY = -3,   /* The device is busy. The caller repeats the call in the next frame. */
    HAL_ERR_ABSENT = -4, /* The kiosk has no device of this type (null driver). */
};

/* Returns true if `result` is a device fault. HAL_ERR_ABSENT (null driver) and
 * HAL_ERR_BUSY (busy device) are not faults. */
static inline bool hal_is_fault(int result)
{
    return result < 0 && result != HAL_ERR_ABSENT && result != HAL_ERR_BUSY;
}

/* Size in bytes of a text of describe(). describe() returns one line that names the device, or that
 * states what is missing and how to repair it. Examples: "mouse (SDL x11)" and "no sound: SDL found
 * no audio device; plug one in or set SDL_AUDIODRIVER". */
#define HAL_TEXT_SIZE 160u

struct hal_clock_ops {
    /* Returns the monotonic time in nanoseconds since an arbitrary start. */
    uint64_t (*now_ns)(void *self);
    /* Writes the local date and time of day in the units of input.day and input.minute. Writes 0 to
     * both if the system clock was never set. The pointer is null in a clock that only measures
     * durations. */
    void (*civil)(void *self, uint16_t *day, uint16_t *minute);
};

/* Pixels of the frame that was presented last, top row first. */
struct hal_image {
    uint32_t width, height;
    uint8_t *rgb; /* Buffer of `size` bytes, owned by the caller. */
    size_t size;
};

/* Events of the windowing system since the last poll. */
struct display_events {
    bool quit; /* True if the user closed the window or the desktop session ends. */
    bool lost; /* True in every poll after the display was lost permanently. */
    /* True while width / height of the window is less than POINTER_UPRIGHT_ASPECT. */
    bool upright;
};

/* Minimum and maximum size of a window in points (the coordinates of the windowing system). Text is
 * unreadable in a window below the minimum. A window manager may ignore the minimum, therefore a
 * display must support any window size. */
#define HAL_WINDOW_WIDTH_MIN 320u
#define HAL_WINDOW_HEIGHT_MIN 240u
#define HAL_WINDOW_SIDE_MAX 8192u

struct hal_display_ops {
    /* Opens the display, and reopens it after HAL_ERR_GONE. May block for a long time. */
    int (*open)(void *self);
    /* Writes the events since the last poll to `out`. After an error, `out` is invalid. */
    int (*poll)(void *self, struct display_events *out);
    /* Draws `scene` and presents the frame. May wait for the screen's vertical synchronization. */
    int (*present)(void *self, const struct scene *scene);
    /* Sets the rotation, margins and brightness of the picture on the screen for all later frames.
     * Copies `display_settings`. */
    void (*set_transform)(void *self, const struct display_settings *display_settings);
    /* Switches between window mode and full-screen mode. */
    int (*toggle_full_screen)(void *self);
    /* Copies the frame that was presented last. Returns HAL_ERR_IO if there is no frame, or if the
     * buffer of `image` is too small. If the buffer is too small, sets the width and height of
     * `image` to the required size. */
    int (*capture)(void *self, struct hal_image *image);
    void (*close)(void *self);
    const char *(*describe)(void *self);
};

/* One decoded controller report: a pose and its arrival time. */
struct poi_sample {
    uint64_t time_ns; /* Arrival time in nanoseconds on the clock of hal_clock_ops. */
    /* True if the controller sent a report at `time_ns`. False if the driver computed the sample
     * itself, either between two reports or for a controller at rest. */
    bool was_stamped;
    bool has_wrist; /* True if the controller measures angles. */
    /* True if the sensor is noisy. Identical values in consecutive samples then mean that the
     * sensor is frozen. */
    bool trembles;
    /* Pose from the device, not validated. Each float may have any bit pattern. */
    struct poi_target target;
};
/* Maximum number of samples that one poll returns. A 1,000 Hz controller sends 16 samples in a
 * 16 ms frame. The other 48 are a reserve for slow frames. */
#define HAL_POI_SAMPLES_MAX 64u

struct hal_poi_ops {
    int (*open)(void *self); /* Opens the device, and reopens it after HAL_ERR_GONE. */
    /* Copies at most `max` samples that arrived since the last poll, oldest first. Returns the
     * number of copied samples. */
    int (*poll)(void *self, struct poi_sample *out, uint32_t max);
    /* Sets the force feedback. The kiosk calls set_force() once per frame, with the strongest force
     * of all ticks in the frame (output_merge_force()). */
    int (*set_force)(void *self, const struct poi_force *force);
    /* Sets the camera view and the display settings for all later samples. A pointer device uses
     * both to convert a screen position to a tank position. Copies both structures. `scoops` is
     * true while a dip scoops fish, and false while a dip presses an item on a page. */
    void (*set_view)(void *self, const struct view *view,
                     const struct display_settings *display_settings, bool scoops);
    const char *(*describe)(void *self);
};

/* Functions of a fan device. A player holds the fan above the water, beside a poi or instead of a
 * poi. */
struct hal_fan_ops {
    int (*open)(void *self); /* Opens the device, and reopens it after HAL_ERR_GONE. */
    /* Writes the fan's current position. The kiosk calls poll() after it has polled all pois,
     * because one device may report both a fan and a poi. */
    int (*poll)(void *self, struct shade_input *out);
    const char *(*describe)(void *self);
};

/* Bit of the first coin line in `missing` and `raw`. The bits of the other coin lines follow. */
#define HAL_MISSING_COIN (1u << INPUT_BUTTON_COUNT)
/* Number of lines with a bit in `missing` and `raw`: all buttons and all coin lines. */
#define HAL_LINE_COUNT (INPUT_BUTTON_COUNT + COIN_LINE_COUNT)

/* State of the buttons and coin lines. `pressed` and `coin_count` are debounced and cover the time
 * since the last poll, so that a coin pulse of 20 ms is not lost. */
struct button_sample {
    /* Buttons held now, and buttons pressed since the last poll: bits of enum input_button. */
    uint32_t held, pressed;
    /* Levels of all lines before debouncing. The bits are those of `missing`. */
    uint32_t raw;
    /* Counts of one line since the last poll. The array index is the bit number of the line in
     * `missing`. */
    struct line_sample {
        uint32_t edges; /* Level changes of the line, including contact bounces. */
        /* Faults of the line. The sum over all lines is `faults` of struct button_sample. */
        uint32_t faults;
    } line[HAL_LINE_COUNT];
    uint32_t coin_count[COIN_LINE_COUNT];
    /* Line faults since the last poll: stuck coin inputs, lost edges, and lines that disappeared or
     * were absent at program start. */
    uint32_t faults;
    /* Configured inputs whose GPIO line does not exist. The bits are those of enum input_button
     * and, for coin lines, HAL_MISSING_COIN. */
    uint32_t missing;
    /* True if the quit key of a desktop keyboard was pressed. Always false in a cabinet. */
    bool quit;
    bool full_screen; /* True if the full-screen key of a desktop keyboard was pressed. */
};

struct hal_buttons_ops {
    int (*poll)(void *self, struct button_sample *out);
    const char *(*describe)(void *self);
};

/* Functions that assign controllers to player slots. The assignment changes if the kiosk has more
 * controllers than slots, or if a better controller is connected. */
struct hal_slots_ops {
    /* Assigns controllers to slots. The kiosk calls arrange() once per frame, before it polls the
     * pois. The kiosk passes true as `may_move` between two games and false during a game. If
     * `may_move` is false, a slot with a connected controller keeps that controller. Returns a bit
     * (1 << slot) for each slot whose controller changed or was reconnected. arrange() also
     * replaces the poi and the fan of each changed slot in struct hal. The caller must reopen the
     * poi and the fan of each returned slot, and set the view of the poi. */
    uint32_t (*arrange)(void *self, bool may_move);
};

/* Outputs that the kiosk switches on and off. */
enum hal_switch {
    HAL_START_LAMP = 0,
    HAL_COIN_LOCKOUT, /* Coin lockout. The driver rejects coins until the first call of set(). */
    HAL_TICKET,       /* Ticket dispenser. One pulse issues one ticket. */
    HAL_COIN_COUNTER, /* Coin counter. One pulse advances the counter by one. */
    HAL_SWITCH_COUNT,
};

/* Functions for switched outputs. A failed call has no effect. The caller repeats a failed call
 * in the next frame after HAL_ERR_BUSY, after one second on a fault, and never after
 * HAL_ERR_ABSENT. */
struct hal_switches_ops {
    /* Switches a lamp or the coin lockout on if `active` is true. Otherwise switches it off. */
    int (*set)(void *self, enum hal_switch which, bool active);
    /* Queues `count` additional pulses. The driver sends all queued pulses one after another at the
     * rate of the driver. */
    int (*pulse)(void *self, enum hal_switch which, uint32_t count);
    const char *(*describe)(void *self);
    /* Returns the number of pulses that pulse() accepted and that are not yet complete. Pulses for
     * a missing line remain pending. */
    uint32_t (*pending)(void *self, enum hal_switch which);
};

/* Size in bytes of a controller's name. The operator's menu has one row for each controller, in
 * which the operator selects the controllers that may play. */
#define HAL_CONTROLLER_TEXT 48u
struct hal_controllers_ops {
    /* Writes the connected controllers and the state of the learn wizard, which learns the mapping
     * of an unknown controller. The kiosk calls poll() once per frame. */
    int (*poll)(void *self, struct controller_status *out);
    /* Returns a UTF-8 name, for example "057e:2009 Pro Controller, port 3-1.2", or "" for an empty
     * row. */
    const char *(*name)(void *self, uint32_t row);
    /* Executes a command that the operator's menu sends to a controller. */
    int (*command)(void *self, const struct controller_command *command);
    const char *(*describe)(void *self);
};

struct hal_audio_ops {
    int (*open)(void *self);
    /* Starts a sound. Never blocks. Returns HAL_ERR_BUSY and drops the sound if the queue is
     * full. */
    int (*play)(void *self, const struct sound_event *event);
    /* Sets the levels of effects, music and surroundings. Never blocks. */
    void (*set_levels)(void *self, const struct sound_levels *levels);
    const char *(*describe)(void *self);
    void (*close)(void *self);
};

struct persistent_state; /* Defined in core/persistent_state.h. */

/* Credit balances before (`from`) and after (`to`) a change. Some coin units of `from` may have
 * become credits in `to`. */
struct balance_change {
    struct balance from, to;
};

/* Functions of the ledger, the append-only list of money events and rounds, and of the disk that
 * holds the ledger, the replays and the edits. */
struct hal_ledger_ops {
    /* Opens the ledger, the replay store and the edit store. */
    int (*open)(void *self);
    /* Loads the persistent state at program start. Sets ledger.boots to the number of program
     * starts so far, including this one. A setting that was never changed in the menu keeps its
     * value in `out`. If there is no store, leaves `out` unchanged. */
    int (*load)(void *self, struct persistent_state *out);
    /* Queues the next ledger entry. Each entry's id must be greater than the previous id. Copies
     * `entry`. Returns HAL_ERR_BUSY if the queue is full; the caller retries in the next frame. */
    int (*append)(void *self, const struct ledger_entry *entry);
    /* Returns the id of the newest ledger entry that is on disk. The value never decreases. */
    uint32_t (*committed_id)(void *self);
    /* Returns the number of writes of entries, replays and edits that failed since open(). */
    uint32_t (*failed_count)(void *self);
    /* Returns true if entries are stored and the last write succeeded. */
    bool (*is_healthy)(void *self);
    /* Returns true if there was no store at program start and a store is available now. The program
     * must restart to use the new store. */
    bool (*needs_restart)(void *self);
    /* Adds the coins that were inserted while there was no store. The coins are added to the new
     * store that needs_restart() reported. `entries` has 1 .. 16 ledger entries for these coins.
     * `step` is the change of the credit balance. The store sets the ids, boot numbers and balances
     * of the entries. Copies all arguments. Returns HAL_ERR_BUSY while earlier entries are being
     * written. */
    int (*merge_offline)(void *self, const struct balance_change *step,
                         const struct ledger_entry *entries, uint32_t count);
    /* Returns HAL_OK if all entries accepted by merge_offline() are on disk, otherwise
     * HAL_ERR_BUSY. */
    int (*offline_merged)(void *self);
    const char *(*describe)(void *self);
    /* Writes the entries and edits that append() and hal_edit_store_ops.store() accepted, then
     * closes all three stores. May block for a few seconds. Returns the number of entries and edits
     * that could not be written. */
    uint32_t (*close)(void *self);
};

/* Functions of the store of replays. Only ranked rounds have a replay. A replay is identified by
 * the id of its round's ledger entry. */
struct hal_replay_store_ops {
    /* Stores the replay of the round `round_id`. The caller must not change `bytes` until
     * stored_id() returns `round_id`, or until a later call of store() is accepted. Returns
     * HAL_ERR_BUSY while another replay is being written. */
    int (*store)(void *self, uint32_t round_id, const uint8_t *bytes, size_t size);
    /* Returns the id of the newest round whose replay was written or abandoned. */
    uint32_t (*stored_id)(void *self);
    /* Starts to load the replay of a round into `bytes` (of `size` bytes), and the round's ledger
     * entry into `round`. Both buffers must stay valid while fetched() returns HAL_ERR_BUSY. Sets
     * the id of `round` to 0 if the ledger no longer has the entry. */
    int (*fetch)(void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                 struct ledger_entry *round);
    /* Returns the size in bytes of the loaded replay, HAL_ERR_BUSY while the replay is being
     * loaded, or HAL_ERR_ABSENT if there is no such replay. */
    int (*fetched)(void *self);
    /* Returns true if the replay of the ranked round `round_id` is on disk. */
    bool (*has)(void *self, uint32_t round_id);
};

/* Functions of the store of edits. An edit is a change of a fish's deformation graphs that a player
 * makes in the growth lab (a page of the kiosk). */
struct hal_edit_store_ops {
    /* Queues an edit. Copies `edit`. Returns HAL_ERR_BUSY if the queue is full; the caller retries
     * in the next frame. */
    int (*store)(void *self, const struct graph_edit_record *edit);
    /* Returns the id of the newest edit that is on disk. */
    uint32_t (*stored_id)(void *self);
    /* Returns true if edits cannot be stored, or if the last write of an edit failed. */
    bool (*has_failed)(void *self);
};

struct hal_watchdog_ops {
    /* Notifies the watchdog that the kiosk runs. The kiosk calls kick() once in each frame in which
     * the game advanced by at least one tick. */
    void (*kick)(void *self);
    /* Returns a value of enum scene_watch: whether the service manager restarts the kiosk if kick()
     * is not called. */
    uint8_t (*watches)(void *self);
    const char *(*describe)(void *self);
};

/* clang-format off */
struct hal_clock { const struct hal_clock_ops *ops; void *self; };
struct hal_display { const struct hal_display_ops *ops; void *self; };
struct hal_poi { const struct hal_poi_ops *ops; void *self; };
struct hal_fan { const struct hal_fan_ops *ops; void *self; };
struct hal_slots { const struct hal_slots_ops *ops; void *self; };
struct hal_buttons { const struct hal_buttons_ops *ops; void *self; };
struct hal_switches { const struct hal_switches_ops *ops; void *self; };
struct hal_controllers { const struct hal_controllers_ops *ops; void *self; };
struct hal_audio { const struct hal_audio_ops *ops; void *self; };
struct hal_ledger { const struct hal_ledger_ops *ops; void *self; };
struct hal_replay_store { const struct hal_replay_store_ops *ops; void *self; };
struct hal_edit_store { const struct hal_edit_store_ops *ops; void *self; };
struct hal_watchdog { const struct hal_watchdog_ops *ops; void *self; };
/* clang-format on */

/* The HAL devices that one controller provides. One constructor returns all of them. */
struct hal_controller_devices {
    struct hal_poi poi;
    struct hal_fan fan;
    struct hal_buttons buttons;
};

/* The three stores in one data folder. One constructor returns all of them. */
struct hal_storage {
    struct hal_ledger ledger;
    struct hal_replay_store replays;
    struct hal_edit_store edits;
};

/* Returns the clock's time in nanoseconds, or 0 if there is no clock. */
static inline uint64_t hal_now_ns(struct hal_clock clock)
{
    return clock.ops ? clock.ops->now_ns(clock.self) : 0;
}

struct hal {
    struct hal_clock clock;
    struct hal_display display;
    struct hal_poi poi[POI_MAX];
    struct hal_fan fan[SHADE_MAX];
    struct hal_slots slots;
    struct hal_buttons buttons;
    struct hal_switches switches;
    struct hal_controllers controllers;
    struct hal_audio audio;
    struct hal_storage storage;
    struct hal_watchdog watchdog;
};
