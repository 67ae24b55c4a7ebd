/* ranking.c -- computes the leaderboards from ledger entries. */
#include "core/game/ranking/ranking.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

#define WEEK_DAYS 7u

static const struct rank_board boards[RANK_BOARD_COUNT] = {
    [MODE_FESTIVAL] = { MODE_FESTIVAL, LEVEL_MASTER },
    [MODE_CHAMPIONSHIP] = { MODE_CHAMPIONSHIP, LEVEL_MASTER },
    [MODE_PRACTICE] = { MODE_PRACTICE, LEVEL_MASTER },
    { MODE_FESTIVAL, LEVEL_NORMAL },
    { MODE_FESTIVAL, LEVEL_EASY },
};

struct rank_board ranking_board_at(uint32_t board)
{
    CORE_ASSERT(board < RANK_BOARD_COUNT);
    return boards[board];
}

uint32_t ranking_board(uint8_t mode, uint8_t level)
{
    CORE_ASSERT(mode < MODE_COUNT);
    uint32_t board = RANK_BOARD_COUNT - 1u;
    while (board >= MODE_COUNT && (boards[board].mode != mode || boards[board].level != level)) {
        board--;
    }
    return board >= MODE_COUNT ? board : mode;
}

static void clear_ranking_period(struct ranking *ranking, enum rank_period period)
{
    CORE_ASSERT(period < RANK_EVER);
    for (uint32_t board = 0; board < RANK_BOARD_COUNT; board++) {
        memset(ranking->row[board][period], 0, sizeof ranking->row[board][period]);
    }
}

static void begin_week(struct ranking *ranking, const struct ledger_entry *entry, uint16_t week)
{
    CORE_ASSERT(week == 0 || entry->day > 0);
    clear_ranking_period(ranking, RANK_WEEK);
    ranking->week = week;
    ranking->week_boot = entry->boot;
}

/* Starts a new day or week of the leaderboards if `entry` belongs to a new day. Entries with a date
 * are compared by date, and entries without a date by the boot counter (number of kiosk starts).
 * Without a date only a round starts a new day. The clock of a board without a battery may be set a
 * minute after the start, before any round. A date one day back means that the clock was set around
 * midnight, and starts no new day. Any other date starts a new day. Otherwise one wrong date would
 * block the leaderboard for years. Rounds that were played before the clock was set belong to the
 * day that the clock then shows. */
static void turn_days(struct ranking *ranking, const struct ledger_entry *entry)
{
    const bool is_first = ranking->day == 0 && entry->boot == ranking->boot;
    const bool is_same = entry->day == ranking->day || entry->day + 1u == ranking->day;
    const uint32_t week_boots = entry->boot - ranking->week_boot;
    if (entry->day == 0) {
        if (entry->kind == LEDGER_ROUND && entry->boot != ranking->boot) {
            clear_ranking_period(ranking, RANK_DAY);
            ranking->day = 0;
            ranking->boot = entry->boot;
            if (week_boots >= WEEK_DAYS) {
                begin_week(ranking, entry, 0);
            }
        }
        return;
    }
    if (!is_same && !is_first) {
        clear_ranking_period(ranking, RANK_DAY);
    }
    /* Weeks begin on Monday; day 0, 2000-01-01, was a Saturday. */
    const uint16_t week = (uint16_t)(((is_same ? ranking->day : entry->day) + 5u) / WEEK_DAYS);
    if (ranking->week == 0 && week_boots < WEEK_DAYS) {
        /* The current week began without a clock, so its number was unknown until now. */
        ranking->week = week;
    } else if (week != ranking->week) {
        begin_week(ranking, entry, week);
    }
    ranking->day = is_same ? ranking->day : entry->day;
    ranking->boot = entry->boot;
}

static void note_round(struct ranking *ranking, const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    const uint32_t board = ranking_board(round->mode, round->level);
    for (uint32_t k = 0; k < POI_MAX * RANK_PERIOD_COUNT; k++) {
        const uint32_t slot = k / RANK_PERIOD_COUNT;
        struct rank_row *rows = ranking->row[board][k % RANK_PERIOD_COUNT];
        const uint32_t caught = round->player[slot].caught;
        if (!(round->players & 1u << slot) || caught <= rows[RANK_ROWS - 1u].caught) {
            continue;
        }
        uint32_t place = RANK_ROWS - 1u;
        for (; place > 0 && rows[place - 1u].caught < caught; place--) {
            rows[place] = rows[place - 1u];
        }
        rows[place] = (struct rank_row){
            .caught = caught, .round_id = entry->id, .day = entry->day, .slot = (uint8_t)slot
        };
    }
}

void ranking_note(struct ranking *ranking, const struct ledger_entry *entry)
{
    turn_days(ranking, entry);
    if (entry->kind == LEDGER_ROUND && !entry->round.by_bot && !entry->round.unscored) {
        note_round(ranking, entry);
    } else if (entry->kind == LEDGER_NAME) {
        struct rank_row *rows = &ranking->row[0][0][0];
        for (uint32_t i = 0; i < RANK_BOARD_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
            if (rows[i].round_id == entry->count && rows[i].slot == entry->detail) {
                memcpy(rows[i].name, entry->name, sizeof rows[i].name);
            }
        }
    }
}

uint32_t ranking_place(const struct ranking *ranking, uint32_t board, enum rank_period period,
                       uint32_t round_id, uint8_t slot)
{
    CORE_ASSERT(slot < POI_MAX);
    CORE_ASSERT(board < RANK_BOARD_COUNT && period < RANK_PERIOD_COUNT);
    const struct rank_row *rows = ranking->row[board][period];
    uint32_t place = 0;
    while (place < RANK_ROWS && (rows[place].caught == 0 || rows[place].round_id != round_id ||
                                 rows[place].slot != slot)) {
        place++;
    }
    return place;
}
