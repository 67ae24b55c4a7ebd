/* bench_usb.c -- benchmark of the two delays of a USB poi's report: from the bus to its time stamp,
 * and from the time stamp to the frame that takes the report.
 *
 * Usage: bench_usb [SECONDS]
 *
 * The benchmark runs the real USB thread in real time on a simulated bus
 * (tests/unit/support/usb/usb_sim.h) with 1,000 reports per second. A loop of 60 frames per second
 * takes all queued reports, and then works for 4 ms in each frame. The figures do not include the
 * kernel's host controller driver and the cable, which takes at most 1 ms at full speed.
 *
 * Returns exit status 1 if a report was lost or arrived out of order. */
#include <pthread.h>
#include <stdatomic.h>
#include <time.h>

#include "drivers/usb/usb_transport.h"
#include "platform/kiosk/frame_pacer.h"
#include "tests/unit/support/usb/usb_fixture.h"

#define REPORT_NS 1000000ull
#define FRAME_NS 16666667ull
#define WORK_NS 4000000ull
#define SECONDS_MAX 600u

static struct usb_fixture fixture;
static struct frame_timing to_stamp, to_frame, call;
/* Send time of each report in ns. The index is the number that the report contains. */
static uint64_t sent_ns[65536];
static atomic_int is_over;
static uint32_t device;

static uint64_t now_ns(void)
{
    return clock_device().ops->now_ns(NULL);
}

static void *wire(void *self)
{
    uint64_t next_ns = now_ns();
    (void)self;
    for (uint32_t i = 0; !atomic_load(&is_over); i++) {
        next_ns += REPORT_NS;
        clock_sleep_until(next_ns);
        sent_ns[i & 0xffffu] = now_ns();
        fixture_send(device, i & 0xffffu);
    }
    return NULL;
}

/* Takes all queued reports. Returns how many of them did not have the expected next number. */
static uint32_t take_all(struct hid_port *port, uint32_t *expected)
{
    struct hid_raw raw;
    uint32_t wrong = 0;
    int result;
    do {
        const uint64_t begin_ns = now_ns();
        result = hid_port_take(port, &raw);
        const uint64_t end_ns = now_ns();
        frame_timing_add(&call, end_ns - begin_ns);
        if (result == 1) {
            const uint32_t number = fixture_number(&raw);
            wrong += number != *expected;
            *expected = (number + 1u) & 0xffffu;
            frame_timing_add(&to_stamp, raw.time_ns - sent_ns[number]);
            frame_timing_add(&to_frame, end_ns - raw.time_ns);
        }
    } while (result == 1);
    return wrong;
}

static void print_timing(const char *what, const struct frame_timing *timing)
{
    printf("%-28s p50 %6.2f ms   p99 %6.2f ms   at most %6.2f ms\n", what,
           (double)frame_timing_quantile_ns(timing, 0.5) * 1e-6,
           (double)frame_timing_quantile_ns(timing, 0.99) * 1e-6, (double)timing->max_ns * 1e-6);
}

static uint32_t run(uint32_t seconds)
{
    struct hid_port *const port = usb_transport_port(fixture.thread, 0);
    const uint64_t end_ns = now_ns() + seconds * 1000000000ull;
    uint32_t expected = 0, wrong = 0;
    for (uint64_t frame_ns = now_ns(); frame_ns < end_ns; frame_ns += FRAME_NS) {
        clock_sleep_until(frame_ns);
        wrong += take_all(port, &expected);
        /* Keeps one processor core busy, as the computation of a frame does, so that the USB thread
         * must use another core. */
        while (now_ns() < frame_ns + WORK_NS) {
        }
    }
    return wrong + atomic_load(&port->lost);
}

int main(int argc, char **argv)
{
    const uint32_t requested = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 10u;
    const uint32_t seconds = requested > 0 && requested <= SECONDS_MAX ? requested : 10u;
    struct hid_device_info face;
    pthread_t thread;
    fixture_prepare(&fixture);
    fixture_start(&fixture, NULL, 0);
    device = usb_sim_plug(&own_poi, 1);
    if (!fixture_open(&fixture, 0, &face) || pthread_create(&thread, NULL, wire, NULL)) {
        return 1;
    }
    const uint32_t wrong = run(seconds);
    atomic_store(&is_over, 1);
    pthread_join(thread, NULL);
    const uint32_t left = fixture_end(&fixture);
    printf("%llu reports in %u s, %u lost or out of order\n", (unsigned long long)to_stamp.count,
           seconds, wrong);
    print_timing("wire to stamp", &to_stamp);
    print_timing("stamp to frame (60 a second)", &to_frame);
    printf("%-28s at most %.1f us\n", "one call of the frame loop", (double)call.max_ns * 1e-3);
    return wrong > 0 || left > 0;
}
