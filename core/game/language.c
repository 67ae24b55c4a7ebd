/* language.c -- changes of the display language, and the end of a visitor's choice. */
#include "core/game/language.h"

#include "core/base/hash.h"
#include "core/core.h"

void language_return(struct core *core)
{
    if (!core->config.rules_7) {
        core->game.language = core->config.language;
        core->game.language_until = 0;
    }
}

void language_tick(struct core *core, const struct input *input)
{
    struct game *game = &core->game;
    if (game->phase == PHASE_ATTRACT && game->language_until != 0 &&
        core->game.tick >= game->language_until) {
        language_return(core);
    }
    if (input->pressed & INPUT_LANGUAGE) {
        game->language = (uint8_t)((game->language + 1u) % LANGUAGE_COUNT);
        game->language_until = core->config.rules_7 ? 0u : core->game.tick + LANGUAGE_TICKS;
    }
}

struct language_choice language_kept(const struct core *core)
{
    const struct game *game = &core->game;
    return (struct language_choice){ .chosen = game->language_until ? game->language : 0u,
                                     .until_tick = game->language_until };
}

uint64_t language_hash(uint64_t hash, const struct language_choice *choice)
{
    return choice->chosen | choice->until_tick
               ? hash_u32(hash_u32(hash, choice->chosen), choice->until_tick)
               : hash;
}
