/* world.h -- struct world: all objects that the physics simulates, which are the tank, the pois and
 * the bowls.
 *
 * A poi is the paper scoop with its sheet of paper. Element i of `poi` and element i of `bowl`
 * belong to player i. The game changes the world, but the physics does not depend on the phases or
 * the players of the game. */
#pragma once

#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/near_miss.h"
#include "core/poi/poi.h"
#include "core/poi/tear_clip.h"
#include "core/tank/tank.h"

struct world {
    struct tank tank;
    struct poi poi[POI_MAX];
    struct bowl bowl[POI_MAX];
    struct tear_clip tear_clip[POI_MAX]; /* Recording of each poi in the present round. */
    struct near_miss near_miss[POI_MAX]; /* Near misses of each poi in the present round. */
};
