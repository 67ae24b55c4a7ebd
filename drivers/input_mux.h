/* input_mux.h -- the input multiplexer: assigns controllers to the players' slots.
 *
 * A slot is the place of one of up to POI_MAX controllers at the tank. A source is a controller
 * with its poi (the paper scoop that it moves) and its fan. Sources come and go while the kiosk
 * runs. For example, a USB poi is plugged in, or the battery of a game pad is empty.
 *
 * Each slot is a fixed device of struct hal that forwards its calls to its current source. The
 * first slot gets the best kind of source, and sources of one kind keep their slots. During a game
 * a slot changes its source only if the source is missing and a free source of the same kind
 * exists.
 *
 * Sources without a slot are polled too, so that their reports do not accumulate. Their buttons are
 * used, and the controller manager can learn them. */
#ifndef KINGYO_DRIVERS_INPUT_MUX_H
#define KINGYO_DRIVERS_INPUT_MUX_H

#include "platform/hal.h"

/* Largest number of sources: POI_MAX USB pois, POI_MAX game pads, and POI_MAX other sources such as
 * the pointer. */
#define INPUT_SOURCE_MAX (3u * POI_MAX)
#define SLOT_NONE UINT8_MAX

/* Kinds of sources (controllers), ordered from best to worst. */
enum input_kind {
    INPUT_KIND_USB = 0, /* A hand-held USB poi, or a USB controller that the operator selected. */
    INPUT_KIND_GAMEPAD,
    INPUT_KIND_POINTER, /* A mouse or a touch screen. */
};

struct input_source {
    struct hal_poi poi;
    struct hal_fan fan;          /* Fan of the source. If `fan.ops` is null the source has no
                                    fan. */
    int (*is_there)(void *self); /* Returns 1 if the source can be used now, otherwise 0. A null
                                    pointer means that the source can always be used. */
    void *self;                  /* First argument of is_there(). */
    uint8_t kind;                /* Kind of the source (enum input_kind). */
    /* 1 if the source is used even while its is_there() returns 0, provided that no other source is
     * available. Otherwise 0. For example, a mouse at rest can play alone, but not as a second
     * player. */
    uint8_t stands_in;
};

struct input_mux {
    struct input_source source[INPUT_SOURCE_MAX];
    uint32_t source_count;
    uint32_t there;   /* Sources that were available at the last check, one bit for each source. */
    uint32_t idle;    /* Available sources that are open but have no slot, one bit for each
                         source. */
    struct view view; /* Camera view that was set last; a source that gets a slot receives it. */
    struct display_settings display_settings; /* Image geometry that was set last; a source that
                                                 gets a slot receives it. */
    uint8_t has_view;
    const char *empty_line; /* Text that describe() returns for the first slot while the slot is
                               empty. The text names the missing device and the remedy. */
    struct seat {
        struct input_mux *mux;
        uint8_t index;
        uint8_t source; /* Index of the slot's source, or SLOT_NONE if the slot is empty. */
    } seat[POI_MAX];
};

/* Initializes all slots as empty. `empty_line` is the description of an empty first slot, which
 * names the missing device and the remedy. The text is not copied and must stay valid. */
void input_mux_init(struct input_mux *mux, const char *empty_line);

/* Adds a source. Sources of a better kind must be added first. Returns 0, or -1 if there are
 * INPUT_SOURCE_MAX sources already; the new source is then ignored. */
int input_mux_add(struct input_mux *mux, const struct input_source *source);

/* Returns the poi device of slot `seat` (0 to POI_MAX - 1). The device is valid even while the slot
 * is empty. */
struct hal_poi input_mux_poi(struct input_mux *mux, uint32_t seat);

/* Returns the fan device of slot `seat` (0 to POI_MAX - 1). */
struct hal_fan input_mux_fan(struct input_mux *mux, uint32_t seat);

/* Returns the device that the frame loop calls once in each frame to update the assignment. */
struct hal_seats input_mux_device(struct input_mux *mux);

/* Computes an assignment without side effects. `seat` holds the source index of each slot, or
 * SLOT_NONE, and is updated. `kind` holds the kinds of the `count` sources. `there` has one bit for
 * each available source. */
void input_mux_assign(uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t there);

#endif
