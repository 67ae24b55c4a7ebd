/* ranking.c -- computes the leaderboards from ledger entries. */
#include "core/game/ranking/ranking.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"

#define WEEK_DAYS 7u

/* Returns the number of the week that contains `day`. Weeks begin on Monday; day 0, 2000-01-01, was
 * a Saturday. */
static uint16_t week_of(uint16_t day)
{
    return (uint16_t)((day + 5u) / WEEK_DAYS);
}

static void clear(struct ranking *ranking, enum rank_period period)
{
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        memset(ranking->row[mode][period], 0, sizeof ranking->row[mode][period]);
    }
}

static void begin_week(struct ranking *ranking, const struct ledger_entry *entry, uint16_t week)
{
    clear(ranking, RANK_WEEK);
    ranking->week = week;
    ranking->week_boot = entry->boot;
}

/* Starts new days and weeks at kiosk starts, for entries without a date. Only a round starts a new
 * day. The clock of a board without a battery may be set a minute after the start, before any
 * round. */
static void turn_by_boots(struct ranking *ranking, const struct ledger_entry *entry)
{
    if (entry->kind != LEDGER_ROUND || entry->boot == ranking->boot) {
        return;
    }
    clear(ranking, RANK_DAY);
    ranking->day = 0;
    ranking->boot = entry->boot;
    if (entry->boot - ranking->week_boot >= WEEK_DAYS) {
        begin_week(ranking, entry, 0);
    }
}

/* Starts new days and weeks by date. A date one day back means that the clock was set around
 * midnight, and starts no new day. Any other date starts a new day. Otherwise one wrong date would
 * block the leaderboard for years. Rounds that were played before the clock was set belong to the
 * day that the clock then shows. */
static void turn_by_clock(struct ranking *ranking, const struct ledger_entry *entry)
{
    const int is_first = ranking->day == 0 && entry->boot == ranking->boot;
    const int is_same = entry->day == ranking->day || entry->day + 1u == ranking->day;
    const uint16_t week = week_of(is_same ? ranking->day : entry->day);
    if (!is_same && !is_first) {
        clear(ranking, RANK_DAY);
    }
    if (ranking->week == 0 && entry->boot - ranking->week_boot < WEEK_DAYS) {
        ranking->week = week; /* The current week began without a clock. */
    } else if (week != ranking->week) {
        begin_week(ranking, entry, week);
    }
    ranking->day = is_same ? ranking->day : entry->day;
    ranking->boot = entry->boot;
}

static void turn_days(struct ranking *ranking, const struct ledger_entry *entry)
{
    if (entry->day == 0) {
        turn_by_boots(ranking, entry);
    } else {
        turn_by_clock(ranking, entry);
    }
}

static void insert(struct rank_row rows[RANK_ROWS], const struct rank_row *row)
{
    uint32_t place = RANK_ROWS;
    while (place > 0 && rows[place - 1u].caught < row->caught) {
        place--;
    }
    if (place < RANK_ROWS) {
        for (uint32_t i = RANK_ROWS - 1u; i > place; i--) {
            rows[i] = rows[i - 1u];
        }
        rows[place] = *row;
    }
}

static void note_round(struct ranking *ranking, const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    CORE_ASSERT(round->mode < MODE_COUNT);
    for (uint8_t seat = 0; seat < POI_MAX; seat++) {
        const struct rank_row row = { .caught = round->player[seat].caught,
                                      .round_id = entry->id,
                                      .day = entry->day,
                                      .seat = seat };
        if ((round->players & 1u << seat) && row.caught > 0) {
            for (uint32_t period = 0; period < RANK_PERIOD_COUNT; period++) {
                insert(ranking->row[round->mode][period], &row);
            }
        }
    }
}

static struct rank_row *rows_of(struct ranking *ranking, uint32_t index)
{
    return ranking->row[index / RANK_PERIOD_COUNT][index % RANK_PERIOD_COUNT];
}

static void note_name(struct ranking *ranking, const struct ledger_entry *entry)
{
    for (uint32_t i = 0; i < MODE_COUNT * RANK_PERIOD_COUNT; i++) {
        struct rank_row *rows = rows_of(ranking, i);
        for (uint32_t k = 0; k < RANK_ROWS; k++) {
            if (rows[k].round_id == entry->count && rows[k].seat == entry->detail) {
                memcpy(rows[k].name, entry->name, sizeof rows[k].name);
            }
        }
    }
}

void ranking_note(struct ranking *ranking, const struct ledger_entry *entry)
{
    turn_days(ranking, entry);
    if (entry->kind == LEDGER_ROUND && !entry->round.by_bot && !entry->round.unscored) {
        note_round(ranking, entry);
    } else if (entry->kind == LEDGER_NAME) {
        note_name(ranking, entry);
    }
}

uint32_t ranking_place(const struct ranking *ranking, uint8_t mode, enum rank_period period,
                       uint32_t round_id, uint8_t seat)
{
    CORE_ASSERT(mode < MODE_COUNT && period < RANK_PERIOD_COUNT);
    const struct rank_row *rows = ranking->row[mode][period];
    uint32_t place = 0;
    while (place < RANK_ROWS && (rows[place].caught == 0 || rows[place].round_id != round_id ||
                                 rows[place].seat != seat)) {
        place++;
    }
    return place;
}

uint64_t ranking_hash(uint64_t hash, const struct ranking *ranking)
{
    const uint32_t words[] = { ranking->boot, ranking->day, ranking->week, ranking->week_boot };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        for (uint32_t i = 0; i < RANK_PERIOD_COUNT * RANK_ROWS; i++) {
            const struct rank_row *row = &ranking->row[mode][i / RANK_ROWS][i % RANK_ROWS];
            hash = hash_u32(hash_u32(hash, row->caught), row->round_id);
            hash = hash_u32(hash, (uint32_t)row->day << 8 | row->seat);
            for (uint32_t k = 0; k < LEDGER_NAME_SIZE; k++) {
                hash = hash_u32(hash, (uint8_t)row->name[k]);
            }
        }
    }
    return hash;
}
