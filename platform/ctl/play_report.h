/* play_report.h -- what came of rounds, on standard output. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_REPORT_H
#define KINGYO_PLATFORM_CTL_PLAY_REPORT_H

#include <stdint.h>

#include "platform/ctl/rounds.h"
#include "platform/ctl/summary.h"

/* A line for people; `number` from 1. */
void play_report_round(uint32_t number, uint32_t seed, const struct round_result *result);

/* "caught: median 2, p90 3.5, most 7", without the line's end. */
void play_report_summary(const struct summary *summary);

/* All of it for programs. */
void play_report_json(const struct round_result *results, uint32_t count,
                      const struct summary *summary);

#endif
