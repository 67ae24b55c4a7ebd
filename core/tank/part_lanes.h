/* part_lanes.h -- part_clear() for LANES fish far from any obstacle; see core/base/lanes.h. */
#ifndef KINGYO_CORE_TANK_PART_LANES_H
#define KINGYO_CORE_TANK_PART_LANES_H

#include "core/base/lanes.h"
#include "core/tank/part.h"

/* Keeps the block that begins at `first` within bounds and sets the allowance of each body. All
 * fish of the block swim, and none gulps or is in the air. The substep is the first of the tick.
 * Returns one bit for each fish that an obstacle could touch. The flagged fish are unchanged and
 * need the full part_clear(). */
#define PART_CLEAR(name)                                                                           \
    uint32_t name(struct part *part, struct crowd *crowd, const struct part_place *place,          \
                  uint32_t first)

LANES_BEGIN
PART_CLEAR(part_clear_block_4);
PART_CLEAR(part_clear_block_8);
LANES_END

#endif
