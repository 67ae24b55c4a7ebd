/* poi_pad.h -- a game pad as a poi, as a fan, and as a panel of buttons. */
#ifndef KINGYO_DRIVERS_POI_PAD_H
#define KINGYO_DRIVERS_POI_PAD_H

#include "drivers/pads.h"
#include "platform/hal.h"

/* Place `index` < PADS_MAX. */
struct hal_poi pads_poi(struct pads *pads, uint32_t index);
struct hal_shade pads_fan(struct pads *pads, uint32_t index);
int pads_is_there(void *pad); /* `pad`: &pads->pad[index]. Looks for new ones, too. */

/* START, LEFT, RIGHT, OK and LANGUAGE of all of them; asked after the pois. */
struct hal_buttons pads_buttons(struct pads *pads);

#endif
