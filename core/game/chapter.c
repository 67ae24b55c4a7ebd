/* chapter.c -- the state that continues across sessions. */
#include "core/game/chapter.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/rng.h"
#include "core/core.h"

void chapter_ask(struct core *core)
{
    if (core->game.turn_tick == 0) {
        core->game.turn_tick = core->tick + CHAPTER_FADE_TICKS;
    }
}

/* Call after `core->tick` was incremented. */
int chapter_is_over(const struct core *core)
{
    const struct game *game = &core->game;
    return game->phase == PHASE_ATTRACT && game->turn_tick != 0 && core->tick >= game->turn_tick;
}

void chapter_turn(struct core *core)
{
    struct core_config *config = &core->config;
    const struct game *game = &core->game;
    config->seed = rng_u32((struct rng_key){ config->seed, core->tick, 0, RNG_CHAPTER });
    config->chapter = (struct chapter){
        .tick = core->tick,
        .order_count = game->menu.order_count,
        .edit_save_id = game->lab.save_id,
        .edit_saved_id = game->lab.saved_id,
        .ledger = game->ledger,
        .credit = game->credit,
        .upkeep = game->upkeep,
        .adjust = game->adjust,
        .language = language_kept(core),
    };
    config->memory.ledger.last_id = game->ledger.last_id;
    config->memory.ledger.purse = game->ledger.purse;
    config->memory.ledger.stand = (struct ledger_stand){ 0 }; /* No round is open in attract
                                                                 mode. */
    config->memory.audits = game->audits;
    config->memory.ranking = game->ranking;
    memcpy(config->book.has_edit, game->lab.has_edit, sizeof config->book.has_edit);
    memcpy(config->book.edits, game->lab.edits, sizeof config->book.edits);
}

void chapter_go_on(struct game *game, const struct chapter *chapter)
{
    if (chapter->tick == 0) {
        return;
    }
    game->menu.order_count = chapter->order_count;
    game->lab.save_id = chapter->edit_save_id;
    game->lab.saved_id = chapter->edit_saved_id;
    game->ledger = chapter->ledger;
    game->credit = chapter->credit;
    game->upkeep = chapter->upkeep;
    game->adjust = chapter->adjust;
    if (chapter->language.until_tick != 0) {
        game->language = (uint8_t)chapter->language.chosen;
        game->language_until = chapter->language.until_tick;
    }
}

float chapter_veil(const struct core *core)
{
    const struct game *game = &core->game;
    const uint32_t since = core->tick - core->config.chapter.tick;
    const uint32_t ahead = game->turn_tick - core->tick;
    uint32_t dark = since < CHAPTER_FADE_TICKS ? CHAPTER_FADE_TICKS - since : 0u;
    if (game->turn_tick != 0 && ahead < CHAPTER_FADE_TICKS && CHAPTER_FADE_TICKS - ahead > dark) {
        dark = CHAPTER_FADE_TICKS - ahead;
    }
    return game->phase == PHASE_ATTRACT ? (float)dark / (float)CHAPTER_FADE_TICKS : 0.0f;
}

uint64_t chapter_hash(uint64_t hash, const struct chapter *chapter, int rules_7)
{
    hash = hash_u32(hash, chapter->tick);
    hash = hash_u32(hash, chapter->order_count);
    hash = hash_u32(hash, chapter->edit_save_id);
    hash = hash_u32(hash, chapter->edit_saved_id);
    hash = ledger_hash(hash, &chapter->ledger);
    hash = credit_hash(hash, &chapter->credit);
    hash = upkeep_hash(hash, &chapter->upkeep);
    return language_hash(adjust_hash(hash, &chapter->adjust, rules_7), &chapter->language);
}
