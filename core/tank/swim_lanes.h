/* swim_lanes.h -- swim_move() and swim_settle() for LANES fish at once; see core/base/lanes.h. */
#ifndef KINGYO_CORE_TANK_SWIM_LANES_H
#define KINGYO_CORE_TANK_SWIM_LANES_H

#include "core/base/lanes.h"
#include "core/tank/swim.h"

LANES_BEGIN
/* Moves the block that begins at `first`, all of which swim and none of which falls, and makes
 * their bodies. */
void swim_move_block_4(const struct shoal *shoal, uint32_t first);
void swim_move_block_8(const struct shoal *shoal, uint32_t first);

/* Takes each to where its body is now and settles it. */
void swim_settle_block_4(const struct shoal *shoal, uint32_t first);
void swim_settle_block_8(const struct shoal *shoal, uint32_t first);
LANES_END

#endif
