/* kiosk.c -- runs one frame: samples the devices, runs the ticks, and presents the picture. The
 * file kiosk_outputs.c sends all other results of the ticks to the devices. */
#include "platform/kiosk/kiosk.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/game/menu/menu_pages.h"
#include "platform/cpu.h"
#include "platform/kiosk/recorder/score_playback.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/system_health.h"
#include "platform/update_link.h"

/* Maximum time between two presses of the quit key. The time equals MENU_CONFIRM_TICKS, the maximum
 * time between two presses of the TEST button during a round. */
#define QUIT_CONFIRM_NS 5000000000ull
#define RETRY_NS 1000000000ull /* Interval between two attempts to reopen a lost display. */

static void read_wall(struct kiosk *kiosk, const struct hal *hal)
{
    if (hal->clock.ops->civil) {
        hal->clock.ops->civil(hal->clock.self, &kiosk->input.day, &kiosk->input.minute);
    }
}

static void open_slot(struct kiosk *kiosk, const struct hal *hal, uint32_t slot)
{
    CORE_ASSERT(slot < POI_MAX);
    const uint64_t now_ns = hal_now_ns(hal->clock);
    kiosk->faults.poi += sampler_poi_open(&kiosk->samplers[slot], &hal->poi[slot], now_ns);
    if (slot < SHADE_MAX) {
        kiosk->faults.shade += sampler_fan_open(&kiosk->shades[slot], &hal->fan[slot], now_ns);
    }
}

/* Sends the camera view and the display settings to the display and to the pointer devices if one
 * of them has changed. */
static void present_view(struct kiosk *kiosk, const struct hal *hal)
{
    const struct display_settings display_settings =
        output_dimmer_step(&kiosk->dimmer, &kiosk->core.config.persistent.settings, &kiosk->input,
                           kiosk->output.phase == PHASE_ATTRACT, hal_now_ns(hal->clock));
    const uint8_t phase = kiosk->output.phase;
    const bool is_turned = kiosk->input.is_turned != 0;
    if (is_turned) {
        scene_use_turned(&kiosk->scene);
    }
    const struct view rest = is_turned ? kiosk->scene.turned_view : kiosk->rest_view;
    struct view view = rest;
    output_camera_step(&kiosk->camera, &kiosk->dimmer, &kiosk->scene, is_turned,
                       kiosk->core.config.persistent.settings.value[SET_CAMERA] == 0, &view);
    kiosk->scene.view = view;
    /* The core projects a pointer to a page with the camera at rest (pointer_mapping.h). */
    if (phase == PHASE_MODE_SELECT || phase == PHASE_NAME || phase == PHASE_LAB ||
        phase == PHASE_MENU) {
        view = rest;
    }
    /* Devices use the player's axes. */
    view.eye_m = view_from_world(is_turned, view.eye_m);
    view.target_m = view_from_world(is_turned, view.target_m);
    const bool scoops = phase == PHASE_READY || phase == PHASE_ROUND;
    if (kiosk->scoops == scoops &&
        memcmp(&kiosk->display_settings, &display_settings, sizeof display_settings) == 0 &&
        memcmp(&kiosk->view, &view, sizeof kiosk->view) == 0) {
        return;
    }
    kiosk->scoops = scoops;
    kiosk->view = view;
    kiosk->display_settings = display_settings;
    hal->display.ops->set_transform(hal->display.self, &display_settings);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i].ops->set_view(hal->poi[i].self, &kiosk->view, &display_settings, scoops);
    }
}

enum core_error kiosk_init(struct kiosk *kiosk, const struct hal *hal,
                           const struct kiosk_config *config)
{
    CORE_ASSERT(hal->audio.ops && hal->display.ops && hal->slots.ops);
    memset(kiosk, 0, sizeof *kiosk);
    cpu_set_float();
    kiosk->config = *config;
    /* The drivers start with the coin lockout on and all other outputs off. */
    kiosk->switches.active = 1u << HAL_COIN_LOCKOUT;
    kiosk->saving.accepted_id = kiosk->output.entry_id = config->core.persistent.ledger.last_id;
    const enum core_error error = core_init(&kiosk->core, &config->core);
    if (error != CORE_OK) {
        return error;
    }
    output_audio_open(&kiosk->voice, &hal->audio, hal_now_ns(hal->clock));
    /* Reads the wall clock once here, because the first call reads the time zone in the C library,
     * which allocates memory. */
    read_wall(kiosk, hal);
    hal->slots.ops->arrange(hal->slots.self, true);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        open_slot(kiosk, hal, i);
    }
    if (config->sessions) {
        session_recorder_begin(config->sessions, &kiosk->core);
    }
    core_scene(&kiosk->core, &kiosk->scene);
    kiosk->rest_view = kiosk->scene.view;
    present_view(kiosk, hal);
    return CORE_OK;
}

uint32_t kiosk_fault_count(const struct kiosk_faults *faults)
{
    CORE_ASSERT(faults);
    return faults->poi + faults->shade + faults->display + faults->audio + faults->storage +
           faults->buttons + faults->switches;
}

/* ---- Sampling the devices ------------------------------------------------------------------ */

/* Returns true if the quit key was pressed once, so that a second press ends the kiosk. */
static bool is_confirming_quit(const struct kiosk *kiosk)
{
    return kiosk->sampled_ns < kiosk->quit_until_ns;
}

/* Handles the quit key. A kiosk on a desktop requires a second press within QUIT_CONFIRM_NS,
 * because Esc is easily pressed by accident. Any other button cancels the first press. A replay
 * ends at the first press. In the operator's menu the quit key returns to the previous page. */
static void handle_quit_key(struct kiosk *kiosk, const struct button_sample *buttons)
{
    const bool is_menu = kiosk->output.phase == PHASE_MENU;
    if (buttons->pressed != 0 || is_menu) {
        kiosk->quit_until_ns = 0;
    }
    if (!buttons->quit) {
        return;
    }
    if (is_menu) {
        kiosk->input.pressed |= MENU_WAY_BACK;
    } else if (is_confirming_quit(kiosk) || kiosk->config.source.next) {
        kiosk->end = KIOSK_QUIT;
    } else {
        kiosk->quit_until_ns = kiosk->sampled_ns + QUIT_CONFIRM_NS;
    }
}

/* Fills kiosk->input with the current device values, except the poses, which are set for each tick.
 * Counts faults. Sets kiosk->end if the user quits or the display is lost permanently. */
static void sample_devices(struct kiosk *kiosk, const struct hal *hal)
{
    struct input *input = &kiosk->input;
    /* The display is polled first, because its poll() fills the event queue from which mouse and
     * keyboard are read. */
    struct display_events events = { 0 };
    if (hal->display.ops->poll(hal->display.self, &events) == HAL_OK) {
        input->upright = input->is_turned = events.upright;
    }
    if (events.quit || events.lost) {
        kiosk->end = events.lost ? KIOSK_DISPLAY_LOST : KIOSK_QUIT;
    }
    hal->controllers.ops->poll(hal->controllers.self, &input->controllers);
    input->controllers.file_count = operator_view_file_count(kiosk->config.notes);
    input->controllers.update =
        kiosk->config.update ? update_link_state(kiosk->config.update) : (uint8_t)UPDATE_NONE;
    const uint64_t now_ns = kiosk->sampled_ns = hal_now_ns(hal->clock);
    /* Assigns controllers to slots. Slots change only between two games and while the operator's
     * menu is shown, so that no player loses a controller during a game. */
    const uint8_t phase = kiosk->output.phase;
    const bool may_move = phase == PHASE_ATTRACT || phase == PHASE_MENU;
    const uint32_t moved = hal->slots.ops->arrange(hal->slots.self, may_move);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (moved & (1u << i)) {
            open_slot(kiosk, hal, i);
            hal->poi[i].ops->set_view(hal->poi[i].self, &kiosk->view, &kiosk->display_settings,
                                      kiosk->scoops);
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        kiosk->faults.poi += sampler_poi_sample(&kiosk->samplers[i], &hal->poi[i], now_ns);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        kiosk->faults.shade += sampler_fan_sample(&kiosk->shades[i], &hal->fan[i], now_ns);
    }
    /* The buttons are polled after the pois, because polling a poi also reads the buttons of its
     * controller. */
    struct button_sample buttons = { 0 };
    hal->buttons.ops->poll(hal->buttons.self, &buttons);
    input->held = buttons.held & (uint32_t)INPUT_BUTTON_ALL;
    input->pressed |= buttons.pressed & (uint32_t)INPUT_BUTTON_ALL;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        input->coin_count[line] += buttons.coin_count[line];
    }
    kiosk->faults.buttons += buttons.faults;
    operator_view_lines_add(&kiosk->lines, &buttons);
    if (buttons.full_screen) {
        hal->display.ops->toggle_full_screen(hal->display.self);
    }
    handle_quit_key(kiosk, &buttons);
    const struct hal_storage *storage = &hal->storage;
    input->record_saved_id = storage->ledger.ops->committed_id(storage->ledger.self);
    input->edit_saved_id = storage->edits.ops->stored_id(storage->edits.self);
    input->edit_refused = storage->edits.ops->has_failed(storage->edits.self);
    input->store_well = storage->ledger.ops->is_healthy(storage->ledger.self);
    kiosk_count_refused(kiosk, hal);
    input->tickets_done = output_lines_are_done(&kiosk->switches, &hal->switches, HAL_TICKET);
    read_wall(kiosk, hal);
    input->dropped_ticks = (uint32_t)kiosk->pace.dropped;
    input->device_faults = kiosk_fault_count(&kiosk->faults);
}

/* ---- Ticks --------------------------------------------------------------------------------- */

/* Prepares kiosk->input for one tick and returns true. If the input source has no more ticks, ends
 * the frame loop and returns false instead. */
static bool prepare_tick(struct kiosk *kiosk, uint32_t index, uint32_t tick_count)
{
    CORE_ASSERT(index < tick_count);
    struct input *input = &kiosk->input;
    if (kiosk->config.source.next) {
        if (kiosk->config.source.next(kiosk->config.source.self, input)) {
            return true;
        }
        kiosk->end = KIOSK_SOURCE_END;
        return false;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct poi_target *const target = &input->poi[i].target;
        sampler_poi_at(&kiosk->samplers[i], index, tick_count, kiosk->sampled_ns, &input->poi[i]);
        if (input->is_turned) {
            target->position_m = view_to_world(true, target->position_m);
            target->angles.yaw_rad += VIEW_TURN_RAD;
        }
        if (kiosk->config.bot[i]) {
            input->poi[i].link = POI_SOURCE_BOT;
        }
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        struct shade_input *const shade = &input->shade[i];
        *shade = sampler_fan_at(&kiosk->shades[i], index, tick_count);
        const vec3 at_m = view_to_world(input->is_turned != 0, v3(shade->x_m, 0.0f, shade->z_m));
        shade->x_m = at_m.x;
        shade->z_m = at_m.z;
    }
    /* During a score playback, poses and buttons control the playback, and the game gets only
     * coins. The input that ends the playback is not passed to the game. */
    if (kiosk->config.playback && kiosk->config.playback->state != PLAYBACK_OFF) {
        score_playback_handle_input(kiosk->config.playback, input->pressed, input->poi);
        input->pressed = input->held = 0;
        for (uint32_t i = 0; i < POI_MAX; i++) {
            input->poi[i].link = POI_SOURCE_ABSENT;
        }
    }
    return true;
}

/* Runs one tick. Returns false and sets kiosk->end if the core rejects the tick, otherwise returns
 * true. session_recorder_before() must be the first call: if another thread has panicked, this call
 * blocks, so that the tick does not change the state any more. */
static bool run_tick(struct kiosk *kiosk)
{
    CORE_ASSERT(kiosk->output.sound_count <= OUTPUT_SOUND_MAX);
    const struct kiosk_tap *tap = &kiosk->config.tap;
    if (kiosk->config.sessions) {
        session_recorder_before(kiosk->config.sessions, &kiosk->input);
    }
    if (tap->before) {
        tap->before(tap->self, &kiosk->input);
    }
    if (core_tick(&kiosk->core, &kiosk->input, &kiosk->output) != CORE_OK) {
        kiosk->end = KIOSK_FLOAT;
        return false;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        output_merge_force(&kiosk->felt[i], &kiosk->output.poi[i]);
    }
    if (tap->tick) {
        tap->tick(tap->self, &kiosk->input, &kiosk->core);
    }
    if (kiosk->config.sessions) {
        session_recorder_tick(kiosk->config.sessions, &kiosk->input, &kiosk->core, &kiosk->output);
    }
    kiosk->input.pressed = 0; /* A button press is valid for one tick only. */
    memset(kiosk->input.coin_count, 0, sizeof kiosk->input.coin_count);
    return true;
}

/* Runs the ticks of the frame. Returns the number of completed ticks. */
static uint32_t run_ticks(struct kiosk *kiosk, uint32_t tick_count)
{
    CORE_ASSERT(tick_count <= FRAME_PACER_TICKS_MAX);
    uint32_t done = 0;
    kiosk->output.sound_count = 0;
    /* The forces are cleared only in a frame with ticks. In a frame without ticks, the forces of
     * the previous frame stay set. */
    if (tick_count > 0) {
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
            sampler_path_end(&kiosk->samplers[i].path);
        }
        for (uint32_t i = 0; i < SHADE_MAX; i++) {
            kiosk->shades[i].from = kiosk->shades[i].to;
        }
        core_scene(&kiosk->core, &kiosk->scene);
    }
    return done;
}

/* ---- Frame --------------------------------------------------------------------------------- */

/* Draws the picture. Game and store continue without a display. A lost display is retried once per
 * second. */
static void present_picture(struct kiosk *kiosk, const struct hal *hal)
{
    const struct hal_display *display = &hal->display;
    const uint64_t now_ns = hal_now_ns(hal->clock);
    if (kiosk->display_retry_ns > 0 && now_ns >= kiosk->display_retry_ns) {
        const bool is_back = display->ops->open(display->self) == HAL_OK;
        kiosk->display_retry_ns = is_back ? 0 : hal_now_ns(hal->clock) + RETRY_NS;
    }
    if (kiosk->display_retry_ns > 0) {
        return;
    }
    const int result = display->ops->present(display->self, &kiosk->scene);
    kiosk->faults.display += (uint32_t)hal_is_fault(result);
    if (result == HAL_ERR_GONE) {
        kiosk->display_retry_ns = now_ns + RETRY_NS;
    }
}

/* Completes the scene: shows a score playback in place of the game, and fills the operator's
 * menu. */
static void complete_scene(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count)
{
    struct score_playback *playback = kiosk->config.playback;
    if (playback) {
        if (kiosk->wanted_replay_id != 0) {
            score_playback_request(playback, kiosk->wanted_replay_id);
            kiosk->wanted_replay_id = 0;
        }
        score_playback_frame(playback, hal, &kiosk->config.stopwatch, core_ranking(&kiosk->core),
                             tick_count);
        score_playback_show(playback, &kiosk->scene, &kiosk->output);
    }
    kiosk->scene.is_confirming_quit = is_confirming_quit(kiosk);
    /* Copies the newest system health, and forwards the operator's acknowledgement to the health
     * monitor. Never blocks. */
    struct system_health *machine = kiosk->config.machine;
    kiosk->machine.watch = hal->watchdog.ops->watches(hal->watchdog.self);
    kiosk->machine.missed = kiosk->config.sessions ? kiosk->config.sessions->missed : 0u;
    if (machine) {
        if (kiosk->has_acknowledged) {
            system_health_acknowledge(machine);
            kiosk->has_acknowledged = 0;
        }
        system_health_read(machine, &kiosk->machine);
    }
    struct update_link *update = kiosk->config.update;
    if (update) {
        const bool is_open =
            kiosk->output.phase == PHASE_MENU && kiosk->scene.menu.page == MENU_UPDATE;
        update_link_step(update, is_open, hal_now_ns(hal->clock));
    }
    const struct operator_view operator_view = {
        .update = update ? &update->newest : NULL,
        .notes = kiosk->config.notes,
        .input = &kiosk->input,
        .samplers = kiosk->samplers,
        .lines = &kiosk->lines,
        .button_faults = kiosk->faults.buttons,
        .machine = &kiosk->machine,
        .frame_ns = frame_timing_quantile_ns(&kiosk->frame_time, 0.5),
    };
    operator_view_fill(&kiosk->scene, hal, &operator_view);
}

enum kiosk_end kiosk_frame(struct kiosk *kiosk, const struct hal *hal)
{
    CORE_ASSERT(hal->display.ops && hal->slots.ops && hal->storage.ledger.ops);
    const struct hal_clock stopwatch = kiosk->config.stopwatch;
    const uint64_t begin_ns = hal_now_ns(stopwatch);
    if (kiosk->frames > 0) {
        frame_timing_add(&kiosk->frame_time, begin_ns - kiosk->frame_begin_ns);
    }
    kiosk->frame_begin_ns = begin_ns;
    kiosk->frames++;
    const uint32_t tick_due = frame_pacer_ticks_due(&kiosk->pace, hal_now_ns(hal->clock));
    sample_devices(kiosk, hal);
    if (tick_due > 0) {
        /* Adds the waiting time of each poi report to the statistics. The waiting time ends now.
         * The time is read from the clock that also stamped the reports. */
        const uint64_t now_ns = hal_now_ns(hal->clock);
        for (uint32_t i = 0; i < POI_MAX; i++) {
            sampler_poi_time(&kiosk->samplers[i], now_ns, &kiosk->report_wait);
        }
    }
    output_dimmer_notice(&kiosk->dimmer, &kiosk->input, kiosk->output.phase == PHASE_ATTRACT);
    const uint64_t core_begin_ns = hal_now_ns(stopwatch);
    const uint32_t tick_count = run_ticks(kiosk, tick_due);
    complete_scene(kiosk, hal, tick_count);
    if (tick_count > 0) {
        kiosk->rest_view = kiosk->scene.view;
    }
    kiosk->core_ns += hal_now_ns(stopwatch) - core_begin_ns;
    present_view(kiosk, hal);
    if (tick_count > 0) {
        kiosk_send_results(kiosk, hal);
    }
    /* The picture is presented last, because presenting may block until the screen is refreshed.
     * Sounds must not wait that long. */
    present_picture(kiosk, hal);
    if (tick_count > 0) {
        hal->watchdog.ops->kick(hal->watchdog.self); /* The watchdog is notified only after a frame
                                                        with ticks. The watchdog therefore restarts
                                                        a kiosk that runs no ticks. */
    }
    frame_timing_add(&kiosk->work_time, hal_now_ns(stopwatch) - begin_ns);
    return kiosk->end;
}
