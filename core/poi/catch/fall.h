/* fall.h -- the fall of a fish that slipped off the ring of a poi (paper scoop) or fell through its
 * paper. */
#ifndef KINGYO_CORE_POI_CATCH_FALL_H
#define KINGYO_CORE_POI_CATCH_FALL_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/carried_fish.h"
#include "core/tank/tank.h"

enum fall_end {
    FALL_GOES_ON = 0,
    FALL_INTO_BOWL,  /* The bowl holds and counts the fish. */
    FALL_INTO_WATER, /* The fish is back in the water and swims as soon as it is clear of other
                        fish. */
};

/* Starts the fall of a carried fish at a world velocity. */
void fall_begin(struct carried_fish *carried, vec3 velocity_m_s);

/* Advances a fall by one tick (1/120 s). A fish enters a bowl only from above through its mouth;
 * the bowl may belong to any player. If the result is FALL_INTO_BOWL, the index of the bowl is
 * written to `bowl_index`. */
enum fall_end fall_tick(struct carried_fish *carried, const struct stall *stall,
                        uint32_t *bowl_index);

/* Puts a fish back into the water: below the surface, inside the walls, and at full alarm. */
void fall_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

#endif
