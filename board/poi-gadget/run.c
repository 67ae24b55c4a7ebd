/* run.c -- runs the main loop of the poi's board. Each cycle starts at an absolute time, so that
 * delays do not accumulate. */
#include "board/poi-gadget/run.h"

#include <assert.h>
#include <errno.h>
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "board/poi-gadget/hid_gadget.h"
#include "board/poi-gadget/pose_script.h"
#include "platform/os/print.h"

/* Number of cycles of the main loop between two attempts to open a missing device. */
#define REOPEN_BEATS 64u

static volatile sig_atomic_t told_to_end;

static void on_signal(int number)
{
    (void)number;
    told_to_end = 1;
}

/* ---- Timing of the main loop ----------------------------------------------------------------- */

struct beat {
    uint64_t next_ns, period_ns, begin_ns;
    uint64_t count; /* Number of cycles that were due since the start of the loop. */
    uint32_t late;  /* Number of due cycles that were skipped because the board was too slow. */
};

static uint64_t run_now_ns(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (uint64_t)time.tv_sec * 1000000000u + (uint64_t)time.tv_nsec;
}

/* Sleeps until the next cycle is due. Returns the time in seconds since the previous cycle. */
static float beat_wait(struct beat *beat)
{
    assert(beat->period_ns > 0);
    const uint64_t now = run_now_ns();
    uint64_t beats = 1;
    if (now > beat->next_ns + beat->period_ns) {
        const uint64_t late = (now - beat->next_ns) / beat->period_ns;
        beat->late += (uint32_t)late;
        beats += late;
    }
    beat->next_ns += beats * beat->period_ns;
    beat->count += beats;
    const struct timespec until = { .tv_sec = (time_t)(beat->next_ns / 1000000000u),
                                    .tv_nsec = (long)(beat->next_ns % 1000000000u) };
    while (!told_to_end && clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, NULL) == EINTR) {
    }
    return (float)(beats * beat->period_ns) * 1e-9f;
}

/* ---- Statistics and the USB device ---------------------------------------------------------- */

static void print_figures(const struct hid_gadget *gadget, const struct beat *beat)
{
    const double seconds = (double)(beat->next_ns - beat->begin_ns) * 1e-9;
    print_error("kingyo-poi: %u reports sent in %.1f s, %u not fetched in time; %u of %" PRIu64
                " beats late; felt %u, %u refused",
                gadget->sent_count, seconds, gadget->skipped_count, beat->late, beat->count,
                gadget->felt_count, gadget->refused_count);
}

/* Sends the report if it is new, and forwards the host's force feedback to `sink`. */
static void exchange(struct hid_gadget *gadget, struct feel_sink sink, float seconds,
                     const struct poi_report *report)
{
    struct poi_force force;
    if (report) {
        hid_gadget_send(gadget, report);
    }
    const int felt = hid_gadget_feel(gadget, &force);
    if (sink.feel) {
        sink.feel(sink.self, felt ? &force : NULL, seconds);
    }
}

/* Runs the main loop. If `gadget` is null, prints each new pose as text. Returns EXIT_OK, or
 * EXIT_BAD_DATA if the source has an invalid pose. */
static enum exit_code run_loop(const struct run_options *options, struct pose_source source,
                               struct hid_gadget *gadget, struct feel_sink sink)
{
    const uint64_t now = run_now_ns();
    struct beat beat = { .next_ns = now, .begin_ns = now };
    struct poi_report report = { 0 };
    enum pose_result result = POSE_NONE;
    assert(options->rate_hz >= RUN_RATE_MIN_HZ && options->rate_hz <= RUN_RATE_MAX_HZ);
    const struct sigaction action = { .sa_handler = on_signal };
    told_to_end = 0;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    signal(SIGPIPE, SIG_IGN);
    beat.period_ns = 1000000000u / options->rate_hz;
    float seconds = 1.0f / (float)options->rate_hz;
    while (result >= 0 && !told_to_end && (gadget || !ferror(stdout)) &&
           (options->seconds == 0 ||
            (float)(beat.next_ns - beat.begin_ns) * 1e-9f <= (float)options->seconds)) {
        if (gadget && gadget->fd < 0 && beat.count % REOPEN_BEATS == 0) {
            hid_gadget_open(gadget);
        }
        result = source.step(source.self, seconds, &report);
        if (gadget) {
            exchange(gadget, sink, seconds, result == POSE_NEW ? &report : NULL);
        } else if (result == POSE_NEW) {
            char text[POSE_LINE_SIZE];
            pose_line_write(&report, text);
            puts(text);
            fflush(stdout);
        }
        seconds = beat_wait(&beat);
    }
    if (sink.stop) {
        sink.stop(sink.self);
    }
    if (gadget) {
        print_figures(gadget, &beat);
        hid_gadget_close(gadget);
    }
    return result == POSE_BAD ? EXIT_BAD_DATA : EXIT_OK;
}

enum exit_code run(const struct run_options *options, struct pose_source source,
                   struct feel_sink sink)
{
    struct hid_gadget gadget;
    hid_gadget_init(&gadget, options->device);
    if (!hid_gadget_open(&gadget)) {
        print_error("%s: %s; 'kingyo-poi-gadget start' makes it, or name it by --device",
                    options->device, strerror(errno));
        return EXIT_IO;
    }
    return run_loop(options, source, &gadget, sink);
}

enum exit_code run_watch(const struct run_options *options, struct pose_source source)
{
    return run_loop(options, source, NULL, (struct feel_sink){ 0 });
}
