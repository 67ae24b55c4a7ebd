/* self_test.h -- `kingyo-poi test`: each part of a poi, and one line of what to do about it. */
#ifndef KINGYO_POI_GADGET_SELF_TEST_H
#define KINGYO_POI_GADGET_SELF_TEST_H

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

/* Lets the motor hum for half a second. EXIT_NOT_SO where something failed. */
enum exit_code self_test(const struct poi_config *config, const char *root, const char *device);

#endif
