/* bot.h -- a player made of rules: sees as a person does, aims, dips, glides, lifts, tips. */
#ifndef KINGYO_CORE_GAME_BOT_H
#define KINGYO_CORE_GAME_BOT_H

#include <stdint.h>

#include "core/game/sight.h"
#include "core/game/technique.h"
#include "core/input.h"

enum bot_stage {
    BOT_LOOK = 0, /* Hovers and chooses. */
    BOT_APPROACH, /* Over the water, to where the slide begins. */
    BOT_WATCH,    /* Waits there until the fish is calm: a still shadow frightens nobody. */
    BOT_DIP,      /* Slides in along the slanted paper. */
    BOT_GLIDE,    /* Levels off and goes under the fish. */
    BOT_LIFT,
    BOT_CARRY,
    BOT_TIP,
    BOT_STAGE_COUNT,
};

struct bot {
    struct technique technique;
    uint32_t seed;          /* Of its luck. */
    uint8_t stage;          /* enum bot_stage */
    uint16_t prey;          /* Index of the fish it is after, or AIM_NO_FISH. */
    uint32_t stage_tick;    /* When the stage began. */
    uint32_t think_tick;    /* When it looks and decides again. */
    float yaw_rad;          /* How it holds the handle for this fish. */
    struct poi_target hand; /* Where its hand is now: moves no faster than an arm. */
    vec3 velocity_m_s;      /* Of the hand. */
    vec3 aim_m;             /* Where it wants the hand to be. */
    struct angles aim_angles;
};

/* A bot that plays by a copy of `technique`; its hand begins over the middle of the tank. */
void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed);

/* One tick of thought and motion for the bot that holds the poi of `sight->player`: where its hand
 * is now. */
struct poi_target bot_tick(struct bot *bot, const struct sight *sight);

uint64_t bot_hash(uint64_t hash, const struct bot *bot);

#endif
