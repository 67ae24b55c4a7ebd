/* commands.h -- the commands `kingyo-poi calibrate`, which calibrates each draw wire at marks with
 * known positions, and `kingyo-poi test`, which checks each part of a poi and prints advice for
 * each failure.
 *
 * The instructions of the calibration are printed to standard error. Its results, which are lines
 * for the configuration file, and the results of the checks are printed to standard output. */
#ifndef KINGYO_BOARD_POI_GADGET_COMMANDS_H
#define KINGYO_BOARD_POI_GADGET_COMMANDS_H

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

/* Runs the calibration. Returns EXIT_OK. Returns EXIT_NOT_SO if the measurements at the marks
 * contradict each other, or EXIT_IO if a sensor or standard input is missing. */
enum exit_code commands_calibrate(const struct poi_config *config, const char *root);

/* Runs all checks. The motor turns for half a second. `root` is the prefix of all paths: "" for
 * this machine, or a test folder. Returns EXIT_OK, or EXIT_NOT_SO if a check failed. */
enum exit_code commands_self_test(const struct poi_config *config, const char *root,
                                  const char *device);

#endif
