/* footing.h -- what bears a fish on a poi: paper and ring under several points of its body.
 *
 * A hole drops who is truly over it. A pinhole under the middle of a fish drops nobody, and no hole
 * beside it; one as wide as its girth does, and so does one that leaves it nothing but a strip. */
#ifndef KINGYO_CORE_POI_FOOTING_H
#define KINGYO_CORE_POI_FOOTING_H

#include "core/poi/rider.h"
#include "core/poi/sheet.h"

/* Whether a lying rider stays up: its middle lies on something, and so does its front half or its
 * rear. Its centre beyond the ring, it slips off. */
int footing_holds(const struct sheet *sheet, const struct rider *rider, const struct fish *fish);

#endif
