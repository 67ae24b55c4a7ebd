/* language.c -- changes the display language, and ends a visitor's choice. */
#include "core/game/language.h"

#include "core/base/hash.h"
#include "core/game/game.h"
#include "core/config.h"

void language_return(struct game *game, const struct core_config *config)
{
    if (!config->rules_7) {
        game->language = config->language;
        game->language_until = 0;
    }
}

void language_tick(struct game *game, const struct core_config *config, const struct input *input)
{
    if (game->phase == PHASE_ATTRACT && game->language_until != 0 &&
        game->tick >= game->language_until) {
        language_return(game, config);
    }
    if (input->pressed & INPUT_LANGUAGE) {
        game->language = (uint8_t)((game->language + 1u) % LANGUAGE_COUNT);
        game->language_until = config->rules_7 ? 0u : game->tick + LANGUAGE_TICKS;
    }
}

struct language_choice language_kept(const struct game *game)
{
    return (struct language_choice){ .chosen = game->language_until ? game->language : 0u,
                                     .until_tick = game->language_until };
}

uint64_t language_hash(uint64_t hash, const struct language_choice *choice)
{
    return choice->chosen | choice->until_tick
               ? hash_u32(hash_u32(hash, choice->chosen), choice->until_tick)
               : hash;
}
