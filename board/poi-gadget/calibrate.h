/* calibrate.h -- `kingyo-poi calibrate`, which measures the scale of each draw wire at known marks.
 *
 * The instructions are printed to standard error. The lines for the configuration file are printed
 * to standard output. */
#ifndef KINGYO_BOARD_POI_GADGET_CALIBRATE_H
#define KINGYO_BOARD_POI_GADGET_CALIBRATE_H

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

/* Runs the calibration. Returns EXIT_OK, EXIT_NOT_SO if the marks do not fit, or EXIT_IO if a
 * sensor or standard input is missing. */
enum exit_code calibrate(const struct poi_config *config, const char *root);

#endif
