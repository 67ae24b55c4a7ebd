/* carried_support.h -- support of a carried fish by the paper and the ring of a poi (paper scoop).
 *
 * A fish falls only through a hole under its body. A pinhole under its middle or a hole beside it
 * does not drop the fish. A hole as wide as the fish's girth drops it, and so does a hole that
 * leaves only a narrow strip of paper under it. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_SUPPORT_H
#define KINGYO_CORE_POI_CATCH_CARRIED_SUPPORT_H

#include "core/poi/catch/carried_fish.h"
#include "core/poi/paper/sheet.h"

/* Returns 1 if paper or ring supports a lying fish at its middle, and also at its front half or its
 * rear half; otherwise 0. A fish whose centre is beyond the ring is not supported. */
int carried_support_holds(const struct sheet *sheet, const struct carried_fish *carried,
                          const struct fish *fish);

#endif
