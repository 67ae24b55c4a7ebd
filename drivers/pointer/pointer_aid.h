/* pointer_aid.h -- adapts pointer reports to players who cannot hold a button, or who cannot reach
 * the upper part of the screen.
 *
 * Pure: uses no device, clock or library. */
#pragma once

#include "drivers/pointer/pointer_poi.h"

/* Smallest value of `reach_percent` other than 0, in per cent of the height of the picture. */
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

/* Adapts `report`, which has image coordinates (pointer_report_on()). `scoops` is true in a round
 * and false on a page with buttons. On a page, a press acts as long as it lasts. A ring that is
 * still lowered is then raised. */
void pointer_aid_apply(struct pointer_aid *aid, bool scoops, struct pointer_report *report);

/* Raises the ring until the dip button is pressed again. Must be called when a page with buttons
 * opens or closes. Otherwise a press on a button of the page would also lower the ring in the
 * round. */
void pointer_aid_raise(struct pointer_aid *aid);
