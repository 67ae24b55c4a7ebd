/* round_standing.c -- logs the state of an open round. Packs the state into one ledger entry, and
 * unpacks it. */
#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/game/game.h"
#include "core/game/phases.h"
#include "core/game/rules.h"
#include "core/game/table_setup.h"

/* Number of bits of the member `count` for each player slot. The bits hold the slot's number of
 * caught fish. */
#define CAUGHT_BITS 8u
#define CAUGHT_MAX 255u
/* Mask of the bits of the member `value` that hold the number of tickets. The higher bits hold the
 * players, the bot and the level of the round. */
#define TICKETS_MASK 0xffffu
#define PLAYERS_SHIFT 16u
#define PLAYERS_MASK 15u
#define BOT_SHIFT 20u
#define LEVEL_SHIFT 21u
#define LEVEL_MASK 3u
/* Position of the lowest bit of the paper grade in the member `detail`. The bits below this
 * position hold the mode. */
#define GRADE_SHIFT 4u
#define MODE_MASK 15u
_Static_assert(POI_MAX *CAUGHT_BITS <= 32u && POI_MAX <= 4u, "each slot has a byte and a bit");
_Static_assert(CHOICE_COUNT <= MODE_MASK + 1u && SHEET_GRADE_MAX <= 15u, "mode and grade fit");

bool round_standing_is_spent(const struct game *game, const struct core_config *config)
{
    const uint32_t total = game->round_s * CORE_TICK_HZ;
    const bool is_mostly_played =
        game->phase == PHASE_ROUND &&
        STAND_SHARE_DENOMINATOR * (game->tick - game->phase_tick) >= STAND_SHARE_NUMERATOR * total;
    return config_has_rules(config, 8) &&
           ((game->accounts.ledger.balance.open & PAYMENT_SPENT) || is_mostly_played);
}

static struct ledger_stand stand_of(const struct game *game, const struct core_config *config)
{
    CORE_ASSERT(game->mode < MODE_COUNT);
    const uint32_t won = credit_tickets_won(game, config);
    uint32_t count = 0, value = won < BALANCE_TICKETS_MAX ? won : BALANCE_TICKETS_MAX;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        if (player->plays) {
            count |= (player->caught < CAUGHT_MAX ? player->caught : CAUGHT_MAX) << i * CAUGHT_BITS;
            value |= 1u << (PLAYERS_SHIFT + i);
        }
    }
    value |= (uint32_t)(game->bot_played != 0) << BOT_SHIFT;
    value |= (uint32_t)game_level(game) << LEVEL_SHIFT;
    return (struct ledger_stand){
        .count = count,
        .value = (int32_t)value,
        .detail =
            (uint8_t)(game->mode | (uint32_t)table_setup_grade(config, game->mode) << GRADE_SHIFT),
    };
}

/* Logs the state of the open round whenever the state changes, after the credit is no longer
 * refundable. A free round without tickets is not logged, because a power cut could not remove
 * anything of value. */
void round_standing_tick(struct accounts *accounts, const struct game *game,
                         const struct core_config *config, struct output *output)
{
    struct ledger *ledger = &accounts->ledger;
    struct credit *credit = &accounts->credit;
    const struct ledger_stand now = stand_of(game, config), *last = &credit->stand;
    const uint8_t kind = ledger->balance.open & PAYMENT_KIND_MASK;
    const bool has_value = kind == PAYMENT_PAID || kind == PAYMENT_SERVICE ||
                           (kind == PAYMENT_FREE && config->ticket_fish > 0);
    const bool is_logged = (ledger->balance.open & PAYMENT_SPENT) && now.count == last->count &&
                           now.value == last->value && now.detail == last->detail;
    CORE_ASSERT(round_standing_is_good(&now));
    if (!round_standing_is_spent(game, config) || !has_value || is_logged ||
        !ledger_is_saved(ledger, credit->stand_id) || !ledger_may_write(ledger, LEDGER_STAND)) {
        return;
    }
    const struct ledger_entry entry = {
        .kind = LEDGER_STAND, .detail = now.detail, .count = now.count, .value = now.value
    };
    ledger->balance.open |= PAYMENT_SPENT;
    credit->stand = now;
    credit->stand_id = ledger_write(accounts, game->tick, &entry, output);
}

/* ---- Finishing an interrupted round at the next start ---------------------------------------- */

/* Returns the record of the round whose last logged state is `stand`. Times, paper and fish count
 * are unknown and therefore 0, as in records of an earlier Kingyo. */
static struct round_record record_of(const struct ledger_stand *stand)
{
    CORE_ASSERT(round_standing_is_good(stand));
    const uint32_t value = (uint32_t)stand->value;
    struct round_record record = {
        .mode = stand->detail & MODE_MASK, /* The unpacked mode is in range, because the caller
                                              has checked round_standing_is_good(). */
        .grade = stand->detail >> GRADE_SHIFT,
        .players = (uint8_t)(value >> PLAYERS_SHIFT & PLAYERS_MASK),
        .by_bot = (uint8_t)(value >> BOT_SHIFT & 1u),
        .level = (uint8_t)(value >> LEVEL_SHIFT & LEVEL_MASK),
    };
    record.unscored = (uint8_t)!rules_of(record.mode)->keeps_score;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (record.players >> i & 1u) {
            record.player[i].caught = stand->count >> i * CAUGHT_BITS & CAUGHT_MAX;
            record.player[i].sheets = 1u;
            record.caught += record.player[i].caught;
        }
    }
    return record;
}

bool round_standing_finish(struct accounts *accounts, const struct core_config *config,
                           uint32_t tick, struct output *output)
{
    struct ledger *ledger = &accounts->ledger;
    const struct ledger_stand *stand = &config->persistent.ledger.stand;
    struct ledger_entry entry = { .kind = LEDGER_ROUND,
                                  .detail = ROUND_CUT_OFF,
                                  .value = (int32_t)((uint32_t)stand->value & TICKETS_MASK),
                                  .round = record_of(stand) };
    if (entry.round.players == 0) {
        return false;
    }
    entry.round.id = ledger->last_id + 1u;
    ledger->balance.open = PAYMENT_NONE;
    entry.value = (int32_t)credit_add_tickets(accounts, config, (uint32_t)entry.value);
    ledger_write(accounts, tick, &entry, output);
    return true;
}

struct ledger_stand round_standing_after(struct ledger_stand before,
                                         const struct ledger_entry *entry)
{
    if (entry->kind == LEDGER_STAND) {
        return (struct ledger_stand){ entry->count, entry->value, entry->detail };
    }
    return entry->kind != LEDGER_BEGIN && (entry->balance.open & PAYMENT_SPENT)
               ? before
               : (struct ledger_stand){ 0 };
}

bool round_standing_is_good(const struct ledger_stand *stand)
{
    const uint32_t value = (uint32_t)stand->value;
    return (stand->detail & MODE_MASK) < MODE_COUNT &&
           stand->detail >> GRADE_SHIFT <= SHEET_GRADE_MAX && value >> LEVEL_SHIFT < LEVEL_COUNT &&
           (value & TICKETS_MASK) <= BALANCE_TICKETS_MAX;
}
