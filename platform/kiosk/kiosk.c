/* kiosk.c -- runs one frame: samples the devices, runs the ticks, and presents the result. The file
 * kiosk_devices.c accesses the devices. */
#include "platform/kiosk/kiosk.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/phases.h"
#include "platform/cpu.h"
#include "platform/kiosk/operator_view.h"
#include "platform/kiosk/recorder/score_playback.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/system_health.h"

enum core_error kiosk_init(struct kiosk *kiosk, const struct hal *hal,
                           const struct kiosk_config *config)
{
    CORE_ASSERT(hal->audio.ops && hal->display.ops && hal->seats.ops);
    memset(kiosk, 0, sizeof *kiosk);
    cpu_set_float();
    kiosk->config = *config;
    kiosk->switches.active = 1u << HAL_COIN_LOCKOUT; /* Initially the coin lockout is on and all
                                                        other outputs are off. */
    kiosk->saving.accepted_id = kiosk->output.entry_id = config->core.persistent.ledger.last_id;
    const enum core_error error = core_init(&kiosk->core, &config->core);
    if (error != CORE_OK) {
        return error;
    }
    output_audio_open(&kiosk->voice, &hal->audio, hal_now_ns(hal->clock));
    kiosk_open_devices(kiosk, hal);
    if (config->chapters) {
        session_recorder_begin(config->chapters, &kiosk->core);
    }
    core_scene(&kiosk->core, &kiosk->scene);
    kiosk_present_view(kiosk, hal);
    return CORE_OK;
}

int kiosk_asks_to_quit(const struct kiosk *kiosk)
{
    return kiosk->sampled_ns < kiosk->quit_until_ns;
}

uint32_t kiosk_fault_count(const struct kiosk_faults *faults)
{
    CORE_ASSERT(faults);
    return faults->poi + faults->shade + faults->display + faults->audio + faults->storage +
           faults->buttons + faults->switches;
}

/* Prepares kiosk->input for one tick. Returns 1. If the input source has no more ticks, ends the
 * frame loop and returns 0. */
static int prepare_tick(struct kiosk *kiosk, uint32_t index, uint32_t tick_count)
{
    CORE_ASSERT(index < tick_count);
    if (!kiosk->config.source.next) {
        for (uint32_t i = 0; i < POI_MAX; i++) {
            struct poi_input *poi = &kiosk->input.poi[i];
            sampler_poi_at(&kiosk->hands[i], index, tick_count, kiosk->sampled_ns, poi);
            poi->link = kiosk->config.bot[i] ? (uint8_t)POI_SOURCE_BOT : poi->link;
        }
        for (uint32_t i = 0; i < SHADE_MAX; i++) {
            kiosk->input.shade[i] = sampler_fan_at(&kiosk->shades[i], index, tick_count);
        }
        /* During a score playback, poses and buttons control the playback, and the game gets
         * only coins. The input that ends the playback is not passed to the game. */
        if (kiosk->config.playback && kiosk->config.playback->state != ENCORE_OFF) {
            score_playback_handle_input(kiosk->config.playback, kiosk->input.pressed,
                                        kiosk->input.poi);
            kiosk->input.pressed = kiosk->input.held = 0;
            for (uint32_t i = 0; i < POI_MAX; i++) {
                kiosk->input.poi[i].link = POI_SOURCE_ABSENT;
            }
        }
        return 1;
    }
    if (!kiosk->config.source.next(kiosk->config.source.self, &kiosk->input)) {
        kiosk->end = KIOSK_SOURCE_END;
        return 0;
    }
    return 1;
}

/* Runs one tick. Returns 1. If the core rejects the tick, sets kiosk->end and returns 0.
 * session_recorder_before() must be the first call, because it blocks the calling thread if another
 * thread panics. */
static int run_tick(struct kiosk *kiosk)
{
    CORE_ASSERT(kiosk->output.sound_count <= OUTPUT_SOUND_MAX);
    const struct kiosk_tap *tap = &kiosk->config.tap;
    if (kiosk->config.chapters) {
        session_recorder_before(kiosk->config.chapters, &kiosk->input);
    }
    if (tap->before) {
        tap->before(tap->self, &kiosk->input);
    }
    if (core_tick(&kiosk->core, &kiosk->input, &kiosk->output) != CORE_OK) {
        kiosk->end = KIOSK_FLOAT;
        return 0;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        output_merge_force(&kiosk->felt[i], &kiosk->output.poi[i]);
    }
    if (tap->tick) {
        tap->tick(tap->self, &kiosk->input, &kiosk->core);
    }
    if (kiosk->config.chapters) {
        session_recorder_tick(kiosk->config.chapters, &kiosk->input, &kiosk->core, &kiosk->output);
    }
    kiosk->input.pressed = 0; /* A button press is valid for one tick only. */
    memset(kiosk->input.coin_count, 0, sizeof kiosk->input.coin_count);
    return 1;
}

/* Runs the ticks of the frame. Returns the number of completed ticks. */
static uint32_t run_ticks(struct kiosk *kiosk, uint32_t tick_count)
{
    CORE_ASSERT(tick_count <= FRAME_PACER_TICKS_MAX);
    uint32_t done = 0;
    kiosk->output.sound_count = 0;
    if (tick_count > 0) { /* In a frame without ticks the poi forces of the previous frame remain
                             set. */
        memset(kiosk->felt, 0, sizeof kiosk->felt);
    }
    kiosk->float_resets += (uint32_t)cpu_set_float(); /* Restores the floating-point control
                                                         register, which driver libraries may have
                                                         changed. */
    while (done < tick_count && prepare_tick(kiosk, done, tick_count) && run_tick(kiosk)) {
        done++;
    }
    if (done > 0) {
        for (uint32_t i = 0; i < POI_MAX; i++) {
            sampler_poi_end(&kiosk->hands[i]);
        }
        for (uint32_t i = 0; i < SHADE_MAX; i++) {
            sampler_fan_end(&kiosk->shades[i]);
        }
        core_scene(&kiosk->core, &kiosk->scene);
    }
    return done;
}

/* Shows a score playback in place of the game. */
static void show_encore(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count)
{
    struct score_playback *playback = kiosk->config.playback;
    if (!playback) {
        return;
    }
    if (kiosk->wanted_replay_id != 0) {
        score_playback_request(playback, kiosk->wanted_replay_id);
        kiosk->wanted_replay_id = 0;
    }
    score_playback_frame(playback, hal, &kiosk->config.stopwatch, core_ranking(&kiosk->core),
                         tick_count);
    score_playback_show(playback, &kiosk->scene, &kiosk->output);
}

static uint64_t stopwatch_ns(const struct kiosk *kiosk)
{
    return hal_now_ns(kiosk->config.stopwatch);
}

enum kiosk_end kiosk_frame(struct kiosk *kiosk, const struct hal *hal)
{
    CORE_ASSERT(hal->display.ops && hal->seats.ops && hal->storage.ledger.ops);
    const uint64_t begin_ns = stopwatch_ns(kiosk);
    if (kiosk->frames > 0) {
        frame_timing_add(&kiosk->frame_time, begin_ns - kiosk->frame_begin_ns);
    }
    kiosk->frame_begin_ns = begin_ns;
    kiosk->frames++;
    const uint32_t tick_due = frame_pacer_ticks_due(&kiosk->pace, hal_now_ns(hal->clock));
    kiosk_sample_devices(kiosk, hal);
    if (tick_due > 0) {
        /* Adds the waiting time of each poi report to the statistics. The end of the waiting
         * time is read from the clock that also stamped the reports. */
        const uint64_t now_ns = hal_now_ns(hal->clock);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            sampler_poi_time(&kiosk->hands[i], now_ns, &kiosk->report_wait);
        }
    }
    output_dimmer_notice(&kiosk->dimmer, &kiosk->input, kiosk->output.phase == PHASE_ATTRACT);
    const uint64_t core_begin_ns = stopwatch_ns(kiosk);
    const uint32_t tick_count = run_ticks(kiosk, tick_due);
    show_encore(kiosk, hal, tick_count);
    kiosk->scene.asks_quit = (uint8_t)kiosk_asks_to_quit(kiosk);
    /* Copies the newest system health, and forwards the operator's acknowledgement to the health
     * monitor. Never blocks. */
    struct system_health *machine = kiosk->config.machine;
    kiosk->machine.watch = hal->watchdog.ops->watches(hal->watchdog.self);
    kiosk->machine.missed = kiosk->config.chapters ? kiosk->config.chapters->missed : 0u;
    if (machine) {
        if (kiosk->has_acknowledged) {
            kiosk->has_acknowledged = !system_health_acknowledge(machine);
        }
        system_health_read(machine, &kiosk->machine);
    }
    const struct operator_view operator_view = { .notes = kiosk->config.notes,
                                                 .input = &kiosk->input,
                                                 .hands = kiosk->hands,
                                                 .lines = &kiosk->lines,
                                                 .button_faults = kiosk->faults.buttons,
                                                 .machine = &kiosk->machine,
                                                 .frame_ns = frame_timing_quantile_ns(
                                                     &kiosk->frame_time, 0.5) };
    operator_view_fill(&kiosk->scene, hal, &operator_view);
    kiosk->core_ns += stopwatch_ns(kiosk) - core_begin_ns;
    kiosk_present_view(kiosk, hal);
    kiosk_present_frame(kiosk, hal, tick_count);
    if (tick_count > 0) {
        hal->watchdog.ops->kick(hal->watchdog.self); /* The watchdog is notified only after a frame
                                                        with ticks. The watchdog therefore restarts
                                                        a kiosk that runs no ticks. */
    }
    frame_timing_add(&kiosk->work_time, stopwatch_ns(kiosk) - kiosk->frame_begin_ns);
    return kiosk->end;
}

uint32_t kiosk_close_store(struct kiosk *kiosk, const struct hal *hal)
{
    CORE_ASSERT(hal->storage.ledger.ops);
    const int is_replay = kiosk->config.source.next != NULL;
    const uint32_t waiting = is_replay ? 0 : kiosk->output.entry_id - kiosk->saving.accepted_id;
    /* Adds a last health entry, which contains the uptime, to the ledger when the program ends
     * without an error. Adds no entry while other entries wait for the store. */
    struct ledger_entry entry;
    if (!kiosk->config.source.next && saving_is_done(&kiosk->saving, &kiosk->output) &&
        core_final_entry(&kiosk->core, &kiosk->input, &entry)) {
        hal->storage.ledger.ops->append(hal->storage.ledger.self, &entry);
    }
    const uint32_t unwritten = hal->storage.ledger.ops->close(hal->storage.ledger.self);
    kiosk->faults.storage += saving_refused(&kiosk->saving, &hal->storage.ledger);
    return unwritten + waiting;
}
