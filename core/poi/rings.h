/* rings.h -- two pois at one tank: neither goes through the other, and neither holds the other. */
#ifndef KINGYO_CORE_POI_RINGS_H
#define KINGYO_CORE_POI_RINGS_H

#include "core/poi/poi.h"

/* After poi_tick() of both: discs that are in each other, or came through each other in this tick,
 * are parted, each by half. What presses them together slides them past each other at 0.6 m/s each,
 * so that no hand is held by another for longer than that takes. Whose is whose makes no
 * difference. Returns whether they touched: then walls and bowls must be asked again. */
int rings_part(struct poi *a, struct poi *b);

#endif
