/* replay_verifier.c -- runs the core with the recorded inputs and compares the results; see
 * replay_verifier.h. */
#include "platform/kiosk/recorder/replay_verifier.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/cpu.h"

int replay_verifier_open(struct replay_verifier *verifier, const uint8_t *bytes, size_t size)
{
    CORE_ASSERT(bytes);
    struct core_config config;
    verifier->round = (struct ledger_entry){ 0 };
    verifier->recorded = (struct replay_totals){ 0 };
    verifier->round_tick = 0;
    verifier->is_read = verifier->is_refused = false;
    verifier->bytes = bytes;
    verifier->size = size;
    memset(&verifier->output, 0, sizeof verifier->output);
    cpu_set_float();
    verifier->is_damaged = replayer_begin_in(&verifier->replayer, bytes, size, &config) != 0;
    return verifier->is_damaged ? -1 : 0;
}

int replay_verifier_read(struct replay_verifier *verifier)
{
    struct replay_reader *reader = &verifier->replayer.reader;
    int more = verifier->is_damaged ? -1 : 1;
    for (uint32_t tick = 0; more == 1 && tick < REPLAY_CHUNK_TICKS; tick++) {
        more = replay_next(reader, &verifier->input);
        if (more == 1 && reader->totals.rounds != verifier->recorded.rounds) {
            verifier->recorded.rounds = reader->totals.rounds;
            verifier->round_tick = reader->tick;
        }
    }
    if (more == 0) {
        verifier->recorded = reader->totals;
        replay_close(reader);
        struct core_config config;
        if (replayer_begin_in(&verifier->replayer, verifier->bytes, verifier->size, &config)) {
            verifier->is_damaged = true;
            return -1;
        }
        config.lanes = cpu_lanes();
        verifier->input = (struct input){ 0 };
        const enum core_error error = core_init(&verifier->core, &config);
        verifier->is_refused = error == CORE_ERR_FLOAT;
        if (error != CORE_OK) {
            if (!verifier->is_refused) {
                reader->problem = (struct replay_problem){ .offset = REPLAY_HEADER_SIZE };
                snprintf(reader->problem.text, sizeof reader->problem.text,
                         "this version has no such tank or game mode");
                verifier->is_damaged = true;
            }
            return -1;
        }
        verifier->seen_id = core_status(&verifier->core).entry_id;
        verifier->is_read = true;
        return 0;
    }
    verifier->is_damaged = more < 0;
    return more;
}

int replay_verifier_begin(struct replay_verifier *verifier, const uint8_t *bytes, size_t size)
{
    int more = replay_verifier_open(verifier, bytes, size) ? -1 : 1;
    while (more == 1) {
        more = replay_verifier_read(verifier);
    }
    return more;
}

bool replay_verifier_tick(struct replay_verifier *verifier)
{
    struct replayer *replayer = &verifier->replayer;
    const struct kiosk_source source = replayer_source(replayer);
    const struct kiosk_tap tap = replayer_tap(replayer);
    if (verifier->is_damaged || verifier->is_refused || !verifier->is_read ||
        replayer->difference.found || !source.next(source.self, &verifier->input)) {
        return false;
    }
    verifier->output.sound_count = 0;
    verifier->is_refused =
        core_tick(&verifier->core, &verifier->input, &verifier->output) == CORE_ERR_FLOAT;
    if (verifier->is_refused) {
        return false;
    }
    tap.tick(tap.self, &verifier->input, &verifier->core);
    const uint32_t entry_id = core_status(&verifier->core).entry_id;
    while (verifier->seen_id != entry_id) {
        const struct ledger_entry *entry =
            &verifier->output.entries[++verifier->seen_id % LEDGER_RING];
        if (entry->id == verifier->seen_id && entry->kind == LEDGER_ROUND) {
            verifier->round = *entry;
        }
    }
    return true;
}

bool replay_verifier_is_at_round(const struct replay_verifier *verifier)
{
    return verifier->replayer.totals.ticks >= verifier->round_tick;
}

/* Returns true if at least one row of the ranking has the id `round_id`, and every row with this id
 * equals the simulated round. */
static bool ranking_matches(const struct replay_verifier *verifier, const struct ranking *ranking,
                            uint32_t round_id)
{
    const struct round_record *round = &verifier->round.round;
    const struct rank_row *rows = &ranking->row[0][0][0];
    const uint32_t board = ranking_board(round->mode, round->level);
    bool is_found = false;
    for (uint32_t i = 0; i < RANK_BOARD_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        const struct rank_row *row = &rows[i];
        if (row->caught == 0 || row->round_id != round_id) {
            continue;
        }
        if (row->slot >= POI_MAX || board != i / (RANK_PERIOD_COUNT * RANK_ROWS) ||
            !(round->players & 1u << row->slot) || round->player[row->slot].caught != row->caught) {
            return false;
        }
        is_found = true;
    }
    return is_found;
}

static bool same_players(const struct round_record *a, const struct round_record *b)
{
    bool same = true;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player_record *one = &a->player[i], *other = &b->player[i];
        same &= one->caught == other->caught && one->scoops == other->scoops &&
                one->hole_area_mm2 == other->hole_area_mm2 && one->torn_tick == other->torn_tick &&
                one->sheets == other->sheets && one->fouls == other->fouls;
    }
    return same;
}

/* Returns true if the simulated round's entry equals the ledger's entry `kept`. */
static bool is_entry(const struct ledger_entry *played, const struct ledger_entry *kept)
{
    const struct round_record *a = &played->round, *b = &kept->round;
    /* Older versions of Kingyo did not store tank data. A round without tank data is accepted. */
    return kept->kind == LEDGER_ROUND && played->id == kept->id && played->boot == kept->boot &&
           played->tick == kept->tick && played->value == kept->value && a->seed == b->seed &&
           a->start_tick == b->start_tick && a->end_tick == b->end_tick && a->caught == b->caught &&
           a->by_bot == b->by_bot && a->mode == b->mode && a->grade == b->grade &&
           a->players == b->players && a->unscored == b->unscored && a->level == b->level &&
           same_players(a, b) &&
           (b->fish_count == 0 ||
            (a->fish_count == b->fish_count && a->round_s == b->round_s && a->preset == b->preset));
}

enum replay_verdict replay_verifier_result(const struct replay_verifier *verifier,
                                           const struct ranking *ranking, uint32_t round_id,
                                           const struct ledger_entry *kept)
{
    const struct replayer *replayer = &verifier->replayer;
    if (verifier->is_refused) {
        return REPLAY_VERDICT_UNCHECKED;
    }
    if (verifier->is_damaged || !verifier->is_read || replayer->damaged) {
        return REPLAY_VERDICT_DAMAGED;
    }
    if (replayer->difference.found || replayer->totals.ticks != verifier->recorded.ticks ||
        verifier->round.id != round_id || verifier->round.round.by_bot ||
        verifier->round.round.unscored || !ranking_matches(verifier, ranking, round_id) ||
        (kept->id != 0 && !is_entry(&verifier->round, kept))) {
        return REPLAY_VERDICT_OTHER;
    }
    return REPLAY_VERDICT_GENUINE;
}
