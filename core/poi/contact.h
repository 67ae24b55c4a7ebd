/* contact.h -- which fish touch the upper side of the paper. */
#ifndef KINGYO_CORE_POI_CONTACT_H
#define KINGYO_CORE_POI_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Whether a swimming fish is over paper that holds and so near that the poi may take it up. Which
 * side of the paper it is on is simply where it is: parting lets none through. `axes` are the
 * poi's. */
int contact_fish(const struct poi *poi, const struct basis *axes, const struct fish *fish);

/* Whether a ring that fish hold up presses this one against the surface, itself or by others that
 * lie between: it must slip off, or the poi could never be lifted. */
int contact_squeezed(const struct poi *poi, const struct fish *fish);

#endif
