/* world.h -- everything that physics acts on: the tank, the pois and the bowls.
 *
 * The game is above the world: a phase of the game acts on the world, and the physics of the world
 * knows no phase and no player. A poi is the paper scoop together with its sheet of paper. Element
 * i of `poi` and element i of `bowl` belong to player i. */
#ifndef KINGYO_CORE_POI_WORLD_H
#define KINGYO_CORE_POI_WORLD_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

struct world {
    struct tank tank;
    struct poi poi[POI_MAX];
    struct bowl bowl[POI_MAX];
};

#endif
