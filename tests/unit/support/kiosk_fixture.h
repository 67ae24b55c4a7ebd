/* kiosk_fixture.h -- test fixture of the frame loop. All devices are simulated. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_KIOSK_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_KIOSK_FIXTURE_H

#include <string.h>

#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/newest_record.h"

#define MS 1000000ull
#define FRAME_NS 16666667ull
#define SEEN_MAX 4096u

/* A kiosk whose devices are all simulated. Its tap, which is a callback in each tick, records the
 * input. */
static struct rig {
    struct clock_sim clock;
    struct display_sim display;
    struct buttons_sim buttons;
    struct pointer_sim poi;
    struct storage_sim storage;
    struct audio_sim audio;
    struct hal hal;
    struct kiosk kiosk;
    struct input seen[SEEN_MAX];
    uint32_t seen_count;
    uint32_t kicks;
} rig;

/* Records the input of a tick. */
static inline void record_input(void *self, const struct input *input, const struct core *core)
{
    (void)self;
    (void)core;
    if (rig.seen_count < SEEN_MAX) {
        rig.seen[rig.seen_count++] = *input;
    }
}

/* Counts a call of kick(). The kiosk calls kick() to reset the watchdog's timeout. */
static inline void count_kick(void *self)
{
    (void)self;
    rig.kicks++;
}

/* Returns WATCH_OK, which is the state of a watchdog that is in use. */
static inline uint8_t watches(void *self)
{
    (void)self;
    return WATCH_OK;
}

/* Configuration of the kiosk: a small tank and short rounds. */
static const struct kiosk_config small = {
    .core = { .seed = 5, .fish_count = 8, .round_s = 10 },
    .tap = { .tick = record_input },
};

/* Initializes the kiosk with simulated devices; a cmocka setup function. */
static inline int set_up(void **state)
{
    static const struct hal_watchdog_ops watchdog = { .kick = count_kick, .watches = watches };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.hal.display = sim_display_device(&rig.display);
    rig.buttons.clock = rig.hal.clock;
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    pointer_sim_init(&rig.poi, rig.hal.clock, &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.hal.poi[0] = pointer_sim_devices(&rig.poi).poi;
    rig.hal.storage = storage_sim_device(&rig.storage);
    rig.hal.audio = sim_audio_device(&rig.audio);
    rig.hal.watchdog = (struct hal_watchdog){ .ops = &watchdog };
    return kiosk_init(&rig.kiosk, &rig.hal, &small);
}

/* Advances the clock and runs one frame. Returns the result of the frame. */
static inline enum kiosk_end frame_after(uint64_t ns)
{
    rig.clock.now_ns += ns;
    return kiosk_frame(&rig.kiosk, &rig.hal);
}

/* Runs `count` frames. If a frame ends the loop, the test fails. */
static inline void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        assert_int_equal(frame_after(FRAME_NS), KIOSK_RUNS);
    }
}

/* Sets the events that the simulated buttons will report. */
static inline void script(const struct button_event *events, uint32_t count)
{
    rig.buttons.events = events;
    rig.buttons.event_count = count;
}

/* Reports that the simulated pointer will send. */
static struct pointer_report reports[1000];

/* Prepares `count` pointer reports. The first is at 1 s, and the others follow every `step_ms`.
 * Their positions move to the right. */
static inline void glide(uint32_t count, uint64_t step_ms)
{
    for (uint32_t i = 0; i < count; i++) {
        reports[i] = (struct pointer_report){
            .time_ns = (1000 + step_ms * i) * MS,
            .x_px = 100.0f + (float)i,
            .y_px = 360.0f,
            .width_px = 1280,
            .height_px = 720,
        };
    }
    rig.poi.reports = reports;
    rig.poi.feed.count = count;
}

/* Number of ledger entries that a round writes. */
#define ENTRIES 2u

/* Plays a round of ten seconds. At the end, the core has a record of the round that must be
 * stored. */
static inline void play_a_round(void)
{
    static const struct button_event events[] = {
        { .time_ns = 1100 * MS, .pressed = INPUT_START },
    };
    glide(1000, 20);
    script(events, 1);
    for (uint32_t i = 0; i < 2400 && newest_record(&rig.kiosk.output)->id == 0; i++) {
        frames(1);
    }
    /* Entry 1 records the start of the round, and entry 2 its result. */
    assert_int_equal(newest_record(&rig.kiosk.output)->id, ENTRIES);
}

#define TEST(name) cmocka_unit_test_setup(name, set_up)

#endif
