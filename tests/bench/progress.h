/* progress.h -- prints on standard error how many rounds of a benchmark are played. */
#ifndef KINGYO_TESTS_BENCH_PROGRESS_H
#define KINGYO_TESTS_BENCH_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    const char *speaker;
    uint32_t played, count, printed_percent;
    double begin_s;
    bool is_watched; /* True if standard error is a terminal. */
};

/* Returns the progress of `count` rounds that begin now. */
struct progress progress_begin(const char *speaker, uint32_t count);

/* Counts one more round. Prints the progress after each round on a terminal, and after each tenth
 * of the rounds in a log. Only one thread at a time may call the function. */
void progress_add(struct progress *progress);

/* Ends the line on a terminal. Returns the seconds since progress_begin(). */
double progress_end(const struct progress *progress);

#endif
