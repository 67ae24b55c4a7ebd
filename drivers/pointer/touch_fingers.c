/* touch_fingers.c -- tracks the leader (the first finger) and the number of fingers. */
#include "drivers/pointer/touch_fingers.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"

/* Sets the pointer's position to the position of the leader (the first finger). Returns true if the
 * position changed. */
static bool lead(struct touch_fingers *fingers, const struct touch_event *event)
{
    const float x = f_clamp(event->x, 0.0f, 1.0f);
    const float y = f_clamp(event->y, 0.0f, 1.0f);
    const bool is_new = !fingers->has_place || x != fingers->x || y != fingers->y;
    fingers->x = x;
    fingers->y = y;
    fingers->has_place = true;
    return is_new;
}

bool touch_fingers_take(struct touch_fingers *fingers, const struct touch_event *event)
{
    if (!f_is_finite(event->x) || !f_is_finite(event->y)) {
        return false;
    }
    uint32_t place = 0;
    CORE_ASSERT(fingers->count <= TOUCH_FINGER_MAX);
    while (place < fingers->count && fingers->id[place] != event->id) {
        place++;
    }
    const bool is_known = place < fingers->count;
    const bool is_leader = fingers->has_leader && fingers->leader == event->id;
    bool changed = false;
    if (event->kind == TOUCH_DOWN && !is_known) {
        changed = fingers->count < TOUCH_FINGER_MAX;
        if (changed) {
            fingers->id[fingers->count++] = event->id;
        }
        if (changed && fingers->count == 1) {
            fingers->leader = event->id;
            fingers->has_leader = true;
            lead(fingers, event);
        }
        fingers->start_pressed |= changed && fingers->count == TOUCH_START_FINGERS;
    } else if (event->kind != TOUCH_UP || is_known) {
        /* A finger that is already tracked may touch the screen again, because the event that
         * lifted the finger was lost. */
        changed = is_leader && lead(fingers, event);
    }
    if (event->kind == TOUCH_UP && is_known) {
        fingers->has_leader &= !is_leader;
        fingers->id[place] = fingers->id[--fingers->count];
        changed = true;
    }
    fingers->dips = fingers->count >= TOUCH_DIP_FINGERS;
    return changed;
}

void touch_fingers_point(const struct touch_fingers *fingers, struct pointer_report *report)
{
    CORE_ASSERT(fingers->count <= TOUCH_FINGER_MAX);
    if (fingers->has_place) {
        report->x_px = fingers->x * (float)report->width_px;
        report->y_px = fingers->y * (float)report->height_px;
    }
    report->buttons = fingers->dips ? report->buttons | (uint32_t)POINTER_DIP
                                    : report->buttons & ~(uint32_t)POINTER_DIP;
}

bool touch_fingers_start(struct touch_fingers *fingers)
{
    const bool pressed = fingers->start_pressed;
    fingers->start_pressed = false;
    return pressed;
}
