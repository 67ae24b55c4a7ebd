/* judge.c -- the same inputs, the same core, and what comes of it. */
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

/* Reads all of what is open, to know how long it is and when its last round begins. */
static int scan(struct judge *judge)
{
    struct replay_reader *reader = &judge->replayer.reader;
    uint32_t rounds = 0;
    int more;
    judge->round_tick = 0;
    while ((more = replay_next(reader, &judge->input)) == 1) {
        if (reader->totals.rounds != rounds) {
            rounds = reader->totals.rounds;
            judge->round_tick = reader->tick;
        }
    }
    judge->said = reader->totals;
    replay_close(reader);
    return more;
}

int judge_begin(struct judge *judge, const uint8_t *bytes, size_t size)
{
    struct core_config config;
    struct replay_reader *reader = &judge->replayer.reader;
    judge->round = (struct ledger_entry){ 0 };
    judge->is_damaged = 0;
    memset(&judge->output, 0, sizeof judge->output);
    if (replay_open_in(reader, bytes, size) || scan(judge) ||
        replayer_begin_in(&judge->replayer, bytes, size, &config)) {
        judge->is_damaged = 1;
        return -1;
    }
    config.lanes = cpu_lanes();
    judge->input = (struct input){ 0 };
    if (core_init(&judge->core, &config) != CORE_OK) {
        return no_such_stall(judge);
    }
    judge->seen_id = judge->core.game.ledger.last_id;
    return 0;
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
    if (judge->is_damaged || replayer->difference.found ||
        !source.next(source.self, &judge->input)) {
        return 0;
    }
    judge->output.sound_count = 0;
    core_tick(&judge->core, &judge->input, &judge->output);
    tap.tick(tap.self, &judge->input, &judge->core);
    note_entries(judge);
    return 1;
}

int judge_is_at_round(const struct judge *judge)
{
    return judge->replayer.totals.ticks >= judge->round_tick;
}

/* 1: it says what was played; -1: it does not; 0: it is of another round. */
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

enum verdict judge_say(const struct judge *judge, const struct ranking *ranking, uint32_t round_id)
{
    const struct replayer *replayer = &judge->replayer;
    if (judge->is_damaged || replayer->damaged) {
        return VERDICT_DAMAGED;
    }
    if (replayer->difference.found || replayer->totals.ticks != judge->said.ticks ||
        judge->round.id != round_id || judge->round.round.by_bot ||
        judge->round.round.unscored || !agrees_with(judge, ranking, round_id)) {
        return VERDICT_OTHER;
    }
    return VERDICT_GENUINE;
}
