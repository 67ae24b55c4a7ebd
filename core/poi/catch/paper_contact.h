/* paper_contact.h -- the fish that touch the upper side of the paper. */
#ifndef KINGYO_CORE_POI_CATCH_PAPER_CONTACT_H
#define KINGYO_CORE_POI_CATCH_PAPER_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Returns 1 if a swimming fish is above intact paper and near enough for capture. The fish's
 * position gives the side of the paper, because the contact solver lets no fish through. `axes` are
 * the poi's. */
int paper_contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish);

/* Returns 1 if a ring blocked by fish presses this fish against the surface. Such a fish must slip
 * off, because the poi could otherwise never be lifted. */
int paper_contact_squeezed(const struct poi *poi, const struct fish *fish);

/* Returns 1 if fish block the ring while the hand pulls up from at least 3 cm above it: 6.5 N. */
int paper_contact_jams(const struct poi *poi);

/* Returns 1 if this fish jams the ring and must leave now. The fish between disc and surface leave
 * from the edge inward, more of them the longer the jam lasts. After 0.1 s all that touch the ring
 * leave. `axes` are the poi's. */
int paper_contact_releases(const struct poi *poi, const struct basis *axes,
                           const struct fish *fish);

#endif
