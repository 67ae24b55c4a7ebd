/* bench_reports.c -- benchmark of the time from the arrival of a USB poi's report to the tick that
 * uses the report.
 *
 * Usage: bench_reports [SECONDS [REPORT_HZ [FRAME_MS [WORK_MS]]]]. The defaults are 10 500 16.667
 * 5.
 *
 * The benchmark runs the real frame loop, decoder and ring buffer on the real clock. A test thread
 * replaces the libusb thread and pushes reports at the rate of a poi. A test display replaces the
 * screen: it takes WORK_MS to draw and returns at the next multiple of FRAME_MS. The benchmark
 * prints the same figures that the kiosk prints at its end. These figures do not include the cable,
 * the host controller, libusb, or the frame after the tick (bench_latency measures that frame).
 *
 * Returns exit status 1 if reports were lost or if the 99th percentile exceeds one frame plus 2
 * ms. */
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/tank/preset.h"
#include "drivers/hid/poi_report.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/null.h"
#include "drivers/hid/hid_port.h"
#include "platform/kiosk/kiosk.h"
#include "platform/os/clock.h"

static struct bench {
    double seconds, report_hz, frame_ms, work_ms;
    struct hal_clock clock;
    struct hid_port port;
    struct poi_hid poi;
    struct kiosk kiosk;
    uint64_t beat_ns;
    atomic_int stop;
    uint32_t sent;
} bench = { .seconds = 10.0, .report_hz = 500.0, .frame_ms = 16.667, .work_ms = 5.0 };

static uint64_t now_ns(void)
{
    return bench.clock.ops->now_ns(bench.clock.self);
}

/* Pushes the report with the number `index` into the queue of the port. The simulated poi moves in
 * a circle over the water. */
static void push_report(uint32_t index)
{
    uint8_t bytes[POI_REPORT_SIZE];
    const float turn = (float)index / (float)bench.report_hz;
    const struct poi_report report = {
        .target.position_m = v3(0.1f * f_cos(turn), 0.05f, 0.1f * f_sin(turn)),
        .sequence = (uint8_t)index,
    };
    poi_report_encode(&report, bytes);
    hid_port_report(&bench.port, now_ns(), bytes, sizeof bytes);
}

static void *run_poi(void *context)
{
    const uint64_t begin_ns = now_ns();
    (void)context;
    while (!atomic_load(&bench.stop)) {
        bench.sent++;
        clock_sleep_until(begin_ns + (uint64_t)(1e9 * bench.sent / bench.report_hz));
        push_report(bench.sent);
    }
    return NULL;
}

static int screen_present(void *self, const struct scene *scene)
{
    const uint64_t beat_ns = (uint64_t)(bench.frame_ms * 1e6);
    const uint64_t drawn_ns = now_ns() + (uint64_t)(bench.work_ms * 1e6);
    (void)self;
    (void)scene;
    /* Keeps the processor core busy for WORK_MS, as drawing does. */
    while (now_ns() < drawn_ns) {
    }
    bench.beat_ns += beat_ns * ((drawn_ns - bench.beat_ns) / beat_ns + 1u);
    clock_sleep_until(bench.beat_ns);
    return HAL_OK;
}

/* Takes the force feedback report, which goes to the poi, from the port and discards the report. */
static void take_feeling(void *self)
{
    (void)self;
    if (hid_port_outgoing(&bench.port) > 0) {
        hid_port_sent(&bench.port);
    }
}

static void wire(struct hal *hal)
{
    static struct hid_device_info face = { .identity = { .name = "Kingyo poi" } };
    static struct hal_display_ops screen;
    memcpy(face.descriptor, poi_descriptor, sizeof poi_descriptor);
    face.descriptor_size = sizeof poi_descriptor;
    hid_port_init(&bench.port, take_feeling, NULL);
    hid_port_attach(&bench.port, &face);
    poi_hid_init(&bench.poi, &bench.port, bench.clock, (struct hid_mapper){ 0 },
                 &tank_preset(TANK_PRESET_FESTIVAL)->view);
    *hal = null_hal(NULL);
    hal->clock = bench.clock;
    hal->poi[0] = poi_hid_devices(&bench.poi).poi;
    screen = *hal->display.ops;
    screen.present = screen_present;
    hal->display.ops = &screen;
}

static int print_result(uint32_t lost)
{
    const struct frame_timing *wait = &bench.kiosk.report_wait;
    const double median_ms = (double)frame_timing_quantile_ns(wait, 0.5) * 1e-6;
    const double p99_ms = (double)frame_timing_quantile_ns(wait, 0.99) * 1e-6;
    printf("%.0f reports a second, a frame each %.1f ms of which %.1f are work: %llu of %u used, "
           "%u lost; arrival to tick: median %.1f ms, p99 %.1f ms, max %.1f ms\n",
           bench.report_hz, bench.frame_ms, bench.work_ms, (unsigned long long)wait->count,
           bench.sent, lost, median_ms, p99_ms, (double)wait->max_ns * 1e-6);
    return lost == 0 && wait->count > 0 && p99_ms < bench.frame_ms + 2.0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    double *const figures[] = { &bench.seconds, &bench.report_hz, &bench.frame_ms, &bench.work_ms };
    static const struct kiosk_config config = { .core = { .seed = 1 } };
    struct hal hal;
    pthread_t thread;
    for (int i = 1; i < argc && i <= 4; i++) {
        *figures[i - 1] = strtod(argv[i], NULL);
    }
    bench.clock = clock_device();
    wire(&hal);
    if (kiosk_init(&bench.kiosk, &hal, &config) != CORE_OK ||
        pthread_create(&thread, NULL, run_poi, NULL) != 0) {
        return 2;
    }
    bench.beat_ns = now_ns();
    const uint64_t end_ns = bench.beat_ns + (uint64_t)(bench.seconds * 1e9);
    while (now_ns() < end_ns) {
        kiosk_frame(&bench.kiosk, &hal);
    }
    atomic_store(&bench.stop, 1);
    pthread_join(thread, NULL);
    return print_result(atomic_load(&bench.port.lost));
}
