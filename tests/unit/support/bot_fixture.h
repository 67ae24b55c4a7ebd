/* bot_fixture.h -- test fixture of the whole core, in which a bot plays. The bot moves the first
 * poi (paper scoop) through controller input, with a technique that the test chooses. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_BOT_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_BOT_FIXTURE_H

#include "core/core.h"
#include "core/game/bot/bot.h"
#include "core/game/rules.h"

struct bot_fixture {
    struct core core;
    struct input input;
    struct output output;
    struct bot bot;
};

/* Initializes the core with `config` and the bot with `technique`. The bot uses the seed of
 * `config`, like the core. */
static inline void bot_fixture_open(struct bot_fixture *fixture, const struct core_config *config,
                                    const struct technique *technique)
{
    assert_int_equal(core_init(&fixture->core, config), CORE_OK);
    memset(&fixture->input, 0, sizeof fixture->input);
    memset(&fixture->output, 0, sizeof fixture->output);
    bot_init(&fixture->bot, technique, config->seed);
    fixture->bot.hand.pose = (struct poi_target){ .position_m = v3(0.0f, 0.10f, 0.0f) };
    /* Places the target pose of the bot 10 cm above the water over the middle of the tank, and the
     * poi 5 cm below this pose. */
    fixture->core.game.control[0].target_pose = fixture->bot.hand.pose;
    fixture->core.world.poi[0].position_m = v3(0.0f, 0.05f, 0.0f);
}

/* Returns what the bot of player 0 can see of the game and the tank. */
static inline struct vision bot_fixture_sight(const struct bot_fixture *fixture)
{
    return (
        struct vision){ .game = &fixture->core.game, .world = &fixture->core.world, .player = 0 };
}

/* Runs one tick (1/120 s) with the bot's pose as input. Presses START once per second while no
 * round has been started. */
static inline void bot_fixture_tick(struct bot_fixture *fixture)
{
    const uint8_t phase = fixture->core.game.phase;
    const int idle = phase == PHASE_ATTRACT || phase == PHASE_MODE_SELECT;
    const struct vision vision = bot_fixture_sight(fixture);
    fixture->input.pressed = idle && fixture->core.game.tick % CORE_TICK_HZ == 0 ? INPUT_START : 0;
    fixture->input.poi[0] = (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .trembles = 1,
        .target = bot_tick(&fixture->bot, &vision),
    };
    fixture->output.sound_count = 0;
    assert_int_equal(core_tick(&fixture->core, &fixture->input, &fixture->output), CORE_OK);
}

/* Runs ticks until the round has begun. If it has not begun after 20 s, the test fails. */
static inline void bot_fixture_begin(struct bot_fixture *fixture)
{
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ && fixture->core.game.phase != PHASE_ROUND; i++) {
        bot_fixture_tick(fixture);
    }
    assert_int_equal(fixture->core.game.phase, PHASE_ROUND);
}

/* Runs ticks until the bot enters the stage `stage`, which is a step of its scoop (enum bot_stage).
 * Returns 1 if the bot enters the stage within `seconds` and before the round ends, otherwise 0. */
static inline int bot_fixture_until(struct bot_fixture *fixture, uint8_t stage, uint32_t seconds)
{
    for (uint32_t i = 0; i < seconds * CORE_TICK_HZ; i++) {
        if (fixture->bot.stage == stage) {
            return 1;
        }
        if (fixture->core.game.phase == PHASE_RESULT) {
            return 0;
        }
        bot_fixture_tick(fixture);
    }
    return 0;
}

#endif
