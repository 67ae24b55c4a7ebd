/* progress.h -- prints on standard error how many rounds of a benchmark are done. */
#ifndef KINGYO_TESTS_BENCH_PROGRESS_H
#define KINGYO_TESTS_BENCH_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    const char *prefix;
    /* Word for what is counted. The default is "rounds"; the caller may change the word. */
    const char *unit;
    uint32_t played, count, printed_percent;
    double begin_s;
    bool is_watched; /* True if standard error is a terminal. */
};

/* Starts to count the progress of `count` rounds. `prefix` is the program's name in the output. */
struct progress progress_begin(const char *prefix, uint32_t count);

/* Counts one more round. On a terminal, the function prints the progress after each round;
 * otherwise it prints the progress after each tenth of the rounds. The caller must ensure that only
 * one thread calls this function at a time. */
void progress_add(struct progress *progress);

/* Ends the line of the progress on a terminal. Returns the seconds since progress_begin(). */
double progress_end(const struct progress *progress);

#endif
