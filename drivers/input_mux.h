/* input_mux.h -- the input multiplexers: one assigns controllers to the players' slots, and one
 * merges several button devices (keyboard, GPIO lines, controllers) into one device.
 *
 * A slot is the place of one of up to POI_MAX controllers at the tank. A source is a controller
 * with its poi (the paper scoop that it moves) and its fan. Sources come and go while the kiosk
 * runs. For example, a USB poi is plugged in, or the battery of a game pad is empty.
 *
 * The multiplexer puts the devices of each slot's current source into struct hal, so the kiosk
 * calls the sources directly. The first slot gets the best kind of source, and sources of one kind
 * keep their slots. During a game a slot changes its source only if the source is missing and a
 * free source of the same kind exists.
 *
 * Sources without a slot are polled too, so that their reports do not accumulate. The buttons of
 * these sources are used, and the controller manager can learn the mappings of these sources.
 *
 * A button of the merged device is held while at least one part (merged device) holds it. The
 * counts of edges, coins and faults are the sums over all parts. */
#pragma once

#include <stdbool.h>

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
    struct hal_fan fan; /* Fan of the source. If `fan.ops` is null the source has no fan. */
    /* Returns true if the source can be used now. A null pointer means that the source can always
     * be used. */
    bool (*is_present)(void *self);
    void *self;   /* First argument of is_present(). */
    uint8_t kind; /* Kind of the source (enum input_kind). */
    /* True if the source is used even while its is_present() returns false, provided that no other
     * source is available. For example, a resting mouse can control the first poi if there is no
     * other source, but never a second poi. */
    bool stands_in;
};

struct input_mux {
    struct input_source source[INPUT_SOURCE_MAX];
    uint32_t source_count;
    /* Sources that were available at the last check, one bit for each source. */
    uint32_t present;
    /* Available sources that are open but have no slot, one bit for each source. */
    uint32_t idle;
    uint8_t slot[POI_MAX]; /* Index of each slot's source, or SLOT_NONE if the slot is empty. */
    struct hal *hal;       /* Devices of the kiosk. The multiplexer sets hal->poi and hal->fan. */
    /* Text that describe() returns for the first slot while the slot is empty. The text names the
     * missing device and the remedy. */
    const char *empty_line;
};

/* Initializes all slots as empty, and sets the devices of all slots in `hal`. Returns the device
 * that the frame loop calls once in each frame to update the assignment. `hal` must stay valid.
 * `empty_line` is the description of an empty first slot, which names the missing device and the
 * remedy. The text is not copied and must stay valid. */
struct hal_slots input_mux_init(struct input_mux *mux, struct hal *hal, const char *empty_line);

/* Adds a source. Sources of a better kind must be added first. Returns 0, or -1 if there are
 * INPUT_SOURCE_MAX sources already. After -1 the new source is ignored. */
int input_mux_add(struct input_mux *mux, const struct input_source *source);

/* Computes an assignment without side effects. `slot` holds the source index of each slot, or
 * SLOT_NONE, and is updated. `kind` holds the kinds of the `count` sources. `present` has one bit
 * for each available source. */
void input_mux_assign(uint8_t slot[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t present);

/* Largest number of parts: the keyboard, the cabinet's lines, and one part for each controller. */
#define INPUT_BUTTONS_MAX 12u

struct input_buttons {
    struct hal_buttons part[INPUT_BUTTONS_MAX];
    uint32_t part_count;
    /* Descriptions of all parts, joined into one text that is truncated to the size of the
     * buffer. */
    char text[3u * HAL_TEXT_SIZE];
};

/* Adds a part. Parts are polled in the order in which they were added. Returns 0, or -1 if there
 * are INPUT_BUTTONS_MAX parts already. After -1 the new part is ignored. */
int input_buttons_add(struct input_buttons *buttons, struct hal_buttons part);

/* Returns the merged button device. */
struct hal_buttons input_buttons_device(struct input_buttons *buttons);
