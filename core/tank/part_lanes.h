/* part_lanes.h -- how part_clear() treats fish that are far from any obstacle, LANES of them at
 * once; see core/base/lanes.h. */
#ifndef KINGYO_CORE_TANK_PART_LANES_H
#define KINGYO_CORE_TANK_PART_LANES_H

#include "core/base/lanes.h"
#include "core/tank/part.h"

/* Keeps the block that begins at `first` within bounds, and says how far parting may move each. All
 * of it swims; nobody gulps or is in the air; the step is the tick's first. Returns a bit for each
 * that an obstacle could touch: those are as they were, and need part_clear()'s full care. */
#define PART_CLEAR(name)                                                                           \
    uint32_t name(struct part *part, struct crowd *crowd, const struct part_place *place,          \
                  uint32_t first)

LANES_BEGIN
PART_CLEAR(part_clear_block_4);
PART_CLEAR(part_clear_block_8);
LANES_END

#endif
