/* fall.h -- moves a fish that slipped off the ring of a poi (paper scoop) or fell through its
 * paper. */
#ifndef KINGYO_CORE_POI_CATCH_FALL_H
#define KINGYO_CORE_POI_CATCH_FALL_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/carried_fish.h"
#include "core/tank/tank.h"

enum fall_end {
    FALL_GOES_ON = 0,
    FALL_INTO_BOWL,  /* The fish is now in a bowl, which counts the fish. */
    FALL_INTO_WATER, /* The fish is back in the water of the tank. The fish swims as soon as no
                        other fish is in its way. */
};

/* Changes a carried fish to a falling fish with the world velocity `velocity_m_s`. */
void fall_begin(struct carried_fish *carried, vec3 velocity_m_s);

/* Advances the fall of a fish by one tick (1/120 s). A fish can enter the bowl of any player, but
 * only from above through the bowl's mouth. If the result is FALL_INTO_BOWL, writes the index of
 * the bowl to `bowl_index`. */
enum fall_end fall_tick(struct carried_fish *carried, const struct stall *stall,
                        uint32_t *bowl_index);

/* Puts a fish back into the water of the tank: below the surface, inside the walls, and with full
 * alarm. */
void fall_set_free(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

#endif
