/* track.h -- a function of progress as few enough samples with straight lines between.
 *
 * An animation in a file is a table. How dense it must be depends on how the function bends:
 * samples are put where the straight line would be wrong, and nowhere else. */
#ifndef KINGYO_PLATFORM_CTL_TRACK_H
#define KINGYO_PLATFORM_CTL_TRACK_H

#include <stdbool.h>
#include <stdint.h>

#define TRACK_HALVINGS 14u /* The densest: a 16,384th of a step between two marks. */

struct track_function {
    uint32_t width; /* Numbers that it gives at a progress. */
    void (*ask)(const void *self, float progress, float *values);
    /* How wrong it is to take the middle of `from` and `to` for `exact`. */
    float (*error)(const void *self, const float *from, const float *to, const float *exact);
    const void *self;
};

struct track {
    uint32_t count, width;
    float *progress; /* count, rising. */
    float *values;   /* count x width; both the track's own. */
};

/* Samples at every mark (rising, from 0 to 1, 2 or more) and between until the middle of no two
 * neighbours is wrong by more than `tolerance`. False when there is no memory. */
bool track_fit(struct track *track, const struct track_function *function, const float *marks,
               uint32_t mark_count, float tolerance);

void track_free(struct track *track);

#endif
