/* run.c -- runs the main loop of the poi's board. Each cycle starts at an absolute time, so that
 * delays do not accumulate. */
#include "board/poi-gadget/run.h"

#include <assert.h>
#include <errno.h>
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "board/poi-gadget/hid_gadget.h"
#include "board/poi-gadget/pose_script.h"
#include "platform/os/clock.h"
#include "platform/os/print.h"

/* Number of cycles of the main loop between two attempts to open a missing device. */
#define REOPEN_BEATS 64u

static volatile sig_atomic_t must_stop;

static void on_signal(int number)
{
    (void)number;
    must_stop = 1;
}

/* ---- Timing of the main loop ----------------------------------------------------------------- */

struct beat {
    uint64_t next_ns, period_ns, begin_ns;
    uint64_t count; /* Number of cycles that have become due since the start of the loop. */
    uint32_t late;  /* Number of due cycles that were skipped because the board was too slow. */
};

/* Sleeps until the next cycle is due. Returns the time in seconds since the previous cycle. */
static float beat_wait(struct beat *beat)
{
    assert(beat->period_ns > 0);
    const uint64_t now = clock_ns(CLOCK_MONOTONIC);
    uint64_t beats = 1;
    if (now > beat->next_ns + beat->period_ns) {
        const uint64_t late = (now - beat->next_ns) / beat->period_ns;
        beat->late += (uint32_t)late;
        beats += late;
    }
    beat->next_ns += beats * beat->period_ns;
    beat->count += beats;
    while (!must_stop && clock_ns(CLOCK_MONOTONIC) < beat->next_ns) {
        clock_sleep_until(beat->next_ns);
    }
    return (float)(beats * beat->period_ns) * 1e-9f;
}

/* ---- Statistics and the USB device ---------------------------------------------------------- */

/* Sends the report if it is new, and forwards the host's force feedback to `sink`. */
static void exchange(struct hid_gadget *gadget, struct force_sink sink, float seconds,
                     const struct poi_report *report)
{
    struct poi_force force;
    if (report) {
        hid_gadget_send(gadget, report);
    }
    sink.feel(sink.self, hid_gadget_feel(gadget, &force) ? &force : NULL, seconds);
}

enum exit_code run(const struct run_options *options, struct pose_source source,
                   struct force_sink sink)
{
    assert(options->rate_hz >= RUN_RATE_MIN_HZ && options->rate_hz <= RUN_RATE_MAX_HZ);
    const uint64_t now = clock_ns(CLOCK_MONOTONIC);
    struct beat beat = { .next_ns = now,
                         .begin_ns = now,
                         .period_ns = NS_PER_S / options->rate_hz };
    struct hid_gadget gadget;
    struct poi_report report = { 0 };
    enum pose_result result = POSE_NONE;
    hid_gadget_init(&gadget, options->device);
    if (!options->prints && !hid_gadget_open(&gadget)) {
        return print_fail(
            EXIT_IO,
            "kingyo-poi: %s: %s; 'kingyo-poi-gadget start' creates the device, or name "
            "another device with --device",
            options->device, strerror(errno));
    }
    const struct sigaction action = { .sa_handler = on_signal };
    must_stop = 0;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    signal(SIGPIPE, SIG_IGN);
    float seconds = 1.0f / (float)options->rate_hz;
    while (result >= 0 && !must_stop && !(options->prints && ferror(stdout)) &&
           (options->seconds == 0 ||
            (float)(beat.next_ns - beat.begin_ns) * 1e-9f <= (float)options->seconds)) {
        result = source.step(source.self, seconds, &report);
        if (!options->prints) {
            if (gadget.fd < 0 && beat.count % REOPEN_BEATS == 0) {
                hid_gadget_open(&gadget);
            }
            exchange(&gadget, sink, seconds, result == POSE_NEW ? &report : NULL);
        } else if (result == POSE_NEW) {
            char text[POSE_LINE_SIZE];
            pose_line_write(&report, text);
            puts(text);
            fflush(stdout);
        }
        seconds = beat_wait(&beat);
    }
    if (!options->prints) {
        sink.stop(sink.self);
        print_error("kingyo-poi: %u reports sent in %.1f s, %u not fetched in time; %u of %" PRIu64
                    " cycles late; %u force feedback reports received, %u rejected",
                    gadget.sent_count, (double)(beat.next_ns - beat.begin_ns) * 1e-9,
                    gadget.skipped_count, beat.late, beat.count, gadget.felt_count,
                    gadget.refused_count);
        hid_gadget_close(&gadget);
    }
    return result == POSE_BAD ? EXIT_BAD_DATA : EXIT_OK;
}
