/* ledger_writer.c -- writes entries to the ledger's ring buffer and tracks which entries are on
 * disk. */
#include "core/game/accounting/ledger_writer.h"

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"

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

/* Entries written without a store are lost. A store that becomes available after the start
 * therefore does not wait for the lost entries. health_log.c then logs the current balance, which
 * becomes `committed` when that entry is on disk. An older saved id is ignored, because saved
 * entries stay saved. */
void ledger_tick(struct ledger *ledger, const struct input *input)
{
    const int is_well = input->store_well != 0;
    if (ledger->boot == 0 && is_well && !ledger->is_healthy) {
        ledger->saved_id = ledger->last_id;
        ledger->wait_ticks = 0;
    }
    ledger->is_healthy = (uint8_t)is_well;
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

int ledger_has_room(const struct ledger *ledger, uint8_t kind)
{
    const int is_of_a_round = kind == LEDGER_BEGIN || kind == LEDGER_ROUND ||
                              kind == LEDGER_REFUND || kind == LEDGER_LEFT;
    CORE_ASSERT(kind < LEDGER_KIND_COUNT);
    return ledger->last_id < LEDGER_ID_MAX &&
           unsaved_entry_count(ledger) < LEDGER_RING - (is_of_a_round ? 0u : LEDGER_RESERVE);
}

/* In a kiosk without a store, no entry ever reaches a disk, so the oldest entry may be
 * overwritten. */
int ledger_may_write(const struct ledger *ledger, uint8_t kind)
{
    return ledger_has_room(ledger, kind) ||
           (ledger->last_id < LEDGER_ID_MAX && ledger->boot == 0 && !ledger->is_healthy);
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

int ledger_is_saved(const struct ledger *ledger, uint32_t id)
{
    return id <= ledger->saved_id;
}

int ledger_is_flushed(const struct ledger *ledger)
{
    return unsaved_entry_count(ledger) == 0 || ledger->boot == 0;
}

int ledger_is_safe(const struct ledger *ledger)
{
    return ledger->is_healthy && ledger->wait_ticks <= LEDGER_WAIT_TICKS_MAX &&
           ledger_has_room(ledger, LEDGER_COINS);
}

int ledger_needs_sync(const struct ledger *ledger)
{
    return ledger->is_healthy && unsaved_entry_count(ledger) == 0 &&
           ledger_balance_hash(HASH_START, &ledger->balance) !=
               ledger_balance_hash(HASH_START, &ledger->committed);
}

/* Returns the part of the count `sure` (credits on disk) that is left after the whole count changed
 * from `before` to `after`. An increase leaves `sure` unchanged. */
static uint32_t less_spent(uint32_t sure, uint32_t before, uint32_t after)
{
    const uint32_t spent = before > after ? before - after : 0u;
    return sure > spent ? sure - spent : 0u;
}

struct ledger_credits ledger_committed_credits(const struct ledger *ledger)
{
    struct ledger_credits sure = { ledger->committed.paid, ledger->committed.service };
    struct balance before = ledger->committed;
    for (uint32_t i = 1; i <= unsaved_entry_count(ledger); i++) {
        if (unsaved_entry_count(ledger) > LEDGER_RING) {
            return (struct ledger_credits){ 0 }; /* Without a store, no entry is saved, so no credit
                                                    is on disk. */
        }
        const struct balance *after = &ledger->after[(ledger->saved_id + i) % LEDGER_RING];
        sure.paid = less_spent(sure.paid, before.paid, after->paid);
        sure.service = less_spent(sure.service, before.service, after->service);
        before = *after;
    }
    return sure;
}

static uint64_t hash_words(uint64_t hash, const uint32_t *words, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        hash = hash_u32(hash, words[i]);
    }
    return hash;
}

uint64_t ledger_balance_hash(uint64_t hash, const struct balance *balance)
{
    const uint32_t words[] = { balance->units,   balance->bonus_units, balance->paid,
                               balance->service, balance->unlogged,    balance->open };
    hash = hash_words(hash, words, sizeof words / sizeof words[0]);
    return hash_later(hash_later(hash, 1, balance->returned), 2, balance->tickets);
}

uint64_t ledger_start_hash(uint64_t hash, const struct ledger_start *start)
{
    hash = hash_u32(hash_u32(hash, start->last_id), start->boots);
    return round_standing_hash(ledger_balance_hash(hash, &start->balance), &start->stand);
}

uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger)
{
    const uint32_t words[] = { ledger->last_id,     ledger->saved_id,   ledger->boot,
                               ledger->uncommitted, ledger->wait_ticks, ledger->day,
                               ledger->minute,      ledger->is_healthy };
    hash = hash_words(hash, words, sizeof words / sizeof words[0]);
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        hash = ledger_balance_hash(hash, &ledger->after[i]);
    }
    return ledger_balance_hash(ledger_balance_hash(hash, &ledger->committed), &ledger->balance);
}
