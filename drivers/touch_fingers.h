/* touch_fingers.h -- fingers on glass into one pointer. Pure.
 *
 * A finger that lies on the screen cannot hover, so where a mouse has a button a second finger is:
 * the first leads the ring over the water, two let it down, three press START. Who led stays the
 * leader until all are up: another finger does not pull the ring to its own place. */
#ifndef KINGYO_DRIVERS_TOUCH_FINGERS_H
#define KINGYO_DRIVERS_TOUCH_FINGERS_H

#include <stdint.h>

#include "drivers/pointer_poi.h"

#define TOUCH_FINGER_MAX 10u /* More do not fit on a hand; they are not heeded. */
#define TOUCH_DIP_FINGERS 2u
#define TOUCH_START_FINGERS 3u

enum touch_kind {
    TOUCH_DOWN = 0,
    TOUCH_MOVE,
    TOUCH_UP,
};

struct touch_event {
    uint64_t time_ns; /* When it came. */
    uint8_t kind;     /* enum touch_kind */
    int64_t id;       /* Of the finger, as long as it is down. */
    float x, y;       /* In the window, 0 .. 1 from its top left corner; any bits. */
};

struct touch_fingers {
    int64_t id[TOUCH_FINGER_MAX]; /* Of those that are down. */
    uint32_t count;
    int64_t leader;
    uint8_t has_leader;           /* It is still down. */
    float x, y;                   /* Where the leader was last, [0, 1]; */
    uint8_t has_place;            /* after the first touch. */
    uint8_t dips;                 /* Level. */
    uint8_t start_pressed;        /* An edge, until it is taken. */
};

/* 1: something changed. 0: no number, an unknown finger, one too many, or nothing new. */
int touch_fingers_take(struct touch_fingers *fingers, const struct touch_event *event);

/* What they say as a pointer: its place in a window and its buttons; the rest of `report` stays. */
void touch_fingers_point(const struct touch_fingers *fingers, struct pointer_report *report);

/* Whether three fingers came together since the last call. */
int touch_fingers_start(struct touch_fingers *fingers);

#endif
