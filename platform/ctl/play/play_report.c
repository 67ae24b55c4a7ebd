/* play_report.c -- prints the results of played rounds as text and as JSON. */
#include "platform/ctl/play/play_report.h"

#include <stdio.h>

#include "platform/os/number.h"

/* Prints a value with one decimal, or without decimals if the value is whole. */
static void print_short(double value)
{
    char digits[NUMBER_FIXED_MAX];
    const double whole = (double)(uint64_t)value;
    const uint32_t length = number_print_fixed(digits, value, value > whole ? 1 : 0);
    printf("%.*s", (int)length, digits);
}

static void print_fixed(const char *before, double value, uint32_t decimals)
{
    char digits[NUMBER_FIXED_MAX];
    const uint32_t length = number_print_fixed(digits, value, decimals);
    printf("%s%.*s", before, (int)length, digits);
}

void play_report_round(uint32_t number, uint32_t seed, const struct round_result *result)
{
    printf("round %-4u seed %-10u %3u caught in", number, seed, result->caught);
    print_fixed(" ", result->length_s, 1);
    printf(" s, %u scoops, %u fouls,", result->scoops, result->fouls);
    if (result->torn) {
        print_fixed(" torn at ", result->torn_at_s, 1);
        fputs(" s,", stdout);
        if (result->sheets > 1) {
            printf(" %u sheets,", result->sheets);
        }
    } else {
        fputs(" not torn,", stdout);
    }
    printf(" holes of %u mm2, hash %016llx\n", result->hole_area_mm2,
           (unsigned long long)result->state_hash);
}

void play_report_summary(const struct summary *summary)
{
    fputs("caught: median ", stdout);
    print_short(summary->median);
    fputs(", p90 ", stdout);
    print_short(summary->p90);
    printf(", most %u", summary->max);
}

static void tell_json(const struct round_result *result, int is_first)
{
    printf("%s{\"caught\": %u, \"scoops\": %u, \"fouls\": %u, \"torn_at_s\": ",
           is_first ? "" : ", ", result->caught, result->scoops, result->fouls);
    if (result->torn) {
        print_fixed("", result->torn_at_s, 3);
    } else {
        fputs("null", stdout);
    }
    printf(", \"sheets\": %u, \"hole_area_mm2\": %u, \"state_hash\": \"%016llx\"}", result->sheets,
           result->hole_area_mm2, (unsigned long long)result->state_hash);
}

void play_report_json(const struct round_result *results, uint32_t count,
                      const struct summary *summary)
{
    fputs("{\"rounds\": [", stdout);
    for (uint32_t i = 0; i < count; i++) {
        tell_json(&results[i], i == 0);
    }
    fputs("], \"caught_median\": ", stdout);
    print_short(summary->median);
    fputs(", \"caught_p90\": ", stdout);
    print_short(summary->p90);
    printf(", \"caught_max\": %u}\n", summary->max);
}
