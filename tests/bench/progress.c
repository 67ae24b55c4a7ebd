/* progress.c -- prints the progress of a benchmark on standard error. */
#include "tests/bench/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

struct progress progress_begin(const char *prefix, uint32_t count)
{
    return (struct progress){ .prefix = prefix,
                              .unit = "rounds",
                              .count = count,
                              .begin_s = now_s(),
                              .is_watched = isatty(STDERR_FILENO) };
}

void progress_add(struct progress *progress)
{
    progress->played++;
    const uint32_t percent = 100u * progress->played / progress->count;
    const double took_s = now_s() - progress->begin_s;
    const double left_s =
        took_s / (double)progress->played * (double)(progress->count - progress->played);
    if (progress->is_watched) {
        fprintf(stderr, "\r%s: %u of %u %s, %.0f s, %.0f s to go   ", progress->prefix,
                progress->played, progress->count, progress->unit, took_s, left_s);
    } else if (percent / 10u > progress->printed_percent / 10u) {
        fprintf(stderr, "%s: %u of %u %s, %.0f s, %.0f s to go\n", progress->prefix,
                progress->played, progress->count, progress->unit, took_s, left_s);
    }
    progress->printed_percent = percent;
}

double progress_end(const struct progress *progress)
{
    fputs(progress->is_watched ? "\n" : "", stderr);
    return now_s() - progress->begin_s;
}
