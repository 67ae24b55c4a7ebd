/* game.h -- attract, ready, round, result: what the stall is doing, and the score. */
#ifndef KINGYO_CORE_GAME_GAME_H
#define KINGYO_CORE_GAME_GAME_H

#include <stdint.h>

#include "core/game/bot.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

struct game {
    uint8_t phase;      /* enum scene_phase */
    uint8_t language;   /* enum language */
    uint8_t hint;       /* enum scene_hint */
    uint32_t phase_tick; /* When the phase began. */
    uint32_t round_s;
    uint32_t round_count; /* Rounds begun; seeds the next poi's paper. */
    uint32_t caught[POI_MAX];
    uint32_t best_today;
    uint32_t record_id;
    uint8_t bot_played; /* Some poi of this round was the bot's. */
    struct bot bot[POI_MAX];
};

struct core;
struct core_config;

void game_init(struct game *game, const struct core_config *config);

/* The first step of a tick: phases, fresh poi and empty bowls at the start of a round. Fills
 * `targets` with what each hand wants (the controller's, or the bot's) and `live` with which poi
 * take part. */
void game_tick(struct core *core, const struct input *input, struct output *output,
               struct poi_target targets[POI_MAX], uint8_t live[POI_MAX]);

/* The last step of a tick: what was landed counts. */
void game_score(struct core *core, const uint32_t landed[POI_MAX], struct output *output);

uint64_t game_hash(uint64_t hash, const struct game *game);

#endif
