/* pin_sweep.c -- replays, verifies and replaces recordings that may contain a PIN; see
 * pin_sweep.h. */
#include "platform/kiosk/recorder/pin_sweep.h"

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/cpu.h"
#include "platform/os/log.h"

static void report(const struct pin_sweep *sweep)
{
    if (sweep->cleaned + sweep->deleted + sweep->left > 0) {
        log_print(LOG_LEVEL_WARNING,
                  "kept replays that may contain a PIN: %u were cleared of the PIN; %u were "
                  "deleted, because they could not be cleared; %u could not be examined and stay "
                  "until the next start (all scores stay)",
                  sweep->cleaned, sweep->deleted, sweep->left);
    }
}

/* Replaces the stored replay by the new recording, or deletes the stored replay if `size` is 0.
 * Returns an SQLite result code. */
static int settle(struct pin_sweep *sweep, struct ledger_file *file, size_t size)
{
    const int code =
        ledger_file_renew_replay(file, sweep->round_id, size > 0 ? sweep->made : NULL, size);
    sweep->cleaned += code == SQLITE_OK && size > 0;
    sweep->deleted += code == SQLITE_OK && size == 0;
    sweep->left += code != SQLITE_OK;
    sweep->stage = PIN_SWEEP_SEEK;
    return code;
}

/* Ends the examination of a replay from which the PIN cannot be removed, and deletes the replay. If
 * the core refused to run, the replay may be valid and stays until the next start. */
static int give_up(struct pin_sweep *sweep, struct ledger_file *file)
{
    if (sweep->verifier.is_refused) {
        sweep->left++;
        sweep->stage = PIN_SWEEP_SEEK;
        return SQLITE_OK;
    }
    return settle(sweep, file, 0);
}

/* Reads the next stored replay and selects the replay if it may contain a PIN. */
static int seek(struct pin_sweep *sweep, struct ledger_file *file)
{
    int code = ledger_file_next_replay(file, sweep->round_id, &sweep->round_id);
    if (code != SQLITE_OK) {
        sweep->left += code != SQLITE_NOTFOUND;
        sweep->stage = PIN_SWEEP_DONE;
        report(sweep);
        return SQLITE_OK;
    }
    code = ledger_file_get_replay(file, sweep->round_id, sweep->replay, sizeof sweep->replay,
                                  &sweep->size);
    const bool is_cut = code == SQLITE_TOOBIG;
    if (code != SQLITE_OK && !is_cut) {
        sweep->left++;
        return SQLITE_OK;
    }
    const size_t size = is_cut ? sizeof sweep->replay : sweep->size;
    const bool is_open = replay_verifier_open(&sweep->verifier, sweep->replay, size) == 0;
    const struct replay_reader *reader = &sweep->verifier.replayer.reader;
    if (reader->header.version > REPLAY_VERSION || !session_recorder_may_contain_pin(reader)) {
        return SQLITE_OK;
    }
    if (is_cut || !is_open) {
        return give_up(sweep, file);
    }
    ledger_file_round(file, sweep->round_id, &sweep->kept);
    sweep->is_check = false;
    sweep->stage = PIN_SWEEP_READ;
    return SQLITE_OK;
}

/* Starts the second core and the new recording from the recorded configuration without its PIN. The
 * verifier has already accepted this configuration. */
static int begin_recording(struct pin_sweep *sweep)
{
    struct core_config *config = &sweep->verifier.replayer.reader.header.config;
    session_recorder_withhold_pin(config);
    config->lanes = cpu_lanes();
    sweep->output = (struct output){ 0 };
    sweep->totals = (struct replay_totals){ 0 };
    sweep->tally = (struct recorder_tally){ 0 };
    const enum core_error error = core_init(&sweep->core, config);
    sweep->verifier.is_refused = error == CORE_ERR_FLOAT;
    return error != CORE_OK || replay_create_in(&sweep->writer, sweep->made, sizeof sweep->made,
                                                config, core_hash(&sweep->core)) != 0;
}

/* Parses one second of the recording. Starts the simulation after the last second. */
static int read_on(struct pin_sweep *sweep, struct ledger_file *file)
{
    const int more = replay_verifier_read(&sweep->verifier);
    if (more < 0 || (more == 0 && !sweep->is_check && begin_recording(sweep) != 0)) {
        return give_up(sweep, file);
    }
    sweep->stage = more == 0 ? PIN_SWEEP_PLAY : PIN_SWEEP_READ;
    return SQLITE_OK;
}

/* Handles the end of a simulation. The first simulation verifies the stored recording and creates
 * the new recording. The second simulation verifies the new recording, which must give the same
 * result. */
static int end_play(struct pin_sweep *sweep, struct ledger_file *file)
{
    struct replay_verifier *verifier = &sweep->verifier;
    const struct replayer *replayer = &verifier->replayer;
    const enum replay_verdict verdict = replay_verifier_result(
        verifier, &file->content.memory.ranking, sweep->round_id, &sweep->kept);
    if (verifier->is_refused || replayer->damaged || replayer->difference.found ||
        replayer->totals.ticks != verifier->recorded.ticks) {
        return give_up(sweep, file);
    }
    if (sweep->is_check) {
        return settle(sweep, file, verdict == sweep->verdict ? verifier->size : 0);
    }
    if (replay_finish(&sweep->writer, core_hash(&sweep->core)) != 0 ||
        replay_verifier_open(verifier, sweep->made,
                             (size_t)sweep->writer.offset + REPLAY_END_SIZE) != 0) {
        return give_up(sweep, file);
    }
    sweep->verdict = verdict;
    sweep->is_check = true;
    sweep->stage = PIN_SWEEP_READ;
    return SQLITE_OK;
}

static int play_on(struct pin_sweep *sweep, struct ledger_file *file)
{
    struct replay_verifier *verifier = &sweep->verifier;
    if (!replay_verifier_tick(verifier)) {
        return end_play(sweep, file);
    }
    if (sweep->is_check) {
        return SQLITE_OK;
    }
    if (core_status(&verifier->core).takes_pin) {
        return give_up(sweep, file);
    }
    sweep->output.sound_count = 0;
    verifier->is_refused = core_tick(&sweep->core, &verifier->input, &sweep->output) != CORE_OK;
    if (verifier->is_refused) {
        return give_up(sweep, file);
    }
    recorder_add_tick(&sweep->writer, &sweep->totals, &sweep->tally, &verifier->input,
                      &sweep->core);
    return SQLITE_OK;
}

static int do_step(void *self, struct ledger_file *file)
{
    struct pin_sweep *sweep = self;
    CORE_ASSERT(sweep->stage <= PIN_SWEEP_DONE);
    switch ((enum pin_sweep_stage)sweep->stage) {
    case PIN_SWEEP_SEEK:
        return seek(sweep, file);
    case PIN_SWEEP_READ:
        return read_on(sweep, file);
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
