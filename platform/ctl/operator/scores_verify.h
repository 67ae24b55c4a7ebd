/* scores_verify.h -- the subcommands `kingyoctl scores verify` and `kingyoctl scores replay`.
 *
 * `verify` recomputes the stored replay of a score and compares the result. `replay` writes the
 * stored replay to a file. */
#ifndef KINGYO_PLATFORM_CTL_OPERATOR_SCORES_VERIFY_H
#define KINGYO_PLATFORM_CTL_OPERATOR_SCORES_VERIFY_H

#include "platform/ctl/lib/ctl.h"

/* Runs the subcommand. argv[0] is "verify" or "replay". Returns the exit code of the program. */
enum exit_code scores_verify(int argc, const char *const *argv);

#endif
