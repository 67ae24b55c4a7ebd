/* bench_latency.c -- benchmark of the latency from a pointer event to the first frame that shows
 * its effect.
 *
 * Usage: bench_latency [FRAME_MS WORK_MS]
 *
 * The benchmark runs the real frame loop and pointer decoder on a simulated clock, so the figures
 * do not depend on the machine. Each trial makes two copies of the game and gives one copy a
 * pointer event at a random time within a frame. Both copies run until the positions of their rings
 * differ. After a motion of the pointer, the difference must be half a pixel. After a button press,
 * any difference counts, because a dip starts slowly.
 *
 * The latency ends when the frame loop passes the scene to the display. The latency must be at most
 * the duration of one frame plus one tick. Drawing, the screen, the mouse, the kernel and the X
 * server are not included. FRAME_MS (frame period) and WORK_MS (drawing time) are figures that
 * kingyo prints at its end. If both figures are given, the table has an additional row for this
 * machine.
 *
 * Returns exit status 1 if a latency exceeds the bound. */
#include <stdio.h>
#include <stdlib.h>

#include "core/base/rng.h"
#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "platform/kiosk/kiosk.h"

#define TRIALS 400u
#define FRAMES_MAX 8u
/* Length in the tank that this benchmark counts as one pixel. In a window 1,280 pixels wide, a
 * pixel shows 0.8 mm of the tank. The smaller value ensures that no visible motion is missed. */
#define PIXEL_M 0.0006f

/* State of a simulated kiosk, which a trial copies. Some pointers of a copy still point into the
 * original, so wire() must set them again. */
struct fixture {
    struct clock_sim clock;
    struct display_sim display;
    struct pointer_sim poi;
    struct pointer_report reports[2];
    struct kiosk kiosk;
};

static struct fixture base, with, without;

static struct hal wire(struct fixture *fixture)
{
    struct hal hal = null_hal(NULL);
    hal.clock = sim_clock_device(&fixture->clock);
    hal.display = sim_display_device(&fixture->display);
    fixture->poi.feed.clock = hal.clock;
    fixture->poi.reports = fixture->reports;
    hal.poi[0] = pointer_sim_devices(&fixture->poi).poi;
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

static void frame(struct fixture *fixture, uint64_t frame_ns)
{
    const struct hal hal = wire(fixture);
    fixture->clock.now_ns += frame_ns;
    kiosk_frame(&fixture->kiosk, &hal);
}

/* Starts a round, with the pointer at rest over the middle of the tank. */
static void open_fixture(uint64_t frame_ns)
{
    const struct kiosk_config config = { .core = { .seed = 1, .fish_count = 20 } };
    base = (struct fixture){ .clock.now_ns = 1000000000 };
    pointer_sim_init(&base.poi, sim_clock_device(&base.clock),
                     &tank_preset(TANK_PRESET_FESTIVAL)->view);
    base.reports[0] = report_at(1000000001, 640.0f, 0);
    base.poi.feed.count = 1;
    const struct hal hal = wire(&base);
    if (kiosk_init(&base.kiosk, &hal, &config) != CORE_OK) {
        abort();
    }
    base.kiosk.input.pressed = INPUT_START;
    while (base.kiosk.core.game.tick < 5 * CORE_TICK_HZ) {
        frame(&base, frame_ns);
    }
}

static float moved_px(const struct fixture *a, const struct fixture *b)
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
    float x_px;       /* New x position of the pointer in pixels. The old position is 640. */
    uint32_t buttons; /* New state of the buttons. No button was held before the event. */
    /* The effect counts as visible when the ring is more than this distance, in pixels, from its
     * position in a game without the event. */
    float seen_px;
    /* Time for drawing that is added to the latency; 0 measures only until the scene is passed to
     * the display. */
    double work_ms;
};

/* Measures the latency of one event. `phase` is the time from the last reading of the input to the
 * event, as a fraction of a frame in [0, 1). */
static struct latency measure(const struct event *event, float phase)
{
    const uint64_t event_ns = base.clock.now_ns + 1 + (uint64_t)(phase * (float)event->frame_ns);
    struct latency latency = { 0 };
    with = base;
    without = base;
    with.reports[1] = report_at(event_ns, event->x_px, event->buttons);
    with.poi.feed.count = 2;
    do {
        const uint32_t tick = with.kiosk.core.game.tick;
        frame(&with, event->frame_ns);
        frame(&without, event->frame_ns);
        latency.frames++;
        latency.ticks += with.kiosk.core.game.tick - tick;
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

/* Measures TRIALS events of one kind at random times within a frame, and prints a row of the table.
 * Returns 1 if no latency was longer than the sum of one frame, one tick and the drawing time. */
static int bench(const struct event *event)
{
    static double ms[TRIALS];
    uint32_t frames_max = 0;
    uint32_t ticks_max = 0;
    open_fixture(event->frame_ns);
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
    /* The additional row for this machine does not change the exit status, because a software
     * renderer is too slow for the bound. */
    if (argc == 3) {
        here.frame_ns = (uint64_t)(here_ms * 1e6);
        here.work_ms = strtod(argv[2], NULL);
        bench(&here);
    }
    return holds ? 0 : 1;
}
