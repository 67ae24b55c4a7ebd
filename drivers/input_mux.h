/* input_mux.h -- the input multiplexer: assigns controllers to the players' slots.
 *
 * Controllers (sources) come and go while the kiosk runs. For example, a USB poi is plugged in,
 * or the battery of a pad is empty. Each slot is a fixed device of struct hal that forwards to
 * its current source. The best kind of source gets the first slot, and sources of one kind keep
 * their slots. During a game a slot changes only if its controller is missing and another one of
 * its kind is free. Sources without a slot are polled too, so that their reports do not
 * accumulate. Their buttons count, and the controller manager can learn them. */
#ifndef KINGYO_DRIVERS_INPUT_MUX_H
#define KINGYO_DRIVERS_INPUT_MUX_H

#include "platform/hal.h"

/* USB pois, pads, and up to POI_MAX others such as the pointer. */
#define INPUT_SOURCE_MAX (3u * POI_MAX)
#define SLOT_NONE UINT8_MAX

/* Kinds of sources, best first. */
enum input_kind {
    INPUT_KIND_USB = 0, /* A hand-held poi, or a controller that the operator chose. */
    INPUT_KIND_GAMEPAD,
    INPUT_KIND_POINTER, /* The mouse or a touch screen. */
};

struct input_source {
    struct hal_poi poi;
    struct hal_fan fan;          /* The source's fan; ops null: no fan. */
    int (*is_there)(void *self); /* Returns 1 if the source can be used now; null: always. */
    void *self;                  /* First argument of is_there(). */
    uint8_t kind;                /* enum input_kind */
    /* 1: the source is used if no other source is available, even if is_there() returns 0. For
     * example, a mouse at rest can play alone, but not as a second player. */
    uint8_t stands_in;
};

struct input_mux {
    struct input_source source[INPUT_SOURCE_MAX];
    uint32_t source_count;
    uint32_t there;   /* Sources available at the last check, one bit each. */
    uint32_t idle;    /* Available sources that are open without a slot. */
    struct view view; /* Camera view set last. */
    struct display_settings display_settings; /* Image geometry set last; a new source gets both. */
    uint8_t has_view;
    const char *empty_line; /* Description of the first slot while it is empty. */
    struct seat {
        struct input_mux *mux;
        uint8_t index;
        uint8_t source; /* Index < source_count, or SLOT_NONE. */
    } seat[POI_MAX];
};

/* Initializes empty slots. `empty_line` names the missing device and the remedy. The text is
 * not copied. */
void input_mux_init(struct input_mux *mux, const char *empty_line);

/* Adds a source; better sources must be added first. Returns 0, or -1 if there are
 * INPUT_SOURCE_MAX sources already; the source is then ignored. */
int input_mux_add(struct input_mux *mux, const struct input_source *source);

/* Returns the poi device of slot `seat` < POI_MAX, which is valid even while the slot is empty. */
struct hal_poi input_mux_poi(struct input_mux *mux, uint32_t seat);

/* Returns the fan device of slot `seat` < POI_MAX. */
struct hal_fan input_mux_fan(struct input_mux *mux, uint32_t seat);

/* Returns the device that the frame loop calls once a frame to update the assignment. */
struct hal_seats input_mux_device(struct input_mux *mux);

/* Computes the assignment only. `seat` has the index of each slot's source or SLOT_NONE and is
 * updated. `kind` has the kinds of `count` sources, and `there` one bit for each available
 * source. */
void input_mux_assign(uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t there);

#endif
