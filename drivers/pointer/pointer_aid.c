/* pointer_aid.c -- implementation of pointer_aid.h. */
#include "drivers/pointer/pointer_aid.h"

#include "core/base/panic.h"

void pointer_aid_apply(struct pointer_aid *aid, bool scoops, struct pointer_report *report)
{
    CORE_ASSERT(aid->reach_percent == 0 ||
                (aid->reach_percent >= POINTER_REACH_MIN_PERCENT && aid->reach_percent <= 100u));
    const bool is_pressed = (report->buttons & POINTER_DIP) != 0;
    const bool begins = is_pressed && !aid->is_pressed;
    aid->is_down = aid->clicks && scoops ? aid->is_down != begins : is_pressed;
    aid->is_pressed = is_pressed;
    report->buttons &= ~(uint32_t)POINTER_DIP;
    report->buttons |= aid->is_down ? (uint32_t)POINTER_DIP : 0u;
    if (aid->reach_percent != 0) {
        const float height = (float)report->height_px;
        const float up = height - report->y_px;
        report->y_px = height - up * 100.0f / (float)aid->reach_percent;
    }
}

void pointer_aid_raise(struct pointer_aid *aid)
{
    aid->is_down = false;
}
