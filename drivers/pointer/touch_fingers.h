/* touch_fingers.h -- combines the fingers on a touch screen into one pointer.
 *
 * A finger cannot hover, so a second finger replaces the mouse button. The first finger is the
 * leader: the leader moves the ring over the water until the leader is lifted. A second finger
 * lowers the ring, and a third finger presses START. Fingers other than the leader never move the
 * ring. Pure: uses no device and no clock. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "drivers/pointer/pointer_poi.h"

#define TOUCH_FINGER_MAX 10u /* Largest number of tracked fingers. Further fingers are ignored. */
#define TOUCH_DIP_FINGERS 2u
#define TOUCH_START_FINGERS 3u

enum touch_kind {
    TOUCH_DOWN = 0,
    TOUCH_MOVE,
    TOUCH_UP,
};

struct touch_event {
    uint64_t time_ns; /* Time at which the event arrived. */
    uint8_t kind;     /* Kind of the event (enum touch_kind). */
    int64_t id;       /* Id of the finger, unique while the finger touches the screen. */
    /* Position in the window, 0 to 1 from the top left corner. Any value is accepted, including
     * NaN. */
    float x, y;
};

struct touch_fingers {
    int64_t id[TOUCH_FINGER_MAX]; /* Ids of the fingers that touch the screen. */
    uint32_t count;
    int64_t leader;
    bool has_leader; /* True while the leader (the first finger) touches the screen. */
    /* Last position of the leader (the first finger) in the window, 0 to 1 from the top left
     * corner. */
    float x, y;
    bool has_place; /* True after the first touch of the screen. `x` and `y` are then valid. */
    bool dips;      /* True while at least two fingers touch the screen, which lowers the ring. */
    /* True from the touch of a third finger until touch_fingers_start() is called. */
    bool start_pressed;
};

/* Processes one event. Returns true if the state changed. Returns false if nothing changed, if the
 * position is not finite, if the finger is unknown, or if too many fingers touch the screen. */
bool touch_fingers_take(struct touch_fingers *fingers, const struct touch_event *event);

/* Writes the position and the POINTER_DIP bit to `report`, and leaves all other fields
 * unchanged. */
void touch_fingers_point(const struct touch_fingers *fingers, struct pointer_report *report);

/* Returns true if a third finger touched the screen since the last call. */
bool touch_fingers_start(struct touch_fingers *fingers);
