/* bench_latency.c -- input to picture: how long after a pointer event the first frame shows it.
 *
 * bench_latency [FRAME_MS WORK_MS]
 *
 * The real frame loop and the real pointer decoder, on a simulated clock, so that the figures
 * are the program's own and not the machine's. At each trial the stall is copied, one copy gets
 * an event and the other does not, and both run until their rings differ: by half a pixel after
 * a step of the pointer; by anything at all after the button's edge, for a dip is a smooth stroke
 * that sets off from rest. The event falls anywhere between two frames. Time is counted to the
 * moment at which the frame's scene is handed to the display; the bound is one frame and one tick.
 * Not in it: drawing, the swap, the screen itself, and what the mouse, the kernel and the X server
 * do before the event is stamped. With the two figures that kingyo prints at its end (how often a
 * frame comes on this machine's screen, and how much work, drawing and swap, it is) one more row
 * says what the sum is here. Exit code 1 when the bound does not hold. */
#include <stdio.h>
#include <stdlib.h>

#include "core/base/rng.h"
#include "core/tank/preset.h"
#include "drivers/clock_sim.h"
#include "drivers/display_sim.h"
#include "drivers/null.h"
#include "drivers/poi_sim.h"
#include "platform/kiosk/kiosk.h"

#define TRIALS 400u
#define FRAMES_MAX 8u
#define PIXEL_M 0.0006f /* 1,280 over a tank of 0.85 m and its rim. */

/* Everything that a copy needs, and no pointer into itself but those that wire() sets. */
struct booth {
    struct clock_sim clock;
    struct display_sim display;
    struct poi_sim poi;
    struct pointer_report reports[2];
    struct kiosk kiosk;
};

static struct booth base, with, without;

static struct hal wire(struct booth *stall)
{
    struct hal hal = null_hal();
    hal.clock = clock_sim_device(&stall->clock);
    hal.display = display_sim_device(&stall->display);
    stall->poi.clock = hal.clock;
    stall->poi.reports = stall->reports;
    hal.poi[0] = poi_sim_device(&stall->poi);
    return hal;
}

static struct pointer_report report_at(uint64_t time_ns, float x_px, uint32_t buttons)
{
    return (struct pointer_report){
        .time_ns = time_ns,
        .x_px = x_px,
        .y_px = 330.0f,
        .width_px = 1280,
        .height_px = 720,
        .buttons = buttons,
    };
}

static void frame(struct booth *stall, uint64_t frame_ns)
{
    const struct hal hal = wire(stall);
    stall->clock.now_ns += frame_ns;
    kiosk_frame(&stall->kiosk, &hal);
}

/* A round that has begun, the hand at rest over the middle. */
static void open_stall(uint64_t frame_ns)
{
    const struct kiosk_config config = { .core = { .seed = 1, .fish_count = 20 } };
    base = (struct booth){ .clock.now_ns = 1000000000 };
    poi_sim_init(&base.poi, clock_sim_device(&base.clock),
                 &tank_preset(TANK_PRESET_FESTIVAL)->view);
    base.reports[0] = report_at(1000000001, 640.0f, 0);
    base.poi.report_count = 1;
    const struct hal hal = wire(&base);
    if (kiosk_init(&base.kiosk, &hal, &config) != CORE_OK) {
        abort();
    }
    base.kiosk.input.pressed = INPUT_START;
    while (base.kiosk.core.tick < 5 * CORE_TICK_HZ) {
        frame(&base, frame_ns);
    }
}

static float moved_px(const struct booth *a, const struct booth *b)
{
    const struct scene_poi *left = &a->display.scene.poi[0];
    const struct scene_poi *right = &b->display.scene.poi[0];
    return v3_length(v3_sub(left->position_m, right->position_m)) / PIXEL_M;
}

struct latency {
    uint32_t frames, ticks;
    double ms;
};

struct event {
    const char *name;
    uint64_t frame_ns;
    float x_px;       /* The pointer was at 640 ... */
    uint32_t buttons; /* ... and no button was held. */
    float seen_px;    /* The rings differ by more than this. */
    double work_ms;   /* Of drawing and swap, counted on top; 0: to the hand-over alone. */
};

/* The event comes `phase` in [0, 1) of a frame after the last frame looked. */
static struct latency measure(const struct event *event, float phase)
{
    const uint64_t event_ns = base.clock.now_ns + 1 + (uint64_t)(phase * (float)event->frame_ns);
    struct latency latency = { 0 };
    with = base;
    without = base;
    with.reports[1] = report_at(event_ns, event->x_px, event->buttons);
    with.poi.report_count = 2;
    do {
        const uint32_t tick = with.kiosk.core.tick;
        frame(&with, event->frame_ns);
        frame(&without, event->frame_ns);
        latency.frames++;
        latency.ticks += with.kiosk.core.tick - tick;
    } while (moved_px(&with, &without) <= event->seen_px && latency.frames < FRAMES_MAX);
    latency.ms = (double)(with.clock.now_ns - event_ns) * 1e-6 + event->work_ms;
    return latency;
}

static int compare(const void *left, const void *right)
{
    const double a = *(const double *)left;
    const double b = *(const double *)right;
    return (a > b) - (a < b);
}

/* Prints a row; returns whether every event was shown within one frame, one tick and the work. */
static int bench(const struct event *event)
{
    static double ms[TRIALS];
    uint32_t frames_max = 0;
    uint32_t ticks_max = 0;
    open_stall(event->frame_ns);
    for (uint32_t i = 0; i < TRIALS; i++) {
        const float phase = rng_unit((struct rng_key){ 1, i, 0, RNG_TEST });
        const struct latency latency = measure(event, phase);
        ms[i] = latency.ms;
        frames_max = latency.frames > frames_max ? latency.frames : frames_max;
        ticks_max = latency.ticks > ticks_max ? latency.ticks : ticks_max;
    }
    qsort(ms, TRIALS, sizeof ms[0], compare);
    const double frame_ms = (double)event->frame_ns * 1e-6;
    const double bound_ms = frame_ms + 1000.0 / CORE_TICK_HZ + event->work_ms;
    printf("%-26s %6.2f %6.2f %6.2f ms  %u frames %u ticks  bound %.2f ms\n", event->name,
           ms[TRIALS / 2], ms[TRIALS * 99 / 100], ms[TRIALS - 1], frames_max, ticks_max, bound_ms);
    return ms[TRIALS - 1] <= bound_ms;
}

int main(int argc, char **argv)
{
    static const struct event events[] = {
        { "move, 60 Hz, 0.5 px", 16666667, 700.0f, 0, 0.5f, 0.0 },
        { "move, 144 Hz, 0.5 px", 6944444, 700.0f, 0, 0.5f, 0.0 },
        { "move, 30 Hz, 0.5 px", 33333333, 700.0f, 0, 0.5f, 0.0 },
        { "dip, 60 Hz, any move", 16666667, 640.0f, POINTER_DIP, 0.0f, 0.0 },
    };
    struct event here = { "move, here, with drawing", 0, 700.0f, 0, 0.5f, 0.0 };
    const double here_ms = argc == 3 ? strtod(argv[1], NULL) : 0.0;
    int holds = 1;
    if (argc != 1 && (argc != 3 || !(here_ms >= 1.0 && here_ms <= 1000.0))) {
        fprintf(stderr, "usage: bench_latency [FRAME_MS WORK_MS], a frame of 1 .. 1000 ms\n");
        return 2;
    }
    printf("pointer event to frame     median    p99    max     at most\n");
    for (size_t i = 0; i < sizeof events / sizeof events[0]; i++) {
        holds &= bench(&events[i]);
    }
    if (argc == 3) { /* For information: a machine that draws in software does not keep up. */
        here.frame_ns = (uint64_t)(here_ms * 1e6);
        here.work_ms = strtod(argv[2], NULL);
        bench(&here);
    }
    return holds ? 0 : 1;
}
