/* test_jam.c -- checks that neither fish nor another poi block a poi for long.
 *
 * A poi counts as jammed while the player pulls it upward with at least 6.5 N, but the ring moves
 * at less than 2 cm/s. The force of 6.5 N belongs to a target that is more than 3 cm above the
 * ring. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/game/bot/bot.h"
#include "core/game/table_setup.h"
#include "tests/unit/support/poi_fixture.h"

#define PULL_M 0.03f
#define STILL_M (0.02f * CORE_TICK_S)
/* Longest permitted jam in ticks (one second). The longest jam that was measured had 12 ticks (0.1
 * s). */
#define JAM_TICKS_MAX CORE_TICK_HZ

static struct core core;
static struct input input;
static struct output output;
static struct bot bots[POI_MAX];
static struct poi_fixture fixture;

static bool is_jammed(const struct poi *poi)
{
    const vec3 made_m = v3_sub(poi->position_m, poi->before_m);
    return poi->hand_m.y > poi->position_m.y + PULL_M && v3_length(made_m) < STILL_M;
}

static void play_tick(uint32_t players)
{
    const uint8_t phase = core.game.phase;
    const int idle = phase == PHASE_ATTRACT || phase == PHASE_MODE_SELECT;
    input.pressed = idle && core.game.tick % CORE_TICK_HZ == 0 ? INPUT_START : 0;
    for (uint32_t i = 0; i < players; i++) {
        const struct vision vision = { .game = &core.game, .world = &core.world, .player = i };
        input.poi[i] = (struct poi_input){
            .link = POI_SOURCE_LIVE,
            .has_wrist = 1,
            .trembles = 1,
            .target = bot_tick(&bots[i], &vision),
        };
    }
    output.sound_count = 0;
    core_tick(&core, &input, &output);
}

static void open_fixture(uint8_t mode, uint32_t players, uint32_t seed)
{
    struct core_config config = {
        .seed = seed, .modes = (uint8_t)(1u << mode), .players = (uint8_t)players, .lanes = 4
    };
    config.preset = table_setup_preset(&config, mode);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    for (uint32_t i = 0; i < players; i++) {
        bot_init(&bots[i], i % 2u ? &technique_novice : &technique_expert, 4u * seed + i);
        bots[i].hand.pose = core.game.control[i].target_pose;
    }
}

/* Plays a round of `seconds` seconds. Returns the longest jam of any poi in ticks. */
static uint32_t longest_jam(uint8_t mode, uint32_t players, uint32_t seed, uint32_t seconds)
{
    uint32_t held[POI_MAX] = { 0 }, longest = 0, played = 0, dipped = 0;
    open_fixture(mode, players, seed);
    for (uint32_t tick = 0; tick < (seconds + 20u) * CORE_TICK_HZ; tick++) {
        play_tick(players);
        if (core.game.phase != PHASE_ROUND) {
            continue;
        }
        played++;
        for (uint32_t i = 0; i < players; i++) {
            held[i] = is_jammed(&core.world.poi[i]) ? held[i] + 1u : 0;
            longest = held[i] > longest ? held[i] : longest;
            dipped += core.world.poi[i].immersed > 0.0f;
        }
    }
    assert_true(played > 20u * CORE_TICK_HZ);
    assert_true(dipped > 5u * CORE_TICK_HZ);
    return longest;
}

/* ---- Rounds that had jams of 18 to 163 s in earlier versions -------------------------------- */

static void test_a_jam_of_one_players_poi_ends_soon_in_a_festival(void **state)
{
    (void)state;
    static const uint32_t seeds[] = { 2, 4, 8 };
    for (uint32_t i = 0; i < sizeof seeds / sizeof seeds[0]; i++) {
        assert_in_range(longest_jam(MODE_FESTIVAL, 1, seeds[i], 60), 0, JAM_TICKS_MAX);
    }
}

static void test_a_jam_ends_soon_in_a_championship(void **state)
{
    (void)state;
    assert_in_range(longest_jam(MODE_CHAMPIONSHIP, 1, 1, 60), 0, JAM_TICKS_MAX);
}

static void test_a_jam_of_two_or_four_players_ends_soon(void **state)
{
    (void)state;
    assert_in_range(longest_jam(MODE_FESTIVAL, 2, 0, 60), 0, JAM_TICKS_MAX);
    assert_in_range(longest_jam(MODE_FESTIVAL, 4, 1, 60), 0, JAM_TICKS_MAX);
    assert_in_range(longest_jam(MODE_FESTIVAL, 4, 2, 60), 0, JAM_TICKS_MAX);
}

/* ---- A heap of fish on the ring ------------------------------------------------------------- */

/* Places the ring at a depth of 6 cm. Piles fish up to the surface, above the paper and across the
 * ring's edge. */
static void heap(uint32_t seed, float pitch_rad)
{
    fixture_init(&fixture, 4, seed);
    fixture_dip(&fixture);
    fixture_turn(&fixture, pitch_rad, 0.0f, 0.2f);
    for (uint32_t layer = 0; layer < 3; layer++) {
        for (uint32_t i = 0; i < 12; i++) {
            const float x_m = 0.022f * ((float)(i % 4u) - 1.5f);
            const float z_m = 0.042f * ((float)(i / 4u) - 1.0f);
            const uint32_t fish =
                fixture_add_fish(&fixture, v3(x_m, -0.008f - 0.017f * (float)layer, z_m), 0.038f);
            fixture.tank.fish[fish].angles.yaw_rad = 0.1f * (float)((seed + i) % 5u);
        }
    }
}

static void test_a_poi_under_a_heap_of_fish_rises_with_the_hand(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 24; seed++) {
        heap(seed, 0.04f * (float)(seed % 10u));
        const vec3 up_m = v3(fixture.hand.position_m.x, 0.10f, fixture.hand.position_m.z);
        fixture_move(&fixture, up_m, 0.25f);
        fixture_wait(&fixture, 0.5f);
        assert_true(fixture.poi.position_m.y > 0.05f);
    }
}

/* ---- Two pois at one place ------------------------------------------------------------------ */

static void hold(uint32_t which, vec3 place_m)
{
    input.poi[which] = (struct poi_input){
        .link = POI_SOURCE_LIVE,
        .has_wrist = 1,
        .target.position_m = place_m,
    };
}

static void two_hands(vec3 a_m, vec3 b_m)
{
    const struct core_config config = { .seed = 3, .fish_count = 1, .players = 2, .lanes = 4 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    for (uint32_t tick = 0; core.game.phase != PHASE_ROUND || tick < 10u * CORE_TICK_HZ; tick++) {
        hold(0, a_m);
        hold(1, b_m);
        input.pressed = tick == 240u ? INPUT_START : 0;
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        assert_true(tick < 20u * CORE_TICK_HZ);
    }
}

static void both_to(vec3 a_m, vec3 b_m, float seconds)
{
    const vec3 from_a_m = input.poi[0].target.position_m, from_b_m = input.poi[1].target.position_m;
    const uint32_t ticks = (uint32_t)(seconds * (float)CORE_TICK_HZ);
    for (uint32_t tick = 1; tick <= ticks; tick++) {
        const float share = (float)tick / (float)ticks;
        hold(0, v3_lerp(from_a_m, a_m, share));
        hold(1, v3_lerp(from_b_m, b_m, share));
        output.sound_count = 0;
        core_tick(&core, &input, &output);
    }
}

static void test_two_pois_at_one_place_separate_sideways_or_vertically(void **state)
{
    (void)state;
    two_hands(v3(-0.10f, 0.08f, 0.0f), v3(0.10f, 0.08f, 0.0f));
    both_to(v3(-0.01f, 0.08f, 0.0f), v3(0.01f, 0.08f, 0.0f), 0.5f);
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        both_to(input.poi[0].target.position_m, input.poi[1].target.position_m, 0.01f);
        const vec3 apart_m = v3_sub(core.world.poi[1].position_m, core.world.poi[0].position_m);
        const float flat_m = v3_length(v3(apart_m.x, 0.0f, apart_m.z));
        assert_true(flat_m > 2.0f * POI_OUTER_RADIUS_M - 0.006f ||
                    f_abs(apart_m.y) > 0.5f * POI_THICKNESS_M);
        /* Poi 1 must stay on the right of poi 0, because the pois cannot pass through each
         * other. */
        assert_true(apart_m.x > 0.0f);
    }
}

static void test_two_pois_push_each_other_equally(void **state)
{
    (void)state;
    two_hands(v3(-0.10f, 0.08f, 0.0f), v3(0.10f, 0.08f, 0.0f));
    both_to(v3(-0.03f, 0.08f, 0.0f), v3(0.03f, 0.08f, 0.0f), 0.5f);
    both_to(v3(-0.03f, 0.08f, 0.0f), v3(0.03f, 0.08f, 0.0f), 0.3f);
    const float left_m = core.world.poi[0].position_m.x + 0.03f;
    const float right_m = core.world.poi[1].position_m.x - 0.03f;
    assert_true(right_m > 0.010f);
    assert_float_equal(left_m, -right_m, 0.002f);
}

static void test_a_poi_under_another_rises_within_half_a_second(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 8; i++) {
        const float off_m = 0.008f * (float)i;
        two_hands(v3(0.0f, -0.06f, 0.0f), v3(off_m, 0.02f, 0.0f));
        both_to(v3(0.0f, 0.10f, 0.0f), v3(off_m, -0.06f, 0.0f), 0.5f);
        both_to(v3(0.0f, 0.10f, 0.0f), v3(off_m, -0.06f, 0.0f), 0.5f);
        assert_true(core.world.poi[0].position_m.y > 0.07f);
        assert_true(core.world.poi[1].position_m.y < -0.03f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_jam_of_one_players_poi_ends_soon_in_a_festival),
        cmocka_unit_test(test_a_jam_ends_soon_in_a_championship),
        cmocka_unit_test(test_a_jam_of_two_or_four_players_ends_soon),
        cmocka_unit_test(test_a_poi_under_a_heap_of_fish_rises_with_the_hand),
        cmocka_unit_test(test_two_pois_at_one_place_separate_sideways_or_vertically),
        cmocka_unit_test(test_two_pois_push_each_other_equally),
        cmocka_unit_test(test_a_poi_under_another_rises_within_half_a_second),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
