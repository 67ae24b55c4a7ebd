/* ledger_writer.c -- writes entries to the ledger's ring buffer, tracks which entries are on disk,
 * and checks the ranges of each kind of stored record. */
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/session_state.h"
#include "core/persistent_state.h"
#include "core/tank/preset.h"

void ledger_init(struct ledger *ledger, const struct ledger_start *start)
{
    CORE_ASSERT(start->last_id <= LEDGER_ID_MAX);
    CORE_ASSERT(start->boots <= LEDGER_BOOTS_MAX);
    *ledger = (struct ledger){
        .last_id = start->last_id,
        .saved_id = start->last_id,
        .boot = start->boots,
        .balance = start->balance,
        .committed = start->balance,
    };
}

static uint32_t unsaved_entry_count(const struct ledger *ledger)
{
    CORE_ASSERT(ledger->saved_id <= ledger->last_id);
    return ledger->last_id - ledger->saved_id;
}

/* Returns true if the kiosk started without a store and has had no store since. In recordings of
 * formats before 9, `store_came_late` is always 0. */
static bool has_no_store(const struct ledger *ledger)
{
    return ledger->boot == 0 && !ledger->store_came_late;
}

/* Reads from `input` which entries are on disk. Entries written without a store are lost. If a
 * store becomes available after the start, the function therefore stops waiting for the lost
 * entries, but only once: later entries are kept in the ring buffer while the store is not healthy.
 * In recordings of formats before 9 the function does this each time the store becomes healthy.
 * health_log.c then logs the current balance, which becomes `committed` when that entry is on disk.
 * If `input` reports an older saved id, the report is ignored, because saved entries stay saved.
 *
 * If the store has read entries that may not be on disk, it is not healthy and `input` reports the
 * saved id 0. No credit or ticket then counts as saved until health_log.c has logged the balance in
 * the same way. */
void ledger_tick(struct ledger *ledger, const struct core_config *config, const struct input *input)
{
    const bool is_well = input->store_well != 0;
    if (has_no_store(ledger) && is_well && !ledger->is_healthy) {
        ledger->saved_id = ledger->last_id;
        ledger->wait_ticks = 0;
        ledger->store_came_late = config_has_rules(config, 9);
    }
    ledger->is_healthy = (uint8_t)is_well;
    if (config_has_rules(config, 10) && !has_no_store(ledger) && !is_well &&
        input->record_saved_id == 0 && ledger->saved_id > 0) {
        ledger->committed = (struct balance){ 0 };
    }
    const uint32_t ahead = input->record_saved_id - ledger->saved_id;
    if (ahead != 0 && ahead <= unsaved_entry_count(ledger)) {
        ledger->saved_id = input->record_saved_id;
        ledger->wait_ticks = 0;
        if (unsaved_entry_count(ledger) < LEDGER_RING) {
            ledger->committed = ledger->after[ledger->saved_id % LEDGER_RING];
        }
    }
    if (ledger_is_flushed(ledger)) {
        ledger->wait_ticks = 0;
    } else if (ledger->wait_ticks <= LEDGER_WAIT_TICKS_MAX) {
        ledger->wait_ticks++;
    }
    ledger->day = input->day;
    ledger->minute = input->minute;
}

bool ledger_has_room(const struct ledger *ledger, uint8_t kind)
{
    const bool is_of_a_round = kind == LEDGER_BEGIN || kind == LEDGER_ROUND ||
                               kind == LEDGER_REFUND || kind == LEDGER_LEFT;
    CORE_ASSERT(kind < LEDGER_KIND_COUNT);
    return ledger->last_id < LEDGER_ID_MAX &&
           unsaved_entry_count(ledger) < LEDGER_RING - (is_of_a_round ? 0u : LEDGER_RESERVE);
}

/* Returns true if the ledger has room for the entry, or if the kiosk has had no store since its
 * start. Without a store no entry ever reaches a disk, so the oldest entry may be overwritten. */
bool ledger_may_write(const struct ledger *ledger, uint8_t kind)
{
    return ledger_has_room(ledger, kind) ||
           (ledger->last_id < LEDGER_ID_MAX && has_no_store(ledger) && !ledger->is_healthy);
}

uint32_t ledger_write(struct accounts *accounts, uint32_t tick, const struct ledger_entry *what,
                      struct output *output)
{
    CORE_ASSERT(what->kind > LEDGER_NOTHING && what->kind < LEDGER_KIND_COUNT);
    struct ledger *ledger = &accounts->ledger;
    if (!ledger_may_write(ledger, what->kind)) {
        ledger->uncommitted++;
        return 0;
    }
    struct ledger_entry entry = *what;
    entry.id = ++ledger->last_id;
    entry.boot = ledger->boot;
    entry.tick = tick;
    entry.day = ledger->day;
    entry.minute = ledger->minute;
    entry.balance = ledger->balance;
    ledger->after[entry.id % LEDGER_RING] = ledger->balance;
    output->entries[entry.id % LEDGER_RING] = entry;
    output->entry_id = entry.id;
    audits_note(&accounts->audits, &entry);
    ranking_note(&accounts->ranking, &entry);
    return entry.id;
}

bool ledger_is_saved(const struct ledger *ledger, uint32_t id)
{
    return id <= ledger->saved_id;
}

bool ledger_is_flushed(const struct ledger *ledger)
{
    return unsaved_entry_count(ledger) == 0 || has_no_store(ledger);
}

bool ledger_is_safe(const struct ledger *ledger)
{
    return ledger->is_healthy && ledger->wait_ticks <= LEDGER_WAIT_TICKS_MAX &&
           ledger_has_room(ledger, LEDGER_COINS);
}

_Static_assert(sizeof(struct balance) == 24u, "balances without padding can be compared as bytes");

bool ledger_needs_sync(const struct ledger *ledger)
{
    return ledger->is_healthy && unsaved_entry_count(ledger) == 0 &&
           memcmp(&ledger->balance, &ledger->committed, sizeof ledger->balance) != 0;
}

/* Returns how many of the `sure` credits on disk are left after the number of all credits changed
 * from `before` to `after`. A decrease lowers the result by the same number. An increase has no
 * effect, because new credits are not on disk yet. */
static uint32_t less_spent(uint32_t sure, uint32_t before, uint32_t after)
{
    const uint32_t spent = before > after ? before - after : 0u;
    return sure > spent ? sure - spent : 0u;
}

struct ledger_credits ledger_committed_credits(const struct ledger *ledger)
{
    struct ledger_credits sure = { ledger->committed.paid, ledger->committed.service };
    struct balance before = ledger->committed;
    const uint32_t count = unsaved_entry_count(ledger);
    if (count > LEDGER_RING) {
        /* Without a store, no entry is saved, so no credit is on disk. */
        return (struct ledger_credits){ 0 };
    }
    for (uint32_t i = 1; i <= count; i++) {
        const struct balance *after = &ledger->after[(ledger->saved_id + i) % LEDGER_RING];
        sure.paid = less_spent(sure.paid, before.paid, after->paid);
        sure.service = less_spent(sure.service, before.service, after->service);
        before = *after;
    }
    return sure;
}

/* ---- Validation of stored records ------------------------------------------------------------ */

#define DAY_MINUTES (24u * 60u)
/* Largest valid count in a stored balance. Refunds are added without a limit, so a count may exceed
 * BALANCE_MAX. */
#define BALANCE_LIMIT (2u * BALANCE_MAX)

/* Returns true if `open`, the payment of an open round, is valid. The flag PAYMENT_SPENT is valid
 * only together with a kind of credit. */
static bool open_is_good(int32_t open)
{
    return open >= PAYMENT_NONE && open <= (int32_t)(PAYMENT_SERVICE | PAYMENT_SPENT) &&
           open != PAYMENT_SPENT;
}

static bool balance_is_good(const struct balance *balance)
{
    return balance->units <= BALANCE_LIMIT && balance->bonus_units <= BALANCE_LIMIT &&
           balance->paid <= BALANCE_LIMIT && balance->service <= BALANCE_LIMIT &&
           balance->unlogged <= BALANCE_LIMIT && open_is_good(balance->open) &&
           (balance->returned == PAYMENT_NONE || balance->returned == PAYMENT_PAID ||
            balance->returned == PAYMENT_SERVICE) &&
           balance->tickets <= BALANCE_TICKETS_MAX;
}

/* Returns true if the player's name ends within its field and contains no control character. */
static bool name_is_good(const char name[LEDGER_NAME_SIZE])
{
    uint32_t length = 0;
    while (length < LEDGER_NAME_SIZE && name[length] != '\0') {
        if ((uint8_t)name[length] < 0x20u || name[length] == 0x7f) {
            return false;
        }
        length++;
    }
    return length < LEDGER_NAME_SIZE;
}

/* Largest valid value of the member `detail` for each kind of entry. 0 means that every value is
 * valid. */
static const uint8_t detail_max[LEDGER_KIND_COUNT] = {
    [LEDGER_COINS] = COIN_LINE_COUNT - 1u,
    [LEDGER_TEST_COIN] = COIN_LINE_COUNT - 1u,
    [LEDGER_BEGIN] = CHOICE_COUNT - 1u,
    [LEDGER_REFUND] = REFUND_CAUSE_COUNT - 1u,
    [LEDGER_RESET] = AUDIT_GROUP_COUNT - 1u,
    [LEDGER_ROUND] = ROUND_CUT_OFF,
    [LEDGER_NAME] = POI_MAX - 1u,
    [LEDGER_LOSS] = POI_MAX - 1u,
    [LEDGER_PIN] = 1u,
};

/* Returns true if each member of `entry` is in its valid range. The value of most entry kinds must
 * be >= 0, because the audits add the value as an unsigned number. The grade of a round is 0 in
 * records of an earlier version. */
bool ledger_entry_is_valid(const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    const struct ledger_stand stand = { entry->count, entry->value, entry->detail };
    const bool value_is_good =
        entry->kind == LEDGER_SETTING || entry->kind == LEDGER_RESET ||
        (entry->value >= 0 && (entry->kind != LEDGER_REFUND || open_is_good(entry->value)));
    const bool round_is_good = round->mode < MODE_COUNT && round->grade <= SHEET_GRADE_MAX &&
                               round->players < 1u << POI_MAX && round->by_bot <= 1u &&
                               round->unscored <= 1u && round->level < LEVEL_COUNT &&
                               round->preset < TANK_PRESET_COUNT;
    return entry->id > 0 && entry->id <= LEDGER_ID_MAX && entry->boot <= LEDGER_BOOTS_MAX &&
           entry->minute < DAY_MINUTES && entry->kind > LEDGER_NOTHING &&
           entry->kind < LEDGER_KIND_COUNT &&
           (detail_max[entry->kind] == 0 || entry->detail <= detail_max[entry->kind]) &&
           value_is_good && balance_is_good(&entry->balance) && name_is_good(entry->name) &&
           (entry->kind != LEDGER_ROUND || round_is_good) &&
           (entry->kind != LEDGER_STAND || round_standing_is_good(&stand));
}

bool ledger_state_is_valid(const struct persistent_state *memory)
{
    const struct ledger_start *start = &memory->ledger;
    const struct rank_row *rows = &memory->ranking.row[0][0][0];
    bool is_good = start->last_id <= LEDGER_ID_MAX && start->boots <= LEDGER_BOOTS_MAX &&
                   balance_is_good(&start->balance) && round_standing_is_good(&start->stand);
    for (uint32_t i = 0; i < RANK_BOARD_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        is_good = is_good && rows[i].slot < POI_MAX && rows[i].round_id <= LEDGER_ID_MAX &&
                  name_is_good(rows[i].name);
    }
    return is_good;
}

bool ledger_session_is_valid(const struct game_session *session)
{
    const struct ledger *ledger = &session->ledger;
    bool is_good = ledger->last_id <= LEDGER_ID_MAX && ledger->saved_id <= ledger->last_id &&
                   ledger->boot <= LEDGER_BOOTS_MAX && ledger->minute < DAY_MINUTES &&
                   ledger->is_healthy <= 1u && ledger->store_came_late <= 1u &&
                   balance_is_good(&ledger->balance) && balance_is_good(&ledger->committed) &&
                   session->health_log.is_written <= 1u;
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        is_good = is_good && balance_is_good(&ledger->after[i]);
    }
    for (uint32_t i = 0; i < COIN_LINE_COUNT; i++) {
        const struct pending_coins *pending = &session->credit.pending_coins[i];
        is_good = is_good && pending->units <= BALANCE_LIMIT && pending->owed <= BALANCE_LIMIT;
    }
    return is_good;
}
