/* paper_contact.h -- tests which fish touch the upper side of the paper of a poi (paper scoop). */
#ifndef KINGYO_CORE_POI_CATCH_PAPER_CONTACT_H
#define KINGYO_CORE_POI_CATCH_PAPER_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Returns 1 if a swimming fish is above intact paper and near enough to be captured, otherwise 0.
 * The position of the fish's centre decides whether the fish is above the paper, because the
 * contact solver lets no fish pass through the paper. `axes` are the poi's axes. */
int paper_contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish);

/* Returns 1 if fish block the ring and the ring presses the fish `fish` against the water
 * surface, otherwise 0. In this case the fish must slip off, because the poi could not be lifted
 * otherwise. */
int paper_contact_squeezed(const struct poi *poi, const struct fish *fish);

/* Returns 1 if the ring is jammed, otherwise 0. The ring is jammed if fish block it while the
 * target of the hand is at least 3 cm above the ring (a pull of 6.5 N). */
int paper_contact_jams(const struct poi *poi);

/* Returns 1 if the fish `fish` jams the ring and must leave the poi in this tick, otherwise 0.
 * The fish between the disc and the water surface leave from the edge inward. The longer the jam
 * lasts, the more fish leave. After 0.1 s, all fish that touch the ring leave. `axes` are the
 * poi's axes. */
int paper_contact_releases(const struct poi *poi, const struct basis *axes,
                           const struct fish *fish);

#endif
