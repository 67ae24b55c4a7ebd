/* swim_lanes.h -- swim_move() and swim_settle() for LANES fish at once; see core/base/lanes.h. */
#ifndef KINGYO_CORE_TANK_SWIM_LANES_H
#define KINGYO_CORE_TANK_SWIM_LANES_H

#include "core/base/lanes.h"
#include "core/tank/body.h"
#include "core/tank/fish.h"

/* Moves `fish`, all of which swim and none of which falls, and makes their bodies. */
void swim_move_block_4(struct fish *fish, struct body *body, const struct law *law, float space);
void swim_move_block_8(struct fish *fish, struct body *body, const struct law *law, float space);

/* Takes each to where its body is now and settles it. `before_m`, where they were when the tick
 * began, is followed by at least one float more. */
void swim_settle_block_4(struct fish *fish, const struct body *body, const vec3 *before_m);
void swim_settle_block_8(struct fish *fish, const struct body *body, const vec3 *before_m);

#endif
