/* burden.h -- what the fish on a poi press on its paper with. */
#ifndef KINGYO_CORE_POI_BURDEN_H
#define KINGYO_CORE_POI_BURDEN_H

#include "core/poi/poi.h"

/* [0, 1]: how much of a rider's weight the water no longer bears. */
float burden_dryness(const struct poi *poi, const struct basis *axes, const struct rider *rider,
                     const struct fish *fish);

/* Fills the poi's loads and its riders' weight for the next tick's paper. A body lies on a patch of
 * 20 mm; a slap falls where the tail is, on 2 to 5 mm, if there is paper: a tail that is off it
 * slaps the air, and the body takes the kick on 16 to 100 times the area. `pull_m_s2` is gravity
 * less the poi's own acceleration along its up; `fish` is the tank's. */
void burden_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                   const struct fish *fish);

#endif
