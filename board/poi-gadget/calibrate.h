/* calibrate.h -- the command `kingyo-poi calibrate`, which calibrates each draw wire at marks with
 * known positions.
 *
 * The instructions for the user are printed to standard error. The resulting lines for the
 * configuration file are printed to standard output. */
#ifndef KINGYO_BOARD_POI_GADGET_CALIBRATE_H
#define KINGYO_BOARD_POI_GADGET_CALIBRATE_H

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

/* Runs the calibration. Returns EXIT_OK. Returns EXIT_NOT_SO if the measurements at the marks
 * contradict each other, or EXIT_IO if a sensor or standard input is missing. */
enum exit_code calibrate(const struct poi_config *config, const char *root);

#endif
