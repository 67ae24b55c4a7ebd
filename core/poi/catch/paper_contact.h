/* paper_contact.h -- the fish that touch the upper side of the paper of a poi (paper scoop). */
#ifndef KINGYO_CORE_POI_CATCH_PAPER_CONTACT_H
#define KINGYO_CORE_POI_CATCH_PAPER_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Returns 1 if a swimming fish is above intact paper and near enough for a capture, otherwise 0.
 * The position of the fish's centre decides on which side of the paper it is, because the contact
 * solver lets no fish through. `axes` are the poi's axes. */
int paper_contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish);

/* Returns 1 if the ring is blocked by fish and presses this fish against the water surface,
 * otherwise 0. The fish must slip off, because the poi could not be lifted otherwise. */
int paper_contact_squeezed(const struct poi *poi, const struct fish *fish);

/* Returns 1 if the ring is jammed: fish block the ring while the target of the hand is at least
 * 3 cm above it (a pull of 6.5 N). */
int paper_contact_jams(const struct poi *poi);

/* Returns 1 if this fish jams the ring and must leave in this tick, otherwise 0. The fish between
 * disc and surface leave from the edge inward, and more fish leave the longer the jam lasts. After
 * 0.1 s, all fish that touch the ring leave. `axes` are the poi's axes. */
int paper_contact_releases(const struct poi *poi, const struct basis *axes,
                           const struct fish *fish);

#endif
