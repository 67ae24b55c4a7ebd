/* bot.h -- a player made of habits: it looks, and acts a moment later on what it saw.
 *
 * It knows the stall only by looks (look.h), one each 150 to 250 ms, and each is known to it only
 * when the next is taken: what it acts on is always the past. Its hand moves as an arm does. */
#ifndef KINGYO_CORE_GAME_BOT_H
#define KINGYO_CORE_GAME_BOT_H

#include <stdint.h>

#include "core/game/bot_hand.h"
#include "core/game/look.h"
#include "core/game/sight.h"
#include "core/game/technique.h"
#include "core/input.h"

enum bot_stage {
    BOT_REST = 0, /* Keeps poi and shadow off the water: nothing is played. */
    BOT_SOAK,     /* Wets the fresh paper. */
    BOT_CHOOSE,   /* Hovers and chooses. */
    BOT_APPROACH, /* Over the water, to where the slide begins. */
    BOT_WATCH,    /* Waits there until the fish is calm: a still shadow frightens nobody. */
    BOT_DIP,      /* Slides in. */
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
    uint16_t prey;          /* The fish it is after, or LOOK_NO_FISH. */
    uint32_t stage_tick;    /* When the stage began. */
    uint32_t act_tick;      /* When it knows what it last saw. */
    uint32_t tries;         /* Fish that it went for. */
    float yaw_rad;          /* How it holds the handle for this fish. */
    vec3 miss_m;            /* How far this try goes wrong. */
    struct poi_target goal; /* Where it wants its hand, ... */
    float speed_m_s;        /* ... how fast on the way there, ... */
    float ease_s;           /* ... and in what time it gets up that speed. */
    struct bot_hand hand;
    struct look known;      /* What it acts on. */
    struct look seen;       /* The newest look; becomes known at `act_tick`. */
};

/* A bot that plays by a copy of `technique`; its hand begins over the middle of the tank. */
void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed);

/* One tick of thought and motion for the bot that holds the poi of `sight->player`, before the
 * core's tick: where its hand is now, wrist and all. */
struct poi_target bot_tick(struct bot *bot, const struct sight *sight);

uint64_t bot_hash(uint64_t hash, const struct bot *bot);

#endif
