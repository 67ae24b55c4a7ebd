/* session_recorder.c -- records sessions in memory and starts a new recording for each session; see
 * session_recorder.h. */
#include "platform/kiosk/recorder/session_recorder.h"

#include <poll.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/pin.h"

void session_recorder_withhold_pin(struct core_config *config)
{
    int32_t *kept = &config->persistent.settings.value[SET_PIN];
    int32_t *logged = &config->session.settings_edit.logged.value[SET_PIN];
    *logged = *logged == *kept ? (*kept != 0 ? PIN_WITHHELD : 0) : *kept == 0 ? PIN_WITHHELD : 0;
    *kept = *kept != 0 ? PIN_WITHHELD : 0;
}

static bool is_pin(int32_t value)
{
    return value != 0 && value != PIN_WITHHELD;
}

bool session_recorder_may_contain_pin(const struct replay_reader *reader)
{
    const struct core_config *config = &reader->header.config;
    const bool has_header = reader->offset >= REPLAY_HEADER_SIZE;
    const bool has_initial_state = reader->offset > REPLAY_HEADER_SIZE;
    return !has_header || reader->header.version <= 7u ||
           (has_initial_state && (is_pin(config->persistent.settings.value[SET_PIN]) ||
                                  is_pin(config->session.settings_edit.logged.value[SET_PIN])));
}

void session_recorder_begin(struct session_recorder *sessions, const struct core *core)
{
    CORE_ASSERT(core_is_fresh(core));
    memset(&sessions->totals, 0, sizeof sessions->totals);
    memset(&sessions->tally, 0, sizeof sessions->tally);
    sessions->totals.hash = core_hash(core);
    sessions->seen_id = core_status(core).entry_id;
    sessions->start = core->config;
    session_recorder_withhold_pin(&sessions->start);
    replay_create_in(&sessions->writer, sessions->memory, sizeof sessions->memory, &sessions->start,
                     sessions->totals.hash);
}

static bool is_ranked(const struct core *core, const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    uint32_t place = RANK_ROWS;
    if (entry->kind != LEDGER_ROUND || round->by_bot || round->unscored) {
        return false;
    }
    for (uint32_t i = 0; i < RANK_PERIOD_COUNT * POI_MAX && place == RANK_ROWS; i++) {
        place = ranking_place(core_ranking(core), ranking_board(round->mode, round->level),
                              (enum rank_period)(i / POI_MAX), entry->id, (uint8_t)(i % POI_MAX));
    }
    return place < RANK_ROWS;
}

static void keep_round(struct session_recorder *sessions, uint32_t round_id,
                       const struct core *core)
{
    CORE_ASSERT(round_id != 0);
    const bool has_ended_for_pin =
        !replay_is_open(&sessions->writer) && sessions->writer.error == 0;
    if (has_ended_for_pin) {
        return;
    }
    if (sessions->round_id != 0) {
        sessions->missed++;
        return;
    }
    sessions->replay_size =
        replay_copy(&sessions->writer, core_hash(core), sessions->replay, sizeof sessions->replay);
    sessions->round_id = sessions->replay_size > 0 ? round_id : 0;
    sessions->missed += sessions->replay_size == 0;
}

void session_recorder_before(struct session_recorder *sessions, const struct input *input)
{
    atomic_store(&sessions->is_busy, true);
    /* Another thread has panicked and reads the recording. Blocks this thread, which runs the
     * ticks, forever. */
    while (atomic_load(&sessions->is_frozen)) {
        atomic_store(&sessions->is_busy, false);
        pause();
    }
    sessions->begun = *input;
    atomic_store(&sessions->is_in_tick, true);
}

void session_recorder_tick(struct session_recorder *sessions, const struct input *input,
                           const struct core *core, const struct output *output)
{
    const struct core_status status = core_status(core);
    atomic_store(&sessions->is_in_tick, false);
    /* A new session has begun. Its initial configuration already includes the effect of the current
     * tick. */
    if (core_is_fresh(core)) {
        session_recorder_begin(sessions, core);
    } else {
        recorder_add_tick(&sessions->writer, &sessions->totals, &sessions->tally, input, core);
        if (status.takes_pin && replay_is_open(&sessions->writer)) {
            replay_finish(&sessions->writer, core_hash(core));
        }
    }
    while (sessions->seen_id != status.entry_id) {
        const struct ledger_entry *entry = &output->entries[++sessions->seen_id % LEDGER_RING];
        if (entry->id == sessions->seen_id && is_ranked(core, entry)) {
            keep_round(sessions, entry->id, core);
        }
    }
    atomic_store(&sessions->is_busy, false);
}

bool session_recorder_freeze(struct session_recorder *sessions, bool is_own)
{
    if (is_own) {
        return !atomic_load(&sessions->is_busy) || atomic_load(&sessions->is_in_tick);
    }
    atomic_store(&sessions->is_frozen, true);
    for (int i = 0; i < SESSION_RECORDER_FREEZE_MS && atomic_load(&sessions->is_busy); i++) {
        poll(NULL, 0, 1);
    }
    return !atomic_load(&sessions->is_busy);
}

bool session_recorder_has_begun(const struct session_recorder *sessions)
{
    return sessions->writer.offset > 0;
}

uint32_t session_recorder_end_tick(const struct session_recorder *sessions, uint32_t tick,
                                   bool is_sound)
{
    return is_sound && replay_is_open(&sessions->writer)
               ? tick
               : sessions->start.session.tick + sessions->writer.saved.ticks;
}

int session_recorder_dump(struct session_recorder *sessions, const struct core *core, bool is_sound,
                          int fd)
{
    uint64_t hash = sessions->totals.hash;
    if (is_sound && atomic_load(&sessions->is_in_tick)) {
        hash = sessions->totals.hash = REPLAY_HASH_NONE;
        sessions->totals.ticks++;
        replay_add(&sessions->writer, &sessions->begun, 0, &sessions->totals);
    } else if (is_sound) {
        hash = core_hash(core);
    }
    return replay_dump(&sessions->writer, sessions->memory, hash, !is_sound, fd);
}

/* The store drops replays of rounds that are not in its database. Therefore the replay is passed to
 * the store after its round is on disk. */
bool session_recorder_offer(struct session_recorder *sessions, const struct hal_storage *storage)
{
    CORE_ASSERT(storage->ledger.ops && storage->replays.ops);
    const struct hal_replay_store *store = &storage->replays;
    if (sessions->round_id == 0 ||
        storage->ledger.ops->committed_id(storage->ledger.self) < sessions->round_id) {
        return false;
    }
    if (sessions->is_lent) {
        const bool is_done = store->ops->stored_id(store->self) == sessions->round_id;
        sessions->round_id = is_done ? 0 : sessions->round_id;
        sessions->is_lent = !is_done;
        return false;
    }
    const int result =
        store->ops->store(store->self, sessions->round_id, sessions->replay, sessions->replay_size);
    if (result == HAL_OK) {
        sessions->is_lent = true;
    } else if (result != HAL_ERR_BUSY) {
        sessions->round_id = 0;
        sessions->missed += (uint32_t)hal_is_fault(result);
    }
    return hal_is_fault(result);
}
