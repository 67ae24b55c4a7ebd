/* ledger.c -- one entry after the other. */
#include "core/game/ledger.h"

#include "core/base/hash.h"
#include "core/core.h"

void ledger_init(struct ledger *ledger, const struct core_config *config)
{
    const struct ledger_start *start = &config->memory.ledger;
    *ledger = (struct ledger){
        .last_id = start->last_id,
        .saved_id = start->last_id,
        .boot = start->boots,
        .purse = start->purse,
    };
}

/* What is on disk stays there: an older answer that comes late says nothing new. */
void ledger_tick(struct core *core, const struct input *input)
{
    struct ledger *ledger = &core->game.ledger;
    const uint32_t ahead = input->record_saved_id - ledger->saved_id;
    if (ahead <= ledger->last_id - ledger->saved_id) {
        ledger->saved_id = input->record_saved_id;
    }
    ledger->is_well = input->store_well != 0;
    ledger->day = input->day;
    ledger->minute = input->minute;
}

int ledger_has_room(const struct ledger *ledger)
{
    return ledger->last_id - ledger->saved_id < LEDGER_RING;
}

/* Where nothing is kept (a desktop without a store) the oldest entry gives way: nobody was told
 * that it is safe. */
uint32_t ledger_write(struct core *core, const struct ledger_entry *what, struct output *output)
{
    struct ledger *ledger = &core->game.ledger;
    if (!ledger_has_room(ledger) && ledger->is_well) {
        ledger->unkept++;
        return 0;
    }
    struct ledger_entry entry = *what;
    entry.id = ++ledger->last_id;
    entry.boot = ledger->boot;
    entry.tick = core->tick;
    entry.day = ledger->day;
    entry.minute = ledger->minute;
    entry.purse = ledger->purse;
    output->entries[entry.id % LEDGER_RING] = entry;
    output->entry_id = entry.id;
    audits_note(&core->game.audits, &entry);
    ranking_note(&core->game.ranking, &entry);
    return entry.id;
}

int ledger_is_saved(const struct ledger *ledger, uint32_t id)
{
    return id <= ledger->saved_id;
}

static uint64_t hash_words(uint64_t hash, const uint32_t *words, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        hash = hash_u32(hash, words[i]);
    }
    return hash;
}

uint64_t purse_hash(uint64_t hash, const struct purse *purse)
{
    const uint32_t words[] = { purse->units,   purse->bonus_units, purse->paid,
                               purse->service, purse->untold,      purse->open };
    return hash_words(hash, words, sizeof words / sizeof words[0]);
}

uint64_t ledger_hash(uint64_t hash, const struct ledger *ledger)
{
    const uint32_t words[] = { ledger->last_id, ledger->saved_id, ledger->boot,
                               ledger->unkept,  ledger->day,      ledger->minute,
                               ledger->is_well };
    hash = hash_words(hash, words, sizeof words / sizeof words[0]);
    return purse_hash(hash, &ledger->purse);
}
