/* gamepad_queue.c -- implements the queue of reports and the sampling at intervals of one tick. */
#include "drivers/gamepad/gamepad_queue.h"

#include <string.h>

#define SAMPLE_NS 8333333ull /* Interval of the samples: one tick of the game, 1/120 s. */

void gamepad_queue_init(struct gamepad_queue *track, const struct view *view, uint64_t time_ns)
{
    *track = (struct gamepad_queue){ .sampled_ns = time_ns };
    gamepad_decoder_init(&track->hand, view);
}

void gamepad_queue_push(struct gamepad_queue *track, const struct gamepad_report *report)
{
    if (track->report_count == GAMEPAD_REPORTS_MAX) {
        gamepad_decoder_report(&track->hand, &track->report[0]);
        memmove(&track->report[0], &track->report[1],
                sizeof track->report - sizeof track->report[0]);
        track->report_count--;
    }
    track->report[track->report_count++] = *report;
}

/* Writes a sample every `step_ns` as long as its time is before `until_ns`. Returns the number of
 * samples. */
static uint32_t sample_until(struct gamepad_queue *track, uint64_t until_ns, uint64_t step_ns,
                             struct poi_sample *out, uint32_t max)
{
    uint32_t count = 0;
    while (count < max && track->sampled_ns + step_ns < until_ns) {
        track->sampled_ns += step_ns;
        out[count++] = gamepad_decoder_sample(&track->hand, track->sampled_ns);
    }
    return count;
}

uint32_t gamepad_queue_pop(struct gamepad_queue *track, uint64_t now_ns, struct poi_sample *out,
                           uint32_t max)
{
    if (max == 0) {
        return 0;
    }
    const uint64_t span_ns = now_ns > track->sampled_ns ? now_ns - track->sampled_ns : 0;
    /* After a stall of the caller the steps are larger, so that `max` samples cover the whole
     * time. */
    const uint64_t even_ns = span_ns / max + 1u;
    const uint64_t step_ns = even_ns > SAMPLE_NS ? even_ns : SAMPLE_NS;
    uint32_t count = 0;
    for (uint32_t i = 0; i < track->report_count; i++) {
        const struct gamepad_report *report = &track->report[i];
        count += sample_until(track, report->time_ns, step_ns, out + count, max - 1u - count);
        gamepad_decoder_report(&track->hand, report);
    }
    track->report_count = 0;
    count += sample_until(track, now_ns, step_ns, out + count, max - 1u - count);
    track->sampled_ns = now_ns;
    out[count++] = gamepad_decoder_sample(&track->hand, now_ns);
    return count;
}

void gamepad_queue_buttons(struct gamepad_queue *track, struct button_sample *out)
{
    for (uint32_t i = 0; i < track->report_count; i++) {
        gamepad_decoder_report(&track->hand, &track->report[i]);
    }
    track->report_count = 0;
    gamepad_decoder_buttons(&track->hand, out);
}
