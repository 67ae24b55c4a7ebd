/* ledger_range.c -- checks the ranges of each kind of ledger record. */
#include "core/game/accounting/ledger_writer.h"

#include "core/base/panic.h"
#include "core/game/accounting/audits.h"
#include "core/game/session_state.h"
#include "core/persistent_state.h"
#include "core/poi/paper/sheet.h"
#include "core/tank/preset.h"

#define DAY_MINUTES (24u * 60u)
/* Largest valid count in a stored balance. Refunds are added without a limit, so a count may exceed
 * BALANCE_MAX. */
#define PURSE_LIMIT (2u * BALANCE_MAX)

/* Returns 1 if `open` is valid, otherwise 0. The flag PAYMENT_SPENT is valid only together with a
 * kind of credit. */
static int open_is_good(int32_t open)
{
    return open >= PAYMENT_NONE && open <= (int32_t)(PAYMENT_SERVICE | PAYMENT_SPENT) &&
           open != PAYMENT_SPENT;
}

static int purse_is_good(const struct balance *balance)
{
    return balance->units <= PURSE_LIMIT && balance->bonus_units <= PURSE_LIMIT &&
           balance->paid <= PURSE_LIMIT && balance->service <= PURSE_LIMIT &&
           balance->unlogged <= PURSE_LIMIT && open_is_good(balance->open) &&
           (balance->returned == PAYMENT_NONE || balance->returned == PAYMENT_PAID ||
            balance->returned == PAYMENT_SERVICE) &&
           balance->tickets <= BALANCE_TICKETS_MAX;
}

/* Returns 1 if the name ends within its field and contains no control character, otherwise 0. */
static int name_is_good(const char name[LEDGER_NAME_SIZE])
{
    uint32_t length = 0;
    while (length < LEDGER_NAME_SIZE && name[length] != '\0') {
        if ((uint8_t)name[length] < 0x20u || name[length] == 0x7f) {
            return 0;
        }
        length++;
    }
    return length < LEDGER_NAME_SIZE;
}

/* Returns the largest valid `detail` of an entry of kind `kind`. For LEDGER_SETTING every value is
 * valid. */
static uint8_t detail_max(uint8_t kind)
{
    CORE_ASSERT(kind < LEDGER_KIND_COUNT);
    switch (kind) {
    case LEDGER_COINS:
    case LEDGER_TEST_COIN:
        return COIN_LINE_COUNT - 1u;
    case LEDGER_BEGIN:
        return CHOICE_COUNT - 1u;
    case LEDGER_REFUND:
        return REFUND_CAUSE_COUNT - 1u;
    case LEDGER_RESET:
        return AUDIT_GROUP_COUNT - 1u;
    case LEDGER_ROUND:
        return ROUND_CUT_OFF;
    case LEDGER_NAME:
    case LEDGER_LOSS:
        return POI_MAX - 1u;
    case LEDGER_PIN:
        return 1u;
    default:
        return UINT8_MAX;
    }
}

/* The value of most entry kinds must be >= 0, because the audits add it as an unsigned number. The
 * grade of a round is 0 in records of an earlier version. */
int ledger_entry_is_valid(const struct ledger_entry *entry)
{
    const struct round_record *round = &entry->round;
    const struct ledger_stand stand = { entry->count, entry->value, entry->detail };
    const int value_is_good =
        entry->kind == LEDGER_SETTING || entry->kind == LEDGER_RESET ||
        (entry->value >= 0 && (entry->kind != LEDGER_REFUND || open_is_good(entry->value)));
    const int round_is_good = round->mode < MODE_COUNT && round->grade <= SHEET_GRADE_MAX &&
                              round->players < 1u << POI_MAX && round->by_bot <= 1u &&
                              round->unscored <= 1u && round->preset < TANK_PRESET_COUNT;
    return entry->id > 0 && entry->id <= LEDGER_ID_MAX && entry->boot <= LEDGER_BOOTS_MAX &&
           entry->minute < DAY_MINUTES && entry->kind > LEDGER_NOTHING &&
           entry->kind < LEDGER_KIND_COUNT && entry->detail <= detail_max(entry->kind) &&
           value_is_good && purse_is_good(&entry->balance) && name_is_good(entry->name) &&
           (entry->kind != LEDGER_ROUND || round_is_good) &&
           (entry->kind != LEDGER_STAND || round_standing_is_good(&stand));
}

int ledger_state_is_valid(const struct persistent_state *memory)
{
    const struct ledger_start *start = &memory->ledger;
    const struct rank_row *rows = &memory->ranking.row[0][0][0];
    int is_good = start->last_id <= LEDGER_ID_MAX && start->boots <= LEDGER_BOOTS_MAX &&
                  purse_is_good(&start->balance) && round_standing_is_good(&start->stand);
    for (uint32_t i = 0; i < MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        is_good = is_good && rows[i].seat < POI_MAX && rows[i].round_id <= LEDGER_ID_MAX &&
                  name_is_good(rows[i].name);
    }
    return is_good;
}

int ledger_session_is_valid(const struct game_session *session)
{
    const struct ledger *ledger = &session->ledger;
    int is_good = ledger->last_id <= LEDGER_ID_MAX && ledger->saved_id <= ledger->last_id &&
                  ledger->boot <= LEDGER_BOOTS_MAX && ledger->minute < DAY_MINUTES &&
                  ledger->is_healthy <= 1u && purse_is_good(&ledger->balance) &&
                  purse_is_good(&ledger->committed) && session->health_log.is_told <= 1u;
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        is_good = is_good && purse_is_good(&ledger->after[i]);
    }
    for (uint32_t i = 0; i < COIN_LINE_COUNT; i++) {
        const struct pending_coins *untold = &session->credit.pending_coins[i];
        is_good = is_good && untold->units <= PURSE_LIMIT && untold->owed <= PURSE_LIMIT;
    }
    return is_good;
}
