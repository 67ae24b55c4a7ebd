/* buttons_mux.h -- merges several button devices into one: keyboard, GPIO lines, controllers.
 *
 * A button is held while any part holds it. Edges, coins and faults of all parts are added. */
#ifndef KINGYO_DRIVERS_BUTTONS_MUX_H
#define KINGYO_DRIVERS_BUTTONS_MUX_H

#include "platform/hal.h"

#define BUTTONS_MUX_MAX 12u /* Keyboard, cabinet lines, and one part for each controller. */

struct buttons_mux {
    struct hal_buttons part[BUTTONS_MUX_MAX];
    uint32_t part_count;
    char text[3u * HAL_TEXT_SIZE]; /* Descriptions of the parts, truncated to fit. */
};

/* Adds a part, which is polled in this order. Returns 0, or -1 if there are BUTTONS_MUX_MAX
 * parts already; the part is then ignored. */
int buttons_mux_add(struct buttons_mux *join, struct hal_buttons part);

struct hal_buttons buttons_mux_device(struct buttons_mux *join);

#endif
