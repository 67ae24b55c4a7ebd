/* pointer_aid.h -- adapts pointer reports to players who cannot hold a button, or who cannot reach
 * the upper part of the screen.
 *
 * Pure: uses no device, clock or library. */
#pragma once

#include "drivers/pointer/pointer_poi.h"

/* Smallest reach: two fifths of the height of the picture. */
#define POINTER_REACH_MIN_PERCENT 40u

struct pointer_aid {
    /* True if one press of the dip button lowers the ring, and the next press lifts it. */
    bool clicks;
    /* Height of the lower part of the picture that stands for the whole picture, in per cent of
     * the picture's height. 0 means 100. */
    uint32_t reach_percent;
    bool is_pressed; /* True if the dip button was pressed in the last report. */
    bool is_down;    /* True if the ring is lowered because of a press. */
};

/* Adapts `report`, which has image coordinates (pointer_report_on()). `scoops` is false on pages
 * with buttons, where a press acts as long as it lasts and lifts a ring that is still lowered. */
void pointer_aid_apply(struct pointer_aid *aid, bool scoops, struct pointer_report *report);

/* Raises the ring until the button is pressed again. Must be called when a page with buttons opens
 * or closes. Otherwise the press on a tag of the page would also lower the ring in the round. */
void pointer_aid_raise(struct pointer_aid *aid);
