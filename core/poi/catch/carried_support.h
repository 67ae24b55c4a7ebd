/* carried_support.h -- tests whether the paper and the ring of a poi (paper scoop) support a
 * carried fish.
 *
 * A fish falls only through a hole under its body. A pinhole under the body or a hole beside the
 * body does not drop the fish. A hole as wide as the fish's girth drops the fish. A hole that
 * leaves only a narrow strip of paper under the fish also drops it. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_SUPPORT_H
#define KINGYO_CORE_POI_CATCH_CARRIED_SUPPORT_H

#include "core/poi/catch/carried_fish.h"
#include "core/poi/paper/sheet.h"

/* Returns 1 if paper or ring supports the middle of a lying fish, and also its front half or its
 * rear half. Otherwise returns 0. A fish whose centre is beyond the ring is not supported. */
int carried_support_holds(const struct sheet *sheet, const struct carried_fish *carried,
                          const struct fish *fish);

#endif
