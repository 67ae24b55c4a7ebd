/* kiosk_devices.c -- reads the devices at the start of a frame, and writes the results of the ticks
 * to the devices at the end of the frame; see kiosk.h. */
#include "core/base/panic.h"
#include "platform/kiosk/kiosk.h"

#include <string.h>

#include "core/game/menu/menu_pages.h"
#include "platform/kiosk/recorder/session_recorder.h"

/* Maximum time between two presses of the quit key. The time equals MENU_ASK_TICKS, which is the
 * maximum time between two presses of the TEST button during a round. */
#define QUIT_ASK_NS 5000000000ull

static void read_wall(struct kiosk *kiosk, const struct hal *hal)
{
    if (hal->clock.ops->civil) {
        hal->clock.ops->civil(hal->clock.self, &kiosk->input.day, &kiosk->input.minute);
    }
}

static void open_seat(struct kiosk *kiosk, const struct hal *hal, uint32_t seat, uint64_t now_ns)
{
    CORE_ASSERT(seat < POI_MAX);
    kiosk->faults.poi += sampler_poi_open(&kiosk->hands[seat], &hal->poi[seat], now_ns);
    if (seat < SHADE_MAX) {
        kiosk->faults.shade += sampler_fan_open(&kiosk->shades[seat], &hal->fan[seat], now_ns);
    }
}

void kiosk_open_devices(struct kiosk *kiosk, const struct hal *hal)
{
    read_wall(kiosk, hal); /* The first call reads the time zone in the C library, which allocates
                              memory. */
    hal->seats.ops->arrange(hal->seats.self, 1);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        open_seat(kiosk, hal, i, hal_now_ns(hal->clock));
    }
}

/* Handles the quit key. A kiosk on a desktop requires a second press within QUIT_ASK_NS, because
 * Esc is easily pressed by accident. Any other button cancels the first press. A replay ends at the
 * first press. In the operator's menu the quit key returns to the previous page. */
static void heed_quit(struct kiosk *kiosk, const struct button_sample *buttons)
{
    const int is_menu = kiosk->output.phase == PHASE_MENU;
    if (buttons->pressed != 0 || is_menu) {
        kiosk->quit_until_ns = 0;
    }
    if (!buttons->quit) {
        return;
    }
    if (is_menu) {
        kiosk->input.pressed |= MENU_WAY_BACK;
    } else if (kiosk_asks_to_quit(kiosk) || kiosk->config.source.next) {
        kiosk->end = KIOSK_QUIT;
    } else {
        kiosk->quit_until_ns = kiosk->sampled_ns + QUIT_ASK_NS;
    }
}

void kiosk_sample_devices(struct kiosk *kiosk, const struct hal *hal)
{
    /* The display is polled first, because its poll() fills the event queue from which mouse and
     * keyboard are read. */
    struct display_events events = { 0 };
    if (hal->display.ops->poll(hal->display.self, &events) == HAL_OK) {
        kiosk->input.upright = events.upright;
    }
    if (events.quit) {
        kiosk->end = KIOSK_QUIT;
    }
    if (events.lost) {
        kiosk->end = KIOSK_DISPLAY_LOST;
    }
    hal->controllers.ops->poll(hal->controllers.self, &kiosk->input.controllers);
    kiosk->input.controllers.file_count = operator_view_file_count(kiosk->config.notes);
    const uint64_t now_ns = kiosk->sampled_ns = hal_now_ns(hal->clock);
    /* Assigns controllers to slots. Slots change only between two games and while the operator's
     * menu is shown, so that no player loses a controller during a game. */
    const uint8_t phase = kiosk->output.phase;
    const int may_move = phase == PHASE_ATTRACT || phase == PHASE_MENU;
    const uint32_t moved = hal->seats.ops->arrange(hal->seats.self, may_move);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (moved & (1u << i)) {
            open_seat(kiosk, hal, i, kiosk->sampled_ns);
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        kiosk->faults.poi += sampler_poi_sample(&kiosk->hands[i], &hal->poi[i], now_ns);
    }
    for (uint32_t i = 0; i < SHADE_MAX; i++) {
        kiosk->faults.shade += sampler_fan_sample(&kiosk->shades[i], &hal->fan[i], now_ns);
    }
    /* The buttons are polled after the pois, because polling a poi also reads the buttons of its
     * controller. */
    struct button_sample buttons = { 0 };
    hal->buttons.ops->poll(hal->buttons.self, &buttons);
    kiosk->input.held = buttons.held & (uint32_t)INPUT_BUTTON_ALL;
    kiosk->input.pressed |= buttons.pressed & (uint32_t)INPUT_BUTTON_ALL;
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        kiosk->input.coin_count[line] += buttons.coin_count[line];
    }
    kiosk->faults.buttons += buttons.faults;
    operator_view_lines_add(&kiosk->lines, &buttons);
    if (buttons.full_screen) {
        hal->display.ops->toggle_full_screen(hal->display.self);
    }
    heed_quit(kiosk, &buttons);
    kiosk->input.record_saved_id = hal->storage.ledger.ops->committed_id(hal->storage.ledger.self);
    kiosk->input.edit_saved_id = hal->storage.edits.ops->stored_id(hal->storage.edits.self);
    kiosk->input.edit_refused = hal->storage.edits.ops->has_failed(hal->storage.edits.self) != 0;
    kiosk->input.store_well = hal->storage.ledger.ops->is_healthy(hal->storage.ledger.self) != 0;
    kiosk->faults.storage += saving_refused(&kiosk->saving, &hal->storage.ledger);
    kiosk->input.tickets_done = output_lines_are_done(&kiosk->switches, &hal->switches, HAL_TICKET);
    read_wall(kiosk, hal);
    kiosk->input.dropped_ticks = (uint32_t)kiosk->pace.dropped;
    kiosk->input.device_faults = kiosk_fault_count(&kiosk->faults);
}

/* ---- Presenting ---------------------------------------------------------------------------- */

/* Maximum time that a restart waits for the store. If the store needs longer, the memory card is
 * assumed to be full. */
#define RESTART_WAIT_NS 5000000000ull
#define RETRY_NS 1000000000ull /* Interval between two attempts to reopen a lost display. */

void kiosk_present_view(struct kiosk *kiosk, const struct hal *hal)
{
    const struct display_settings display_settings =
        output_dimmer_step(&kiosk->dimmer, &kiosk->core.config.persistent.settings, &kiosk->input,
                           kiosk->output.phase == PHASE_ATTRACT, hal_now_ns(hal->clock));
    if (memcmp(&kiosk->display_settings, &display_settings, sizeof display_settings) == 0 &&
        memcmp(&kiosk->view, &kiosk->scene.view, sizeof kiosk->view) == 0) {
        return;
    }
    kiosk->view = kiosk->scene.view;
    kiosk->display_settings = display_settings;
    hal->display.ops->set_transform(hal->display.self, &display_settings);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hal->poi[i].ops->set_view(hal->poi[i].self, &kiosk->view, &display_settings);
    }
}

_Static_assert(FRAME_PACER_TICKS_MAX / MENU_TAKE_TICKS + 2u <= CONTROLLER_COMMAND_MAX,
               "a take in the first tick, one after each pause, and the menu that closes itself");

/* Ends the frame loop for a restart. A restart requested by the operator waits until the store has
 * every entry, at most RESTART_WAIT_NS. */
static void end_for_restart(struct kiosk *kiosk, const struct hal *hal)
{
    /* Returns 1 if the kiosk must restart to use a store that appeared after program start.
     * Otherwise returns 0. The kiosk restarts only while no game, replay or recording runs.
     * Before the restart, all coins and credits that were only in memory must be in the store. A
     * remaining credit does not delay the restart, because a credit cannot be played before it
     * is stored. */
    if (kiosk->output.is_idle && !kiosk->config.source.next && !kiosk->config.tap.tick &&
        hal->storage.ledger.ops->needs_restart(hal->storage.ledger.self) &&
        saving_flush_offline(&kiosk->late, &hal->storage.ledger, &kiosk->core)) {
        kiosk->end = KIOSK_RESTART;
        return;
    }
    const int is_kept = saving_is_done(&kiosk->saving, &kiosk->output);
    if (kiosk->restart_ns > 0 && (is_kept || hal_now_ns(hal->clock) >= kiosk->restart_ns)) {
        kiosk->end = KIOSK_RESTART;
    }
}

/* Draws the picture. Game and store continue without a display. A lost display is retried once per
 * second. */
static void present_picture(struct kiosk *kiosk, const struct hal *hal)
{
    const struct hal_display *display = &hal->display;
    const uint64_t now_ns = hal_now_ns(hal->clock);
    if (kiosk->display_retry_ns > 0 && now_ns >= kiosk->display_retry_ns) {
        const int is_back = display->ops->open(display->self) == HAL_OK;
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

void kiosk_present_frame(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count)
{
    CORE_ASSERT(tick_count <= FRAME_PACER_TICKS_MAX);
    if (tick_count > 0) {
        kiosk->faults.audio += output_audio_play(
            &kiosk->voice, &hal->audio, &kiosk->output, &kiosk->core.config.persistent.settings,
            kiosk->output.phase == PHASE_ATTRACT, hal_now_ns(hal->clock));
        /* Sends the start lamp, the coin lockout, the coin counter and the tickets to the
         * driver. A replay sends nothing, because its coins were counted when they were
         * inserted. During a replay the driver's coin lockout therefore stays on. The coin slot
         * then returns each coin, which would otherwise be lost. */
        if (!kiosk->config.source.next) {
            kiosk->faults.switches += output_lines_put(&kiosk->switches, &hal->switches,
                                                       &kiosk->output, hal_now_ns(hal->clock));
        }
        /* Execute the operator commands of the frame in their order. */
        const struct output *output = &kiosk->output;
        while (!kiosk->config.source.next && kiosk->told_orders != output->command_count) {
            const struct controller_command *order =
                &output->commands[kiosk->told_orders++ % CONTROLLER_COMMAND_MAX];
            if (order->kind == COMMAND_RESTART) {
                kiosk->restart_ns = hal_now_ns(hal->clock) + RESTART_WAIT_NS;
            } else if (order->kind == COMMAND_REPLAY) {
                kiosk->wanted_replay_id = order->round_id;
            } else if (order->kind == COMMAND_SEEN) {
                kiosk->has_acknowledged = 1;
            } else {
                hal->controllers.ops->command(hal->controllers.self, order);
            }
        }
        for (uint32_t i = 0; i < POI_MAX; i++) {
            if (kiosk->hands[i].link == POI_SOURCE_LIVE) {
                const int result = hal->poi[i].ops->set_force(hal->poi[i].self, &kiosk->felt[i]);
                kiosk->faults.poi += (uint32_t)hal_is_fault(result);
            }
        }
        /* Store data that must survive a power cut. A replay stores no entries, because its
         * entries were stored during the recorded game. The recording of a score is stored after
         * the score is on disk. */
        const struct hal_storage *storage = &hal->storage;
        const uint64_t saved_ns = hal_now_ns(hal->clock);
        uint32_t faults = 0;
        if (!kiosk->config.source.next) {
            faults +=
                saving_put_entries(&kiosk->saving, &storage->ledger, &kiosk->output, saved_ns);
            faults += saving_put_edit(&kiosk->saving, &storage->edits, &kiosk->output, saved_ns);
        }
        if (kiosk->config.chapters) {
            faults += (uint32_t)session_recorder_offer(kiosk->config.chapters, storage);
        }
        kiosk->faults.storage += faults;
        end_for_restart(kiosk, hal);
    }
    present_picture(kiosk, hal); /* The picture is last because it may wait for the screen, and
                                    sounds must not be delayed. */
}
