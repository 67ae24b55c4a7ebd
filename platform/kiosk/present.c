/* present.c -- writes the results of a frame to the devices; see present.h. */
#include "platform/kiosk/present.h"

#include <string.h>

#include "core/game/menu/menu_pages.h"
#include "platform/kiosk/session_recorder.h"

/* Maximum time that a restart waits for the store. A slower card is assumed to be full. */
#define RESTART_WAIT_NS 5000000000ull
#define RETRY_NS 1000000000ull /* Interval between two attempts to reopen a lost display. */

void present_view(struct kiosk *kiosk, const struct hal *hal)
{
    const struct display_settings display_settings =
        dimmer_step(&kiosk->dimmer, &kiosk->core.config.persistent.settings, &kiosk->input,
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

static void present_sounds(struct kiosk *kiosk, const struct hal *hal)
{
    kiosk->faults.audio += audio_output_play(
        &kiosk->voice, &hal->audio, &kiosk->output, &kiosk->core.config.persistent.settings,
        kiosk->output.phase == PHASE_ATTRACT, hal_now_ns(hal->clock));
}

/* Sends the start lamp, the coin lockout, the coin counter and the tickets to the driver. A replay
 * sends nothing, because its coins were counted when they were inserted. During a replay the
 * driver's coin lockout therefore stays on. The coin slot then returns each coin, which would
 * otherwise be lost. */
static void present_switches(struct kiosk *kiosk, const struct hal *hal)
{
    if (!kiosk->config.source.next) {
        kiosk->faults.switches += output_lines_put(&kiosk->switches, &hal->switches, &kiosk->output,
                                                   hal_now_ns(hal->clock));
    }
}

_Static_assert(FRAME_PACER_TICKS_MAX / MENU_TAKE_TICKS + 2u <= CONTROLLER_COMMAND_MAX,
               "a take in the first tick, one after each pause, and the menu that closes itself");

/* Executes the operator commands of the frame in their order. */
static void present_orders(struct kiosk *kiosk, const struct hal *hal)
{
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
}

/* Returns 1 if the kiosk must restart to use a store that appeared after program start. Otherwise
 * returns 0.
 *
 * The kiosk restarts only while no game, replay or recording runs. Before the restart, all coins
 * and credits that were only in memory must be in the store. A remaining credit does not delay the
 * restart, because a credit cannot be played before it is stored. */
static int is_called_back(struct kiosk *kiosk, const struct hal *hal)
{
    return kiosk->output.is_idle && !kiosk->config.source.next && !kiosk->config.tap.tick &&
           hal->storage.ledger.ops->needs_restart(hal->storage.ledger.self) &&
           offline_flush_step(&kiosk->late, &hal->storage.ledger, &kiosk->core);
}

/* Ends the frame loop for a restart. A restart requested by the operator waits until the store has
 * every entry, at most RESTART_WAIT_NS. */
static void end_for_restart(struct kiosk *kiosk, const struct hal *hal)
{
    if (is_called_back(kiosk, hal)) {
        kiosk->end = KIOSK_RESTART;
        return;
    }
    const int is_kept = saving_is_done(&kiosk->saving, &kiosk->output);
    if (kiosk->restart_ns > 0 && (is_kept || hal_now_ns(hal->clock) >= kiosk->restart_ns)) {
        kiosk->end = KIOSK_RESTART;
    }
}

static void present_forces(struct kiosk *kiosk, const struct hal *hal)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (kiosk->hands[i].link == POI_SOURCE_LIVE) {
            const int result = hal->poi[i].ops->set_force(hal->poi[i].self, &kiosk->felt[i]);
            kiosk->faults.poi += (uint32_t)hal_is_fault(result);
        }
    }
}

/* Stores data that must survive a power cut. A replay stores no entries, because its entries
 * were stored during the recorded game. The recording of a score is stored after the score is on
 * disk. */
static void present_savings(struct kiosk *kiosk, const struct hal *hal)
{
    const struct hal_storage *storage = &hal->storage;
    const uint64_t now_ns = hal_now_ns(hal->clock);
    uint32_t faults = 0;
    if (!kiosk->config.source.next) {
        faults += saving_put_entries(&kiosk->saving, &storage->ledger, &kiosk->output, now_ns);
        faults += saving_put_edit(&kiosk->saving, &storage->edits, &kiosk->output, now_ns);
    }
    if (kiosk->config.chapters) {
        faults += (uint32_t)session_recorder_offer(kiosk->config.chapters, storage);
    }
    kiosk->faults.storage += faults;
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

void present_frame(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count)
{
    if (tick_count > 0) {
        present_sounds(kiosk, hal);
        present_switches(kiosk, hal);
        present_orders(kiosk, hal);
        present_forces(kiosk, hal);
        present_savings(kiosk, hal);
        end_for_restart(kiosk, hal);
    }
    present_picture(kiosk, hal); /* The picture is last because it may wait for the screen, and
                                    sounds must not be delayed. */
}
