/* contact.h -- which fish touch the upper side of the paper. */
#ifndef KINGYO_CORE_POI_CONTACT_H
#define KINGYO_CORE_POI_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Whether a swimming fish is over paper that holds and so near that the poi may take it up. Which
 * side of the paper it is on is simply where it is: parting lets none through. `axes` are the
 * poi's. */
int contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish);

/* Whether a ring that fish hold up presses this one against the surface: it must slip off, or the
 * poi could never be lifted. */
int contact_squeezed(const struct poi *poi, const struct fish *fish);

/* Whether fish hold the ring so fast that a hand pulls up in vain, from 3 cm over it: 6.5 N. */
int contact_jams(const struct poi *poi);

/* Whether this is one of them whose turn it is: those between the disc and the surface let go from
 * the edge inward, however deep it is, the longer it jams the more of them; after 0.1 s all who
 * touch it do. `axes` are the poi's. */
int contact_holds(const struct poi *poi, const struct basis *axes, const struct fish *fish);

#endif
