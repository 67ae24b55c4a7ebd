/* lag.c -- measures the delay from a report of a USB poi to the tick that uses the report.
 *
 * Usage: lag VVVV:PPPP SECONDS
 *
 * Runs the kiosk's code from the libusb thread to the pose of each tick, at 60 frames per second.
 * Drawing and the core are left out, because on an emulated machine their time would dominate the
 * result. Prints the figures in one line. Exit code 0 means that at least half of the sent reports
 * were used, and that the median delay was at most one and a half frames. Exit code 1 means that
 * one of these conditions failed or that there is no such poi. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/tank/preset.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/null.h"
#include "drivers/usb/usb_transport.h"
#include "platform/kiosk/frame_pacer.h"
#include "platform/kiosk/sampler.h"
#include "platform/os/clock.h"

#define FRAME_NS 16666667u
/* Longest time in ns until the device gets a slot, even on a slow machine. */
#define FIND_NS 10000000000u
/* Smallest number of reports per second that must be used. The poi sends 250 reports per second. */
#define REPORTS_MIN 125u
#define MEDIAN_MAX_NS (FRAME_NS + FRAME_NS / 2u)

static struct poi_hid poi[POI_MAX];
static struct poi_sampler hand;
static struct frame_pacer pace;
static struct frame_timing waits;

static void tell(void *self, const char *line)
{
    (void)self;
    fprintf(stderr, "lag: %s\n", line);
}

static struct usb_event_thread *start(struct hal *hal, const struct usb_key *key)
{
    char why[HAL_TEXT_SIZE];
    const struct usb_transport_config config = {
        .clock = hal->clock,
        .listed = key,
        .listed_count = 1,
        .report = tell,
    };
    struct usb_event_thread *usb = usb_transport_start(&config, why);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        poi_hid_init(&poi[i], usb_transport_port(usb, i), hal->clock, (struct hid_mapper){ 0 },
                     &tank_preset(TANK_PRESET_FESTIVAL)->view);
        hal->poi[i] = poi_hid_devices(&poi[i]).poi;
    }
    if (why[0]) {
        tell(NULL, why);
    }
    return usb;
}

/* Waits until the device has a slot. The kiosk too reads reports only from a device that has a
 * slot. */
static bool is_found(const struct hal *hal)
{
    const uint64_t end_ns = hal->clock.ops->now_ns(hal->clock.self) + FIND_NS;
    uint64_t now_ns;
    while (!poi[0].plays && (now_ns = hal->clock.ops->now_ns(hal->clock.self)) < end_ns) {
        hal->poi[0].ops->open(hal->poi[0].self);
        clock_sleep_until(now_ns + FRAME_NS);
    }
    return poi[0].plays;
}

/* Runs one frame with its steps in the order of kiosk_frame(). */
static void frame(const struct hal *hal)
{
    struct poi_input input;
    const uint64_t now_ns = hal->clock.ops->now_ns(hal->clock.self);
    const uint32_t due = frame_pacer_ticks_due(&pace, now_ns);
    sampler_poi_sample(&hand, &hal->poi[0], now_ns);
    if (due == 0) {
        return;
    }
    sampler_poi_time(&hand, hal->clock.ops->now_ns(hal->clock.self), &waits);
    for (uint32_t i = 0; i < due; i++) {
        sampler_poi_at(&hand, i, due, now_ns, &input);
    }
    sampler_path_end(&hand.path);
}

/* Runs frames for `long_ns`. If a frame takes too long, the next one starts at once, and the missed
 * frames are not made up. Returns the number of frames. */
static uint32_t play(const struct hal *hal, uint64_t long_ns)
{
    const uint64_t begin_ns = hal->clock.ops->now_ns(hal->clock.self);
    uint64_t next_ns = begin_ns, now_ns = begin_ns;
    uint32_t frames = 0;
    sampler_poi_open(&hand, &hal->poi[0], begin_ns);
    for (; now_ns < begin_ns + long_ns; frames++) {
        frame(hal);
        now_ns = hal->clock.ops->now_ns(hal->clock.self);
        next_ns = next_ns + FRAME_NS > now_ns ? next_ns + FRAME_NS : now_ns;
        clock_sleep_until(next_ns);
    }
    return frames;
}

static int check_latency(uint32_t frames, uint64_t seconds)
{
    const uint64_t median_ns = frame_timing_quantile_ns(&waits, 0.5);
    printf("median %.1f ms, p99 %.1f ms, longest %.1f ms; "
           "%llu reports and %llu frames a second\n",
           (double)median_ns * 1e-6, (double)frame_timing_quantile_ns(&waits, 0.99) * 1e-6,
           (double)waits.max_ns * 1e-6, (unsigned long long)(waits.count / seconds),
           (unsigned long long)(frames / seconds));
    return waits.count >= REPORTS_MIN * seconds && median_ns <= MEDIAN_MAX_NS;
}

int main(int argc, char **argv)
{
    struct usb_key key;
    struct hal hal = null_hal(NULL);
    const uint64_t seconds = argc == 3 ? strtoull(argv[2], NULL, 10) : 0;
    int passed = 0;
    if (seconds == 0 || usb_key_read(&key, argv[1]) != 0) {
        fprintf(stderr, "usage: lag VVVV:PPPP SECONDS\n");
        return 2;
    }
    hal.clock = clock_device();
    struct usb_event_thread *usb = start(&hal, &key);
    if (is_found(&hal)) {
        passed = check_latency(play(&hal, seconds * 1000000000u), seconds);
    } else {
        fprintf(stderr, "lag: no poi %s that plays\n", argv[1]);
    }
    usb_transport_stop(usb);
    return !passed;
}
