/* calibrate.h -- `kingyo-poi calibrate`: asks for the eye at each mark, tells what each wire means.
 *
 * Questions go to standard error; the lines for the config go to standard output. */
#ifndef KINGYO_POI_GADGET_CALIBRATE_H
#define KINGYO_POI_GADGET_CALIBRATE_H

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

/* EXIT_NOT_SO: the marks do not fit; EXIT_IO: a sensor or standard input is missing. */
enum exit_code calibrate(const struct poi_config *config, const char *root);

#endif
