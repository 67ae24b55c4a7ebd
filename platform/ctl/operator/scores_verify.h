/* scores_verify.h -- `kingyoctl scores verify` and `kingyoctl scores replay`, which check or write
 * the replay of a score. */
#ifndef KINGYO_PLATFORM_CTL_OPERATOR_SCORES_VERIFY_H
#define KINGYO_PLATFORM_CTL_OPERATOR_SCORES_VERIFY_H

#include "platform/ctl/lib/ctl.h"

/* Runs the command. argv[0] is 'verify' or 'replay'. */
enum exit_code scores_verify(int argc, const char *const *argv);

#endif
