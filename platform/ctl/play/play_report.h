/* play_report.h -- prints the results of played rounds on standard output. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_PLAY_REPORT_H
#define KINGYO_PLATFORM_CTL_PLAY_PLAY_REPORT_H

#include <stdint.h>

#include "platform/ctl/lib/summary.h"
#include "platform/ctl/play/rounds.h"

/* Prints the result of one round as a line of text. `number` is the number of the round, counted
 * from 1. */
void play_report_round(uint32_t number, uint32_t seed, const struct round_result *result);

/* Prints a summary, for example "caught: median 2, p90 3.5, most 7", without a line end. */
void play_report_summary(const struct summary *summary);

/* Prints the results of all rounds and the summary as JSON. */
void play_report_json(const struct round_result *results, uint32_t count,
                      const struct summary *summary);

#endif
