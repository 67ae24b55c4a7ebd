/* buttons_mux.h -- merges several button devices (keyboard, GPIO lines, controllers) into one
 * device.
 *
 * A button is held while at least one part (merged device) holds it. The counts of edges, coins and
 * faults are the sums over all parts. */
#pragma once

#include "platform/hal.h"

/* Largest number of parts: the keyboard, the cabinet's lines, and one part for each controller. */
#define BUTTONS_MUX_MAX 12u

struct buttons_mux {
    struct hal_buttons part[BUTTONS_MUX_MAX];
    uint32_t part_count;
    /* Descriptions of all parts, joined into one text that is truncated to the size of the
     * buffer. */
    char text[3u * HAL_TEXT_SIZE];
};

/* Adds a part. Parts are polled in the order in which they were added. Returns 0, or -1 if there
 * are BUTTONS_MUX_MAX parts already. After -1 the new part is ignored. */
int buttons_mux_add(struct buttons_mux *join, struct hal_buttons part);

/* Returns the merged button device. */
struct hal_buttons buttons_mux_device(struct buttons_mux *join);
