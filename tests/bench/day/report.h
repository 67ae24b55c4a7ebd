/* report.h -- prints the tables of a simulated day, compares the day with the goal, and gives the
 * operator advice. */
#ifndef KINGYO_TESTS_BENCH_DAY_REPORT_H
#define KINGYO_TESTS_BENCH_DAY_REPORT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "platform/os/exit_code.h"
#include "tests/bench/day/day.h"

/* Sums over the visitors that the caller of report_sums() selected. */
struct day_sums {
    uint32_t visitors, declined, left, played;
    uint32_t with_fish; /* Number of visitors who caught at least one fish. */
    uint32_t plays, caught;
};

/* Returns the sums over the visitors of the kind `kind` who chose the level `level`. REPORT_ALL
 * stands for all kinds or all levels. */
#define REPORT_ALL 0xffffffffu
struct day_sums report_sums(const struct day *day, uint32_t kind, uint32_t level);

/* Returns true if the share of visitors who caught a fish reaches the goal of the day. Visitors who
 * left the queue count as visitors without a fish. */
bool report_is_goal_met(const struct day *day);

/* Returns one sentence that advises the operator what to change if the goal is missed. */
const char *report_advice(const struct day *day);

/* Returns true if the accounts of the core agree with the rounds and catches of the day. */
bool report_is_money_right(const struct day *day, const struct day_money *money);

/* Prints the tables, the goal and the advice. Returns EXIT_OK, or EXIT_NOT_SO if the goal is missed
 * or the accounts differ. */
enum exit_code report_print(const struct day *day, const struct day_money *money);

/* Writes one line for each visitor to `file`. */
void report_write(const struct day *day, FILE *file);

#endif
