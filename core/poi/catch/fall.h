/* fall.h -- the fall of a fish that slipped off the ring or through the paper. */
#ifndef KINGYO_CORE_POI_CATCH_FALL_H
#define KINGYO_CORE_POI_CATCH_FALL_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/carried_fish.h"
#include "core/tank/tank.h"

enum fall_end {
    FALL_GOES_ON = 0,
    FALL_INTO_BOWL,  /* The fish belongs to the bowl and is counted there. */
    FALL_INTO_WATER, /* The fish swims as soon as it is clear. */
};

/* Starts the fall of a carried fish at a world velocity. */
void fall_begin(struct carried_fish *carried, vec3 velocity_m_s);

/* Advances a fall by one tick. A fish enters a bowl, of any player, only from above through its
 * mouth; `*bowl_index` is then that bowl. */
enum fall_end fall_tick(struct carried_fish *carried, const struct stall *stall,
                        uint32_t *bowl_index);

/* Releases a carried fish into the water, under the surface and inside the walls, in alarm. */
void fall_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

#endif
