/* kiosk_outputs.c -- sends the results of a frame's ticks to the devices and to the store, and
 * closes the store; see kiosk.h. */
#include "platform/kiosk/kiosk.h"

#include "core/base/panic.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/update_link.h"

/* Maximum time that a restart waits for the store. If the store needs longer, the memory card is
 * assumed to be full. */
#define RESTART_WAIT_NS (5u * NS_PER_S)

_Static_assert(FRAME_PACER_TICKS_MAX / MENU_TAKE_TICKS + 2u <= CONTROLLER_COMMAND_MAX,
               "a take in the first tick, one after each pause, and the menu that closes itself");

/* Executes the operator's commands of the frame in their order. */
static void execute_commands(struct kiosk *kiosk, const struct hal *hal)
{
    while (kiosk->sent_commands != kiosk->output.command_count) {
        const struct controller_command *order =
            &kiosk->output.commands[kiosk->sent_commands++ % CONTROLLER_COMMAND_MAX];
        if (order->kind == COMMAND_RESTART) {
            kiosk->restart_ns = hal_now_ns(hal->clock) + RESTART_WAIT_NS;
        } else if (order->kind == COMMAND_REPLAY) {
            kiosk->wanted_replay_id = order->round_id;
        } else if (order->kind == COMMAND_SEEN) {
            kiosk->has_acknowledged = true;
        } else if (order->kind == COMMAND_UPDATE) {
            if (kiosk->config.update) {
                update_link_start(kiosk->config.update);
            }
        } else {
            hal->controllers.ops->command(hal->controllers.self, order);
        }
    }
}

/* ---- Store --------------------------------------------------------------------------------- */

/* Passes the ledger's entries to the store, oldest first, and then the newest edit of the growth
 * lab. If the store is busy, the next frame tries again. If the store failed, the next attempt
 * follows after one second. If no store exists, the entries count as settled. Returns the number of
 * faults. */
static uint32_t put_in_store(struct saving *saving, const struct hal_storage *storage,
                             const struct output *output, uint64_t now_ns)
{
    const struct hal_ledger *ledger = &storage->ledger;
    const struct hal_edit_store *edits = &storage->edits;
    int result = HAL_OK;
    bool is_accepted = true;
    uint32_t faults = 0;
    while (is_accepted && saving->accepted_id != output->entry_id && now_ns >= saving->retry_ns) {
        const uint32_t behind = output->entry_id - saving->accepted_id;
        saving->accepted_id += behind > LEDGER_RING ? behind - LEDGER_RING : 0u;
        const uint32_t place = (saving->accepted_id + 1u) % LEDGER_RING;
        result = ledger->ops->append(ledger->self, &output->entries[place]);
        saving->is_offline |= result == HAL_ERR_ABSENT;
        is_accepted = output_is_settled(result, now_ns, &saving->retry_ns);
        saving->accepted_id += is_accepted;
        faults += (uint32_t)hal_is_fault(result);
    }
    if (output->edit.id != saving->accepted_edit_id && now_ns >= saving->retry_ns) {
        result = edits->ops->store(edits->self, &output->edit);
        if (output_is_settled(result, now_ns, &saving->retry_ns)) {
            saving->accepted_edit_id = output->edit.id;
        }
        faults += (uint32_t)hal_is_fault(result);
    }
    return faults;
}

void kiosk_count_refused(struct kiosk *kiosk, const struct hal *hal)
{
    const uint32_t refused = hal->storage.ledger.ops->failed_count(hal->storage.ledger.self);
    kiosk->faults.storage += refused - kiosk->saving.refused_seen;
    kiosk->saving.refused_seen = refused;
}

/* Returns true if the kiosk must restart in this frame, to use a new store or because the operator
 * requested a restart. */
static bool must_restart(struct kiosk *kiosk, const struct hal *hal, bool is_replay)
{
    /* The kiosk restarts to use a store that appeared after program start, but only while no game,
     * replay or recording runs. Before the restart, all coins and credits that were only in memory
     * must be in the store. A remaining credit does not delay the restart, because a credit cannot
     * be played before it is stored. */
    const struct hal_ledger *ledger = &hal->storage.ledger;
    if (kiosk->output.is_idle && !is_replay && !kiosk->config.tap.tick &&
        ledger->ops->needs_restart(ledger->self) &&
        offline_flush_step(&kiosk->late, ledger, &kiosk->core)) {
        return true;
    }
    /* A restart requested by the operator waits until the store has every entry, at most
     * RESTART_WAIT_NS. */
    return kiosk->restart_ns > 0 && (kiosk->saving.accepted_id == kiosk->output.entry_id ||
                                     hal_now_ns(hal->clock) >= kiosk->restart_ns);
}

/* A replay sends nothing to the output lines and to the ledger, and executes no commands, because
 * its coins were counted and its entries were stored during the recorded game. During a replay the
 * coin lockout therefore stays on, and the coin slot returns each coin, which would otherwise be
 * lost. */
void kiosk_send_results(struct kiosk *kiosk, const struct hal *hal)
{
    CORE_ASSERT(hal->audio.ops && hal->storage.ledger.ops);
    const bool is_replay = kiosk->config.source.next != NULL;
    const struct hal_storage *storage = &hal->storage;
    kiosk->faults.audio += output_audio_play(
        &kiosk->voice, &hal->audio, &kiosk->output, &kiosk->core.config.persistent.settings,
        &kiosk->input, kiosk->output.phase == PHASE_ATTRACT, hal_now_ns(hal->clock));
    if (!is_replay) {
        kiosk->faults.switches += output_lines_put(&kiosk->switches, &hal->switches, &kiosk->output,
                                                   hal_now_ns(hal->clock));
        execute_commands(kiosk, hal);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (kiosk->samplers[i].link == POI_SOURCE_LIVE) {
            const bool is_turned = kiosk->input.is_turned != 0;
            struct poi_force force = kiosk->felt[i];
            force.force_n = view_from_world(is_turned, force.force_n);
            force.torque_n_m = view_from_world(is_turned, force.torque_n_m);
            const int result = hal->poi[i].ops->set_force(hal->poi[i].self, &force);
            kiosk->faults.poi += (uint32_t)hal_is_fault(result);
        }
    }
    if (!is_replay) {
        kiosk->faults.storage +=
            put_in_store(&kiosk->saving, storage, &kiosk->output, hal_now_ns(hal->clock));
    }
    /* The recording of a ranked round is passed to the store only after the entry of the round is
     * on disk. */
    if (kiosk->config.sessions) {
        kiosk->faults.storage += session_recorder_offer(kiosk->config.sessions, storage);
    }
    if (must_restart(kiosk, hal, is_replay)) {
        kiosk->end = KIOSK_RESTART;
    }
}

uint32_t kiosk_close_store(struct kiosk *kiosk, const struct hal *hal)
{
    CORE_ASSERT(hal->storage.ledger.ops);
    const struct hal_ledger *ledger = &hal->storage.ledger;
    const bool is_replay = kiosk->config.source.next != NULL;
    const bool is_offline = !is_replay && kiosk->saving.is_offline;
    const uint32_t waiting = is_replay ? 0 : kiosk->output.entry_id - kiosk->saving.accepted_id;
    /* Adds a last health entry, which contains the uptime, to the ledger when the program ends
     * without an error. Adds no entry while other entries wait for the store. */
    struct ledger_entry entry;
    if (!is_replay && waiting == 0 && core_final_entry(&kiosk->core, &kiosk->input, &entry)) {
        ledger->ops->append(ledger->self, &entry);
    }
    /* Starts a transfer, because the store may be available when it closes. */
    if (is_offline) {
        offline_flush_step(&kiosk->late, ledger, &kiosk->core);
    }
    const uint32_t unwritten = ledger->ops->close(ledger->self);
    kiosk_count_refused(kiosk, hal);
    return unwritten + waiting +
           (is_offline ? offline_flush_missing(&kiosk->late, ledger, &kiosk->core) : 0u);
}
