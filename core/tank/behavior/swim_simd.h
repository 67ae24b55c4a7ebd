/* swim_simd.h -- swim_move() and swim_settle() for SIMD_LANES fish at a time; see
 * core/base/simd.h. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_SWIM_SIMD_H
#define KINGYO_CORE_TANK_BEHAVIOR_SWIM_SIMD_H

#include "core/base/simd.h"
#include "core/tank/behavior/swim.h"

SIMD_BEGIN
/* Moves the block of fish that begins at `first` and updates its bodies. The caller guarantees that
 * all fish of the block swim and that none falls. The suffix is the number of lanes. */
void swim_move_block_4(const struct shoal *shoal, uint32_t first);
void swim_move_block_8(const struct shoal *shoal, uint32_t first);

/* Moves each fish of the block that begins at `first` to the position of its body, and does for
 * each fish what swim_settle() does. The caller guarantees that all fish of the block swim and that
 * none falls. */
void swim_settle_block_4(const struct shoal *shoal, uint32_t first);
void swim_settle_block_8(const struct shoal *shoal, uint32_t first);
SIMD_END

#endif
