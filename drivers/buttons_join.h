/* buttons_join.h -- several panels as one: the keyboard, GPIO lines, controllers' own buttons.
 *
 * A level is held while any of them holds it; each edge, coin and fault of any counts. */
#ifndef KINGYO_DRIVERS_BUTTONS_JOIN_H
#define KINGYO_DRIVERS_BUTTONS_JOIN_H

#include "platform/hal.h"

#define BUTTONS_JOIN_MAX 12u /* A keyboard, a cabinet's lines, and what can sit at a seat. */

struct buttons_join {
    struct hal_buttons part[BUTTONS_JOIN_MAX];
    uint32_t part_count;
    char text[3u * HAL_TEXT_SIZE]; /* What the parts say, cut to fit. */
};

/* Adds a panel; it is asked in that order. -1: there are BUTTONS_JOIN_MAX, and nobody asks it. */
int buttons_join_add(struct buttons_join *join, struct hal_buttons part);

struct hal_buttons buttons_join_device(struct buttons_join *join);

#endif
