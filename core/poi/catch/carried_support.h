/* carried_support.h -- support of a carried fish by paper and ring under several points of its
 * body.
 *
 * A fish falls only through a hole under it. A pinhole under its middle does not drop it, and
 * neither does a hole beside it. A hole as wide as its girth drops it, and so does a hole that
 * leaves only a strip of paper. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_SUPPORT_H
#define KINGYO_CORE_POI_CATCH_CARRIED_SUPPORT_H

#include "core/poi/catch/carried_fish.h"
#include "core/poi/paper/sheet.h"

/* Returns 1 if a lying fish is supported: at its middle, and at its front half or its rear. A fish
 * whose centre is beyond the ring slips off. */
int carried_support_holds(const struct sheet *sheet, const struct carried_fish *carried,
                          const struct fish *fish);

#endif
