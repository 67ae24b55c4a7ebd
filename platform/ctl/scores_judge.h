/* scores_judge.h -- `kingyoctl scores verify` and `scores replay`: what stands behind a score. */
#ifndef KINGYO_PLATFORM_CTL_SCORES_JUDGE_H
#define KINGYO_PLATFORM_CTL_SCORES_JUDGE_H

#include "platform/ctl/ctl.h"

/* argv[0] is 'verify' or 'replay'. */
enum exit_code scores_judge(int argc, const char *const *argv);

#endif
