/* bot.h -- the built-in bot: an artificial player with human reaction times and arm motion.
 *
 * The bot perceives the game only through snapshots (snapshot.h), one every 150 to 250 ms. A
 * snapshot becomes usable when the next snapshot is taken, so the bot always acts on the past. The
 * bot's poi moves like a poi in a human hand. */
#ifndef KINGYO_CORE_GAME_BOT_BOT_H
#define KINGYO_CORE_GAME_BOT_BOT_H

#include <stdint.h>

#include "core/game/bot/bot_hand.h"
#include "core/game/bot/snapshot.h"
#include "core/game/bot/technique.h"
#include "core/game/bot/vision.h"
#include "core/input.h"

enum bot_stage {
    BOT_REST = 0, /* Keeps the poi and its shadow away from the water while no game is played. */
    BOT_SOAK,     /* Wets the new paper. */
    BOT_CHOOSE,   /* Hovers and selects a fish. */
    BOT_APPROACH, /* Moves above the water to the start of the path. */
    BOT_WATCH,    /* Waits above the start of the path until the fish is calm, because a still
                     shadow does not startle fish. */
    BOT_DIP,      /* Moves down into the water. */
    BOT_GLIDE,    /* Levels the poi and moves under the fish. */
    BOT_LIFT,
    BOT_CARRY,
    BOT_TIP,
    BOT_STAGE_COUNT,
};

struct bot {
    struct technique technique;
    uint32_t seed;          /* Seed of the bot's random numbers. */
    uint8_t stage;          /* Current stage (enum bot_stage). */
    uint16_t prey;          /* Target fish, or SNAPSHOT_NO_FISH. */
    uint32_t stage_tick;    /* Tick at which the stage began. */
    uint32_t act_tick;      /* Tick at which `seen` becomes usable. */
    uint32_t tries;         /* Number of attempts to catch a fish so far. */
    float yaw_rad;          /* Handle yaw for the target fish. */
    vec3 miss_m;            /* Aiming error of this attempt. */
    struct poi_target goal; /* Pose toward which the arm moves. */
    float speed_m_s;        /* Maximum speed of the motion to `goal`. */
    float ease_s;           /* Time to reach `speed_m_s`, in seconds. */
    struct bot_hand hand;
    struct snapshot known; /* Snapshot on which the bot acts. */
    struct snapshot seen;  /* Newest snapshot; becomes `known` at `act_tick`. */
};

/* Initializes `bot` with a copy of `technique`. The arm starts above the middle of the tank. */
void bot_init(struct bot *bot, const struct technique *technique, uint32_t seed);

/* Advances the bot by one tick, before the core's tick. `vision->player` is the player that the bot
 * controls. Returns the pose of the arm, including the wrist angles. */
struct poi_target bot_tick(struct bot *bot, const struct vision *vision);

uint64_t bot_hash(uint64_t hash, const struct bot *bot);

#endif
