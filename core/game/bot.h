/* bot.h -- a player made of rules: sees the tank as a person does, aims, dips, glides, lifts, tips. */
#ifndef KINGYO_CORE_GAME_BOT_H
#define KINGYO_CORE_GAME_BOT_H

#include <stdint.h>

#include "core/input.h"

#define BOT_NO_PREY 0xffffu

enum bot_stage {
    BOT_LOOK = 0,
    BOT_APPROACH,
    BOT_DIP,
    BOT_GLIDE,
    BOT_LIFT,
    BOT_CARRY,
    BOT_TIP,
};

struct bot {
    uint8_t stage;        /* enum bot_stage */
    uint16_t prey;        /* Index of the fish it is after, or BOT_NO_PREY. */
    uint32_t stage_tick;  /* When the stage began. */
    uint32_t think_tick;  /* When it looks and decides again. */
    struct poi_target hand; /* Where its hand is now: moves no faster than an arm. */
    vec3 velocity_m_s;    /* Of the hand. */
    vec3 aim_m;           /* Where it wants the hand to be. */
    struct angles aim_angles;
};

struct core;

void bot_init(struct bot *bot);

/* One tick of thought and motion for the bot that holds poi `index`. */
struct poi_target bot_tick(struct bot *bot, const struct core *core, uint32_t index);

uint64_t bot_hash(uint64_t hash, const struct bot *bot);

#endif
