/* judge.c -- runs the core with the recorded inputs and compares the results. */
#include "platform/kiosk/judge.h"

#include <stdio.h>
#include <string.h>

#include "platform/cpu.h"

static int no_such_stall(struct judge *judge)
{
    struct replay_problem *problem = &judge->replayer.reader.problem;
    *problem = (struct replay_problem){ .offset = REPLAY_HEADER_SIZE };
    snprintf(problem->text, sizeof problem->text, "this program has no such stall");
    judge->is_damaged = 1;
    return -1;
}

int judge_open(struct judge *judge, const uint8_t *bytes, size_t size)
{
    struct core_config config;
    judge->round = (struct ledger_entry){ 0 };
    judge->said = (struct replay_totals){ 0 };
    judge->round_tick = 0;
    judge->is_read = judge->is_refused = 0;
    judge->bytes = bytes;
    judge->size = size;
    memset(&judge->output, 0, sizeof judge->output);
    cpu_set_float();
    judge->is_damaged = replayer_begin_in(&judge->replayer, bytes, size, &config) != 0;
    return judge->is_damaged ? -1 : 0;
}

/* Creates the initial state of the replay. */
static int make_stall(struct judge *judge)
{
    struct core_config config;
    if (replayer_begin_in(&judge->replayer, judge->bytes, judge->size, &config)) {
        judge->is_damaged = 1;
        return -1;
    }
    config.lanes = cpu_lanes();
    judge->input = (struct input){ 0 };
    const enum core_error error = core_init(&judge->core, &config);
    judge->is_refused = error == CORE_ERR_FLOAT;
    if (error != CORE_OK) {
        return judge->is_refused ? -1 : no_such_stall(judge);
    }
    judge->seen_id = judge->core.game.ledger.last_id;
    judge->is_read = 1;
    return 0;
}

int judge_read(struct judge *judge)
{
    struct replay_reader *reader = &judge->replayer.reader;
    int more = judge->is_damaged ? -1 : 1;
    for (uint32_t tick = 0; more == 1 && tick < REPLAY_CHUNK_TICKS; tick++) {
        more = replay_next(reader, &judge->input);
        if (more == 1 && reader->totals.rounds != judge->said.rounds) {
            judge->said.rounds = reader->totals.rounds;
            judge->round_tick = reader->tick;
        }
    }
    if (more == 0) {
        judge->said = reader->totals;
        replay_close(reader);
        return make_stall(judge);
    }
    judge->is_damaged = more < 0;
    return more;
}

int judge_begin(struct judge *judge, const uint8_t *bytes, size_t size)
{
    int more = judge_open(judge, bytes, size) ? -1 : 1;
    while (more == 1) {
        more = judge_read(judge);
    }
    return more;
}

static void note_entries(struct judge *judge)
{
    while (judge->seen_id != judge->core.game.ledger.last_id) {
        const struct ledger_entry *entry = &judge->output.entries[++judge->seen_id % LEDGER_RING];
        if (entry->id == judge->seen_id && entry->kind == LEDGER_ROUND) {
            judge->round = *entry;
        }
    }
}

int judge_tick(struct judge *judge)
{
    struct replayer *replayer = &judge->replayer;
    const struct kiosk_source source = replayer_source(replayer);
    const struct kiosk_tap tap = replayer_tap(replayer);
    if (judge->is_damaged || judge->is_refused || !judge->is_read ||
        replayer->difference.found || !source.next(source.self, &judge->input)) {
        return 0;
    }
    judge->output.sound_count = 0;
    judge->is_refused =
        core_tick(&judge->core, &judge->input, &judge->output) == CORE_ERR_FLOAT;
    if (judge->is_refused) {
        return 0;
    }
    tap.tick(tap.self, &judge->input, &judge->core);
    note_entries(judge);
    return 1;
}

int judge_is_at_round(const struct judge *judge)
{
    return judge->replayer.totals.ticks >= judge->round_tick;
}

/* Compares a row of the ranking. Returns 1 if it equals the game, -1 if it differs, 0 if it is of
 * another round. */
static int look_at_row(const struct judge *judge, const struct rank_row *row, uint8_t mode,
                       uint32_t round_id)
{
    const struct round_record *round = &judge->round.round;
    if (row->caught == 0 || row->round_id != round_id) {
        return 0;
    }
    return row->seat < POI_MAX && round->mode == mode && (round->players & 1u << row->seat) &&
                   round->player[row->seat].caught == row->caught
               ? 1
               : -1;
}

static int agrees_with(const struct judge *judge, const struct ranking *ranking, uint32_t round_id)
{
    uint32_t found = 0;
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        for (uint32_t i = 0; i < RANK_PERIOD_COUNT * RANK_ROWS; i++) {
            const struct rank_row *row = &ranking->row[mode][i / RANK_ROWS][i % RANK_ROWS];
            const int says = look_at_row(judge, row, mode, round_id);
            if (says < 0) {
                return 0;
            }
            found += (uint32_t)says;
        }
    }
    return found > 0;
}

static int same_players(const struct round_record *a, const struct round_record *b)
{
    int same = 1;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player_record *one = &a->player[i], *other = &b->player[i];
        same &= one->caught == other->caught && one->scoops == other->scoops &&
                one->hole_area_mm2 == other->hole_area_mm2 &&
                one->torn_tick == other->torn_tick && one->sheets == other->sheets &&
                one->fouls == other->fouls;
    }
    return same;
}

/* Compares the tank of two rounds. Older versions did not store the tank; such a round is
 * accepted. */
static int same_stall(const struct round_record *a, const struct round_record *kept)
{
    return kept->fish_count == 0 || (a->fish_count == kept->fish_count &&
                                     a->round_s == kept->round_s && a->preset == kept->preset);
}

/* Compares the game's entry with the ledger's: boot, tank, ticks and papers. */
static int is_entry(const struct ledger_entry *played, const struct ledger_entry *kept)
{
    const struct round_record *a = &played->round, *b = &kept->round;
    return kept->kind == LEDGER_ROUND && played->id == kept->id && played->boot == kept->boot &&
           played->tick == kept->tick && played->value == kept->value && a->seed == b->seed &&
           a->start_tick == b->start_tick && a->end_tick == b->end_tick &&
           a->caught == b->caught && a->by_bot == b->by_bot && a->mode == b->mode &&
           a->grade == b->grade && a->players == b->players && a->unscored == b->unscored &&
           same_players(a, b) && same_stall(a, b);
}

enum verdict judge_say(const struct judge *judge, const struct ranking *ranking, uint32_t round_id,
                       const struct ledger_entry *kept)
{
    const struct replayer *replayer = &judge->replayer;
    if (judge->is_refused) {
        return VERDICT_UNCHECKED;
    }
    if (judge->is_damaged || !judge->is_read || replayer->damaged) {
        return VERDICT_DAMAGED;
    }
    if (replayer->difference.found || replayer->totals.ticks != judge->said.ticks ||
        judge->round.id != round_id || judge->round.round.by_bot ||
        judge->round.round.unscored || !agrees_with(judge, ranking, round_id) ||
        (kept->id != 0 && !is_entry(&judge->round, kept))) {
        return VERDICT_OTHER;
    }
    return VERDICT_GENUINE;
}
