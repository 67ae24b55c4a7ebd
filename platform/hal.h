/* hal.h -- the hardware abstraction layer: one small table of functions per device.
 *
 * The frame loop (platform/kiosk/kiosk.h) is the only caller, always from the same thread. No call
 * blocks, except where its comment allows it. A driver exports one constructor that pairs its ops
 * with its state. A return value of 0 or a count means success. A negative enum hal_error is a
 * run-time event that the caller counts and survives. A device that is absent gets a null driver
 * (drivers/null.c), so that no pointer here is null unless its comment allows it. */
#ifndef KINGYO_PLATFORM_HAL_H
#define KINGYO_PLATFORM_HAL_H

#include <stddef.h>
#include <stdint.h>

#include "core/display_geometry.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

enum hal_error {
    HAL_OK = 0,
    HAL_ERR_IO = -1,     /* The call failed this time; retry next frame. */
    HAL_ERR_GONE = -2,   /* The device was unplugged; retry with open(). */
    HAL_ERR_BUSY = -3,   /* The device is busy; repeat the call next frame. */
    HAL_ERR_ABSENT = -4, /* This kiosk has no such device (null driver). */
};

/* Returns 1 if `result` is a device fault. HAL_ERR_ABSENT (null driver) and HAL_ERR_BUSY (retry
 * next frame) are no faults. */
static inline int hal_is_fault(int result)
{
    return result < 0 && result != HAL_ERR_ABSENT && result != HAL_ERR_BUSY;
}

/* Size in bytes of a describe() text. Each device describes itself in one line, or states what is
 * missing and how to fix it. Examples: "mouse (SDL x11)", "no sound: SDL found no audio device;
 * plug one in or set SDL_AUDIODRIVER". */
#define HAL_TEXT_SIZE 160u

struct hal_clock_ops {
    uint64_t (*now_ns)(void *self); /* Monotonic time in nanoseconds, with any epoch. */
    /* Writes the local date and time of day in the units of input.day and input.minute. Both are 0
     * if the system clock was evidently never set. Null in a clock that only measures. */
    void (*civil)(void *self, uint16_t *day, uint16_t *minute);
};

/* Pixels of the frame presented last, top row first. */
struct hal_image {
    uint32_t width, height;
    uint8_t *rgb; /* Buffer of `size` bytes, owned by the caller. */
    size_t size;
};

/* Events of the windowing system since the last poll. */
struct display_events {
    uint8_t quit;    /* 1 if the user closed the window or the session ends. */
    uint8_t lost;    /* Level: 1 if the display is lost for good and can show nothing more. */
    uint8_t upright; /* Level: 1 if width / height is below POINTER_UPRIGHT_ASPECT. */
};

/* Smallest window size in points; below this size the text is unreadable. A window manager may
 * ignore the limit, therefore a display must draw into a window of any size. */
#define HAL_WINDOW_WIDTH_MIN 320u
#define HAL_WINDOW_HEIGHT_MIN 240u
#define HAL_WINDOW_SIDE_MAX 8192u

struct hal_display_ops {
    /* Opens the display, and reopens it after HAL_ERR_GONE. May block for a long time. */
    int (*open)(void *self);
    int (*poll)(void *self, struct display_events *out); /* On an error, `out` is invalid. */
    /* Draws a scene and presents it. May wait for the screen's vertical sync. */
    int (*present)(void *self, const struct scene *scene);
    /* Sets how the picture is transformed to the screen from the next present() on. Copies
     * `display_settings`. */
    void (*set_transform)(void *self, const struct display_settings *display_settings);
    /* Switches between window and full screen. */
    int (*toggle_full_screen)(void *self);
    /* Copies the picture presented last. Returns HAL_ERR_IO if there is no picture, or if `image`
     * is too small. In the second case the width and height of `image` are set to the required
     * size. */
    int (*capture)(void *self, struct hal_image *image);
    void (*close)(void *self);
    const char *(*describe)(void *self);
};

/* One decoded controller report: a pose and its arrival time. */
struct poi_sample {
    uint64_t time_ns;    /* Arrival time on the clock of hal_clock_ops. */
    uint8_t was_stamped; /* 1: time of a real report; 0: time of a synthesized sample, between
                            two reports or at rest. */
    uint8_t has_wrist;
    uint8_t trembles;         /* As in struct poi_input. */
    struct poi_target target; /* Unvalidated values from the device, with any bit pattern. */
};
/* Enough for 1,000 Hz reports over a 16 ms frame, with reserve for a slow frame. */
#define HAL_POI_SAMPLES_MAX 64u

struct hal_poi_ops {
    int (*open)(void *self); /* Opens the device, and reopens it after HAL_ERR_GONE. */
    /* Copies at most `max` samples that arrived since the last poll, oldest first. Returns their
     * number. */
    int (*poll)(void *self, struct poi_sample *out, uint32_t max);
    /* Sets the force feedback. Called once a frame with the strongest force of its ticks; see
     * output_merge_force(). */
    int (*set_force)(void *self, const struct poi_force *force);
    /* Sets the camera view and the display transform from now on. A pointer device needs both to
     * map a screen position to the tank. Copies both. */
    void (*set_view)(void *self, const struct view *view,
                     const struct display_settings *display_settings);
    const char *(*describe)(void *self);
};

/* A fan: a device that a player holds over the water beside the poi or in place of a poi. */
struct hal_fan_ops {
    int (*open)(void *self); /* Opens the device, and reopens it after HAL_ERR_GONE. */
    /* Writes the current position. Called after all pois were polled because a fan may share its
     * device with a poi. */
    int (*poll)(void *self, struct shade_input *out);
    const char *(*describe)(void *self);
};

/* The bit of the first coin line; the other coin lines follow. */
#define HAL_MISSING_COIN (1u << INPUT_BUTTON_COUNT)
#define HAL_LINE_COUNT (INPUT_BUTTON_COUNT + COIN_LINE_COUNT)

/* Button levels now, and the debounced edges since the last poll. A coin pulse of 20 ms is not
 * lost. */
struct button_sample {
    uint32_t held, pressed; /* Bits of enum input_button. */
    uint32_t raw;           /* Levels before debouncing; same bits as `missing`. */
    struct line_sample {    /* Counts since the last poll, indexed by the bit numbers of
                               `missing`. */
        uint32_t edges;     /* Level changes, including contact bounces. */
        uint32_t faults;    /* Share of this line in `faults` below. */
    } line[HAL_LINE_COUNT];
    uint32_t coin_count[COIN_LINE_COUNT];
    uint32_t faults;     /* Line faults since the last poll: stuck coin inputs, lost edges, lines
                            that disappeared or were absent at the start. */
    uint32_t missing;    /* Wired inputs whose GPIO line is absent: bits of enum input_button,
                            and HAL_MISSING_COIN. */
    uint8_t quit;        /* 1: the quit key of a desktop was pressed. Always 0 in a cabinet. */
    uint8_t full_screen; /* 1: the full-screen key of a desktop was pressed. */
};

struct hal_buttons_ops {
    int (*poll)(void *self, struct button_sample *out);
    const char *(*describe)(void *self);
};

/* Assigns controllers to player slots when the kiosk has more controllers than slots, or when a
 * better controller is connected. */
struct hal_seats_ops {
    /* Assigns controllers to slots. Called once a frame, before the pois are polled. A slot whose
     * controller is still connected changes only if `may_move` is 1, which is so between two games.
     * Returns a bit (1 << slot) for each slot that changed, or whose own controller was
     * reconnected. The caller must reopen the poi and the fan of these slots. */
    uint32_t (*arrange)(void *self, int may_move);
};

/* Outputs that the kiosk switches. */
enum hal_switch {
    HAL_START_LAMP = 0,
    HAL_COIN_LOCKOUT, /* Locked until it is first set. */
    HAL_TICKET,       /* One pulse issues one ticket. */
    HAL_COIN_COUNTER, /* One pulse advances the meter by one. */
    HAL_SWITCH_COUNT,
};

/* Switched outputs. A call that fails has no effect. The caller repeats it next frame after
 * HAL_ERR_BUSY, after one second on a fault, and never after HAL_ERR_ABSENT. */
struct hal_switches_ops {
    /* Sets the level of a lamp or of the coin lockout. */
    int (*set)(void *self, enum hal_switch which, int active);
    /* Queues `count` more pulses. The driver issues the pulses one after another at its own
     * rate. */
    int (*pulse)(void *self, enum hal_switch which, uint32_t count);
    const char *(*describe)(void *self);
    /* Returns the number of pulses accepted by pulse() that have not ended. Pulses on a missing
     * line remain pending. */
    uint32_t (*pending)(void *self, enum hal_switch which);
};

/* Size in bytes of a controller's name. The operator chooses which controllers play; each
 * controller has one row in the menu. */
#define HAL_CONTROLLER_TEXT 48u
struct hal_controllers_ops {
    /* Writes the connected controllers and the state of mapping learning (levels). Called once a
     * frame. */
    int (*poll)(void *self, struct controller_status *out);
    /* Returns a UTF-8 name, for example "057e:2009 Pro Controller, port 3-1.2", or "" for an empty
     * row. */
    const char *(*name)(void *self, uint32_t row);
    /* Executes a command of the operator on a controller. */
    int (*command)(void *self, const struct controller_command *command);
    const char *(*describe)(void *self);
};

struct hal_audio_ops {
    int (*open)(void *self);
    /* Starts a sound. Never blocks. Returns HAL_ERR_BUSY if the queue is full; the sound is
     * lost. */
    int (*play)(void *self, const struct sound_event *event);
    const char *(*describe)(void *self);
    void (*close)(void *self);
};

struct persistent_state; /* Defined in core/persistent_state.h. */

/* Change of the balance. Units that were due may have become credits in between. */
struct balance_change {
    struct balance from, to;
};

struct hal_storage_ops {
    int (*open)(void *self);
    /* Loads the persistent state at start, with ledger.boots of this start. A setting that was
     * never changed in the menu keeps its value in `out`. Without a store, all of `out` is left
     * unchanged. */
    int (*load)(void *self, struct persistent_state *out);
    /* Queues the next ledger entry; ids must rise. Copies `entry`. Returns HAL_ERR_BUSY if the
     * queue is full; the caller retries next frame. */
    int (*append)(void *self, const struct ledger_entry *entry);
    uint32_t (*saved_id)(void *self); /* Returns the id of the newest entry known to be on disk. The
                                         value never decreases. */
    /* Stores the replay of the round whose entry is `round_id`; only ranked rounds have a
     * replay. The caller must keep `bytes` unchanged until stored_replay_id() returns this id, or
     * until a later store_replay() is accepted. Returns HAL_ERR_BUSY while another replay is
     * being written. */
    int (*store_replay)(void *self, uint32_t round_id, const uint8_t *bytes, size_t size);
    uint32_t (*stored_replay_id)(void *self); /* Returns the newest round id whose replay was
                                                 written or abandoned. */
    /* Starts to load the replay of a round and its ledger entry. The buffers `bytes` (of `size`
     * bytes) and `round` must stay valid while replay_fetched() returns HAL_ERR_BUSY. Afterwards
     * replay_fetched() returns the replay's size in bytes, or HAL_ERR_ABSENT if there is no replay.
     * The entry's id is 0 if the ledger no longer has the entry. */
    int (*fetch_replay)(void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                        struct ledger_entry *round);
    int (*replay_fetched)(void *self);
    int (*has_replay)(void *self, uint32_t round_id); /* Returns 1 if the replay of this ranked
                                                         round is on disk. */
    int (*store_edit)(void *self, const struct graph_edit_record *edit); /* As append(). */
    uint32_t (*stored_edit_id)(void *self);                              /* As saved_id(). */
    int (*edits_failed)(void *self);       /* Returns 1 if edits cannot be stored, or if the last
                                              attempt failed. */
    uint32_t (*refused_count)(void *self); /* Returns the number of writes that failed since
                                              open(). */
    int (*is_healthy)(
        void *self); /* Returns 1 if entries are stored and the last write succeeded. */
    /* Returns 1 if there was no store at the start and a store has appeared since. Only a restart
     * can use the new store. */
    int (*wants_restart)(void *self);
    /* Adds offline credits to the store of wants_restart(): 1 .. 16 entries for coins inserted
     * without a store, and the change of the balance. The store fills in the ids, boot and balance
     * of the entries. Copies all arguments. Returns HAL_ERR_BUSY while earlier entries are being
     * written. */
    int (*merge_offline)(void *self, const struct balance_change *step,
                         const struct ledger_entry *entries, uint32_t count);
    int (*offline_merged)(void *self); /* Returns HAL_OK if all entries accepted by
                                          merge_offline() are on disk, else HAL_ERR_BUSY. */
    const char *(*describe)(void *self);
    /* Writes the entries accepted by append() and store_edit(), and closes the store. May block for
     * a few seconds. Returns the number of entries and edits that could not be written. */
    uint32_t (*close)(void *self);
};

struct hal_watchdog_ops {
    /* Notifies the watchdog that the kiosk runs. Called once in each frame that had ticks. */
    void (*kick)(void *self);
    uint8_t (*watches)(void *self); /* Returns an enum scene_watch: whether missing kicks restart
                                       the kiosk. */
    const char *(*describe)(void *self);
};

/* clang-format off */
struct hal_clock { const struct hal_clock_ops *ops; void *self; };
struct hal_display { const struct hal_display_ops *ops; void *self; };
struct hal_poi { const struct hal_poi_ops *ops; void *self; };
struct hal_fan { const struct hal_fan_ops *ops; void *self; };
struct hal_seats { const struct hal_seats_ops *ops; void *self; };
struct hal_buttons { const struct hal_buttons_ops *ops; void *self; };
struct hal_switches { const struct hal_switches_ops *ops; void *self; };
struct hal_controllers { const struct hal_controllers_ops *ops; void *self; };
struct hal_audio { const struct hal_audio_ops *ops; void *self; };
struct hal_storage { const struct hal_storage_ops *ops; void *self; };
struct hal_watchdog { const struct hal_watchdog_ops *ops; void *self; };
/* clang-format on */

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
    struct hal_seats seats;
    struct hal_buttons buttons;
    struct hal_switches switches;
    struct hal_controllers controllers;
    struct hal_audio audio;
    struct hal_storage storage;
    struct hal_watchdog watchdog;
};

#endif
