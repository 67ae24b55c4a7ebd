/* test_kiosk.c -- the frame loop, with every device simulated and every fault that a device can
 * have. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder/score_playback.h"
#include "platform/kiosk/recorder/session_recorder.h"

#define MS 1000000ull
#define FRAME_NS 16666667ull
#define SEEN_MAX 4096u

/* A stall on a bench: all devices simulated, and a tap that keeps each tick's input. */
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

static void keep_input(void *self, const struct input *input, const struct core *core)
{
    (void)self;
    (void)core;
    if (rig.seen_count < SEEN_MAX) {
        rig.seen[rig.seen_count++] = *input;
    }
}

static void count_kick(void *self)
{
    (void)self;
    rig.kicks++;
}

static uint8_t watches(void *self)
{
    (void)self;
    return WATCH_FED;
}

static const struct kiosk_config small = {
    .core = { .seed = 5, .fish_count = 8, .round_s = 10 },
    .tap = { .tick = keep_input },
};

static int set_up(void **state)
{
    static const struct hal_watchdog_ops watchdog = { .kick = count_kick, .watches = watches };
    (void)state;
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.hal = null_hal();
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.hal.display = sim_display_device(&rig.display);
    rig.buttons.clock = rig.hal.clock;
    rig.hal.buttons = sim_buttons_device(&rig.buttons);
    pointer_sim_init(&rig.poi, rig.hal.clock, &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.hal.poi[0] = pointer_sim_device(&rig.poi);
    rig.hal.storage = storage_sim_device(&rig.storage);
    rig.hal.audio = sim_audio_device(&rig.audio);
    rig.hal.watchdog = (struct hal_watchdog){ .ops = &watchdog };
    return kiosk_init(&rig.kiosk, &rig.hal, &small);
}

static enum kiosk_end frame_after(uint64_t ns)
{
    rig.clock.now_ns += ns;
    return kiosk_frame(&rig.kiosk, &rig.hal);
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        assert_int_equal(frame_after(FRAME_NS), KIOSK_RUNS);
    }
}

static void script(const struct button_event *events, uint32_t count)
{
    rig.buttons.events = events;
    rig.buttons.event_count = count;
}

static void expect_in_tick(void *self, const struct input *input)
{
    const struct session_recorder *chapters = self;
    (void)input;
    assert_true(atomic_load(&chapters->is_busy));
    assert_true(atomic_load(&chapters->is_in_tick));
    rig.seen_count++;
}

/* A panic of another thread stops the frame thread in session_recorder_before(). */
static void test_a_frozen_thread_stops_before_its_tap_records_the_tick(void **state)
{
    static struct session_recorder chapters;
    struct kiosk_config config = small;
    (void)state;
    config.chapters = &chapters;
    config.tap = (struct kiosk_tap){ .before = expect_in_tick, .self = &chapters };
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    frames(2);
    assert_int_equal(rig.seen_count, 4);
}

/* ---- Time ----------------------------------------------------------------------------------- */

static void test_a_frame_is_two_ticks_one_picture_and_one_kick(void **state)
{
    (void)state;
    frames(60);
    assert_int_equal(rig.kiosk.core.game.tick, 120);
    assert_int_equal(rig.display.present_count, 60);
    assert_int_equal(rig.display.scene.tick, 120);
    assert_int_equal(rig.kicks, 60);
    assert_int_equal(rig.kiosk.pace.dropped, 0);
}

static void test_a_frame_without_ticks_shows_the_picture_and_feeds_no_watchdog(void **state)
{
    (void)state;
    frames(1);
    frame_after(2 * MS);
    assert_int_equal(rig.kiosk.core.game.tick, 2);
    assert_int_equal(rig.display.present_count, 2);
    assert_int_equal(rig.kicks, 1);
}

static void test_a_stall_is_dropped_and_counted(void **state)
{
    (void)state;
    frames(1);
    frame_after(1000 * MS);
    assert_int_equal(rig.kiosk.core.game.tick, 2 + 60);
    assert_int_equal(rig.kiosk.pace.dropped, 60);
}

/* ---- Buttons and coins ---------------------------------------------------------------------- */

static uint32_t ticks_that_saw(uint32_t button)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < rig.seen_count; i++) {
        count += (rig.seen[i].pressed & button) != 0;
    }
    return count;
}

static uint32_t coins_seen(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < rig.seen_count; i++) {
        count += rig.seen[i].coin_count[0];
    }
    return count;
}

static void test_a_press_is_seen_by_exactly_one_tick(void **state)
{
    static const struct button_event events[] = {
        { .time_ns = 1030 * MS, .pressed = INPUT_LANGUAGE },
        { .time_ns = 1200 * MS, .released = INPUT_LANGUAGE },
    };
    (void)state;
    script(events, 2);
    frames(30);
    assert_int_equal(ticks_that_saw(INPUT_LANGUAGE), 1);
    assert_int_equal(rig.kiosk.core.game.language, LANGUAGE_EN);
}

static void test_a_press_in_a_frame_without_ticks_waits_for_one(void **state)
{
    static const struct button_event events[] = {
        { .time_ns = 1018 * MS, .pressed = INPUT_START, .coin_count[0] = 2 },
        { .time_ns = 1019 * MS, .released = INPUT_START, .coin_count[0] = 1 },
    };
    (void)state;
    script(events, 2);
    frame_after(FRAME_NS);
    frame_after(2 * MS);
    frame_after(2 * MS);
    assert_int_equal(ticks_that_saw(INPUT_START), 0);
    frame_after(FRAME_NS);
    assert_int_equal(ticks_that_saw(INPUT_START), 1);
    assert_int_equal(coins_seen(), 3);
    frames(10);
    assert_int_equal(ticks_that_saw(INPUT_START), 1);
    assert_int_equal(coins_seen(), 3);
}

static void test_no_coin_is_lost_or_doubled_at_any_frame_load(void **state)
{
    static struct button_event events[500];
    (void)state;
    for (uint32_t i = 0; i < 500; i++) {
        events[i] = (struct button_event){ .time_ns = (1000 + 7 * i) * MS, .coin_count[0] = 1 };
    }
    script(events, 500);
    for (uint32_t i = 0; i < 400; i++) {
        frame_after((1 + (i * 7919u) % 23u) * MS);
    }
    assert_int_equal(coins_seen(), 500);
}

static void test_a_second_press_of_quit_ends_the_loop_after_its_frame(void **state)
{
    static const struct button_event events[] = { { .time_ns = 1020 * MS, .quit = 1 },
                                                  { .time_ns = 5900 * MS, .quit = 1 } };
    (void)state;
    script(events, 2);
    frames(1);
    assert_int_equal(frame_after(FRAME_NS), KIOSK_RUNS);
    assert_int_equal(rig.display.scene.asks_quit, 1);
    uint32_t count = 0;
    while (frame_after(FRAME_NS) == KIOSK_RUNS) {
        assert_in_range(++count, 1, 400);
    }
    assert_int_equal(rig.kiosk.end, KIOSK_QUIT);
    assert_in_range(count, 285, 300);
}

static void test_one_press_of_quit_never_ends_the_loop(void **state)
{
    static const struct button_event event = { .time_ns = 1020 * MS, .quit = 1 };
    (void)state;
    script(&event, 1);
    frames(2);
    assert_int_equal(rig.display.scene.asks_quit, 1);
    frames(1200); /* 20 s. */
    assert_int_equal(rig.kiosk.end, KIOSK_RUNS);
    assert_int_equal(rig.display.scene.asks_quit, 0);
}

static void test_the_question_whether_to_quit_lapses_after_five_seconds(void **state)
{
    static const struct button_event events[] = { { .time_ns = 1020 * MS, .quit = 1 },
                                                  { .time_ns = 6200 * MS, .quit = 1 } };
    (void)state;
    script(events, 2);
    frames(305); /* To 6.1 s. */
    assert_int_equal(rig.display.scene.asks_quit, 0);
    frames(20);
    assert_int_equal(rig.kiosk.end, KIOSK_RUNS);
    assert_int_equal(rig.display.scene.asks_quit, 1); /* Asked anew. */
}

static void test_any_other_button_withdraws_the_question_whether_to_quit(void **state)
{
    static const struct button_event events[] = {
        { .time_ns = 1020 * MS, .quit = 1 },
        { .time_ns = 1100 * MS, .pressed = INPUT_LEFT },
        { .time_ns = 1200 * MS, .released = INPUT_LEFT, .quit = 1 },
    };
    (void)state;
    script(events, 3);
    frames(8);
    assert_int_equal(rig.display.scene.asks_quit, 0);
    frames(10);
    assert_int_equal(rig.kiosk.end, KIOSK_RUNS);
    assert_int_equal(rig.display.scene.asks_quit, 1);
}

static void test_full_screen_is_the_displays_matter(void **state)
{
    static const struct button_event events[] = { { .time_ns = 1020 * MS, .full_screen = 1 } };
    (void)state;
    script(events, 1);
    frames(5);
    assert_int_equal(rig.display.full_screen_count, 1);
}

/* ---- The poi -------------------------------------------------------------------------------- */

static struct pointer_report reports[1000];

/* A report each `step_ms` from 1 s on, gliding to the right. */
static void glide(uint32_t count, uint64_t step_ms)
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

static void test_no_pose_is_used_twice_while_the_hand_moves(void **state)
{
    (void)state;
    glide(1000, 1);
    frames(50);
    for (uint32_t i = 3; i < rig.seen_count; i++) {
        const float now = rig.seen[i].poi[0].target.position_m.x;
        const float before = rig.seen[i - 1].poi[0].target.position_m.x;
        assert_int_equal(rig.seen[i].poi[0].link, POI_SOURCE_LIVE);
        assert_true(now > before);
    }
}

static void test_a_lost_poi_waits_where_it_is_and_is_found_again_within_a_second(void **state)
{
    (void)state;
    glide(1000, 10);
    rig.poi.feed.unplug_at = 20;
    rig.poi.feed.replug_ns = 2500 * MS;
    frames(30);
    const struct poi_input lost = rig.kiosk.input.poi[0];
    assert_int_equal(lost.link, POI_SOURCE_LOST);
    assert_true(rig.kiosk.faults.poi >= 1);
    frames(30);
    assert_memory_equal(&rig.kiosk.input.poi[0].target, &lost.target, sizeof lost.target);
    uint32_t waited = 0;
    while (rig.kiosk.input.poi[0].link != POI_SOURCE_LIVE && waited < 300) {
        frames(1);
        waited++;
    }
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
    assert_true(rig.clock.now_ns < (2500 + 1000 + 20) * MS);
    assert_in_range(rig.poi.feed.open_count, 3, 5); /* At start, then once a second. */
}

static void test_unplugged_at_any_report_the_loop_runs_on(void **state)
{
    (void)state;
    for (uint32_t at = 0; at < 50; at++) {
        set_up(state);
        glide(100, 3);
        rig.poi.feed.unplug_at = at;
        rig.poi.feed.replug_ns = 1500 * MS;
        rig.poi.feed.double_every = 3;
        rig.poi.feed.jump_at = at / 2;
        frames(200);
        assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
        assert_int_equal(rig.kiosk.core.game.tick, 400);
    }
}

static void test_silence_holds_the_poi_and_loses_nothing(void **state)
{
    (void)state;
    glide(1000, 2);
    rig.poi.feed.silent_from_ns = 1200 * MS;
    rig.poi.feed.silent_to_ns = 1700 * MS;
    frames(30);
    const float held = rig.kiosk.input.poi[0].target.position_m.x;
    frames(5);
    assert_true(rig.kiosk.input.poi[0].target.position_m.x == held);
    frames(15);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_LIVE);
    assert_true(rig.kiosk.input.poi[0].target.position_m.x > held);
}

static void test_a_stall_without_any_poi_has_none(void **state)
{
    (void)state;
    rig.hal.poi[0] = null_poi(NULL);
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &small), CORE_OK);
    frames(10);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_ABSENT);
    assert_int_equal(rig.kiosk.faults.poi, 0);
}

static void test_a_poi_given_to_the_bot_is_the_bots(void **state)
{
    struct kiosk_config config = small;
    (void)state;
    config.bot[0] = 1;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    glide(100, 3);
    frames(10);
    assert_int_equal(rig.kiosk.input.poi[0].link, POI_SOURCE_BOT);
}

/* ---- What is shown, heard and kept ---------------------------------------------------------- */

static void test_a_display_that_is_gone_for_good_ends_the_loop(void **state)
{
    (void)state;
    rig.display.gone_at = 3;
    frames(3);
    assert_int_equal(frame_after(FRAME_NS), KIOSK_DISPLAY_LOST);
}

static void test_a_display_that_is_pulled_out_comes_back_and_the_game_goes_on(void **state)
{
    (void)state;
    frames(10);
    rig.display.away = 1;
    const uint32_t tick = rig.kiosk.core.game.tick, shown = rig.display.present_count;
    rig.kicks = 0;
    frames(300);
    assert_int_equal(rig.kiosk.core.game.tick, tick + 600u);
    assert_int_equal(rig.kicks, 300);
    assert_int_equal(rig.display.present_count, shown);
    assert_int_equal(rig.kiosk.faults.display, 1); /* One loss, one fault. */
    assert_in_range(rig.display.open_count, 4, 5); /* Looked for once a second. */
    rig.display.away = 0;
    frames(62);
    assert_true(rig.display.present_count > shown);
    assert_int_equal(rig.display.scene.tick, rig.kiosk.scene.tick);
}

static void test_a_monitor_that_is_off_at_the_start_may_come_later(void **state)
{
    (void)state;
    rig.display.away = rig.display.needs_open = 1;
    frames(120);
    assert_int_equal(rig.kiosk.core.game.tick, 240);
    rig.display.away = 0;
    frames(62);
    assert_true(rig.display.present_count > 0);
}

static void test_while_the_display_is_away_its_picture_stands_as_it_stood(void **state)
{
    (void)state;
    rig.kiosk.input.upright = 1;
    rig.display.away = 1;
    frames(3);
    assert_int_equal(rig.kiosk.input.upright, 1);
}

static void test_one_picture_that_fails_is_a_fault_and_no_more(void **state)
{
    (void)state;
    rig.display.fail_at = 3;
    frames(10);
    assert_int_equal(rig.kiosk.faults.display, 1);
}

static void test_a_closed_window_quits(void **state)
{
    (void)state;
    frames(1);
    rig.display.quit = 1;
    assert_int_equal(frame_after(FRAME_NS), KIOSK_QUIT);
}

#define ENTRIES 2u /* That a round leaves in the ledger. */

/* START, ready, ten seconds of round: until the core has a record to keep. */
static void play_a_round(void)
{
    static const struct button_event events[] = {
        { .time_ns = 1100 * MS, .pressed = INPUT_START },
    };
    glide(1000, 20);
    script(events, 1);
    for (uint32_t i = 0; i < 2400 && rig.kiosk.output.record.id == 0; i++) {
        frames(1);
    }
    assert_int_equal(rig.kiosk.output.record.id, ENTRIES); /* The first: that it began. */
}

static void play_another_round(void)
{
    rig.kiosk.input.pressed = INPUT_START;
    for (uint32_t i = 0; i < 2400 && rig.kiosk.output.record.id == ENTRIES; i++) {
        frames(1);
        rig.kiosk.input.pressed |= i % 60 == 0 ? INPUT_START : 0;
    }
    assert_int_equal(rig.kiosk.output.record.id, 2u * ENTRIES);
}

static void test_a_round_is_heard_and_its_record_is_kept_once(void **state)
{
    (void)state;
    play_a_round();
    frames(120);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
    assert_int_equal(rig.storage.record.id, ENTRIES);
    assert_int_equal(rig.kiosk.input.record_saved_id, ENTRIES);
    assert_true(rig.audio.played[SOUND_START] >= 1);
    assert_int_equal(rig.audio.played[SOUND_RESULT], 1);
}

static void test_a_busy_store_is_asked_again_each_frame(void **state)
{
    (void)state;
    rig.storage.busy_left = 30;
    play_a_round();
    frames(40);
    assert_int_equal(rig.storage.refused_count, 30);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
    assert_int_equal(rig.kiosk.faults.storage, 0);
}

static void test_a_failing_store_is_asked_again_each_second(void **state)
{
    (void)state;
    static const struct button_event events[] = {
        { .time_ns = 1100 * MS, .pressed = INPUT_START },
    };
    rig.storage.fail_left = 2;
    glide(1000, 20);
    script(events, 1);
    for (uint32_t i = 0; i < 60 && rig.storage.refused_count == 0; i++) {
        frames(1);
    }
    frames(30);
    assert_int_equal(rig.storage.refused_count, 1);
    frames(120);
    assert_int_equal(rig.storage.accepted_count, 1); /* That a round began. */
    assert_int_equal(rig.kiosk.faults.storage, 2);
}

static void test_what_the_stores_thread_could_not_write_is_a_fault(void **state)
{
    (void)state;
    frames(10);
    rig.storage.write_refused_count = 2;
    frames(10);
    assert_int_equal(rig.kiosk.faults.storage, 2);
    rig.storage.write_refused_count = 3;
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), 0);
    assert_int_equal(rig.kiosk.faults.storage, 3);
}

static void test_the_core_is_told_while_the_store_keeps_no_graph(void **state)
{
    (void)state;
    frames(10);
    assert_int_equal(rig.kiosk.input.edit_refused, 0);
    rig.storage.edit_failed = 1;
    frames(10);
    assert_int_equal(rig.kiosk.input.edit_refused, 1);
    rig.hal.storage = null_storage("no store");
    rig.storage.edit_failed = 0;
    frames(10);
    assert_int_equal(rig.kiosk.input.edit_refused, 1);
}

static void test_a_round_that_the_store_never_took_is_lost(void **state)
{
    (void)state;
    rig.storage.busy_left = 100000;
    play_a_round();
    frames(10);
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), ENTRIES);
}

/* As the menu's page orders it. */
static void order_restart(void)
{
    struct output *output = &rig.kiosk.output;
    output->commands[output->command_count++ % CONTROLLER_COMMAND_MAX] =
        (struct controller_command){ .kind = COMMAND_RESTART };
}

static void test_a_restart_waits_for_the_store_and_not_for_ever(void **state)
{
    (void)state;
    rig.storage.busy_left = 100000;
    play_a_round();
    order_restart();
    frames(5u * 60u - 2u); /* Five seconds, in which the store may yet take what it is offered. */
    assert_true(rig.kiosk.saving.accepted_id < rig.kiosk.output.entry_id);
    enum kiosk_end end = KIOSK_RUNS;
    for (uint32_t i = 0; i < 6 && end == KIOSK_RUNS; i++) {
        end = frame_after(FRAME_NS);
    }
    assert_int_equal(end, KIOSK_RESTART);
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), ENTRIES);
}

static void test_a_restart_comes_as_soon_as_the_store_has_all(void **state)
{
    (void)state;
    rig.storage.busy_left = 100000;
    play_a_round();
    order_restart();
    frames(30);
    rig.storage.busy_left = 0;
    enum kiosk_end end = KIOSK_RUNS;
    for (uint32_t i = 0; i < 3 && end == KIOSK_RUNS; i++) {
        end = frame_after(FRAME_NS);
    }
    assert_int_equal(end, KIOSK_RESTART);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
}

static void test_the_core_is_told_only_what_is_on_disk(void **state)
{
    (void)state;
    rig.storage.delay_polls = 20;
    play_a_round();
    frames(10);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
    assert_int_equal(rig.kiosk.input.record_saved_id, 0);
    frames(20);
    assert_int_equal(rig.kiosk.input.record_saved_id, ENTRIES);
}

static void test_a_dead_sound_card_is_counted_and_the_round_goes_on(void **state)
{
    (void)state;
    rig.audio.fails = 1;
    play_a_round();
    assert_true(rig.kiosk.faults.audio > 0);
}

static void test_a_sound_card_that_went_is_one_fault_and_is_looked_for_each_second(void **state)
{
    (void)state;
    rig.audio.gone = 1;
    play_a_round();
    assert_int_equal(rig.kiosk.faults.audio, 1);
    assert_in_range(rig.audio.open_count, 8, 20); /* In ten seconds of round and a few around it. */
    rig.audio.gone = 0;
    frames(70);
    play_another_round();
    assert_true(rig.audio.played[SOUND_RESULT] >= 1);
    assert_int_equal(rig.kiosk.faults.audio, 1);
}

static void test_with_every_device_missing_the_stall_still_runs(void **state)
{
    (void)state;
    rig.hal = null_hal();
    rig.hal.clock = sim_clock_device(&rig.clock);
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &small), CORE_OK);
    frames(600);
    assert_int_equal(rig.kiosk.core.game.tick, 1200);
    assert_int_equal(rig.kiosk.faults.display, 0);
}

static void test_equal_devices_give_equal_hashes(void **state)
{
    (void)state;
    play_a_round();
    const uint64_t first = core_hash(&rig.kiosk.core);
    set_up(state);
    play_a_round();
    assert_true(core_hash(&rig.kiosk.core) == first);
}

static void test_a_config_out_of_range_is_refused(void **state)
{
    struct kiosk_config config = small;
    (void)state;
    config.core.round_s = 5;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_ERR_RANGE);
}

#define TEST(name) cmocka_unit_test_setup(name, set_up)

/* ---- A score is shown again ----------------------------------------------------------------- */

static void test_what_ends_a_replay_is_not_heard_in_the_stall(void **state)
{
    (void)state;
    static struct score_playback playback;
    static const struct button_event events[] = {
        { .time_ns = 3000 * MS, .pressed = INPUT_START },
    };
    memset(&playback, 0, sizeof playback);
    rig.kiosk.config.playback = &playback;
    frames(2);
    assert_int_equal(rig.display.scene.playback, ENCORE_OFF);
    rig.kiosk.wanted_replay_id = 7;
    frames(2);
    assert_int_equal(rig.kiosk.wanted_replay_id, 0);
    assert_int_equal(rig.display.scene.playback, ENCORE_NONE); /* This store keeps none. */
    script(events, 1);
    frames(2);
    while (rig.clock.now_ns < 3100 * MS) {
        frames(1);
    }
    assert_int_equal(rig.display.scene.playback, ENCORE_OFF);
    assert_int_equal(rig.kiosk.core.game.phase, PHASE_ATTRACT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_what_ends_a_replay_is_not_heard_in_the_stall),
        TEST(test_a_frozen_thread_stops_before_its_tap_records_the_tick),
        TEST(test_a_frame_is_two_ticks_one_picture_and_one_kick),
        TEST(test_a_frame_without_ticks_shows_the_picture_and_feeds_no_watchdog),
        TEST(test_a_stall_is_dropped_and_counted),
        TEST(test_a_press_is_seen_by_exactly_one_tick),
        TEST(test_a_press_in_a_frame_without_ticks_waits_for_one),
        TEST(test_no_coin_is_lost_or_doubled_at_any_frame_load),
        TEST(test_a_second_press_of_quit_ends_the_loop_after_its_frame),
        TEST(test_one_press_of_quit_never_ends_the_loop),
        TEST(test_the_question_whether_to_quit_lapses_after_five_seconds),
        TEST(test_any_other_button_withdraws_the_question_whether_to_quit),
        TEST(test_full_screen_is_the_displays_matter),
        TEST(test_no_pose_is_used_twice_while_the_hand_moves),
        TEST(test_a_lost_poi_waits_where_it_is_and_is_found_again_within_a_second),
        TEST(test_unplugged_at_any_report_the_loop_runs_on),
        TEST(test_silence_holds_the_poi_and_loses_nothing),
        TEST(test_a_stall_without_any_poi_has_none),
        TEST(test_a_poi_given_to_the_bot_is_the_bots),
        TEST(test_a_display_that_is_gone_for_good_ends_the_loop),
        TEST(test_a_display_that_is_pulled_out_comes_back_and_the_game_goes_on),
        TEST(test_a_monitor_that_is_off_at_the_start_may_come_later),
        TEST(test_while_the_display_is_away_its_picture_stands_as_it_stood),
        TEST(test_one_picture_that_fails_is_a_fault_and_no_more),
        TEST(test_a_closed_window_quits),
        TEST(test_a_round_is_heard_and_its_record_is_kept_once),
        TEST(test_a_busy_store_is_asked_again_each_frame),
        TEST(test_a_failing_store_is_asked_again_each_second),
        TEST(test_what_the_stores_thread_could_not_write_is_a_fault),
        TEST(test_the_core_is_told_while_the_store_keeps_no_graph),
        TEST(test_a_round_that_the_store_never_took_is_lost),
        TEST(test_a_restart_waits_for_the_store_and_not_for_ever),
        TEST(test_a_restart_comes_as_soon_as_the_store_has_all),
        TEST(test_the_core_is_told_only_what_is_on_disk),
        TEST(test_a_dead_sound_card_is_counted_and_the_round_goes_on),
        TEST(test_a_sound_card_that_went_is_one_fault_and_is_looked_for_each_second),
        TEST(test_with_every_device_missing_the_stall_still_runs),
        TEST(test_equal_devices_give_equal_hashes),
        TEST(test_a_config_out_of_range_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
