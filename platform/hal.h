/* hal.h -- one small table of functions per device, written for whoever writes the next driver.
 *
 * The frame loop (platform/kiosk/kiosk.h) is the only caller, from one thread. No call ever waits.
 * A driver exports one constructor that pairs its ops with its state. 0 or a count is success; a
 * negative enum hal_error is an event to count and survive, never a bug. A device that is not there
 * has a null driver (drivers/null.c), so no pointer here is ever null. */
#ifndef KINGYO_PLATFORM_HAL_H
#define KINGYO_PLATFORM_HAL_H

#include <stddef.h>
#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/placing.h"
#include "core/scene.h"

enum hal_error {
    HAL_OK = 0,
    HAL_ERR_IO = -1,   /* Failed this time; ask again next frame. */
    HAL_ERR_GONE = -2, /* Unplugged or vanished; open() again to look for it. */
    HAL_ERR_BUSY = -3, /* Not now; the same request next frame is right. */
    HAL_ERR_NONE = -4, /* There is no such device in this kiosk (the null driver's answer). */
};

/* Whether a device failed: HAL_ERR_NONE is the null driver's answer and HAL_ERR_BUSY a matter of
 * patience. */
static inline int hal_is_fault(int result)
{
    return result < 0 && result != HAL_ERR_NONE && result != HAL_ERR_BUSY;
}

/* Every device says in one line what it is, or what is missing and what to do about it:
 * "mouse (SDL x11)", "no sound: SDL found no audio device; plug one in or set SDL_AUDIODRIVER". */
#define HAL_TEXT_SIZE 160u

struct hal_clock_ops {
    uint64_t (*now_ns)(void *self); /* Monotonic, any epoch. */
    /* What the wall says, as input.day and input.minute: both 0 while it was plainly never set.
     * Null in a clock that only measures. */
    void (*civil)(void *self, uint16_t *day, uint16_t *minute);
};

/* Pixels of the newest presented frame, top row first. */
struct hal_image {
    uint32_t width, height;
    uint8_t *rgb;        /* Caller's buffer of `size` bytes. */
    size_t size;
};

/* What the windowing system said since the last poll. */
struct display_events {
    uint8_t quit;        /* The window was closed, or the session ends. */
    uint8_t lost;        /* Level: it went for good; nothing can be shown any more. */
    uint8_t upright;     /* Level: it is narrower than OVERLAY_UPRIGHT_ASPECT of its height. */
};

/* The smallest window, in points: below it no word can be read. A window manager may ignore the
 * limit, so that a display draws into a window of any size. */
#define HAL_WINDOW_WIDTH_MIN 320u
#define HAL_WINDOW_HEIGHT_MIN 240u
#define HAL_WINDOW_SIDE_MAX 8192u

struct hal_display_ops {
    /* Also reopens after HAL_ERR_GONE: the one call that may take long. */
    int (*open)(void *self);
    int (*poll)(void *self, struct display_events *out); /* When it fails, nothing is known. */
    int (*present)(void *self, const struct scene *scene);
    /* How the picture lies on the screen from the next one on. Copied. */
    void (*place)(void *self, const struct showing *showing);
    int (*toggle_full_screen)(void *self);
    /* Copies the picture last presented. HAL_ERR_IO: there is none, or `image` is too small for it:
     * its width and height then say what it needs. */
    int (*capture)(void *self, struct hal_image *image);
    void (*close)(void *self);
    const char *(*describe)(void *self);
};

/* One decoded reading of a hand: a pose and when it arrived. */
struct poi_sample {
    uint64_t time_ns;         /* Arrival, on the clock of hal_clock_ops. */
    uint8_t was_stamped;      /* 1: a report's own arrival; 0: made up, between two or at rest. */
    uint8_t has_wrist;
    uint8_t trembles;         /* As struct poi_input's. */
    struct poi_target target; /* Any bits that the device sent. */
};
#define HAL_POI_SAMPLES_MAX 64u /* 1,000 Hz reports over a 16 ms frame, with room for a slow one. */

struct hal_poi_ops {
    int (*open)(void *self);  /* Also reopens after HAL_ERR_GONE. */
    /* Copies at most `max` samples since the last poll, oldest first; returns how many. */
    int (*poll)(void *self, struct poi_sample *out, uint32_t max);
    /* The reaction on the hand: once a frame, the hardest blow of its ticks; see output_feel(). */
    int (*feel)(void *self, const struct poi_force *force);
    /* How the tank is looked at from now on, and how that lies on the screen: who points at a
     * picture needs it. Copied. */
    void (*look)(void *self, const struct view *view, const struct showing *showing);
    const char *(*describe)(void *self);
};

/* What one hand holds over the water beside its poi, or in place of one. */
struct hal_shade_ops {
    int (*open)(void *self);  /* Also reopens after HAL_ERR_GONE. */
    /* Where it is now; after every poi was polled, since a fan may share its device with one. */
    int (*poll)(void *self, struct shade_input *out);
    const char *(*describe)(void *self);
};

/* Levels now, and the edges since the last poll, debounced: a 20 ms coin pulse is not lost. */
#define HAL_MISSING_COIN (1u << INPUT_BUTTON_COUNT) /* The first coin line; the others follow. */
#define HAL_LINE_COUNT (INPUT_BUTTON_COUNT + COIN_LINE_COUNT)
struct button_sample {
    uint32_t held, pressed;   /* enum input_button */
    uint32_t raw;             /* Levels as they are before they count: the bits of `missing`. */
    struct line_sample {      /* By those bits. Since the last poll: */
        uint32_t edges;       /* every change of its level, bounces too, */
        uint32_t faults;      /* and its part of `faults`. */
    } line[HAL_LINE_COUNT];
    uint32_t coin_count[COIN_LINE_COUNT];
    uint32_t faults;          /* Since the last poll: coins that stick, edges that were lost, lines
                                 that went, or that were not there at the start. */
    uint32_t missing;         /* Of what is wired, that whose line is not there: enum input_button,
                                 and HAL_MISSING_COIN. */
    uint8_t quit;             /* A desktop's quit key; a cabinet has none. */
    uint8_t full_screen;      /* A desktop's full-screen key was pressed. */
};

struct hal_buttons_ops {
    int (*poll)(void *self, struct button_sample *out);
    const char *(*describe)(void *self);
};

/* Who sits where, in a kiosk that has more controllers than seats, or better ones from now on. */
struct hal_seats_ops {
    /* Once a frame, before the pois are asked. Only when `may_move`, between two games, may a seat
     * go to another controller while its own is there. Returns the seats that did, or whose own
     * came back, a bit (1 << seat) each: their poi and fan are to be opened again. */
    uint32_t (*arrange)(void *self, int may_move);
};

/* What the kiosk switches. */
enum hal_switch {
    HAL_START_LAMP = 0,
    HAL_COIN_LOCKOUT, /* Locked until it is first set. */
    HAL_TICKET,       /* One pulse, one ticket. */
    HAL_COIN_COUNTER, /* One pulse, one step of the meter. */
    HAL_SWITCH_COUNT,
};

/* A call that fails has done nothing of it: it is made again next frame when the answer was BUSY,
 * in a second when it was a fault, and not at all when it was NONE. */
struct hal_switches_ops {
    int (*set)(void *self, enum hal_switch which, int active);
    /* `count` more pulses, which the driver makes one after the other, in its own time. */
    int (*pulse)(void *self, enum hal_switch which, uint32_t count);
    const char *(*describe)(void *self);
    /* Returns how many of the pulses that pulse() took have not ended. One whose line is missing
     * has not. */
    uint32_t (*pending)(void *self, enum hal_switch which);
};

/* Controllers of which the operator may choose those that play: one row each. */
#define HAL_CONTROLLER_TEXT 48u
struct hal_controllers_ops {
    /* Level: what there is, and how learning goes. Once a frame. */
    int (*poll)(void *self, struct desk_input *out);
    /* "057e:2009 Pro Controller, port 3-1.2"; "" for a row without one. UTF-8. */
    const char *(*name)(void *self, uint32_t row);
    int (*order)(void *self, const struct desk_order *order);
    const char *(*describe)(void *self);
};

struct hal_audio_ops {
    int (*open)(void *self);
    int (*play)(void *self, const struct sound_event *event);
    const char *(*describe)(void *self);
    void (*close)(void *self);
};

struct memory; /* core/memory.h */

/* What became of a purse: units that were owed may be credits by now. */
struct purse_step {
    struct purse from, to;
};

struct hal_storage_ops {
    int (*open)(void *self);
    /* At start: what earlier evenings left, with ledger.boots of this start. A setting that the
     * menu never turned, and all else where there is no store, is left as `out` has it. */
    int (*remember)(void *self, struct memory *out);
    /* The next entry, by rising ids. Copies; BUSY: next frame. */
    int (*keep)(void *self, const struct ledger_entry *entry);
    uint32_t (*saved_id)(void *self); /* Newest entry known to be on disk; never goes back. */
    /* The replay of the round whose entry is `round_id`, known to be worth one. `bytes` are lent
     * until replay_kept_id() is that id, or a later keep_replay() is taken. BUSY: one is being
     * written. */
    int (*keep_replay)(void *self, uint32_t round_id, const uint8_t *bytes, size_t size);
    uint32_t (*replay_kept_id)(void *self); /* Newest that was written, or given up. */
    /* Asks for the replay of a round, and for the ledger's entry of it; `bytes`, `size` of them,
     * and `round` are lent until replay_fetched() is no longer BUSY: the replay's size, or
     * HAL_ERR_NONE where there is none. The entry's id is 0 where the ledger has it no more. */
    int (*fetch_replay)(void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                        struct ledger_entry *round);
    int (*replay_fetched)(void *self);
    int (*has_replay)(void *self, uint32_t round_id); /* 1: a ranked round's is on disk. */
    int (*keep_edit)(void *self, const struct edit_record *edit); /* As keep(). */
    uint32_t (*kept_edit_id)(void *self);                      /* As saved_id(). */
    int (*refuses_edits)(void *self); /* 1: no edit can be kept, or the last try failed. */
    uint32_t (*refused_count)(void *self);      /* Writes that failed since open(). */
    int (*is_well)(void *self); /* 1: entries are kept, and the last went well. */
    /* 1: there was no store at the start, and there is one now that only another start can go on
     * from. */
    int (*wants_restart)(void *self);
    /* For that one: what people paid meanwhile, 1 .. 16 entries and what its purse changes by.
     * Ids, boot and purse of the entries are filled in there. Copies; BUSY: others are on their
     * way. */
    int (*hand_over)(void *self, const struct purse_step *step,
                     const struct ledger_entry *entries, uint32_t count);
    int (*handed_over)(void *self); /* OK: all that hand_over() took is on disk; else BUSY. */
    const char *(*describe)(void *self);
    /* Writes what keep() and keep_edit() took, which may wait a few seconds; returns how many of
     * them it could not. */
    uint32_t (*close)(void *self);
};

struct hal_watchdog_ops {
    void (*kick)(void *self);
    uint8_t (*watches)(void *self); /* enum scene_watch: whether anybody would miss a kick. */
    const char *(*describe)(void *self);
};

/* clang-format off */
struct hal_clock { const struct hal_clock_ops *ops; void *self; };
struct hal_display { const struct hal_display_ops *ops; void *self; };
struct hal_poi { const struct hal_poi_ops *ops; void *self; };
struct hal_shade { const struct hal_shade_ops *ops; void *self; };
struct hal_seats { const struct hal_seats_ops *ops; void *self; };
struct hal_buttons { const struct hal_buttons_ops *ops; void *self; };
struct hal_switches { const struct hal_switches_ops *ops; void *self; };
struct hal_controllers { const struct hal_controllers_ops *ops; void *self; };
struct hal_audio { const struct hal_audio_ops *ops; void *self; };
struct hal_storage { const struct hal_storage_ops *ops; void *self; };
struct hal_watchdog { const struct hal_watchdog_ops *ops; void *self; };
/* clang-format on */

/* By that clock; 0 where there is none. */
static inline uint64_t hal_now_ns(struct hal_clock clock)
{
    return clock.ops ? clock.ops->now_ns(clock.self) : 0;
}

struct hal {
    struct hal_clock clock;
    struct hal_display display;
    struct hal_poi poi[POI_MAX];
    struct hal_shade shade[SHADE_MAX];
    struct hal_seats seats;
    struct hal_buttons buttons;
    struct hal_switches switches;
    struct hal_controllers controllers;
    struct hal_audio audio;
    struct hal_storage storage;
    struct hal_watchdog watchdog;
};

#endif
