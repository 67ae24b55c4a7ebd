/* touch_fingers.c -- tracks the leader (the first finger) and the number of fingers. */
#include "drivers/pointer/touch_fingers.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"

static int lead(struct touch_fingers *fingers, const struct touch_event *event)
{
    const float x = f_clamp(event->x, 0.0f, 1.0f);
    const float y = f_clamp(event->y, 0.0f, 1.0f);
    const int is_new = !fingers->has_place || x != fingers->x || y != fingers->y;
    fingers->x = x;
    fingers->y = y;
    fingers->has_place = 1;
    return is_new;
}

/* Processes the first touch of a finger. */
static int put_down(struct touch_fingers *fingers, const struct touch_event *event)
{
    CORE_ASSERT(fingers->count <= TOUCH_FINGER_MAX);
    if (fingers->count == TOUCH_FINGER_MAX) {
        return 0;
    }
    fingers->id[fingers->count++] = event->id;
    if (fingers->count == 1) {
        fingers->leader = event->id;
        fingers->has_leader = 1;
        lead(fingers, event);
    }
    fingers->start_pressed |= fingers->count == TOUCH_START_FINGERS;
    return 1;
}

int touch_fingers_take(struct touch_fingers *fingers, const struct touch_event *event)
{
    if (!f_is_finite(event->x) || !f_is_finite(event->y)) {
        return 0;
    }
    uint32_t place = 0;
    CORE_ASSERT(fingers->count <= TOUCH_FINGER_MAX);
    while (place < fingers->count && fingers->id[place] != event->id) {
        place++;
    }
    const int is_known = place < fingers->count;
    const int is_leader = fingers->has_leader && fingers->leader == event->id;
    int changed = 0;
    if (event->kind == TOUCH_DOWN && !is_known) {
        changed = put_down(fingers, event);
    } else if (event->kind != TOUCH_UP || is_known) {
        /* A known finger may touch the screen again if the event that lifted the finger was
         * lost. */
        changed = is_leader ? lead(fingers, event) : 0;
    }
    if (event->kind == TOUCH_UP && is_known) {
        fingers->has_leader &= !is_leader;
        fingers->id[place] = fingers->id[--fingers->count];
        changed = 1;
    }
    fingers->dips = fingers->count >= TOUCH_DIP_FINGERS;
    return changed;
}

void touch_fingers_point(const struct touch_fingers *fingers, struct pointer_report *report)
{
    CORE_ASSERT(fingers->dips <= 1);
    if (fingers->has_place) {
        report->x_px = fingers->x * (float)report->width_px;
        report->y_px = fingers->y * (float)report->height_px;
    }
    report->buttons = fingers->dips ? report->buttons | (uint32_t)POINTER_DIP
                                    : report->buttons & ~(uint32_t)POINTER_DIP;
}

int touch_fingers_start(struct touch_fingers *fingers)
{
    CORE_ASSERT(fingers->start_pressed <= 1);
    const int pressed = fingers->start_pressed;
    fingers->start_pressed = 0;
    return pressed;
}
