/* touch_fingers.h -- combines the fingers on a touch screen into one pointer. Pure.
 *
 * A finger cannot hover, so a second finger replaces the mouse button. The first finger moves
 * the ring over the water, a second one lowers the ring, and a third one presses START. The
 * first finger remains the leader until it is lifted; other fingers never move the ring. */
#ifndef KINGYO_DRIVERS_POINTER_TOUCH_FINGERS_H
#define KINGYO_DRIVERS_POINTER_TOUCH_FINGERS_H

#include <stdint.h>

#include "drivers/pointer/pointer_poi.h"

#define TOUCH_FINGER_MAX 10u /* Further fingers are ignored. */
#define TOUCH_DIP_FINGERS 2u
#define TOUCH_START_FINGERS 3u

enum touch_kind {
    TOUCH_DOWN = 0,
    TOUCH_MOVE,
    TOUCH_UP,
};

struct touch_event {
    uint64_t time_ns; /* Time at which the event arrived. */
    uint8_t kind;     /* enum touch_kind */
    int64_t id;       /* Id of the finger while it is down. */
    float x, y;       /* Position in the window, 0 .. 1 from the top left corner; any bits. */
};

struct touch_fingers {
    int64_t id[TOUCH_FINGER_MAX]; /* Ids of the fingers that are down. */
    uint32_t count;
    int64_t leader;
    uint8_t has_leader;    /* 1 while the leader is down. */
    float x, y;            /* Last position of the leader, [0, 1]. */
    uint8_t has_place;     /* 1 after the first touch. */
    uint8_t dips;          /* 1 while two or more fingers are down. */
    uint8_t start_pressed; /* 1 from the third finger's touch until it is read. */
};

/* Processes one event. Returns 1 if the state changed. Returns 0 for a position that is not
 * finite, an unknown finger, too many fingers, or no change. */
int touch_fingers_take(struct touch_fingers *fingers, const struct touch_event *event);

/* Writes the position and the dip button to `report`. All other fields stay unchanged. */
void touch_fingers_point(const struct touch_fingers *fingers, struct pointer_report *report);

/* Returns 1 if a third finger came down since the last call. */
int touch_fingers_start(struct touch_fingers *fingers);

#endif
