/* pin_sweep.c -- replays, verifies and replaces recordings that contain a PIN; see pin_sweep.h. */
#include "platform/kiosk/recorder/pin_sweep.h"

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/log.h"

static void end_replay(struct pin_sweep *sweep, bool is_cleaned)
{
    sweep->cleaned += is_cleaned;
    sweep->left += !is_cleaned;
    sweep->stage = PIN_SWEEP_SEEK;
}

/* Reads the next stored replay and selects the replay if its initial state contains a PIN. A replay
 * that cannot be read is skipped. */
static void seek(struct pin_sweep *sweep, struct ledger_file *file)
{
    if (ledger_file_next_replay(file, sweep->round_id, &sweep->round_id) != SQLITE_OK) {
        sweep->stage = PIN_SWEEP_DONE;
        if (sweep->cleaned + sweep->left > 0) {
            log_print(LOG_LEVEL_WARNING,
                      "kept replays of an older version: the PIN was removed from %u; %u still "
                      "hold one, because they do not verify or a PIN is typed in them",
                      sweep->cleaned, sweep->left);
        }
        return;
    }
    if (ledger_file_get_replay(file, sweep->round_id, sweep->replay, sizeof sweep->replay,
                               &sweep->size) == SQLITE_OK &&
        replay_verifier_open(&sweep->judge, sweep->replay, sweep->size) == 0 &&
        session_recorder_start_has_pin(&sweep->judge.replayer.reader.header.config)) {
        ledger_file_round(file, sweep->round_id, &sweep->kept);
        sweep->is_check = false;
        sweep->stage = PIN_SWEEP_READ;
    }
}

/* Returns the hash that the core would have if the initial configuration had contained PIN_WITHHELD
 * instead of the PIN (core/pin.h). Replaces the PIN, calls `hash`, and restores the PIN. The
 * replacement is sufficient because the PIN affects no other part of the state until digits of a
 * PIN are typed. */
static uint64_t hash_without_pin(struct core *core, uint64_t (*hash)(const struct core *core))
{
    int32_t *kept = &core->config.persistent.settings.value[SET_PIN];
    int32_t *begun = &core->config.session.settings_edit.told.value[SET_PIN];
    int32_t *told = &core->game.settings_edit.told.value[SET_PIN];
    const int32_t before[] = { *kept, *begun, *told };
    session_recorder_withhold_pin(&core->config, told);
    const uint64_t result = hash(core);
    *kept = before[0];
    *begun = before[1];
    *told = before[2];
    return result;
}

/* Handles the end of a simulation. The first simulation replays the stored recording and creates a
 * new recording. The second simulation verifies the new recording. If both simulations succeed, the
 * new recording replaces the stored recording. Returns an SQLite result code. */
static int end_play(struct pin_sweep *sweep, struct ledger_file *file)
{
    struct replay_verifier *judge = &sweep->judge;
    int code = SQLITE_OK;
    if (replay_verifier_result(judge, &file->content.memory.ranking, sweep->round_id,
                               &sweep->kept) != REPLAY_VERDICT_GENUINE) {
        end_replay(sweep, false);
    } else if (sweep->is_check) {
        code = ledger_file_renew_replay(file, sweep->round_id, sweep->made, judge->size);
        end_replay(sweep, code == SQLITE_OK);
    } else if (replay_finish(&sweep->writer, hash_without_pin(&judge->core, core_hash)) != 0 ||
               replay_verifier_open(judge, sweep->made,
                                    (size_t)sweep->writer.offset + REPLAY_END_SIZE) != 0) {
        end_replay(sweep, false);
    } else {
        sweep->is_check = true;
        sweep->stage = PIN_SWEEP_READ;
    }
    return code;
}

static int play_on(struct pin_sweep *sweep, struct ledger_file *file)
{
    if (!replay_verifier_tick(&sweep->judge)) {
        return end_play(sweep, file);
    }
    if (!sweep->is_check && session_recorder_types_pin(&sweep->judge.core)) {
        end_replay(sweep, false);
    } else if (!sweep->is_check) {
        struct core *core = &sweep->judge.core;
        struct replay_writer *writer = &sweep->writer;
        struct replay_totals totals = sweep->judge.replayer.totals;
        uint32_t digest = 0;
        if (replay_wants_hash(writer)) {
            totals.hash = hash_without_pin(core, core_hash);
        }
        if (replay_wants_digest(writer)) {
            digest = (uint32_t)hash_without_pin(core, core_hash_quick);
        }
        replay_add(writer, &sweep->judge.input, digest, &totals);
    }
    return SQLITE_OK;
}

static int do_step(void *self, struct ledger_file *file)
{
    struct pin_sweep *sweep = self;
    CORE_ASSERT(sweep->stage <= PIN_SWEEP_DONE);
    switch ((enum pin_sweep_stage)sweep->stage) {
    case PIN_SWEEP_SEEK:
        seek(sweep, file);
        return SQLITE_OK;
    case PIN_SWEEP_READ: {
        struct core_config *config = &sweep->judge.replayer.reader.header.config;
        const int more = replay_verifier_read(&sweep->judge);
        int error = more < 0;
        if (more == 0 && !sweep->is_check) {
            session_recorder_withhold_pin(config, NULL);
            error = replay_create_in(&sweep->writer, sweep->made, sizeof sweep->made, config,
                                     hash_without_pin(&sweep->judge.core, core_hash));
        }
        if (error) {
            end_replay(sweep, false);
        } else if (more == 0) {
            sweep->stage = PIN_SWEEP_PLAY;
        }
        return SQLITE_OK;
    }
    case PIN_SWEEP_PLAY:
        return play_on(sweep, file);
    default:
        return SQLITE_DONE;
    }
}

struct storage_chore pin_sweep_chore(struct pin_sweep *sweep)
{
    return (struct storage_chore){ .step = do_step, .self = sweep };
}
