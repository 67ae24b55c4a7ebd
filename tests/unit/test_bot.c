/* test_bot.c -- the bot moves and decides within a person's means, and the same way each time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/core.h"

static struct core core;
static struct input input;
static struct output output;

static void open_stall(uint32_t seed, uint32_t round_s)
{
    const struct core_config config = { .seed = seed, .round_s = round_s };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    input.poi[0].link = POI_LINK_BOT;
}

static void tick(void)
{
    output.sound_count = 0;
    core_tick(&core, &input, &output);
    input.pressed = 0;
}

/* A whole round by the bot; the fish it caught. */
static uint32_t play_round(uint32_t seed, uint32_t round_s)
{
    open_stall(seed, round_s);
    input.pressed = INPUT_START;
    do {
        tick();
    } while (core.game.phase != PHASE_RESULT);
    return output.record.caught;
}

static void test_the_hand_moves_no_faster_than_an_arm(void **state)
{
    (void)state;
    open_stall(5, 60);
    vec3 last = core.game.hand[0].position_m;
    vec3 last_step = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t i = 0; i < 20u * CORE_TICK_HZ; i++) {
        tick();
        const vec3 now = core.game.hand[0].position_m;
        const vec3 way = v3_sub(now, last);
        assert_true(v3_length(way) < 0.7f * CORE_TICK_S);
        assert_true(i == 0 || v3_length(v3_sub(way, last_step)) < 8.0f * CORE_TICK_S * CORE_TICK_S);
        last = now;
        last_step = way;
    }
}

static void test_it_decides_no_oftener_than_a_person(void **state)
{
    (void)state;
    open_stall(5, 60);
    uint32_t thoughts = 0;
    uint32_t last = core.game.bot[0].think_tick;
    for (uint32_t i = 0; i < 10u * CORE_TICK_HZ; i++) {
        tick();
        thoughts += core.game.bot[0].think_tick != last;
        last = core.game.bot[0].think_tick;
    }
    assert_in_range(thoughts, 35, 80); /* 150 to 250 ms, and a look at each change of stage */
}

static void test_it_rests_above_the_water_between_rounds(void **state)
{
    (void)state;
    open_stall(5, 10);
    input.pressed = INPUT_START;
    for (uint32_t i = 0; i < GAME_READY_TICKS; i++) {
        tick();
    }
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_true(core.game.hand[0].position_m.y > 0.0f);
    assert_true(core.poi[0].immersed <= 0.0f);
}

static void test_it_leaves_fish_that_flee_or_hug_the_wall(void **state)
{
    (void)state;
    open_stall(5, 60);
    for (uint32_t i = 0; i < core.tank.fish_count; i++) {
        struct fish *fish = &core.tank.fish[i];
        fish->position_m = v3(0.5f * core.tank.size_m.x - 0.02f, -0.03f, 0.0f);
        fish->gait = GAIT_REST;
    }
    core.tank.fish[9].position_m = v3(-0.05f, -0.04f, 0.0f);
    core.tank.fish[8].position_m = v3(-0.05f, -0.02f, 0.03f);
    core.tank.fish[8].gait = GAIT_ESCAPE;
    for (uint32_t i = 0; i < 80; i++) { /* the tank stands still: the bot alone */
        bot_tick(&core.game.bot[0], &(struct sight){ &core, 0 });
        core.tick++;
    }
    assert_int_equal(core.game.bot[0].prey, 9);
}

static void test_with_no_fish_to_take_it_only_looks(void **state)
{
    (void)state;
    open_stall(5, 60);
    for (uint32_t i = 0; i < core.tank.fish_count; i++) {
        core.tank.fish[i].gait = GAIT_BOWL;
    }
    for (uint32_t i = 0; i < 600; i++) {
        const struct poi_target hand = bot_tick(&core.game.bot[0], &(struct sight){ &core, 0 });
        assert_true(hand.position_m.y > 0.03f);
        core.tick++;
    }
    assert_int_equal(core.game.bot[0].stage, BOT_LOOK);
}

static void test_a_bots_round_is_the_same_each_time(void **state)
{
    (void)state;
    const uint32_t caught = play_round(31, 12);
    const uint64_t hash = core_hash(&core);
    assert_int_equal(play_round(31, 12), caught);
    assert_true(core_hash(&core) == hash);
    play_round(32, 12);
    assert_true(core_hash(&core) != hash);
}

/* Ten rounds of 15 s, as the demo plays them: one empty one is bad luck, more are a fault. */
static void test_a_short_round_nearly_always_catches_a_fish(void **state)
{
    (void)state;
    uint32_t empty = 0;
    uint32_t total = 0;
    for (uint32_t seed = 1; seed <= 10; seed++) {
        const uint32_t caught = play_round(seed, 15);
        empty += caught == 0;
        total += caught;
    }
    assert_in_range(empty, 0, 1);
    assert_in_range(total, 10, 60);
}

/* Ten seconds each: the tank's size, depth and crowd are the bot's only rules. */
static void test_it_plays_in_each_tank(void **state)
{
    (void)state;
    for (uint8_t preset = 0; preset < TANK_PRESET_COUNT; preset++) {
        uint32_t caught = 0;
        for (uint32_t seed = 1; seed <= 3; seed++) {
            const struct core_config config = { .seed = seed, .preset = preset, .round_s = 10 };
            assert_int_equal(core_init(&core, &config), CORE_OK);
            assert_int_equal(core.tank.fish_count, tank_preset(preset)->fish_count);
            input = (struct input){ .poi[0].link = POI_LINK_BOT, .pressed = INPUT_START };
            output = (struct output){ 0 };
            do {
                tick();
            } while (core.game.phase != PHASE_RESULT);
            caught += output.record.caught;
        }
        print_message("%s: %u caught in three rounds of 10 s\n", tank_preset(preset)->name,
                      caught);
        assert_true(caught > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_hand_moves_no_faster_than_an_arm),
        cmocka_unit_test(test_it_decides_no_oftener_than_a_person),
        cmocka_unit_test(test_it_rests_above_the_water_between_rounds),
        cmocka_unit_test(test_it_leaves_fish_that_flee_or_hug_the_wall),
        cmocka_unit_test(test_with_no_fish_to_take_it_only_looks),
        cmocka_unit_test(test_a_bots_round_is_the_same_each_time),
        cmocka_unit_test(test_a_short_round_nearly_always_catches_a_fish),
        cmocka_unit_test(test_it_plays_in_each_tank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
