/* self_test.h -- the command `kingyo-poi test`, which checks each part of a poi and prints advice
 * for each failure. */
#ifndef KINGYO_BOARD_POI_GADGET_SELF_TEST_H
#define KINGYO_BOARD_POI_GADGET_SELF_TEST_H

#include "board/poi-gadget/poi_config.h"
#include "board/poi-gadget/run.h"

/* Runs all checks. The motor turns for half a second. `root` is the prefix of all paths: "" for
 * this machine, or a test folder. Returns EXIT_OK, or EXIT_NOT_SO if a check failed. */
enum exit_code self_test(const struct poi_config *config, const char *root, const char *device);

#endif
